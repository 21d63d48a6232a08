"""What a motion does, read off its outer turning points."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from kugelpendel.motion import RealMotion
from kugelpendel.parameters import Numbers


def outer_points(motion: RealMotion, start: float, stop: float) -> tuple[Numbers, Numbers]:
    """Times, s, and horizontal positions, m, (n, 2), of the outer turning points between."""
    times = motion.events("outer", start, stop)
    return times, motion.position(times)[:, :2]


def turned(points: Numbers) -> Numbers:
    """Azimuth of the swing since the first of its outer turning points, rad, continuous.

    Of points at most some swings apart, between which the swing turns by less than a quarter.
    """
    azimuth = np.arctan2(points[:, 1], points[:, 0])
    steps = np.diff(azimuth)
    return np.concatenate([[0.0], np.cumsum(steps - math.pi * np.rint(steps / math.pi))])


def turning_rate(motion: RealMotion, swing: float, swings: int = 10) -> float:
    """Mean rate of turning over the first swings, rad/s, counter-clockwise seen from above."""
    times, points = outer_points(motion, swing / 4, (swings + 0.75) * swing)
    return float(turned(points)[-1] / (times[-1] - times[0]))


def period(motion: RealMotion, swing: float) -> float:
    """Time of one swing there and back, s: a mean over the first ones."""
    times = motion.events("outer", swing / 4, 2.4 * swing)
    span = float(times[-1] - times[0])
    return span / (round(2 * span / swing) / 2)


def amplitude(motion: RealMotion, at: float, swing: float) -> tuple[float, float]:
    """Time, s, and radius, m, of the outer turning point next after a time."""
    time = motion.next_event("outer", after=at, within=2 * swing)
    x, y, _ = motion.position(time)
    return time, math.hypot(x, y)


@dataclass(frozen=True)
class Course:
    """How a motion goes on for long, at turning points next after some moments.

    Attributes
    ----------
    times, azimuths
        s, and rad, continuous, of outer ones.
    inner
        m, radii of the inner ones after them.
    """

    times: Numbers
    azimuths: Numbers
    inner: Numbers

    @classmethod
    def of(
        cls, motion: RealMotion, swing: float, moments: Iterable[float], worked: Callable[[], None]
    ) -> Course:
        """Walk through the motion; `worked` is told after each moment."""
        times: list[float] = []
        inner: list[float] = []
        for moment in moments:
            outer = motion.next_event("outer", after=moment, within=2 * swing)
            times.append(outer)
            inner.append(motion.next_event("inner", after=outer, within=2 * swing))
            worked()
        radii = np.hypot(*motion.position(inner)[:, :2].T)
        return cls(np.array(times), turned(motion.position(times)[:, :2]), radii)

    @property
    def rates(self) -> Numbers:
        """Means between two of them, rad/s, counter-clockwise seen from above."""
        return np.diff(self.azimuths) / np.diff(self.times)
