"""The one interface of every motion."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from math import inf, isfinite, prod
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel import _core
from kugelpendel.errors import EventNotFound, InvalidInput, require_extra
from kugelpendel.motion._given import selected, short
from kugelpendel.motion._kept import kept
from kugelpendel.motion._problems import Problems, Reasons
from kugelpendel.motion._times import checked_times
from kugelpendel.parameters import (
    Launch,
    Numbers,
    Pendulum,
    Scalar_co,
    column,
    one_number,
)

if TYPE_CHECKING:
    from xarray import Dataset

EventKind: TypeAlias = Literal["outer", "inner", "bottom", "azimuth", "radius", "slack", "taut"]

_EVENTS = {
    "outer": None,
    "inner": None,
    "bottom": None,
    "azimuth": "rad",
    "radius": "m",
    "slack": None,
    "taut": None,
}
"""The kinds of events, each with the unit of the value that it takes."""

MOST_EVENTS = 10_000_000
"""Events are handed out in one array, of 80 MB at most."""

_GRID = 24
"""Pieces of a half swing between which a change of sign is looked for."""


class Motion(ABC, Generic[Scalar_co]):
    """A pendulum under way: what plots, observables and exports take.

    All eight motions are one: whatever is given, arrays in it broadcast to an ensemble, a motion
    with a `shape`. `motion[i]` is one of its motions, or several; `len` and iteration go along the
    first axis. Motions are equal where they are of one class and all that they were given is equal;
    they can be hashed, pickled and copied, and nothing about them can be set.

    Scalars such as `frequency` are a float for a single motion and a read-only array for an
    ensemble, and typed so: `Motion[float]`, `Motion[Numbers]`, or `Motion` for either. Arrays of
    positions and the like belong to whoever asked for them.
    """

    _motions: Any
    """The core's motions in a row, as `Cases` and what else each kind of motion asks of them."""

    @property
    @abstractmethod
    def pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The pendulum as it was given."""

    @property
    @abstractmethod
    def launch(self) -> Launch[Scalar_co] | Launch[float]:
        """Position and velocity at t = 0, as they were given."""

    @property
    @abstractmethod
    def shape(self) -> tuple[int, ...]:
        """Shape of the ensemble; () for a single motion."""

    @property
    @abstractmethod
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which the motion can be asked."""

    @property
    @abstractmethod
    def trust(self) -> str:
        """A sentence that says where the motion holds, and how far."""

    @property
    @abstractmethod
    def frequency(self) -> Scalar_co:
        """ω of the swing in the frame that turns with the precession, rad/s.

        Raises AttributeError for a motion whose frequency changes under way.
        """

    @property
    @abstractmethod
    def precession(self) -> Scalar_co:
        """Ω of that frame, rad/s, positive counter-clockwise seen from above.

        Raises AttributeError for a motion whose precession changes under way.
        """

    @abstractmethod
    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3)."""

    @abstractmethod
    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3)."""

    @abstractmethod
    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3)."""

    @abstractmethod
    def _arguments(self) -> dict[str, Any]:
        """What the constructor was given, by name; what was left out is left out here too."""

    @property
    def effective_pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The point mass that moves like the bob: here the pendulum itself."""
        return self.pendulum

    @property
    def rotation(self) -> Scalar_co | float:
        """Rate of the ground about the vertical, rad/s, counter-clockwise seen from above."""
        return 0.0

    @property
    def period(self) -> Scalar_co:
        """2π/ω, s: there and back; infinite on the separatrix, where ω = 0.

        Raises AttributeError as `frequency` does.
        """
        with np.errstate(divide="ignore"):
            return self._constant(2 * np.pi / np.asarray(self.frequency))

    def tension(self, t: ArrayLike) -> Numbers:
        """Pull of the thread, N, at the motion's own position and velocity: (*shape, *t.shape).

        Negative where a thread would be slack and only a rod holds the motion. t and errors as in
        `position`. Source: Olsson (1981), eq. (5a), m(g cos θ + v²/l).
        """
        times = np.asarray(t)
        position, velocity = self.position(t), self.velocity(t)
        columns = [column(value, self.shape) for value in self.effective_pendulum.values]
        pull = _core.thread_pull(self._count, columns, position.ravel(), velocity.ravel())
        return pull.reshape((*self.shape, *times.shape))

    def events(
        self, kind: EventKind, start: float, stop: float, value: float | None = None
    ) -> Numbers:
        """Times of an event between two times, s, in order: shape (n,).

        Parameters
        ----------
        kind
            "outer" (the bob is farthest from the vertical axis), "inner" (closest to it), "bottom"
            (at the lowest point of its path), "azimuth" (it passes an azimuth, either way),
            "radius" (it passes a distance from the axis, either way), "slack" (the pull of the
            thread falls through zero) or "taut" (it rises through zero, or the thread is straight
            again after a flight).
        start, stop
            s, start ≤ stop, both belong to the interval; a motion that ends earlier is asked up to
            its end.
        value
            The azimuth in rad or the radius in m; for those two kinds only.

        Raises
        ------
        InvalidInput
            For an unknown kind, a value left out or given in vain, times that make no sense, and
            an ensemble: `motion[i].events(…)`.

        Notes
        -----
        Times are the zeros of what the event watches, found to the last bits of the motion. A
        turning point of an ellipse is good to ε/(1 − b²/a²) of a swing where the motion is good to
        ε, except for `ExactMotion`, whose turning points come from its phase and are good to an ulp
        or two of the time. On a circle to the last bit there are none, but for `ExactMotion`, which
        has the limit of a slight wobble. In a vertical plane no azimuth is passed.
        """
        event, number = self._checked_event(kind, value)
        first, last = one_number(start, "The start", "s"), one_number(stop, "The stop", "s")
        least, most = self._event_span
        if not (isfinite(first) and isfinite(last) and least <= first <= last):
            bound = f"{least:.6g} s ≤ " if isfinite(least) else ""
            raise InvalidInput(
                f"Events are looked for between {bound}start ≤ stop, but from {first} s to "
                f"{last} s."
            )
        return self._find_events(event, number, (first, min(last, most)), MOST_EVENTS)

    def next_event(
        self,
        kind: EventKind,
        after: float = 0.0,
        within: float = 3600.0,
        value: float | None = None,
    ) -> float:
        """The first time of an event later than `after`, s.

        Looks `within` s ahead; raises EventNotFound where it does not come, and as `events`.
        """
        event, number = self._checked_event(kind, value)
        first, ahead = one_number(after, "after", "s"), one_number(within, "within", "s")
        least, most = self._event_span
        if not (first >= least and 0 < ahead < inf and isfinite(first)):
            bound = f"a time ≥ {least:.6g} s" if isfinite(least) else "a finite time"
            raise InvalidInput(
                f"An event is looked for within a positive time after {bound}, but within "
                f"{ahead} s after {first} s."
            )
        between = (float(np.nextafter(first, inf)), min(first + ahead, most))
        times = self._find_events(event, number, between, 1) if between[0] <= between[1] else ()
        if len(times) == 0:
            raise EventNotFound.of("no_event", event=event, within=(ahead, "s"), after=(first, "s"))
        return float(times[0])

    def to_xarray(self, t: ArrayLike) -> Dataset:
        """Position, velocity and tension at the times t, labelled, with units in the attributes.

        Dimensions (case_0, …, time, component); t in s, one axis. Needs xarray, which the extra
        [run] brings. Errors as in `position`.
        """
        require_extra("run", "to_xarray", "xarray")
        import xarray as xr  # only here: the library itself does without

        times = checked_times(t, 7 * self._count)
        if times.ndim != 1:
            raise InvalidInput(f"A data set needs times on one axis, but theirs are {times.shape}.")
        cases = tuple(f"case_{k}" for k in range(len(self.shape)))
        vector = (*cases, "time", "component")
        return xr.Dataset(
            {
                "position": (vector, self.position(times), {"units": "m", "origin": "support"}),
                "velocity": (vector, self.velocity(times), {"units": "m/s"}),
                "tension": ((*cases, "time"), self.tension(times), {"units": "N"}),
            },
            coords={
                "time": ("time", times, {"units": "s"}),
                "component": ("component", ["x", "y", "z"]),
            },
            attrs={
                "title": f"{type(self).__name__} of a spherical pendulum",
                "motion": repr(self),
                "axes": "z down from the support; x, y the plan view from above",
            },
        )

    @kept
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

    def __len__(self) -> int:
        if self.shape == ():
            raise TypeError("a single motion has no length; an ensemble has that of its first axis")
        return self.shape[0]

    def __bool__(self) -> bool:
        return True  # an empty ensemble is a motion all the same

    def __iter__(self) -> Iterator[Motion]:
        return (self[index] for index in range(len(self)))

    def __getitem__(self, key: Any) -> Motion:
        """The motions at an index, a slice or a mask, as NumPy takes them."""
        if self.shape == () and not (isinstance(key, tuple) and not key):
            raise IndexError("a single motion cannot be indexed; only an ensemble can")
        parts = {
            name: selected(value, self.shape, key) for name, value in self._arguments().items()
        }
        return type(self)(**parts)

    def __repr__(self) -> str:
        return short(type(self).__name__, self._arguments())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and self._arguments() == other._arguments()

    def __hash__(self) -> int:
        return hash((type(self), tuple(self._arguments().items())))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (type(self), self._arguments()))

    def __setattr__(self, name: str, value: object) -> None:
        if not name.startswith("_"):
            raise AttributeError(
                f"{name} of a motion cannot be set; make another {type(self).__name__}"
            )
        super().__setattr__(name, value)

    @property
    def _event_span(self) -> tuple[float, float]:
        """Between which times events are looked for, s."""
        return self.span

    @property
    def _count(self) -> int:
        return prod(self.shape)

    def _refuse_bad(self) -> None:
        """Raise InvalidInput for a single motion with a problem."""
        if self.shape == () and (problem := self._motions.problem(0)):
            raise InvalidInput.told(problem)

    def _constant(self, values: Numbers, *tail: int) -> Any:
        """A float for a single motion where nothing follows, else a read-only array."""
        if self.shape == () and not tail:
            return float(values.reshape(-1)[0])
        shaped = values.reshape((*self.shape, *tail))
        shaped.flags.writeable = False
        return shaped

    def _checked_event(self, kind: object, value: float | None) -> tuple[str, float]:
        """The kind, and its value or 0."""
        if self.shape != ():
            raise InvalidInput(
                f"Events are those of a single motion, but this is an ensemble of shape "
                f"{self.shape}; ask its motions one by one."
            )
        if not isinstance(kind, str) or kind not in _EVENTS:
            names = ", ".join(map(repr, _EVENTS))
            raise InvalidInput(f"The event must be one of {names}, but it is {kind!r}.")
        unit = _EVENTS[kind]
        if unit is None:
            if value is not None:
                raise InvalidInput(f'The event "{kind}" does not take a value, but it is {value}.')
            return kind, 0.0
        if value is None:
            raise InvalidInput(f'The event "{kind}" needs a value, the {kind} in {unit}.')
        number = one_number(value, f"The {kind}", unit)
        if not isfinite(number):
            raise InvalidInput(f"The {kind} must be finite, but it is {number} {unit}.")
        return kind, number

    def _find_events(
        self, kind: str, value: float, between: tuple[float, float], most: int
    ) -> Numbers:
        """Events of a single motion: here on a grid of its own states."""
        point = self.effective_pendulum
        step = event_step(between, float(point.angular_frequency))
        pendulum = [float(number) for number in point.values]
        return _core.events_on_a_grid(
            self._states, kind, value, between, self.span, step, most, pendulum
        )

    def _states(self, times: Numbers) -> tuple[Numbers, Numbers]:
        """Position and velocity at the same times."""
        return self.position(times), self.velocity(times)


def _again(make: type[Motion], arguments: dict[str, Any]) -> Motion:
    return make(**arguments)


def event_step(between: tuple[float, float], omega0: float) -> float:
    """A time, s, in which nothing happens twice: a 24th of a small half swing.

    Raises InvalidInput where the times of the interval are farther apart than that.
    """
    step = np.pi / (_GRID * omega0)
    far = max(between, key=abs)
    apart = float(np.spacing(abs(far)))
    if apart > step:
        raise InvalidInput(
            f"At {far:.6g} s times are known to {apart:.2g} s only, in which more than one event "
            f"happens; ask for earlier times."
        )
    return step
