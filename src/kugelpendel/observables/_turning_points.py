"""The outer turning points of a motion, and how they move round."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kugelpendel import _core
from kugelpendel.motion import ExactMotion, Motion
from kugelpendel.observables._summary import IdealSummary
from kugelpendel.parameters import Numbers

_ROOM = 1.3
"""Radial periods within which an outer turning point is looked for."""

_TURN = math.pi / 4
"""rad that the apsides may turn from one to the next, unless they follow their expected rate."""

_MOST = 400
"""Turning points that are looked for in order to follow the apsides."""


@dataclass(frozen=True)
class TurningPoints:
    """Some of the outer turning points of a single motion.

    Attributes
    ----------
    times
        When, s: shape (n,), ascending.
    turned
        By how much they have moved round since the first of them, rad, counter-clockwise seen from
        above, half turns (or whole ones, `IdealSummary.whole_turns`) taken off: shape (n,).
    """

    times: Numbers
    turned: Numbers

    @classmethod
    def of(cls, motion: Motion, known: IdealSummary, until: float, most: int) -> TurningPoints:
        """Outer turning points from the launch to `until`, s, at most so many, evenly spread.

        There are none at rest and on the separatrix, or where the first comes too late. Those of
        the exact motion come from its phase; of any other motion they are looked for near evenly
        spread times, and followed as they turn: forces may make them turn by 45° from one of 400
        to the next against the ideal rate.
        """
        if isinstance(motion, ExactMotion):
            times = motion.apsidal_times(until, most)
            return cls(times, motion.turned(times))
        half_swing = known.swing_period / 2
        if not known.high > 0 or not half_swing < math.inf:
            return cls(np.empty(0), np.empty(0))
        rate = known.turning - float(motion.rotation)
        count = min(max(most, math.ceil(abs(rate) * until / _TURN)), _MOST)
        found: list[float] = []
        for start in np.linspace(0.0, max(until - half_swing, 0.0), count):
            later = max(float(start), float(np.nextafter(found[-1], math.inf)) if found else 0.0)
            stop = min(later + _ROOM * half_swing, until)
            found += motion.events("outer", later, stop).tolist()[:1] if later <= stop else []
        times = np.array(found)
        x, y, _ = motion.position(times).T
        ahead = rate * times
        off = _core.unwrapped(
            np.arctan2(y, x) - ahead, 2 * math.pi if known.whole_turns else math.pi
        )
        turned = off + ahead
        kept = np.unique(np.linspace(0, len(times) - 1, min(most, len(times))).round().astype(int))
        return cls(times[kept], (turned - turned[:1])[kept])
