"""The wire that a pendulum hangs on, for its stress and stretch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._given import Given, require_finite, require_positive
from kugelpendel.parameters._numbers import Scalars, as_numbers


@dataclass(frozen=True, eq=False, init=False)
class Wire(Given):
    """A round wire; it takes no part in any motion, whose thread keeps its length.

    Parameters
    ----------
    diameter
        m.
    young
        Young's modulus, Pa; steel 2.0e11 to 2.1e11, the default is 2.0e11.
    expansion
        Relative change of the length per kelvin, 1/K; steel 1.2e-5, the default.

    Raises
    ------
    InvalidInput
        For a diameter or modulus that is not positive and finite, and an expansion that is not
        finite; one element of an array included.
    """

    diameter: Scalars
    young: Scalars
    expansion: Scalars

    def __init__(self, diameter: ArrayLike, young: ArrayLike = 2.0e11,
                 expansion: ArrayLike = 1.2e-5):  # fmt: skip
        across = as_numbers(diameter, "The wire's diameter", "m")
        require_positive(across, "The wire's diameter", "m", "leave the wire out for a thread")
        stiff = as_numbers(young, "Young's modulus", "Pa")
        require_positive(stiff, "Young's modulus", "Pa", "steel has 2.0e11 Pa")
        warm = as_numbers(expansion, "The wire's expansion", "1/K")
        require_finite(warm, "The wire's expansion", "1/K")
        for name, value in (("diameter", across), ("young", stiff), ("expansion", warm)):
            object.__setattr__(self, name, value)
        self._check_shapes("the wire's diameter, modulus and expansion")

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Diameter, Young's modulus, expansion."""
        return (self.diameter, self.young, self.expansion)

    @property
    def cross_section(self) -> Scalars:
        """πd²/4, m²."""
        return as_numbers(np.pi / 4 * np.square(self.diameter), "The cross section", "m²")
