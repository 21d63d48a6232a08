"""How the plane of a swing went round, and how the swing changed on the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Course:
    """The swing at some of its outer turning points.

    Attributes
    ----------
    times : (n,) array
        s.
    a, b : (n,) arrays
        Semi-axes, m; b signed, positive counter-clockwise seen from above.
    azimuth : (n,) array
        Of the major axis, rad, continuous, counter-clockwise seen from above.
    ideal : float
        −Ω_E sin(latitude), rad/s: the rate that Foucault meant; 0 without a site.
    widest : float
        Largest |b| of all swings, m, those between the times included.
    """

    times: NDArray[np.float64]
    a: NDArray[np.float64]
    b: NDArray[np.float64]
    azimuth: NDArray[np.float64]
    ideal: float
    widest: float

    @property
    def mean_rate(self) -> float:
        """Of the azimuth from the first to the last time, rad/s; 0 for fewer than two times."""
        if len(self.times) < 2:
            return 0.0
        turned = self.azimuth[-1] - self.azimuth[0]
        return float(turned / (self.times[-1] - self.times[0]))

    @property
    def ideal_azimuth(self) -> NDArray[np.float64]:
        """Where the plane would stand had the Earth alone turned it since the first time, rad."""
        return self.azimuth[0] + self.ideal * (self.times - self.times[0])
