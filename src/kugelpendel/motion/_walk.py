"""A motion followed step by step: position, velocity, tension and events in one pass."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite
from typing import ClassVar, Protocol, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.errors import InvalidInput, MotionEnded
from kugelpendel.motion._base import MOST_EVENTS, EventKind, Motion
from kugelpendel.motion._times import checked_grid, followed_times
from kugelpendel.parameters import Numbers, Scalar_co, one_number

AskedEvent: TypeAlias = EventKind | tuple[EventKind, float]


@final
@dataclass(frozen=True)
class Passages:
    """The bob at the events of one kind.

    Attributes
    ----------
    times
        s, ascending.
    position, velocity
        m from the support, z down; m/s.
    tension
        Pull of the thread, N.
    """

    times: Numbers
    position: Numbers
    velocity: Numbers
    tension: Numbers


@final
@dataclass(frozen=True)
class Leg:
    """A stretch of a motion, read in one pass.

    Attributes
    ----------
    start, until
        s: from when to when the walk has gone. Events at `start` belong to the leg before, except
        for the first leg of a walk.
    times
        s: those of the times asked for that were reached, the first n of them.
    position, velocity
        m from the support, z down; m/s.
    tension
        Pull of the thread, N.
    events
        `Passages` for each event that was asked for, under what it was asked by: ``"outer"`` or
        ``("azimuth", 0.7)``.
    ending
        Why the motion ends at `until`: "slack" (the pull of the thread reaches zero), "level" (the
        bob comes to the height of the support), "runaway" (the speed grows beyond all bounds), or
        "" where it goes on.
    """

    start: float
    until: float
    times: Numbers
    position: Numbers
    velocity: Numbers
    tension: Numbers
    events: Mapping[AskedEvent, Passages]
    ending: str


class _Core(Protocol):
    """What the motions of the core that are integrated have in common."""

    def spans(self, within: Numbers) -> Numbers: ...
    def position(self, times: Numbers) -> tuple[Numbers, Numbers, str]: ...
    def velocity(self, times: Numbers) -> tuple[Numbers, Numbers, str]: ...
    def tension(self, times: Numbers) -> tuple[Numbers, Numbers, str]: ...
    def leg(
        self,
        times: Numbers,
        events: Sequence[tuple[str, float]],
        between: tuple[float, float],
        most: int,
        within: float | None,
    ) -> tuple[int, float, float, str, Numbers, Numbers, Numbers, list[tuple[Numbers, ...]]]: ...


class SteppedMotion(Motion[Scalar_co]):
    """A motion that is integrated, and goes on from where it was.

    Every request goes on from the last checkpoint at or before its first time, with the same steps
    as from the launch, so its bits do not depend on what was asked before. A single motion keeps
    1024 checkpoints, some 130 kB, evenly spread over what has been walked, and the beginnings of
    the latest requests: going back costs at most a five-hundredth of the whole, and asking the same
    stretch for something else costs that stretch. Each motion of an ensemble keeps 16.
    """

    _motions: _Core
    _earliest: ClassVar[float] = 0.0

    @abstractmethod
    def _ended(self, why: str) -> tuple[str, dict[str, str]]:
        """The kind of error, and its other values, where a single motion has ended so."""

    @abstractmethod
    def _check_start(self, first: float) -> None:
        """Refuse a first time, s, before the motion begins."""

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3).

        Raises InvalidInput for times that are not finite or before the span, and MotionEnded for a
        single motion that has ended; in an ensemble it is NaN from its end on.
        """
        times = self._times(t, 3)
        return self._shaped(self._motions.position(times.ravel()), times, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); t and errors as in `position`."""
        times = self._times(t, 3)
        return self._shaped(self._motions.velocity(times.ravel()), times, 3)

    def tension(self, t: ArrayLike) -> Numbers:
        """Pull of the thread, N: shape (*shape, *t.shape); errors as in `position`.

        It is 0 in flight and negative where only a rod would hold the motion; the weight of the
        thread itself is left out.
        """
        times = self._times(t, 1)
        return self._shaped(self._motions.tension(times.ravel()), times)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3); errors as in `position`."""
        size = checked_grid(start, step, count, 3 * self._count)
        return self.position(float(start) + float(step) * np.arange(size))

    def walk(self, start: float = 0.0) -> Walk:
        """A walk along this motion from a time ≥ 0 s on, for everything about it in one pass.

        Raises InvalidInput for an ensemble: walk along its motions one by one.
        """
        return Walk(self, one_number(start, "The start", "s"))

    @property
    def _event_span(self) -> tuple[float, float]:
        return (0.0, inf)  # where the motion ends, the search does too

    def _find_events(
        self, kind: str, value: float, between: tuple[float, float], most: int
    ) -> Numbers:
        found = self._motions.leg(np.empty(0), [(kind, value)], between, most, None)[-1]
        return found[0][0]

    def _span_within(self, within: Numbers) -> tuple[float, float]:
        """Between which times all good motions go on, their ends looked for so many s each way."""
        spans = self._motions.spans(within).reshape(-1, 2)
        spans = spans[~np.isnan(spans).any(axis=-1)]
        return (float(spans[:, 0].max(initial=-inf)), float(spans[:, 1].min(initial=inf)))

    def _times(self, t: ArrayLike, numbers_each: int) -> Numbers:
        times = followed_times(t, numbers_each * self._count)
        self._check_start(float(times.min(initial=0.0)))
        return times

    def _shaped(self, filled: tuple[Numbers, Numbers, str], times: Numbers, *tail: int) -> Numbers:
        flat, ends, why = filled
        if self.shape == () and isfinite(ends[0]):
            kind, values = self._ended(why)
            asked = {"first": (float(times.min()), "s"), "last": (float(times.max()), "s")}
            raise MotionEnded.of(kind, time=(float(ends[0]), "s"), **values, **asked)
        return flat.reshape((*self.shape, *times.shape, *tail))


