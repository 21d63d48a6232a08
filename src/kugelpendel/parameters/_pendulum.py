"""The pendulum: a point mass on a massless thread of fixed length."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, cast, overload

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.errors import Told
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co, as_numbers


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Pendulum(Given[Scalar_co]):
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

    length: Scalar_co
    gravity: Scalar_co
    mass: Scalar_co

    part = "pendulum"
    units: ClassVar = {"length": "m", "gravity": "m/s²", "mass": "kg"}

    @overload
    def __init__(
        self: Pendulum[float], length: OneNumber, gravity: OneNumber = ..., mass: OneNumber = ...
    ) -> None: ...

    @overload
    def __init__(
        self: Pendulum[Numbers], length: ArrayLike, gravity: ArrayLike = ..., mass: ArrayLike = ...
    ) -> None: ...

    def __init__(self, length: ArrayLike, gravity: ArrayLike = 9.80665, mass: ArrayLike = 1.0):
        self._give("length, gravity and mass", length=length, gravity=gravity, mass=mass)

    def _problem(self) -> Told | None:
        # Most programs make many pendulums: by place, which takes half as long as by name.
        return _core.pendulum_problem(float(self.length), float(self.gravity), float(self.mass))

    @property
    def angular_frequency(self) -> Scalar_co:
        """ω0 = √(g/l), rad/s: of infinitesimal swings; NaN for the bad cases of an ensemble."""
        with np.errstate(all="ignore"):
            frequency = np.sqrt(np.divide(self.gravity, self.length))
        if self.shape == ():
            return cast("Scalar_co", float(frequency))
        sound = np.greater(self.gravity, 0) & np.greater(self.length, 0) & np.isfinite(frequency)
        return cast("Scalar_co", as_numbers(np.where(sound, frequency, np.nan), "ω0", "rad/s"))
