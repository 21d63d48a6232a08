"""The pendulum that the questions are about, and the motions that check the answers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

from kugelpendel import _core
from kugelpendel.motion import ExactMotion, RealMotion
from kugelpendel.parameters import (
    Drag,
    Drive,
    Forces,
    InvalidInput,
    Launch,
    Numbers,
    Pendulum,
    Suspension,
    Wire,
)

MOST_SWINGS = 100_000
"""A run of more swings would take more than some seconds, and is left out."""

_FINE, _COARSE = 1e-17, 1e-12
"""Tolerances: the coarse one is for many swings whose phase nobody asks for."""


@dataclass(frozen=True)
class Case:
    """One pendulum, its swing, what acts on it, and what is asked; all single, in SI.

    a and b are the turning radii of the swing as seen from a frame that does not turn.
    """

    pendulum: Pendulum
    a: float
    b: float
    azimuth: float
    forces: Forces
    wire: Wire | None
    share: float
    after: float
    radius: float | None
    time: float | None
    checked: bool
    worked: Callable[[], None] = field(default=lambda: None, repr=False, compare=False)

    def __post_init__(self) -> None:
        _refuse_ensembles(self)
        _refuse_numbers(self)
        _refuse_heavy_losses(self)
        site = self.forces.site
        if site is not None and site.gravity_given and float(site.gravity) != self.gravity:
            raise InvalidInput(
                f"The site's gravity is {float(site.gravity):.9g} m/s², the pendulum's is "
                f"{self.gravity:.9g} m/s²; give the pendulum that of the site, or leave out the "
                "site's."
            )

    @property
    def length(self) -> float:
        """l, m."""
        return float(self.pendulum.length)

    @property
    def gravity(self) -> float:
        """g, m/s²."""
        return float(self.pendulum.gravity)

    @cached_property
    def effective(self) -> Pendulum:
        """The point mass that swings as the bob does."""
        return self.forces.effective_pendulum(self.pendulum)

    @property
    def omega(self) -> float:
        """ω0 with the bob's corrections, rad/s."""
        return float(self.effective.angular_frequency)

    @cached_property
    def exact(self) -> ExactMotion:
        """The swing without Earth, air or suspension."""
        return ExactMotion(self.effective, Launch.apsides(self.a, self.b, self.azimuth))

    @property
    def swing(self) -> float:
        """Period of the swing, there and back, s."""
        return 2 * float(self.exact.radial_period)

    @property
    def earth(self) -> float:
        """Ω_z, rad/s; 0 without a site."""
        return 0.0 if self.forces.site is None else float(self.forces.site.vertical_rotation)

    def ground(self, a: float) -> float:
        """Speed across the swing that rest against the floor is, m/s, at a from the axis.

        Ω_z a − (2/3)(a²/l) Ω_h sin(azimuth): the second is what the Coriolis force on the bob's
        fall and rise leaves of it, docs/design.md.
        """
        if self.forces.site is None:
            return 0.0
        level = float(self.forces.site.horizontal_rotation) * math.sin(self.azimuth)
        return self.earth * a - 2 / 3 * a**2 / self.length * level

    @cached_property
    def fading(self) -> _core.Decay:
        """How the drag takes from a plane swing: a' = −γa − ka², k = (4/3π) c ω0."""
        linear, quadratic = (0.0, 0.0) if self.forces.drag is None else self.forces.drag.values
        return _core.Decay(float(linear), float(quadratic), self.omega)

    @property
    def linear(self) -> float:
        """γ, 1/s."""
        return 0.0 if self.forces.drag is None else float(self.forces.drag.linear)

    @property
    def decay(self) -> float:
        """−a'/a at the given amplitude, 1/s."""
        return self.fading.rate(self.a)

    @property
    def numbers(self) -> tuple[float, float, float]:
        """Length, gravity and mass of the point mass that swings as the bob does."""
        length, gravity, mass = (float(value) for value in self.effective.values)
        return length, gravity, mass

    def averaged(
        self, b: float, forces: Forces
    ) -> tuple[list[float], tuple[float, float, float], dict[str, Numbers]]:
        """What the core takes for the averaged motion of this swing, b wide, under some forces."""
        given = [float(value) for value in self.pendulum.values]
        return given, (self.a, b, self.azimuth), forces.columns(())

    @property
    def stiffness(self) -> float:
        """δ, rad/s; 0 for an even suspension."""
        return 0.0 if self.forces.suspension is None else float(self.forces.suspension.anisotropy)

    @property
    def damping(self) -> float:
        """Δγ, 1/s; 0 for an even suspension."""
        suspension = self.forces.suspension
        return 0.0 if suspension is None else float(suspension.damping_anisotropy)

    def launch(self, b: float, *, turning: bool, a: float | None = None) -> Launch:
        """From the outer turning point, so that the ellipse is a by b where nothing turns.

        Where the Earth turns below (turning), the speed against the floor is less by `ground`.
        """
        out = self.a if a is None else a
        apsides = ExactMotion(self.effective, Launch.apsides(out, b))
        sideways = float(apsides.velocity(0.0)[1]) - (self.ground(out) if turning else 0.0)
        return self.pushed(out, sideways)

    def pushed(self, a: float, sideways: float) -> Launch:
        """Displaced by a along the azimuth, with a speed across it."""
        along, across = math.cos(self.azimuth), math.sin(self.azimuth)
        return Launch.plane(a * along, a * across, -sideways * across, sideways * along)

    def run(
        self,
        launch: Launch,
        *,
        site: bool = False,
        drag: bool | Drag = False,
        suspension: bool | Suspension = False,
        drive: Drive | None = None,
        fine: bool = True,
    ) -> RealMotion:
        """The full equations with the bob, and with what is named of the rest."""
        forces = Forces(
            site=self.forces.site if site else None,
            drag=(self.forces.drag if drag else None) if isinstance(drag, bool) else drag,
            suspension=(self.forces.suspension if suspension else None)
            if isinstance(suspension, bool)
            else suspension,
            bob=self.forces.bob,
            drive=drive,
        )
        return RealMotion(self.pendulum, launch, forces, tolerance=_FINE if fine else _COARSE)


