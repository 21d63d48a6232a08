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
    return np.unwrap(azimuth, period=math.pi) - azimuth[0]


def turning_rate(motion: RealMotion, swing: float, swings: int = 10) -> float:
    """Mean rate of turning over the first swings, rad/s, counter-clockwise seen from above."""
    times, points = outer_points(motion, swing / 4, (swings + 0.75) * swing)
    return float(turned(points)[-1] / (times[-1] - times[0]))


def period(motion: RealMotion, swing: float) -> float:
    """Time of one swing there and back, s: a mean over the first ones."""
    times = motion.events("outer", swing / 4, 2.4 * swing)
    span = float(times[-1] - times[0])
    return span / (round(2 * span / swing) / 2)


def amplitude(motion: RealMotion, at: float, swing: float) -> float:
    """Radius, m, of the outer turning points at a time: between those before and after it.

    By their logarithms, which is exact for linear drag.
    """
    times = motion.events("outer", max(at - 0.75 * swing, 0.0), at + 0.75 * swing)
    radii: Numbers = np.hypot(*motion.position(times)[:, :2].T)
    return float(np.exp(np.interp(at, times, np.log(radii))))


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
        radii: Numbers = np.hypot(*motion.position(inner)[:, :2].T)
        return cls(np.array(times), turned(motion.position(times)[:, :2]), radii)

    @property
    def rates(self) -> Numbers:
        """Means between two of them, rad/s, counter-clockwise seen from above."""
        return np.diff(self.azimuths) / np.diff(self.times)
