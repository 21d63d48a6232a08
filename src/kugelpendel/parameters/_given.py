"""What every frozen parameter has: a shape, equality, a hash, and a way through a pickle."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable

import numpy as np

from kugelpendel.parameters._invalid import InvalidInput
from kugelpendel.parameters._numbers import Scalars, common_shape, equal, hashed, unfit


class Given(ABC):
    """Numbers that belong together; arrays among them broadcast to an ensemble."""

    @property
    @abstractmethod
    def values(self) -> tuple[Scalars, ...]:
        """The numbers, in SI and in the order of the constructor."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single case."""
        return common_shape(self.values)

    def __reduce__(self) -> tuple[Callable[..., Given], tuple[Scalars | None, ...]]:
        return (type(self), self.values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and equal(self.values, other.values)

    def __hash__(self) -> int:
        return hashed(self.values)

    def _check_shapes(self, names: str) -> None:
        """Raise InvalidInput where the numbers do not broadcast."""
        try:
            _ = self.shape
        except ValueError:
            raise unfit(names, self.values) from None


def require(
    value: Scalars, name: str, unit: str, condition: str, sound: np.typing.ArrayLike, way_out: str
) -> None:
    """Raise InvalidInput unless all values are sound; the first bad one of an array is named.

    Parameters
    ----------
    value
        The number or numbers.
    name, unit, condition, way_out
        For the sentence: NAME must CONDITION, but it is VALUE UNIT; WAY_OUT.
    sound
        Whether each is as it must be.
    """
    bad = ~np.asarray(sound, dtype=bool)
    if not bad.any():
        return
    index = tuple(int(k) for k in np.argwhere(bad)[0])
    where = f" at index {', '.join(map(str, index))}" if index else ""
    seen = f"{np.asarray(value)[index]:.6g} {unit}".rstrip()
    raise InvalidInput(f"{name} must {condition}, but it is {seen}{where}; {way_out}.")


def require_finite(value: Scalars, name: str, unit: str) -> None:
    """Raise InvalidInput for NaN and infinity."""
    require(value, name, unit, "be finite", np.isfinite(value), "give a number")


def require_positive(value: Scalars, name: str, unit: str, way_out: str) -> None:
    """Raise InvalidInput for what is not positive and finite."""
    sound = np.isfinite(value) & np.greater(value, 0)
    require(value, name, unit, "be positive and finite", sound, way_out)


def require_not_negative(value: Scalars, name: str, unit: str, way_out: str) -> None:
    """Raise InvalidInput for what is negative or not finite."""
    sound = np.isfinite(value) & np.greater_equal(value, 0)
    require(value, name, unit, "be finite and not negative", sound, way_out)
