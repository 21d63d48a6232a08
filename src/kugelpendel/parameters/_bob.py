"""A bob that is a ball and not a point, in air, on a thread that has a mass."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._given import Given, require, require_not_negative, require_positive
from kugelpendel.parameters._invalid import InvalidInput
from kugelpendel.parameters._numbers import Scalars, as_numbers


@dataclass(frozen=True, eq=False, init=False)
class Bob(Given):
    """A homogeneous ball, or an ensemble of balls where arrays are given; they broadcast.

    Parameters
    ----------
    radius
        m.
    density
        kg/m³; brass 8500, iron 7860, lead 11340.
    thread_mass
        kg, of a thread that is the same all along its length. Its buoyancy is left out.
    air_density
        kg/m³; 1.204 at 20 °C and 1013 hPa, 0 in a vacuum.

    Raises
    ------
    InvalidInput
        For a radius or density that is not positive, a negative mass of the thread, a negative
        density of the air, and a bob lighter than air; one element of an array included.
    """

    radius: Scalars
    density: Scalars
    thread_mass: Scalars
    air_density: Scalars

    def __init__(
        self,
        radius: ArrayLike,
        density: ArrayLike,
        thread_mass: ArrayLike = 0.0,
        air_density: ArrayLike = 1.204,
    ):
        for name, given, spoken, unit, check, way_out in (
            ("radius", radius, "The bob's radius", "m", require_positive, "a point is no Bob at "
             "all: leave the bob out"),
            ("density", density, "The bob's density", "kg/m³", require_positive, "brass has 8500 "
             "kg/m³"),
            ("thread_mass", thread_mass, "The thread's mass", "kg", require_not_negative, "use 0 "
             "to leave it out"),
            ("air_density", air_density, "The air's density", "kg/m³", require_not_negative,
             "use 0 for a vacuum"),
        ):  # fmt: skip
            value = as_numbers(given, spoken, unit)
            object.__setattr__(self, name, value)
            check(value, spoken, unit, way_out)
        self._check_shapes("the bob's radius, density, thread mass and air density")
        above = np.broadcast_to(np.greater(self.density, self.air_density), self.shape)
        ball = np.broadcast_to(self.density, self.shape)
        require(
            ball if self.shape else float(ball), "The bob's density", "kg/m³",
            "exceed that of the air", above, "a bob lighter than air does not hang",
        )  # fmt: skip

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Radius, density, mass of the thread, density of the air."""
        return (self.radius, self.density, self.thread_mass, self.air_density)

    @property
    def mass(self) -> Scalars:
        """4/3 π r³ times the density, kg; this is not `Pendulum.mass`, which scales the tension."""
        mass = 4 / 3 * np.pi * np.power(self.radius, 3) * self.density
        return as_numbers(mass, "The bob's mass", "kg")

    def gravity_factor(self, length: ArrayLike) -> Scalars:
        """κ: small swings are those of a point mass under the gravity κg, so T ∝ 1/√κ.

        κ = (1 − β + μ/2)/(1 + β/2 + (2/5)(r/l)² + μ/3), with β the density of the air over that of
        the bob (buoyancy above, half of the displaced air moved along below) and μ the thread's
        mass over the bob's.

        Parameters
        ----------
        length
            l, m, from the support to the bob's centre.

        Raises
        ------
        InvalidInput
            For a length that is not positive and finite, or not larger than the radius.

        Notes
        -----
        Source: R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112 (1986); to first order their
        relative changes of the period: +(1/5)(r/l)², −μ/12, +β/2 and +β/4. The ball turns with
        the thread, and the thread is taken to reach to the bob's centre.
        """
        l = as_numbers(length, "The pendulum's length", "m")  # noqa: E741
        require_positive(l, "The pendulum's length", "m", "count it from the support")
        try:
            ratio = np.divide(self.radius, l)
        except ValueError:
            raise InvalidInput(
                f"The bob's shape {self.shape} and that of the length {np.shape(l)} do not fit "
                f"together; give one of them another axis."
            ) from None
        radius = np.broadcast_to(self.radius, np.shape(ratio))
        require(
            radius if np.shape(ratio) else float(radius), "The bob's radius", "m",
            "be less than the length of the pendulum", np.less(ratio, 1),
            "the length counts from the support to the bob's centre",
        )  # fmt: skip
        beta = np.divide(self.air_density, self.density)
        mu = np.divide(self.thread_mass, self.mass)
        inertia = 1 + beta / 2 + 0.4 * ratio**2 + mu / 3
        return as_numbers((1 - beta + mu / 2) / inertia, "κ", "1")
