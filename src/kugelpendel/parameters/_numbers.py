"""Numbers as they are given: one, or an array of them."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel.parameters._invalid import InvalidInput

Numbers: TypeAlias = NDArray[np.float64]
Scalars: TypeAlias = float | Numbers
"""A float where one number was given, a read-only array where several were."""


def as_array(value: ArrayLike, name: str, unit: str) -> Numbers:
    """A float64 array, the one given where it is one.

    Raises InvalidInput for what is not made of real numbers.
    """
    try:
        array: NDArray[np.generic] = np.asarray(value)
        if array.dtype.kind not in "iuf":
            raise TypeError
    except (TypeError, ValueError):
        raise InvalidInput(
            f"{name} must be a number or an array of numbers in {unit}, but it is {value!r}; "
            f"leave units out here: they are read from files and on the command line only."
        ) from None
    return array.astype(np.float64, copy=False)


def as_numbers(value: ArrayLike, name: str, unit: str) -> Scalars:
    """A float, or a read-only float64 array that is a copy of its own; raises as `as_array`."""
    if type(value) is float:
        return value
    array = as_array(value, name, unit)
    if array.ndim == 0:
        return float(array)
    array = array.copy()
    array.flags.writeable = False
    return array


def common_shape(values: tuple[Scalars, ...]) -> tuple[int, ...]:
    """The shape that all broadcast to. Raises ValueError where there is none."""
    if all(type(value) is float for value in values):
        return ()  # by far the most frequent case, and NumPy's way takes longer than the motion
    return np.broadcast_shapes(*(np.shape(value) for value in values))


def equal(ours: tuple[Scalars, ...], theirs: tuple[Scalars, ...]) -> bool:
    """Whether all are the same, element by element."""
    pairs = zip(ours, theirs, strict=True)
    return len(ours) == len(theirs) and all(np.array_equal(a, b) for a, b in pairs)


def hashed(values: tuple[Scalars, ...]) -> int:
    """A hash that goes with `equal`, to which 0 and −0 are the same."""
    arrays = (np.asarray(value) + 0.0 for value in values)
    return hash(tuple((array.shape, array.tobytes()) for array in arrays))


def unfit(names: str, values: tuple[Scalars, ...]) -> InvalidInput:
    """What to raise where `common_shape` has found none."""
    shapes = ", ".join(str(np.shape(value)) for value in values)
    return InvalidInput(
        f"The shapes of {names} do not fit together: {shapes}; give them shapes that broadcast."
    )


def lock(values: tuple[Scalars, ...]) -> None:
    """Make the arrays read-only; those that come out of a pickle or a copy are not."""
    for value in values:
        if isinstance(value, np.ndarray):
            value.flags.writeable = False
