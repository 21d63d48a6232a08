"""How the plane of a swing went round, and how the swing changed on the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel import _core

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Apsides:
    """The swing at some of its outer turning points.

    Attributes
    ----------
    times
        s.
    a, b
        Semi-axes, m; b signed, positive counter-clockwise seen from above.
    azimuth
        Of the major axis, rad, continuous, counter-clockwise seen from above.
    foucault_rate
        −Ω_E sin(latitude), rad/s: the rate that Foucault meant; 0 without a site.
    widest
        Largest |b| of all swings, m, those between the times included.
    """

    times: NDArray[np.float64]
    a: NDArray[np.float64]
    b: NDArray[np.float64]
    azimuth: NDArray[np.float64]
    foucault_rate: float
    widest: float

    @property
    def mean_rate(self) -> float:
        """Rate of the azimuth from the first to the last time, rad/s; 0 for fewer than two."""
        return self._rates[0]

    @property
    def rate_at_the_end(self) -> float:
        """Rate of the azimuth over the last twentieth of the time, rad/s; 0 for fewer than two."""
        return self._rates[1]

    @property
    def stands_since(self) -> float | None:
        """Since when the plane stands, s; None where it does not at the end.

        From then on to the end it turns by less than a tenth of what the Earth alone would turn it,
        in any stretch of the time in which the Earth turns it by 0.01 rad, or of a fiftieth of all
        the time where that is longer. None as well without a site, and where the time is too short.
        """
        return self._rates[2]

    @property
    def foucault_azimuth(self) -> NDArray[np.float64]:
        """Where the plane would stand had the Earth alone turned it since the first time, rad."""
        return self.azimuth[0] + self.foucault_rate * (self.times - self.times[0])

    @property
    def _rates(self) -> tuple[float, float, float | None]:
        return _core.plane_rates(self.times, self.azimuth, self.foucault_rate)