@final
class Walk:
    """A walk along one motion: each leg goes on from where the one before has ended.

    What it holds is a time and the motion, whose checkpoints make going on cheap; so a walk can be
    copied, and several can go along one motion.

    Parameters
    ----------
    motion
        A single one that is integrated.
    start
        s ≥ 0, where the first leg begins.

    Raises
    ------
    InvalidInput
        For an ensemble and a time before the launch.
    """

    def __init__(self, motion: SteppedMotion, start: float = 0.0):
        if motion.shape != ():
            raise InvalidInput(
                f"A walk goes along a single motion, but this is an ensemble of shape "
                f"{motion.shape}; walk along its motions one by one."
            )
        if not 0 <= start < inf:
            raise InvalidInput(f"A walk begins at a time ≥ 0 s, but asked for is {start} s.")
        self._motion = motion
        self._time = start
        self._ending = ""
        self._is_fresh = True

    @property
    def motion(self) -> SteppedMotion:
        """The motion that is followed."""
        return self._motion

    @property
    def time(self) -> float:
        """How far the walk has come, s."""
        return self._time

    @property
    def ending(self) -> str:
        """Why the motion has ended there, as in `Leg`; "" while it goes on."""
        return self._ending

    def to(
        self,
        until: float,
        times: ArrayLike = (),
        events: Sequence[AskedEvent] = (),
        *,
        within: float | None = None,
    ) -> Leg:
        """Go on to a time, and read everything on the way in one pass over the steps.

        Parameters
        ----------
        until
            s, not before `time`.
        times
            s, ascending, from `time` to `until`: where position, velocity and tension are wanted.
        events
            Kinds as in `events`, those that need a value as pairs: ``("azimuth", 0.7)``.
        within
            s of work, after which the leg ends where it has come to; it goes at least 64 steps.

        Raises
        ------
        InvalidInput
            For times that are not ascending or out of the leg, and for events that make no sense.
        """
        motion = self._motion
        end = one_number(until, "until", "s")
        wanted = followed_times(times, 7).ravel()
        if not self._time <= end < inf:
            raise InvalidInput(
                f"The walk has come to {self._time:.9g} s and goes on from there, not to {end} s."
            )
        if wanted.size and not (
            (np.diff(wanted) >= 0).all() and wanted[0] >= self._time and wanted[-1] <= end
        ):
            raise InvalidInput(
                f"The times of a leg must ascend from {self._time:.9g} s to {end:.9g} s, but they "
                f"go from {wanted[0]:.9g} s to {wanted[-1]:.9g} s; sort them, or begin a new walk."
            )
        checked = [
            motion._checked_event(*(asked if isinstance(asked, tuple) else (asked, None)))  # pyright: ignore[reportPrivateUsage]
            for asked in events
        ]
        start = self._time
        after = start if self._is_fresh else float(np.nextafter(start, inf))
        count, come, ended, why, position, velocity, tension, found = motion._motions.leg(  # pyright: ignore[reportPrivateUsage]
            wanted, checked, (min(after, end), end), MOST_EVENTS, within
        )
        self._is_fresh = False
        self._time = max(start, come)
        self._ending = why if self._time >= ended else ""
        return Leg(
            start=start,
            until=self._time,
            times=wanted[:count],
            position=position.reshape(-1, 3)[:count],
            velocity=velocity.reshape(-1, 3)[:count],
            tension=tension[:count],
            events={
                asked: Passages(when, where.reshape(-1, 3), how.reshape(-1, 3), pull)
                for asked, (when, where, how, pull) in zip(events, found, strict=True)
            },
            ending=self._ending,
        )
