"""How the outer turning points of a motion move round."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.plot._constants import Constants

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kugelpendel import ExactMotion


def apsidal_times(motion: ExactMotion, duration: float, most: int) -> NDArray[np.float64]:
    """Times of outer turning points, at most so many, evenly spread over the duration, s.

    Empty where there are none: at rest, on the separatrix, or when the first comes too late.
    """
    known = Constants.of(motion)
    period, first = known.radial_period, known.apsis_time
    if not (known.high > 0 and period < math.inf and first <= duration):
        return np.empty(0)
    last = math.floor((duration - first) / period)
    return first + period * np.unique(np.linspace(0, last, min(most, last + 1)).round())


def turning_rate(motion: ExactMotion) -> tuple[float, bool]:
    """Mean rate at which the outer turning points move round, on the branch that turns least.

    Returns
    -------
    rate : float
        rad/s, positive counter-clockwise seen from above: the precession, where half a turn lies
        between successive outer turning points; less half a turn a radial period, where it is
        closer to a whole one, for a path over the top.
    whole : bool
        Whether whole turns and not half turns are taken off.
    """
    known = Constants.of(motion)
    if not known.rises_above or abs(known.precession) * known.radial_period <= math.pi / 2:
        return known.precession, False
    half_turn = math.copysign(math.pi / known.radial_period, known.precession)
    return known.precession - half_turn, True


def turned_azimuth(motion: ExactMotion, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Azimuth of outer turning points since the first of them, unwrapped.

    Parameters
    ----------
    times : (n,) array
        When the bob is at outer turning points, s.

    Returns
    -------
    (n,) array
        rad, counter-clockwise seen from above, from exact positions.
    """
    position = motion.position(times)
    azimuth = np.arctan2(position[:, 1], position[:, 0])
    rate, whole = turning_rate(motion)
    branch = 2 * math.pi if whole else math.pi
    turned = azimuth - azimuth[0]
    branches = np.rint((rate * (times - times[0]) - turned) / branch)
    return np.asarray(turned + branch * branches, dtype=np.float64)
