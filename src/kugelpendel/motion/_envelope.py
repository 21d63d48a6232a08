"""The averaged motion of a real pendulum: days of it at once."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from functools import cached_property
from math import degrees
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar, Unpack, overload

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.errors import InvalidInput, MotionEnded
from kugelpendel.motion._budget import CAUSES, PrecessionBudget
from kugelpendel.motion._forced import ForcedMotion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._times import checked_grid, followed_times, one_time
from kugelpendel.parameters import (
    ForceParts,
    Forces,
    Launch,
    Numbers,
    Pendulum,
    Scalar,
    Scalar_co,
    one_truth,
)

_AHEAD = 1e8
"""s: how far an end of the motion is looked for, some three years."""

_DAY = 86400.0
"""s: over which `trust` says how far the azimuth is off."""

_WARN = 0.01
"""Forces that change a swing by more than this share of it: a warning with the measured error.

The mean motion is then off by 1e-3 … 2e-2 of the amplitude within 100 swings of 0.05 l, and by up
to 0.13 of it at 0.3 l (benchmarks/envelope.py).
"""

_FAR = 5.0
"""Degrees that the azimuth may be off within a day: beyond, a warning.

Not under a drive, whose bound is up to some hundreds of times what is measured (docs/real.md).
"""

_FORCES = (
    "linear drag",
    "quadratic drag",
    "suspension's anisotropy",
    "suspension's damping",
    "drive",
)

_SWINGS = 100
"""Swings over which that error is measured."""


class Settled(NamedTuple):
    """What planes come to: a number of each motion, in arrays of the motion's shape.

    Each is looked at for four turns of the Earth, or until it has gone round or stood for one: a
    driven one once it has settled, one that dies away sooner until a tenth of its amplitude is
    left; at 400 times in each turn, or in that life (crates/kugelpendel/src/plane/settled.rs). NaN
    without a turning ground, where the motion ends before, and where it would take longer than 120
    days.

    Attributes
    ----------
    verdict
        0 where the plane goes round, 1 where it swings to and fro, 2 where it stands.
    since, until
        From when and until when it was looked at, s after the launch.
    turned
        By how much it turned then, rad, counter-clockwise.
    low, high
        The azimuths between which it was in the last turn, or in that life, rad, as
        `EnvelopeMotion.azimuth` has them.
    largest_b
        The largest |b| in the same time, m.
    a
        Half the length of the swing at the end, m.
    dies
        1 where the swing dies away, else 0.
    """

    verdict: Numbers
    since: Numbers
    until: Numbers
    turned: Numbers
    low: Numbers
    high: Numbers
    largest_b: Numbers
    a: Numbers
    dies: Numbers


class ClampOrbits(NamedTuple):
    """Orbits on the portrait of a clamp: a number of each motion, in arrays of its shape.

    Attributes
    ----------
    verdict
        As that of `Settled`.
    rate
        The mean rate of the plane, rad/s, counter-clockwise.
    """

    verdict: Numbers
    rate: Numbers


class PlaneCourse(NamedTuple):
    """What planes do up to a time: a number of each motion, in arrays of its shape.

    NaN where the motion ends before. Errors beside those of the motion, as the tests of
    crates/kugelpendel/src/plane/course.rs measure them.

    Attributes
    ----------
    largest_b
        The largest |b|, m, to 1e-4 of itself.
    quarter_turn
        When the plane has turned by a quarter of a turn, either way, s, to 1e-12 rad of the plane;
        infinite where it does not.
    stands_since
        Since when it stands, s, as `Apsides.stands_since` has it; infinite where it does not.
    """

    largest_b: Numbers
    quarter_turn: Numbers
    stands_since: Numbers


class PlanePace(NamedTuple):
    """Rates of planes, in the sense in which the Earth turns them, in arrays of the motion's shape.

    Clockwise where the ground does not turn; to 1e-3 of their difference, beside the motion's
    errors. NaN where the motion ends before.

    Attributes
    ----------
    slowest, fastest
        The least and the largest rate, rad/s.
    """

    slowest: Numbers
    fastest: Numbers


_Told = TypeVar("_Told", Settled, ClampOrbits, PlaneCourse, PlanePace)


class EnvelopeMotion(ForcedMotion[Scalar_co]):
    """A real pendulum, averaged over its swings: an ellipse that turns, shrinks and widens.

    What `RealMotion` integrates swing by swing goes in some dozens of steps here, over days. Arrays
    in what is given broadcast to an ensemble.

    Parameters
    ----------
    pendulum, launch, forces, site, drag, suspension, bob, drive
        As for `RealMotion`; the horizontal part of the Earth's rotation averages out.
    exact
        Whether every force is averaged over the exact swing, at any amplitude; otherwise over
        harmonic swings, with Olsson's (25) and (26) for their rates.

    Raises
    ------
    InvalidInput
        For what `RealMotion` would refuse, a launch that rises to the support, a drive that pumps
        without end, anisotropies beyond a tenth of ω0 and a linear drag beyond half of it. In an
        ensemble a bad case gives NaN, and `reason` says why.

    Warns
    -----
    UserWarning
        Where a force changes a swing by more than a hundredth of itself: with the error, measured
        against `RealMotion` over 100 swings. Else where, without a drive, the azimuth may be off by
        more than 5° within a day.

    Notes
    -----
    Semi-axes are the turning radii of the mean motion. A drive's pushes and the horizontal part of
    the Earth's rotation come and go within a swing, about that mean; but for these, place and
    velocity at t = 0 are those of the launch. What is left out is of second order in the forces;
    `trust` says how far the azimuth may be off over a day; docs/scripts/averaging.py measures it
    force by force, studies/mixtures.py for mixtures of them.
    Sources: the averages are in docs/conventions.md; Olsson (1981), eq. (25), (26).
    """

    @overload
    def __init__(
        self: EnvelopeMotion[float],
        pendulum: Pendulum[float],
        launch: Launch[float],
        forces: Forces[float] | None = None,
        *,
        exact: bool = ...,
        **parts: Unpack[ForceParts[float]],
    ) -> None: ...

    @overload
    def __init__(
        self: EnvelopeMotion[Scalar],
        pendulum: Pendulum[Scalar] | Pendulum[float],
        launch: Launch[Scalar] | Launch[float],
        forces: Forces[Scalar] | Forces[float] | None = None,
        *,
        exact: bool = ...,
        **parts: Unpack[ForceParts[Scalar]],
    ) -> None: ...

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
        forces: Forces[Scalar_co] | Forces[float] | None = None,
        *,
        exact: bool = True,
        **parts: Unpack[ForceParts[Scalar_co]],
    ):
        self._give(pendulum, launch, forces, parts)
        self._exact = one_truth(exact, "The option exact")
        self._motions = _core.EnvelopeMotions(*self._columns, self._exact)
        self._refuse_bad()
        name, strength = self._strongest
        if strength > _WARN:
            warnings.warn(self._caution(name, strength), stacklevel=2)
        elif self.drive is None and (off := degrees(self._motions.azimuth_error(_DAY))) > _FAR:
            warnings.warn(
                f"On swings as wide as this the averaged azimuth may be off by {off:.2g}° within "
                f"24 h. Use RealMotion, or smaller swings.",
                stacklevel=2,
            )

    if TYPE_CHECKING:  # one of an ensemble may be a single motion: its type knows its class alone

        def __getitem__(self, key: Any) -> EnvelopeMotion: ...
        def __iter__(self) -> Iterator[EnvelopeMotion]: ...

    def _arguments(self) -> dict[str, Any]:
        other = {} if self._exact else {"exact": False}
        return {**super()._arguments(), **other}

    @property
    def exact(self) -> bool:
        """Whether ω and Ω are those of the closed form."""
        return self._exact

    @kept
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which all motions of the ensemble can be asked.

        Where drag takes amplitude, there was more of it before: the first time is where the bob
        would have been level with the support. A driven pendulum begins with its launch.
        """
        spans = self._motions.span(_AHEAD).reshape(-1, 2)
        spans = spans[np.isfinite(spans).all(axis=-1) | np.isinf(spans).any(axis=-1)]
        first = float(spans[:, 0].max(initial=-np.inf))
        last = float(spans[:, 1].min(initial=np.inf))
        return (max(first, 0.0) if self.drive is not None else first, last)

    @cached_property
    def _strongest(self) -> tuple[str, float]:
        """What changes a swing the most, and by which share of itself."""
        strengths = self._motions.strengths()
        largest = max(range(len(strengths)), key=strengths.__getitem__)
        return (_FORCES[largest], strengths[largest])

    def _caution(self, name: str, strength: float) -> str:
        measured = "."
        if self.shape == ():
            error = self._motions.measured_error(_SWINGS)
            measured = (
                f": against RealMotion it is off by {error:.2g} of the amplitude within {_SWINGS} "
                f"swings."
            )
        return (
            f"The {name} changes a swing by {strength:.2g} of itself, much for an averaged motion"
            f"{measured} Use RealMotion."
        )

    @property
    def trust(self) -> str:
        """Where the motion holds, and how far the azimuth may be off within a day."""
        name, strength = self._strongest
        error = self._motions.azimuth_error(_DAY)
        if strength == 0.0 and error == 0.0:
            return "Swings below the support; without forces, exact."
        wavering = ""
        if strength > 0.0:
            wavering = (
                f" The forces change them little in one swing, here by {strength:.1g} of the swing "
                f"({name}); by about half of that it wavers about the mean."
            )
        return (
            f"Swings below the support: the azimuth is within {degrees(error):.2g}° over 24 h, a "
            f"bound of what was measured against the full equations (docs/real.md).{wavering} Next "
            f"to a circle the azimuth, and what a drive does, mean little."
        )

    def semi_axes(self, t: ArrayLike) -> Numbers:
        """Turning radii a ≥ |b| of the mean motion, m: shape (*shape, *t.shape, 2).

        b is positive where the ellipse is run through counter-clockwise. Errors as in `position`.
        """
        return self._read("semi_axes", t, 2)

    def azimuth(self, t: ArrayLike) -> Numbers:
        """ψ of the major axis, rad, counter-clockwise from x: shape (*shape, *t.shape).

        Continuous along the motion, so it may leave ±π; at t = 0 towards the turning point that
        is the nearest to the launch. A circle has no axis. Errors as in `position`.
        """
        return self._read("azimuth", t)

    def phase(self, t: ArrayLike) -> Numbers:
        """Θ, rad: shape (*shape, *t.shape); grows by π from one outer turning point to the next.

        Continuous; 0 at the turning point at ψ that is the nearest to the launch. Errors as in
        `position`.
        """
        return self._read("phase", t)

    def rates(self, t: ArrayLike) -> PrecessionBudget:
        """What turns the plane at these times, cause by cause; errors as in `position`."""
        rates = self._read("rates", t, len(CAUSES) + 2)
        times = np.asarray(t, dtype=np.float64)
        return PrecessionBudget(times, self.azimuth(t), *np.moveaxis(rates, -1, 0))

    def settled(self) -> Settled:
        """What the plane comes to with all that acts, for many motions at once."""
        return self._told(Settled, self._motions.settled())

    def clamp_orbits(self) -> ClampOrbits:
        """What `Portrait` says of the launches, without drag and drive, for many at once."""
        return self._told(ClampOrbits, self._motions.orbits())

    def course(self, until: float) -> PlaneCourse:
        """What the plane does from the launch to a time in s after it.

        Raises InvalidInput for what is no time, or one before the launch.
        """
        return self._told(PlaneCourse, self._motions.course(one_time(until, "The end")))

    def pace(self, start: float, stop: float) -> PlanePace:
        """How fast the plane turns between two times in s; raises InvalidInput as `course`."""
        between = [one_time(start, "The start"), one_time(stop, "The stop")]
        if between[0] > between[1]:
            raise InvalidInput(
                f"The start must not be later than the stop, but they are {between[0]} s and "
                f"{between[1]} s."
            )
        return self._told(PlanePace, self._motions.pace(between))

    def _told(self, kind: type[_Told], rows: Numbers) -> _Told:
        """What the core tells of each motion, an array of each number under its name."""
        width = len(kind._fields)
        return kind(*np.moveaxis(rows.reshape((*self.shape, width)), -1, 0))

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3).

        On the exact motion between the turning radii of that time. Raises InvalidInput for times
        that are not finite, and MotionEnded for a single motion out of its span; in an ensemble it
        is NaN there.
        """
        return self._read("position", t, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); t and errors as in `position`.

        The rate of `position`, but for its slow changes beyond the swing's fundamental.
        """
        return self._read("velocity", t, 3)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3); errors as in `position`."""
        size = checked_grid(start, step, count, 3 * self._count)
        return self.position(float(start) + float(step) * np.arange(size))

    def _read(self, what: str, t: ArrayLike, *tail: int) -> Numbers:
        times = followed_times(t, (tail[0] if tail else 1) * self._count)
        if self.drive is not None and times.size and times.min() < 0:
            raise InvalidInput(
                f"A driven pendulum cannot be followed back before its launch, but asked for is "
                f"{times.min():.6g} s."
            )
        flat, ends = self._motions.read(what, times.ravel())
        if self.shape == () and np.isfinite(ends[0]):
            asked = {"first": (float(times.min()), "s"), "last": (float(times.max()), "s")}
            raise MotionEnded.of("averaged_to_support", time=(float(ends[0]), "s"), **asked)
        return flat.reshape((*self.shape, *times.shape, *tail))
