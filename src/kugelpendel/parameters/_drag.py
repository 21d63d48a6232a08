"""What the air takes away."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._bob import Bob
from kugelpendel.parameters._given import Given, require_not_negative, require_positive
from kugelpendel.parameters._numbers import Scalars, as_numbers
from kugelpendel.parameters._pendulum import Pendulum


@dataclass(frozen=True, eq=False, init=False)
class Drag(Given):
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
        For what is negative or not finite, one element of an array included.

    Notes
    -----
    Source of the two terms and of their effect on the amplitude: R. A. Nelson and M. G. Olsson,
    Am. J. Phys. 54, 112 (1986), section on damping.
    """

    linear: Scalars
    quadratic: Scalars

    def __init__(self, linear: ArrayLike = 0.0, quadratic: ArrayLike = 0.0):
        for name, given, unit in (("linear", linear, "1/s"), ("quadratic", quadratic, "1/m")):
            value = as_numbers(given, f"The {name} drag", unit)
            object.__setattr__(self, name, value)
            way_out = "drag takes energy away: use 0 for none, and kp.Drive to bring some in"
            require_not_negative(value, f"The {name} drag", unit, way_out)
        self._check_shapes("the linear and the quadratic drag")

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Linear, quadratic."""
        return (self.linear, self.quadratic)

    @classmethod
    def from_quality(cls, quality: ArrayLike, pendulum: Pendulum) -> Drag:
        """Linear drag from the quality factor: γ = ω0/(2Q).

        Q is 2π times the energy over what a swing loses of it, or π times the number of swings in
        which the amplitude falls to 1/e; ω0 is the pendulum's `angular_frequency`. Raises
        InvalidInput for a quality that is not positive and finite.
        """
        value = as_numbers(quality, "The quality factor", "1")
        way_out = "for no drag leave it out"
        require_positive(value, "The quality factor", "", way_out)
        return cls(linear=np.divide(pendulum.angular_frequency, np.multiply(2, value)))

    @classmethod
    def from_half_life(cls, half_life: ArrayLike) -> Drag:
        """Linear drag from the time, s, in which the amplitude falls to half: γ = ln 2/t.

        The amplitude, not the energy, whose half life is half as long. Raises InvalidInput for a
        half life that is not positive and finite.
        """
        value = as_numbers(half_life, "The half life", "s")
        require_positive(value, "The half life", "s", "for no drag leave it out")
        return cls(linear=np.divide(math.log(2), value))

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
            For what is not positive, a diameter that is negative, and a bob that does not fit the
            pendulum.

        Notes
        -----
        Both terms are added although each holds where the other is small, and the support takes
        its part, so expect no better than a factor of two: measure the half life and use
        `from_half_life`.
        """
        bob.gravity_factor(pendulum.length)  # raises for a bob that does not fit
        viscosity = as_numbers(air_viscosity, "The air's viscosity", "Pa·s")
        require_positive(viscosity, "The air's viscosity", "Pa·s", "air has 1.81e-5 Pa·s")
        ball = as_numbers(drag_coefficient, "The drag coefficient", "1")
        require_positive(ball, "The drag coefficient", "", "a smooth ball has 0.44")
        diameter = as_numbers(thread_diameter, "The thread's diameter", "m")
        require_not_negative(
            diameter, "The thread's diameter", "m", "use 0 to leave the thread out"
        )
        thread = as_numbers(thread_drag_coefficient, "The thread's drag coefficient", "1")
        require_positive(thread, "The thread's drag coefficient", "", "a cylinder has 1.1")
        r, m, density = (np.asarray(value) for value in (bob.radius, bob.mass, bob.air_density))
        with np.errstate(divide="ignore", invalid="ignore"):
            layer = np.sqrt(2 * np.asarray(viscosity) / (density * pendulum.angular_frequency))
            linear = 3 * np.pi * np.asarray(viscosity) * r * (1 + r / layer) / m
        area = np.asarray(ball) * np.pi * r**2
        area = area + np.asarray(thread) * np.asarray(diameter) * np.asarray(pendulum.length) / 4
        return cls(linear=linear, quadratic=density * area / (2 * m))
