"""What is noted at the outer turning points while a real pendulum swings."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.run.passes import Passes
from kugelpendel.observables import Course, osculating_ellipse

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    import kugelpendel as kp

_KEPT = 4000
"""Turning points that are kept at most, evenly spread; more cannot be told apart in a figure."""


class Watch:
    """Follows a motion from one outer turning point to the next.

    Parameters
    ----------
    make : callable
        Makes the motion, as for `Passes`.
    duration : float
        How long it will be followed at most, s.
    """

    def __init__(self, make: Callable[[], kp.RealMotion], duration: float) -> None:
        self._events, self._swing = make(), Passes(make)
        site, self._point = self._events.site, self._events.effective_pendulum
        half_swing = math.pi / float(self._events.angular_frequency)
        self._ideal = -float(site.vertical_rotation) if site is not None else 0.0
        self._every = max(1, math.ceil(duration / half_swing / _KEPT))
        self._seen = 0
        self._azimuth = 0.0
        self._last: NDArray[np.float64] = np.empty((0, 4))
        self._kept: list[NDArray[np.float64]] = []
        self._first_times: list[float] = []
        self._last_times: list[float] = []
        self._until = 0.0
        self._widest = 0.0

    def advance(self, until: float) -> None:
        """Note the outer turning points up to this time, s."""
        times = self._events.events("outer", self._until, until)
        self._until = until
        # One at the very end of a stretch begins the next one too.
        times = times[times > (self._last[0, 0] if len(self._last) else -1.0)]
        if len(times) == 0:
            return
        place, velocity = self._swing.position(times), self._swing.velocity(times)
        a, b, azimuth = osculating_ellipse(place, velocity, self._point, -self._ideal, times)
        self._widest = max(self._widest, float(np.abs(b).max()))
        first = self._azimuth if self._seen else float(azimuth[0])
        # A major axis has no front end: half turns make no difference.
        turned = np.unwrap(np.concatenate([[first], azimuth]), period=math.pi)[1:]
        table = np.column_stack([times, a, b, turned])
        self._kept.append(table[-self._seen % self._every :: self._every])
        self._seen += len(times)
        self._azimuth = float(turned[-1])
        self._last = table[-1:]
        self._first_times = [*self._first_times, *map(float, times[:3])][:3]
        self._last_times = [*self._last_times, *map(float, times[-3:])][-3:]

    @property
    def swing_periods(self) -> tuple[float, float]:
        """Of the first swing and of the last, there and back, s; NaN where there is none."""
        if len(self._first_times) < 3:
            return math.nan, math.nan
        (first, _, third), (former, _, last) = self._first_times, self._last_times
        return third - first, last - former

    def course(self) -> Course:
        """What was noted so far."""
        rows = [*self._kept, self._last]
        table = np.concatenate(rows) if self._seen else np.empty((0, 4))
        if len(table) > 1 and table[-1, 0] == table[-2, 0]:
            table = table[:-1]
        times, a, b, azimuth = table.T
        return Course(times, a, b, azimuth, self._ideal, self._widest)
