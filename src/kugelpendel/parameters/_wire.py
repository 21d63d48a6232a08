"""The wire that a pendulum hangs on, for its stress and stretch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel.parameters._derived import derived
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Wire(Given[Scalar_co]):
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

    diameter: Scalar_co
    young: Scalar_co
    expansion: Scalar_co

    part = "wire"
    units: ClassVar = {"diameter": "m", "young": "Pa", "expansion": "1/K"}

    @overload
    def __init__(
        self: Wire[float], diameter: OneNumber, young: OneNumber = ..., expansion: OneNumber = ...
    ) -> None: ...

    @overload
    def __init__(
        self: Wire[Numbers], diameter: ArrayLike, young: ArrayLike = ..., expansion: ArrayLike = ...
    ) -> None: ...

    def __init__(
        self, diameter: ArrayLike, young: ArrayLike = 2.0e11, expansion: ArrayLike = 1.2e-5
    ):
        names = "the wire's diameter, modulus and expansion"
        self._give(names, diameter=diameter, young=young, expansion=expansion)

    @property
    def cross_section(self) -> Scalar_co:
        """πd²/4, m²; NaN for the bad cases of an ensemble."""
        return derived("cross_section", "the wire", {"wire.diameter": self.diameter})
