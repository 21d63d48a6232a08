"""The motion of a real pendulum: the full equations, integrated."""

from __future__ import annotations

from functools import cached_property, partial
from math import inf, isfinite
from typing import Literal, TypeAlias, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel import _core
from kugelpendel.errors import EventNotFound, InvalidInput, MotionEnded
from kugelpendel.motion._forced import ForcedMotion
from kugelpendel.motion._problems import Problems, Reasons
from kugelpendel.motion._times import checked_grid, checked_times
from kugelpendel.parameters import ForceParts, Forces, Launch, Numbers, Pendulum, as_numbers

Thread: TypeAlias = Literal["ends", "flies", "rod"]
Event: TypeAlias = Literal["outer", "inner", "azimuth", "slack", "taut"]

_THREADS = ("ends", "flies", "rod")
_EVENTS = ("outer", "inner", "azimuth", "slack", "taut")
_FINEST = 1e-17
_MOST = 10_000_000


class RealMotion(ForcedMotion):
    """A pendulum on the turning Earth, in air, on an imperfect suspension, driven or not.

    The full equations on the sphere, integrated by Taylor series of order 20 with dense output.
    Arrays in what is given broadcast to an ensemble, which is integrated on all processors.

    Parameters
    ----------
    pendulum
        What swings; its gravity is the one that acts.
    launch
        Position and velocity at t = 0, as seen from the ground.
    forces
        What acts, as one object; or by its parts:
    site
        Where: turns the ground; x is east and y north.
    drag
        Of the air.
    suspension
        What it lacks in symmetry, and its own damping.
    bob
        Its size: buoyancy, air carried along and moments of inertia change the gravity that acts.
    drive
        A push in every half swing.
    thread
        What happens where the pull of the thread reaches zero: the motion "ends" there; the bob
        "flies" until the thread is taut again, which takes away its speed along the thread; or
        nothing, since it is a "rod".
    tolerance
        Of the last terms of a step's series against the motion's size; from 1e-17, which is the
        smallest that makes a difference, to 1e-3.

    Raises
    ------
    InvalidInput
        For what a single ExactMotion would refuse, shapes that do not broadcast, a site whose given
        gravity is not the pendulum's, a drive that pumps without end, and an unknown thread or
        tolerance. In an ensemble a bad case of anything that is given, a drive that pumps
        included, gives NaN, and `reason` says why.

    Notes
    -----
    With nothing but pendulum and launch the motion stays within 1e-12 l of ExactMotion over 1000
    periods (tests/motion/real/test_real.py); the error grows like t^1.5. The bob is on the sphere
    and its velocity tangent to it, to rounding, at every step. Speeds below 1e-9 lω0 feel quadratic
    drag as if they were that fast.
    Every request is integrated from t = 0, or goes on from where the last one stopped if it begins
    no earlier; the result is the same. Memory does not grow with the span.
    Sources: Olsson (1981), eq. (4), with the Coriolis force, drag and the suspension's anisotropy
    added; Jorba & Zou, Experimental Mathematics 14, 99 (2005) for the integration. Signs and forms
    of the forces are in docs/conventions.md.
    """

    def __init__(
        self,
        pendulum: Pendulum,
        launch: Launch,
        forces: Forces | None = None,
        *,
        thread: Thread = "ends",
        tolerance: float = _FINEST,
        **parts: Unpack[ForceParts],
    ):
        if str(thread) not in _THREADS:
            raise InvalidInput(
                f"The thread must be one of {', '.join(map(repr, _THREADS))}, but it is {thread!r}."
            )
        tolerance = _one_number(tolerance, "The tolerance", "")
        if not 0 < tolerance <= 1e-3:
            raise InvalidInput(
                f"The tolerance must lie between 0 and 1e-3, but it is {tolerance:g}; leave it out "
                f"for the finest."
            )
        self._give(pendulum, launch, forces, parts)
        self._thread: Thread = thread
        self._tolerance = tolerance
        self._motions = _core.RealMotions(*self._columns, thread, tolerance)
        if self.shape == () and (problem := self._motions.problem(0)):
            raise InvalidInput.told(problem)

    def __reduce__(self) -> tuple[object, ...]:
        options = {"thread": self._thread, "tolerance": self._tolerance}
        return (partial(RealMotion, **options), (self.pendulum, self.launch, self.forces))

    @property
    def thread(self) -> Thread:
        """What happens where its pull reaches zero."""
        return self._thread

    @property
    def tolerance(self) -> float:
        """Of the integration."""
        return self._tolerance

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which the motion can be asked, as far as it is known.

        A push or a jerk of the thread cannot be undone, so a driven pendulum and one that flies
        begin with their launch. A thread that "ends" may end the motion earlier: asked for later
        times a single motion says when, an ensemble gives NaN.
        """
        return (0.0 if self.drive is not None or self.thread == "flies" else -inf, inf)

    @cached_property
    def problems(self) -> Problems:
        """Index and sentence of each bad case of the ensemble; empty where all are good."""
        return Problems(self._motions, self.shape)

    @property
    def status(self) -> NDArray[np.uint8]:
        """0 for a good case, else the number of the kind of its problem: shape `shape`."""
        return self.problems.status

    @property
    def reason(self) -> Reasons:
        """Why a case of the ensemble is bad, "" where it is good: shape `shape`."""
        return self.problems.reasons

    @property
    def trust(self) -> str:
        """Where the motion holds."""
        return "Everywhere, as far as the forces are known; errors of the integration grow slowly."

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3).

        Raises InvalidInput for times that are not finite or before the span, and MotionEnded for a
        single motion that has ended; in an ensemble it is NaN from its end on.
        """
        times = self._times(t, 3)
        return self._shaped(*self._motions.position(times.ravel()), times, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); t and errors as in `position`."""
        times = self._times(t, 3)
        return self._shaped(*self._motions.velocity(times.ravel()), times, 3)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3); errors as in `position`."""
        size = checked_grid(start, step, count, 3 * self._count)
        return self.position(float(start) + float(step) * np.arange(size))

    def tension(self, t: ArrayLike) -> Numbers:
        """Pull of the thread, N: shape (*shape, *t.shape); errors as in `position`.

        0 in flight, negative where a rod pushes. Without the weight of the thread itself.
        """
        times = self._times(t, 1)
        return self._shaped(*self._motions.tension(times.ravel()), times)

    def events(self, kind: Event, start: float, stop: float, value: float | None = None) -> Numbers:
        """Times of an event between two times, s, to the last bits: shape (n,).

        Parameters
        ----------
        kind
            "outer" (farthest from the axis), "inner" (closest approach), "azimuth" (the bob passes
            an azimuth, either way), "slack" (the thread's pull reaches zero) or "taut" (it is
            straight again after a flight).
        start, stop
            s, 0 ≤ start ≤ stop; both belong to the interval.
        value
            rad, the azimuth to pass; only for "azimuth".

        Raises
        ------
        InvalidInput
            For an unknown kind, an azimuth left out or given in vain, times that make no sense, and
            an ensemble.
        """
        azimuth = self._checked_event(kind, value)
        first, last = _one_number(start, "The start", "s"), _one_number(stop, "The stop", "s")
        if not 0 <= first <= last < inf:
            raise InvalidInput(
                f"Events are looked for between 0 s ≤ start ≤ stop, but from {first} s to {last} s."
            )
        return self._motions.events(kind, azimuth, (first, last), _MOST)

    def next_event(
        self, kind: Event, after: float = 0.0, within: float = 3600.0, value: float | None = None
    ) -> float:
        """The first time of an event later than `after`, s.

        Looks `within` s ahead; raises EventNotFound where it does not come, and as `events`.
        """
        azimuth = self._checked_event(kind, value)
        first, ahead = _one_number(after, "after", "s"), _one_number(within, "within", "s")
        if not (first >= 0 and 0 < ahead < inf and isfinite(first)):
            raise InvalidInput(
                f"An event is looked for within a positive time after a time ≥ 0 s, but within "
                f"{ahead} s after {first} s."
            )
        later = float(np.nextafter(first, inf))
        times = self._motions.events(kind, azimuth, (later, first + ahead), 1)
        if times.size == 0:
            raise EventNotFound.of("no_event", event=kind, within=(ahead, "s"), after=(first, "s"))
        return float(times[0])

    def _checked_event(self, kind: str, value: float | None) -> float:
        if self.shape != ():
            raise InvalidInput(
                f"Events are those of a single motion, but this is an ensemble of shape "
                f"{self.shape}; ask its motions one by one."
            )
        if str(kind) not in _EVENTS:
            names = ", ".join(map(repr, _EVENTS))
            raise InvalidInput(f"The event must be one of {names}, but it is {kind!r}.")
        if (kind == "azimuth") != (value is not None):
            which = "needs" if value is None else "does not take"
            raise InvalidInput(f'The event "{kind}" {which} a value, the azimuth in rad.')
        azimuth = 0.0 if value is None else _one_number(value, "The azimuth", "rad")
        if not isfinite(azimuth):
            raise InvalidInput(f"The azimuth must be finite, but it is {azimuth} rad.")
        return azimuth

    def _times(self, t: ArrayLike, numbers_each: int) -> Numbers:
        times = checked_times(t, numbers_each * self._count)
        first = self.span[0]
        if times.size and times.min() < first:
            raise InvalidInput(
                f"A driven or flying pendulum cannot be followed back before its launch, but "
                f"asked for is {times.min():.6g} s."
            )
        return times

    def _shaped(self, flat: Numbers, ends: Numbers, times: Numbers, *tail: int) -> Numbers:
        if self.shape == () and np.isfinite(ends[0]):
            asked = {"first": (float(times.min()), "s"), "last": (float(times.max()), "s")}
            raise MotionEnded.of("slack", time=(float(ends[0]), "s"), **asked)
        return flat.reshape((*self.shape, *times.shape, *tail))


def _one_number(given: float, name: str, unit: str) -> float:
    value = as_numbers(given, name, unit)
    if not isinstance(value, float):
        raise InvalidInput(f"{name} must be one number, but it is {given!r}.")
    return value
