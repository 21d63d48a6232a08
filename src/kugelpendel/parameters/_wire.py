"""The wire that a pendulum hangs on, for its stress and stretch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from numpy.typing import ArrayLike

from kugelpendel.parameters._derived import derived
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Scalars


@dataclass(frozen=True, eq=False, init=False, repr=False)
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
        For a single wire whose diameter or modulus is not positive and finite or whose expansion
        is not finite, and for arrays that do not broadcast.
    """

    diameter: Scalars
    young: Scalars
    expansion: Scalars

    part = "wire"
    units: ClassVar = {"diameter": "m", "young": "Pa", "expansion": "1/K"}

    def __init__(
        self, diameter: ArrayLike, young: ArrayLike = 2.0e11, expansion: ArrayLike = 1.2e-5
    ):
        names = "the wire's diameter, modulus and expansion"
        self._give(names, diameter=diameter, young=young, expansion=expansion)

    @property
    def cross_section(self) -> Scalars:
        """πd²/4, m²; NaN for the bad cases of an ensemble."""
        return derived("cross_section", "the wire", {"wire.diameter": self.diameter})
