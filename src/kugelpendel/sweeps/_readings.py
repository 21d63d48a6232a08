"""How each quantity of a sweep is read off an exact, an averaged or a real ensemble."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from kugelpendel.motion import (
    EnvelopeMotion,
    ExactMotion,
    PlaneCourse,
    PlanePace,
    RealCourse,
    RealMotion,
    Settled,
)
from kugelpendel.parameters import Numbers


class _ExactReadings:
    """Each attribute without an underscore is a quantity."""

    def __init__(self, motion: ExactMotion[Numbers], times: Numbers):
        self._motion, self._times = motion, times

    @cached_property
    def _launch(self) -> Numbers:
        return self._motion.launch_ellipse()

    @cached_property
    def _errors(self) -> Numbers:
        outer, inner = np.moveaxis(self._motion.turning_radii, -1, 0)
        return self._motion.ellipse_rates(outer, np.copysign(inner, self._launch[:, 1]))

    @property
    def frequency(self) -> Numbers:
        return self._motion.frequency

    @property
    def precession(self) -> Numbers:
        return self._motion.precession

    @property
    def period(self) -> Numbers:
        return self._motion.period

    @property
    def azimuth(self) -> Numbers:
        return self._launch[:, 2, None] + self._motion.precession[:, None] * self._times

    @property
    def a(self) -> Numbers:
        return np.repeat(self._launch[:, :1], self._times.size, axis=1)

    @property
    def b(self) -> Numbers:
        return np.repeat(self._launch[:, 1:2], self._times.size, axis=1)

    @property
    def mean_rate(self) -> Numbers:
        return np.repeat(self._motion.precession[:, None], self._times.size, axis=1)

    @property
    def largest_b(self) -> Numbers:
        return np.abs(self._launch[:, 1])

    @property
    def quarter_turn(self) -> Numbers:
        with np.errstate(divide="ignore"):
            after = 0.5 * math.pi / np.abs(self._motion.precession)
        late = self._times[-1] if self._times.size else math.inf
        return np.where(after > late, math.inf, after)

    @property
    def least_tension(self) -> Numbers:
        return self._motion.tension_range[:, 0]

    @property
    def largest_tension(self) -> Numbers:
        return self._motion.tension_range[:, 1]

    @property
    def error_25(self) -> Numbers:
        return self._errors[:, 4]

    @property
    def error_26(self) -> Numbers:
        return self._errors[:, 5]


class _AveragedReadings:
    """Each attribute without an underscore is a quantity."""

    def __init__(self, motion: EnvelopeMotion[Numbers], times: Numbers):
        self._motion, self._times = motion, times

    @cached_property
    def _axes(self) -> Numbers:
        return self._motion.semi_axes(self._times)

    @cached_property
    def _azimuths(self) -> Numbers:
        """At the launch and at the times, in one pass."""
        return self._motion.azimuth(np.concatenate(([0.0], self._times)))

    @cached_property
    def _course(self) -> PlaneCourse:
        return self._motion.course(float(self._times[-1]))

    @cached_property
    def _pace(self) -> PlanePace:
        first = float(self._times[0]) if self._times.size > 1 else 0.0
        return self._motion.pace(first, float(self._times[-1]))

    @cached_property
    def _settled(self) -> Settled:
        return self._motion.settled()

    @property
    def azimuth(self) -> Numbers:
        return self._azimuths[:, 1:]

    @property
    def a(self) -> Numbers:
        return self._axes[..., 0]

    @property
    def b(self) -> Numbers:
        return self._axes[..., 1]

    @property
    def mean_rate(self) -> Numbers:
        return (self._azimuths[:, 1:] - self._azimuths[:, :1]) / self._times

    @property
    def largest_b(self) -> Numbers:
        return self._course.largest_b

    @property
    def quarter_turn(self) -> Numbers:
        return self._course.quarter_turn

    @property
    def stands_since(self) -> Numbers:
        return self._course.stands_since

    @property
    def slowest_rate(self) -> Numbers:
        return self._pace.slowest

    @property
    def fastest_rate(self) -> Numbers:
        return self._pace.fastest

    @property
    def stalls(self) -> Numbers:
        return _truth(self._settled.verdict)

    @property
    def final_direction(self) -> Numbers:
        found = self._settled
        # A swing that dies away is left where it is at the end; another one goes to and fro.
        left, middle = self._azimuths[:, 0] + found.turned, 0.5 * (found.low + found.high)
        end = np.where(found.dies == 1.0, left, middle)
        return np.where(found.verdict > 0.0, np.mod(end, math.pi), math.nan)

    @property
    def clamp_stalls(self) -> Numbers:
        return _truth(self._motion.clamp_orbits().verdict)


class _RealReadings:
    """Each attribute without an underscore is a quantity."""

    def __init__(self, motion: RealMotion[Numbers], times: Numbers):
        self._motion, self._times = motion, times

    @cached_property
    def _course(self) -> RealCourse:
        """With the ellipse at the launch, and then at the times."""
        return self._motion.course(np.concatenate(([0.0], self._times)))

    @property
    def azimuth(self) -> Numbers:
        return self._course.azimuth[:, 1:]

    @property
    def a(self) -> Numbers:
        return self._course.a[:, 1:]

    @property
    def b(self) -> Numbers:
        return self._course.b[:, 1:]

    @property
    def mean_rate(self) -> Numbers:
        azimuths = self._course.azimuth
        return (azimuths[:, 1:] - azimuths[:, :1]) / self._times

    @property
    def largest_b(self) -> Numbers:
        return self._course.largest_b

    @property
    def least_tension(self) -> Numbers:
        return self._course.least_tension

    @property
    def largest_tension(self) -> Numbers:
        return self._course.largest_tension

    @property
    def quarter_turn(self) -> Numbers:
        return self._course.quarter_turn

    @property
    def stands_since(self) -> Numbers:
        return self._course.stands_since

    @property
    def averaging_error(self) -> Numbers:
        motion = self._motion
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # how far it is off is what is asked
            averaged = EnvelopeMotion(motion.pendulum, motion.launch, motion.forces)
        means = averaged.azimuth(np.concatenate(([0.0], self._times)))
        apart = self._course.azimuth - means
        # Both are azimuths of an axis, which has no front end.
        apart -= math.pi * np.round(apart[:, :1] / math.pi)
        return np.abs(apart[:, 1:])


READINGS: dict[str, Callable[[Any, Numbers], object]] = {
    "exact": _ExactReadings,
    "averaged": _AveragedReadings,
    "real": _RealReadings,
}


def _truth(verdict: Numbers) -> Numbers:
    """1 where a plane does not go round, 0 where it does, NaN where that cannot be told."""
    return np.where(np.isnan(verdict), math.nan, np.where(verdict > 0.0, 1.0, 0.0))