def _refuse_ensembles(case: Case) -> None:
    given = {"pendulum": case.pendulum, **case.forces.parts, "wire": case.wire}
    for name, part in given.items():
        if part is not None and part.shape != ():
            raise InvalidInput(
                f"A design answers for one pendulum, but the {name} has the shape {part.shape}; "
                "ask for each case by itself."
            )


def _refuse_numbers(case: Case) -> None:
    l = case.length  # noqa: E741
    if not 0 < case.a < l:
        raise InvalidInput(
            f"The amplitude a must lie between 0 and the length {l:.6g} m, but it is "
            f"{case.a:.6g} m; count it horizontally, from the axis."
        )
    if not abs(case.b) <= case.a / 2:
        raise InvalidInput(
            f"b = {case.b:.6g} m must not exceed half the amplitude, a = {case.a:.6g} m: the "
            "questions are those of a swing; for rounder ellipses use kp.RealMotion."
        )
    if not math.isfinite(case.azimuth):
        raise InvalidInput(f"The azimuth must be finite, but it is {case.azimuth} rad.")
    if not 0 < case.share < 1:
        raise InvalidInput(
            f"The share of the Foucault rate must lie between 0 and 1, but it is {case.share:.6g}; "
            "1 % is 0.01."
        )
    if not 0 < case.after < math.inf:
        raise InvalidInput(
            f"The time after which the amplitude is asked must be positive and finite, but it is "
            f"{case.after:.6g} s."
        )
    if case.radius is not None and not abs(case.b) < case.radius < case.a:
        raise InvalidInput(
            f"The radius to pass must lie between |b| = {abs(case.b):.6g} m and a = "
            f"{case.a:.6g} m, but it is {case.radius:.6g} m: the bob does not come there."
        )
    if case.time is not None and not 0 <= case.time < math.inf:
        raise InvalidInput(
            f"The time after the closest approach must be finite and not negative, but it is "
            f"{case.time:.6g} s."
        )


_MOST_LOSS = 0.05
"""Of ω0: decay rates and anisotropies beyond it make no swing that lasts."""


def _refuse_heavy_losses(case: Case) -> None:
    stiff = damping = 0.0
    if case.forces.suspension is not None:
        stiff = abs(float(case.forces.suspension.anisotropy))
        damping = abs(float(case.forces.suspension.damping_anisotropy))
    for name, rate, unit in (
        ("drag takes", case.decay, "1/s"),
        ("suspension's anisotropy is", stiff, "rad/s"),
        ("suspension's damping anisotropy is", damping, "1/s"),
    ):
        if rate > _MOST_LOSS * case.omega:
            raise InvalidInput(
                f"The {name} {rate:.4g} {unit}, more than {_MOST_LOSS:g} of the swing's "
                f"{case.omega:.4g} rad/s: averages over a swing, and so the builder's formulas, do "
                "not hold; use kp.RealMotion."
            )
