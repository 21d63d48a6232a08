"""The pendulum: a point mass on a massless thread of fixed length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.parameters._invalid import InvalidInput
from kugelpendel.parameters._numbers import Scalars, as_numbers, common_shape, equal, hashed, unfit


@dataclass(frozen=True, eq=False, init=False)
class Pendulum:
    """A spherical pendulum, or an ensemble of them where arrays are given; they broadcast.

    Parameters
    ----------
    length
        m, from the support to the bob's centre.
    gravity
        m/s²; the standard value where it is left out.
    mass
        kg; scales the tension and nothing else.

    Raises
    ------
    InvalidInput
        For a single pendulum whose length, gravity or mass is not positive and finite, and for
        arrays that do not broadcast. In an ensemble a bad case becomes NaN in the motion, which
        gives the reason.
    """

    length: Scalars
    gravity: Scalars
    mass: Scalars

    def __init__(self, length: ArrayLike, gravity: ArrayLike = 9.80665, mass: ArrayLike = 1.0):
        object.__setattr__(self, "length", as_numbers(length, "The pendulum's length", "m"))
        object.__setattr__(self, "gravity", as_numbers(gravity, "Gravity", "m/s²"))
        object.__setattr__(self, "mass", as_numbers(mass, "The bob's mass", "kg"))
        try:
            single = self.shape == ()
        except ValueError:
            raise unfit("length, gravity and mass", self.values) from None
        if single:
            problem = _core.pendulum_problem(*(float(value) for value in self.values))
            if problem is not None:
                raise InvalidInput(problem)

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Length, gravity and mass."""
        return (self.length, self.gravity, self.mass)

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single pendulum."""
        return common_shape(self.values)

    @property
    def angular_frequency(self) -> Scalars:
        """ω0 = √(g/l), rad/s: of infinitesimal swings; NaN for the bad cases of an ensemble."""
        with np.errstate(all="ignore"):
            frequency = np.sqrt(np.divide(self.gravity, self.length))
        if self.shape == ():
            return float(frequency)
        sound = np.greater(self.gravity, 0) & np.greater(self.length, 0) & np.isfinite(frequency)
        return as_numbers(np.where(sound, frequency, np.nan), "ω0", "rad/s")

    def __reduce__(self) -> tuple[type[Pendulum], tuple[Scalars, ...]]:
        return (Pendulum, self.values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pendulum) and equal(self.values, other.values)

    def __hash__(self) -> int:
        return hashed(self.values)
