"""The motion of a real pendulum: the full equations, integrated."""

from __future__ import annotations

from collections.abc import Iterator
from math import prod
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, Unpack, cast, overload

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.errors import InvalidInput
from kugelpendel.motion._forced import ForcedMotion
from kugelpendel.motion._times import followed_times
from kugelpendel.motion._walk import SteppedMotion
from kugelpendel.parameters import (
    ForceParts,
    Forces,
    Launch,
    Numbers,
    Pendulum,
    Scalar,
    Scalar_co,
    column,
    one_number,
)

Thread: TypeAlias = Literal["ends", "flies", "rod"]

_THREADS = ("ends", "flies", "rod")
_FINEST = 1e-17
_LOOKED = 1000
"""Small swings over which an end is looked for."""


class RealCourse(NamedTuple):
    """What real motions do up to a time: arrays of the motion's shape.

    Of more than 4096 outer turning points evenly spread ones count, 2048 at least. NaN where the
    motion ends before.

    Attributes
    ----------
    largest_b
        The largest |b| at any outer turning point, m.
    least_tension, largest_tension
        The least and the largest pull of the thread at the launch, at the turning points and at the
        end, N.
    quarter_turn
        When the plane has turned by a quarter of a turn, either way, s; infinite where it does not.
    stands_since
        Since when it stands, s, as `Apsides.stands_since` has it; infinite where it does not.
    a, b, azimuth
        The ellipse at each of the times, with one axis more for them: m, m, b positive
        counter-clockwise, and rad, continuous, counter-clockwise. In a straight line between the
        outer turning points before and after; NaN where there are fewer than two. Of an ideal
        motion they are right to 1e-9 (crates/kugelpendel/src/meaning/followed.rs).
    """

    largest_b: Numbers
    least_tension: Numbers
    largest_tension: Numbers
    quarter_turn: Numbers
    stands_since: Numbers
    a: Numbers
    b: Numbers
    azimuth: Numbers


class RealMotion(ForcedMotion[Scalar_co], SteppedMotion[Scalar_co]):
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
    Every request goes on from the last checkpoint before it; the result is the same as from the
    launch. Memory does not grow with the span.
    Sources: Olsson (1981), eq. (4), with the Coriolis force, drag and the suspension's anisotropy
    added; Jorba & Zou, Experimental Mathematics 14, 99 (2005) for the integration. Signs and forms
    of the forces are in docs/conventions.md.
    """

    @overload
    def __init__(
        self: RealMotion[float],
        pendulum: Pendulum[float],
        launch: Launch[float],
        forces: Forces[float] | None = None,
        *,
        thread: Thread = ...,
        tolerance: float = ...,
        **parts: Unpack[ForceParts[float]],
    ) -> None: ...

    @overload
    def __init__(
        self: RealMotion[Scalar],
        pendulum: Pendulum[Scalar] | Pendulum[float],
        launch: Launch[Scalar] | Launch[float],
        forces: Forces[Scalar] | Forces[float] | None = None,
        *,
        thread: Thread = ...,
        tolerance: float = ...,
        **parts: Unpack[ForceParts[Scalar]],
    ) -> None: ...

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
        forces: Forces[Scalar_co] | Forces[float] | None = None,
        *,
        thread: Thread = "ends",
        tolerance: float = _FINEST,
        **parts: Unpack[ForceParts[Scalar_co]],
    ):
        if str(thread) not in _THREADS:
            raise InvalidInput(
                f"The thread must be one of {', '.join(map(repr, _THREADS))}, but it is {thread!r}."
            )
        tolerance = one_number(tolerance, "The tolerance", "")
        if not 0 < tolerance <= 1e-3:
            raise InvalidInput(
                f"The tolerance must lie between 0 and 1e-3, but it is {tolerance:g}; leave it out "
                f"for the finest."
            )
        self._give(pendulum, launch, forces, parts)
        self._thread: Thread = thread
        self._tolerance = tolerance
        self._motions = _core.RealMotions(*self._columns, thread, tolerance)
        self._refuse_bad()

    if TYPE_CHECKING:  # one of an ensemble may be a single motion: its type knows its class alone

        def __getitem__(self, key: Any) -> RealMotion: ...
        def __iter__(self) -> Iterator[RealMotion]: ...

    def _arguments(self) -> dict[str, Any]:
        options = {"thread": (self._thread, "ends"), "tolerance": (self._tolerance, _FINEST)}
        other = {name: value for name, (value, usual) in options.items() if value != usual}
        return {**super()._arguments(), **other}

    @property
    def thread(self) -> Thread:
        """What happens where its pull reaches zero."""
        return self._thread

    @property
    def tolerance(self) -> float:
        """The tolerance of the integration."""
        return self._tolerance

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s, between which all motions of the ensemble can be asked.

        A push or a jerk of the thread cannot be undone, so a driven pendulum and one that flies
        begin with their launch. A thread that "ends" ends the motion where it goes slack, forwards
        or backwards, and backwards in time quadratic drag may let the speed grow beyond all bounds.
        Such ends are looked for over a thousand small swings each way, or 100 000 steps if those
        are fewer; later ones are known once the motion has been followed so far. A free pendulum
        with too little energy to come near the height of its support has no end.
        """
        swings = 2 * np.pi * _LOOKED / self.angular_frequency
        return self._span_within(column(swings, self.shape))

    def course(self, times: ArrayLike) -> RealCourse:
        """What the motion does from the launch to the last of some times, s, on one axis.

        Raises InvalidInput for times that do not ascend or begin before the launch.
        """
        asked = followed_times(times, 3 * prod(self.shape))
        if asked.ndim != 1 or not asked.size or asked[0] < 0 or (np.diff(asked) < 0).any():
            raise InvalidInput(
                "The times of a course must ascend on one axis, the first of them at 0 s or later; "
                "sort them, and leave out those before the launch."
            )
        values = (*self.effective_pendulum.values, self.rotation)
        columns = [column(np.asarray(value, np.float64), self.shape) for value in values]
        motions = cast("_core.RealMotions", self._motions)
        rows = motions.course(columns, asked).reshape((*self.shape, 5 + 3 * asked.size))
        ellipses = rows[..., 5:].reshape((*self.shape, asked.size, 3))
        return RealCourse(*np.moveaxis(rows[..., :5], -1, 0), *np.moveaxis(ellipses, -1, 0))

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return "Everywhere, as far as the forces are known; errors of the integration grow slowly."

    def _check_start(self, first: float) -> None:
        if first < 0 and (self.drive is not None or self.thread == "flies"):
            raise InvalidInput(
                f"A driven or flying pendulum cannot be followed back before its launch, but "
                f"asked for is {first:.6g} s."
            )

    def _ended(self, why: str) -> tuple[str, dict[str, str]]:
        return why, {}
