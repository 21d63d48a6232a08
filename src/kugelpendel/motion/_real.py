"""The motion of a real pendulum: the full equations, integrated."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.motion._base import one_number
from kugelpendel.motion._pumping import refuse_pumping
from kugelpendel.motion._surrounded import Surrounded
from kugelpendel.motion._surroundings import Surroundings
from kugelpendel.motion._times import checked_grid, checked_times
from kugelpendel.parameters import (
    Bob,
    Drag,
    Drive,
    InvalidInput,
    Launch,
    Numbers,
    Pendulum,
    Site,
    Suspension,
)

Thread: TypeAlias = Literal["ends", "flies", "rod"]

_THREADS = ("ends", "flies", "rod")
_FINEST = 1e-17


class RealMotion(Surrounded):
    """A pendulum on the turning Earth, in air, on an imperfect suspension, driven or not.

    The full equations on the sphere, integrated by Taylor series of order 20 with dense output.
    Arrays in what is given broadcast to an ensemble, which is integrated on all processors.

    Parameters
    ----------
    pendulum
        What swings; its gravity is the one that acts.
    launch
        Position and velocity at t = 0, as seen from the ground.
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
        tolerance. In an ensemble a bad launch or pendulum gives NaN, and `reason` says why.

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
        *,
        site: Site | None = None,
        drag: Drag | None = None,
        suspension: Suspension | None = None,
        bob: Bob | None = None,
        drive: Drive | None = None,
        thread: Thread = "ends",
        tolerance: float = _FINEST,
    ):
        around = Surroundings(pendulum, launch, site, drag, suspension, bob, drive)
        if thread not in _THREADS:
            raise InvalidInput(
                f"The thread must be one of {', '.join(map(repr, _THREADS))}, but it is {thread!r}."
            )
        tolerance = one_number(tolerance, "The tolerance", "")
        if not 0 < tolerance <= 1e-3:
            raise InvalidInput(
                f"The tolerance must lie between 0 and 1e-3, but it is {tolerance:g}; leave it out "
                f"for the finest."
            )
        refuse_pumping(around.effective_pendulum, launch, drag, drive)
        self._around = around
        self._thread: Thread = thread
        self._tolerance = tolerance
        self._motions = _core.RealMotions(
            around.count,
            around.pendulum_columns,
            (launch.kind, around.launch_columns),
            around.forces,
            (around.drive_kind, around.drive_columns),
            thread,
            tolerance,
        )
        self._refuse_bad()

    def _arguments(self) -> dict[str, Any]:
        options = {"thread": (self._thread, "ends"), "tolerance": (self._tolerance, _FINEST)}
        other = {name: value for name, (value, usual) in options.items() if value != usual}
        return {**super()._arguments(), **other}

    def _problems(self) -> Iterable[tuple[int, str]]:
        return self._motions.problems()

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

    @property
    def trust(self) -> str:
        """Where the motion holds."""
        return "Everywhere, as far as the forces are known; errors of the integration grow slowly."

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3).

        Raises InvalidInput for times that are not finite or before the span, and for a single
        motion that has ended; in an ensemble it is NaN from its end on.
        """
        times = self._times(t, 3)
        return self._shaped(*self._motions.position(times.ravel()), times, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); t and errors as in `position`."""
        times = self._times(t, 3)
        return self._shaped(*self._motions.velocity(times.ravel()), times, 3)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3); errors as in `position`."""
        size = checked_grid(start, step, count, 3 * self._around.count)
        return self.position(float(start) + float(step) * np.arange(size))

    def tension(self, t: ArrayLike) -> Numbers:
        """Pull of the thread, N: shape (*shape, *t.shape); errors as in `position`.

        0 in flight, negative where a rod pushes. Without the weight of the thread itself.
        """
        times = self._times(t, 1)
        return self._shaped(*self._motions.tension(times.ravel()), times)

    @property
    def _first_event(self) -> float:
        return 0.0

    def _find_events(
        self, kind: str, value: float, between: tuple[float, float], most: int
    ) -> Numbers:
        return self._motions.events(kind, value, between, most)

    def _times(self, t: ArrayLike, numbers_each: int) -> Numbers:
        times = checked_times(t, numbers_each * self._around.count)
        first = self.span[0]
        if times.size and times.min() < first:
            raise InvalidInput(
                f"A driven or flying pendulum cannot be followed back before its launch, but "
                f"asked for is {times.min():.6g} s."
            )
        return times

    def _shaped(self, flat: Numbers, ends: Numbers, times: Numbers, *tail: int) -> Numbers:
        if self.shape == () and np.isfinite(ends[0]):
            raise InvalidInput(
                f"The thread goes slack at {ends[0]:.9g} s, where the motion ends; asked for are "
                f"times from {times.min():.6g} s to {times.max():.6g} s. Keep between, or let it "
                f'fly on: thread="flies", or thread="rod".'
            )
        return flat.reshape((*self.shape, *times.shape, *tail))
