"""What the air takes away."""

# One number is array-like too, so overloads for it come first.
# pyright: reportOverlappingOverload=false

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel.parameters._bob import Bob
from kugelpendel.parameters._derived import Origin, derived
from kugelpendel.parameters._given import Given, require_type
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co, Scalars, as_numbers
from kugelpendel.parameters._pendulum import Pendulum


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Drag(Given[Scalar_co]):
    """A force −2γv − c|v|v per unit mass, or an ensemble of them where arrays are given.

    Parameters
    ----------
    linear
        γ, 1/s, not negative: alone it makes the amplitude fall as e^(−γt).
    quadratic
        c, 1/m, not negative: alone it makes a plane swing's amplitude fall as
        a/(1 + (4/3π) c ω0 a t).

    Raises
    ------
    InvalidInput
        For a single number that is negative or not finite, and for arrays that do not broadcast.
        In an ensemble a bad case becomes NaN in the motion, which gives the reason.

    Notes
    -----
    Source of the two terms and of their effect on the amplitude: R. A. Nelson and M. G. Olsson,
    Am. J. Phys. 54, 112 (1986), section on damping.
    """

    linear: Scalar_co
    quadratic: Scalar_co

    part = "drag"
    units: ClassVar = {"linear": "1/s", "quadratic": "1/m"}
    strengths = ("linear", "quadratic")

    @overload
    def __init__(
        self: Drag[float], linear: OneNumber = ..., quadratic: OneNumber = ...
    ) -> None: ...

    @overload
    def __init__(
        self: Drag[Numbers], linear: ArrayLike = ..., quadratic: ArrayLike = ...
    ) -> None: ...

    def __init__(self, linear: ArrayLike = 0.0, quadratic: ArrayLike = 0.0):
        self._give("the linear and the quadratic drag", linear=linear, quadratic=quadratic)

    @overload
    @classmethod
    def from_quality(cls, quality: OneNumber, pendulum: Pendulum[float]) -> Drag[float]: ...

    @overload
    @classmethod
    def from_quality(cls, quality: ArrayLike, pendulum: Pendulum) -> Drag: ...

    @classmethod
    def from_quality(cls, quality: ArrayLike, pendulum: Pendulum) -> Drag:
        """Linear drag from the quality factor: γ = ω0/(2Q).

        Q is 2π times the energy over what a swing loses of it, or π times the number of swings in
        which the amplitude falls to 1/e; ω0 is the pendulum's `angular_frequency`. Raises
        InvalidInput for a single quality that is not positive and finite; in an ensemble such a
        case becomes NaN.
        """
        require_type("The pendulum", pendulum, Pendulum)
        given = {
            "drag.quality": as_numbers(quality, "drag.quality", ""),
            "pendulum.angular_frequency": pendulum.angular_frequency,
        }
        what = "linear_from_quality"
        drag: Drag = Drag(derived(what, "the quality and the pendulum", given))
        return drag._derived_from(linear=Origin(what, given))

    @overload
    @classmethod
    def from_half_life(cls, half_life: OneNumber) -> Drag[float]: ...

    @overload
    @classmethod
    def from_half_life(cls, half_life: ArrayLike) -> Drag[Numbers]: ...

    @classmethod
    def from_half_life(cls, half_life: ArrayLike) -> Drag:
        """Linear drag from the time, s, in which the amplitude falls to half: γ = ln 2/t.

        The amplitude, not the energy, whose half life is half as long. Raises InvalidInput for a
        single half life that is not positive and finite; in an ensemble such a case becomes NaN.
        """
        given = {"drag.half_life": as_numbers(half_life, "drag.half_life", "s")}
        what = "linear_from_half_life"
        drag: Drag = Drag(derived(what, "the half life", given))
        return drag._derived_from(linear=Origin(what, given))

    @overload
    @classmethod
    def from_bob(
        cls,
        bob: Bob[float],
        pendulum: Pendulum[float],
        *,
        air_viscosity: OneNumber = ...,
        drag_coefficient: OneNumber = ...,
        thread_diameter: OneNumber = ...,
        thread_drag_coefficient: OneNumber = ...,
    ) -> Drag[float]: ...

    @overload
    @classmethod
    def from_bob(
        cls,
        bob: Bob,
        pendulum: Pendulum,
        *,
        air_viscosity: ArrayLike = ...,
        drag_coefficient: ArrayLike = ...,
        thread_diameter: ArrayLike = ...,
        thread_drag_coefficient: ArrayLike = ...,
    ) -> Drag: ...

    @classmethod
    def from_bob(
        cls,
        bob: Bob,
        pendulum: Pendulum,
        *,
        air_viscosity: ArrayLike = 1.81e-5,
        drag_coefficient: ArrayLike = 0.44,
        thread_diameter: ArrayLike = 0.0,
        thread_drag_coefficient: ArrayLike = 1.1,
    ) -> Drag:
        """An estimate for a smooth ball in still air.

        Parameters
        ----------
        bob
            Its radius, density and the density of the air.
        pendulum
            Its length and frequency.
        air_viscosity
            η, Pa·s; the default is that of air at 15 to 20 °C.
        drag_coefficient
            Of the ball, 1: 0.44 between Reynolds numbers of 750 and 2·10⁵ (Newton's range).
        thread_diameter
            d, m: a thread of 1 mm and 20 m takes as much as a ball of 13 cm. 0 leaves it out.
        thread_drag_coefficient
            Of a cylinder across the wind, 1.

        Returns
        -------
        Drag
            With the bob's mass m and the air's density ρ:
            γ = 3πηr(1 + r/s)/m, s = √(2η/(ρω0)): Stokes (1851), as in Landau and Lifshitz, Fluid
            Mechanics, §24, problem 5; c = ρ(C π r² + C_t d l/4)/(2m), the thread's share by the
            power that it takes.

        Raises
        ------
        InvalidInput
            For a single case of what is not positive, a diameter that is negative, and a bob that
            does not fit the pendulum; in an ensemble such a case becomes NaN.

        Notes
        -----
        Both terms are added although each holds where the other is small, and the support takes
        its part, so expect no better than a factor of two: measure the half life and use
        `from_half_life`.
        """
        require_type("The bob", bob, Bob)
        require_type("The pendulum", pendulum, Pendulum)
        estimated = {
            "air_viscosity": (air_viscosity, "Pa·s"),
            "drag_coefficient": (drag_coefficient, ""),
            "thread_diameter": (thread_diameter, "m"),
            "thread_drag_coefficient": (thread_drag_coefficient, ""),
        }
        given: dict[str, Scalars] = {
            f"drag.{name}": as_numbers(value, f"drag.{name}", unit)
            for name, (value, unit) in estimated.items()
        }
        given |= bob.prefixed | pendulum.prefixed
        names = "the bob, the pendulum and the air"
        linear, quadratic = Origin("linear_from_bob", given), Origin("quadratic_from_bob", given)
        drag: Drag = Drag(*(derived(origin.what, names, given) for origin in (linear, quadratic)))
        return drag._derived_from(linear=linear, quadratic=quadratic)
