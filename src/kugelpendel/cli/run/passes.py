"""One motion that is asked for several things at once, stretch after stretch."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    import kugelpendel as kp


class Passes:
    """The same motion once for each thing that is read off it.

    An integrated motion goes on from where it was asked last and starts anew when it is asked for
    an earlier time. Position and velocity at the same times, one after the other, would start it
    anew with every stretch; each on a pass of its own they cost two passes in all.

    Parameters
    ----------
    make : callable
        Makes the motion, a single one, as often as it is called.
    """

    def __init__(self, make: Callable[[], kp.RealMotion]) -> None:
        self._places, self._rates, self._pulls = make(), make(), make()
        self.angular_frequency = float(self._places.angular_frequency)

    def position(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """As that of the motion."""
        return self._places.position(t)

    def velocity(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """As that of the motion."""
        return self._rates.velocity(t)

    def tension(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """As that of the motion."""
        return self._pulls.tension(t)

    def reach(self, until: float) -> None:
        """Raise MotionEnded where the motion ends before that; the next times must be later."""
        self._places.position(until)
