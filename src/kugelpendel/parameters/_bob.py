"""A bob that is a ball and not a point, in air, on a thread that has a mass."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel.parameters._derived import derived
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co, Scalars, as_numbers


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Bob(Given[Scalar_co]):
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
        For a single bob whose radius or density is not positive, for a negative mass of the
        thread or density of the air, for a bob lighter than air, and for arrays that do not
        broadcast. In an ensemble a bad case becomes NaN in the motion, which gives the reason.
    """

    radius: Scalar_co
    density: Scalar_co
    thread_mass: Scalar_co
    air_density: Scalar_co

    part = "bob"
    units: ClassVar = {
        "radius": "m",
        "density": "kg/m³",
        "thread_mass": "kg",
        "air_density": "kg/m³",
    }
    follows: ClassVar = {"mass": "kg"}

    @overload
    def __init__(
        self: Bob[float],
        radius: OneNumber,
        density: OneNumber,
        thread_mass: OneNumber = ...,
        air_density: OneNumber = ...,
    ) -> None: ...

    @overload
    def __init__(
        self: Bob[Numbers],
        radius: ArrayLike,
        density: ArrayLike,
        thread_mass: ArrayLike = ...,
        air_density: ArrayLike = ...,
    ) -> None: ...

    def __init__(
        self,
        radius: ArrayLike,
        density: ArrayLike,
        thread_mass: ArrayLike = 0.0,
        air_density: ArrayLike = 1.204,
    ):
        self._give(
            "the bob's radius, density, thread mass and air density",
            radius=radius,
            density=density,
            thread_mass=thread_mass,
            air_density=air_density,
        )

    @property
    def mass(self) -> Scalar_co:
        """4/3 π r³ times the density, kg; this is not `Pendulum.mass`, which scales the tension."""
        return derived("bob_mass", "the bob", self.prefixed)

    @overload
    def gravity_factor(self: Bob[float], length: OneNumber) -> float: ...

    @overload
    def gravity_factor(self, length: ArrayLike) -> Scalars: ...

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
            For a single length that is not positive and finite, or not larger than the radius; in
            an ensemble such a case is NaN.

        Notes
        -----
        Source: R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112 (1986); to first order their
        relative changes of the period: +(1/5)(r/l)², −μ/12, +β/2 and +β/4. The ball turns with
        the thread, and the thread is taken to reach to the bob's centre.
        """
        given = as_numbers(length, "pendulum.length", "m")
        numbers = {**self.prefixed, "pendulum.length": given}
        return derived("gravity_factor", "the bob and the length", numbers)
