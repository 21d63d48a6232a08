"""A real motion, followed from its launch, and what it comes to."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel import _core
from kugelpendel.errors import KugelpendelError
from kugelpendel.motion import EnvelopeMotion, PrecessionBudget, RealMotion
from kugelpendel.observables._apsides import Apsides
from kugelpendel.parameters import Launch

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kugelpendel.motion import AskedEvent, Leg

_ROUND = 0.9
"""An ellipse whose |b| is never less than this share of a is taken for a circle."""

_REVOLUTIONS = 100
"""Revolutions over which the two senses of a circle are compared, at most."""

_TIMES = 2001
"""Times at which causes are told apart: modulations last hours, and a day has one every 43 s."""


@dataclass(frozen=True)
class Revolutions:
    """A bob that runs round in a circle, as Bravais' did.

    Attributes
    ----------
    sense
        1 for counter-clockwise seen from above, −1 for clockwise.
    period
        Time of one revolution, s: mean of the first ones, at most 100.
    last_period
        Time of the last revolution, s.
    other_period
        Mean of as many revolutions of the same launch with its velocity reversed, s.
    """

    sense: int
    period: float
    last_period: float
    other_period: float


@dataclass(frozen=True)
class RealSummary:
    """What a real motion comes to: numbers in SI; azimuths and rates counter-clockwise from above.

    Attributes
    ----------
    apsides
        The swing at its outer turning points.
    swing_periods
        Of the first swing and of the last, there and back, s; NaN where there is none.
    tension
        Smallest and largest pull of the thread, N: at the launch, at all turning points and at the
        times that were asked for.
    until
        How far the motion was followed, s.
    slack_time
        When the thread went slack, which ended the motion, s; inf where it did not.
    point_period, small_period
        Of small swings, s: of a point on a thread without weight, and with the bob's correction.
    revolutions
        For a circle, which has no plane; None for a swing.
    """

    apsides: Apsides
    swing_periods: tuple[float, float]
    tension: tuple[float, float]
    until: float
    slack_time: float
    point_period: float
    small_period: float
    revolutions: Revolutions | None

    @property
    def foucault_rate(self) -> float:
        """−Ω_E sin(latitude), rad/s; 0 without a site."""
        return self.apsides.foucault_rate

    @property
    def foucault_turn(self) -> float:
        """Time for one turn at that rate, s; inf without a site and on the equator."""
        return 2 * math.pi / abs(self.foucault_rate) if self.foucault_rate else math.inf


class Follower:
    """Follows one real motion in one pass, and notes what its summary needs.

    Parameters
    ----------
    motion
        A single one.
    """

    def __init__(self, motion: RealMotion) -> None:
        point = motion.effective_pendulum
        site = motion.site
        self._motion = motion
        self._walk = motion.walk()
        self._rotation = float(site.vertical_rotation) if site is not None else 0.0
        values = [float(value) for value in point.values]
        self._track = _core.ApsidesTracker(values, self._rotation)
        x, y, _ = motion.position(0.0)
        vx, vy, _ = motion.velocity(0.0)
        # The ray that is passed once in each revolution: that of the launch or, from the axis, the
        # one across its velocity.
        on_axis = math.hypot(x, y) <= 1e-9 * float(motion.pendulum.length)
        self._ray = math.atan2(vx, -vy) if on_axis else math.atan2(y, x)
        self._passes: list[NDArray[np.float64]] = []
        pull = float(motion.tension(0.0))
        self._tension = (pull, pull)

    @property
    def time(self) -> float:
        """How far the motion has been followed, s."""
        return self._walk.time

    @property
    def ending(self) -> str:
        """Why the motion has ended there, as in `Leg`; "" while it goes on."""
        return self._walk.ending

    def to(self, until: float, times: ArrayLike = (), *, within: float | None = None) -> Leg:
        """Go on; times and errors as in `Walk.to`."""
        ray: AskedEvent = ("azimuth", self._ray)
        leg = self._walk.to(until, times, ("outer", "inner", ray), within=within)
        outer, inner = leg.events["outer"], leg.events["inner"]
        self._track.add(outer.times, outer.position.ravel(), outer.velocity.ravel())
        self._passes.append(leg.events[ray].times)
        least, most = self._tension
        for pull in (leg.tension, outer.tension, inner.tension):
            least = min(least, float(pull.min(initial=math.inf)))
            most = max(most, float(pull.max(initial=-math.inf)))
        self._tension = (0.0 if leg.ending == "slack" else least, most)
        return leg

    def summary(self) -> RealSummary:
        """The summary of what was noted so far."""
        motion = self._motion
        widest, flattest, first, last = self._track.extremes()
        times, a, b, azimuth = (
            np.ascontiguousarray(column) for column in self._track.track().reshape(-1, 4).T
        )
        return RealSummary(
            apsides=Apsides(times, a, b, azimuth, -self._rotation, widest),
            swing_periods=(first, last),
            tension=self._tension,
            until=self.time,
            slack_time=self.time if self.ending == "slack" else math.inf,
            point_period=2 * math.pi / float(motion.pendulum.angular_frequency),
            small_period=2 * math.pi / float(motion.angular_frequency),
            revolutions=self._revolutions() if flattest >= _ROUND else None,
        )

    def _revolutions(self) -> Revolutions | None:
        passes = np.concatenate(self._passes) if self._passes else np.empty(0)
        count = min(len(passes) - 1, _REVOLUTIONS)
        if count < 1:
            return None
        motion = self._motion
        position, velocity = motion.position(0.0), motion.velocity(0.0)
        momentum = position[0] * velocity[1] - position[1] * velocity[0]
        back = RealMotion(
            motion.pendulum, Launch.state(position, -velocity), motion.forces, thread=motion.thread
        )
        # The other sense passes the ray as often in about that time; half as much again is enough.
        period = float((passes[count] - passes[0]) / count)
        late = 1.5 * (count + 2) * period
        other = back.events("azimuth", 0.0, late, self._ray)[: count + 1]
        return Revolutions(
            sense=1 if momentum > 0 else -1,
            period=period,
            last_period=float(passes[-1] - passes[-2]),
            other_period=float(np.diff(other).mean()) if len(other) > 1 else math.nan,
        )


@dataclass(frozen=True)
class Explanation:
    """What turned the plane of a real motion, by the averaged equations.

    Attributes
    ----------
    shares
        The rate of the plane by its causes; None where the average does not hold, as ``why_not``
        says.
    why_not
        Empty where there are shares.
    apart
        Azimuth of the plane at the end, full equations less averaged ones, rad; NaN without.
    caution
        What the averaged equations say about themselves; empty for nothing.
    """

    shares: PrecessionBudget | None
    why_not: str
    apart: float
    caution: str


def explain(motion: RealMotion, summary: RealSummary) -> Explanation:
    """Ask the averaged equations what turned the plane of a motion that was followed."""
    apsides = summary.apsides
    if summary.revolutions is not None:
        return Explanation(None, "a circle has no plane", math.nan, "")
    if len(apsides.times) < 2:
        return Explanation(None, "there is no full swing", math.nan, "")
    try:
        with warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter("always")
            averaged = EnvelopeMotion(motion.pendulum, motion.launch, motion.forces)
            shares = averaged.rates(np.linspace(0.0, summary.until, _TIMES))
            started, ended = averaged.azimuth(apsides.times[[0, -1]])
    except KugelpendelError as error:
        return Explanation(None, str(error), math.nan, "")
    caution = " ".join(str(warning.message) for warning in warned)
    # Both azimuths are those of an axis, which has no front end.
    apart = apsides.azimuth[-1] - ended
    apart -= math.pi * round((apsides.azimuth[0] - started) / math.pi)
    if not np.isfinite(shares.total).all():
        why_not = "the swing does not stay one of a turning ellipse"
        return Explanation(None, why_not, float(apart), caution)
    return Explanation(shares, "", float(apart), caution)
