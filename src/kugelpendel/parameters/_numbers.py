"""Numbers as they are given: one, or an array of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel.errors import InvalidInput

Numbers: TypeAlias = NDArray[np.float64]
Scalars: TypeAlias = float | Numbers
"""A float where one number was given, a read-only array where several were."""

OneNumber: TypeAlias = float | np.floating[Any] | np.integer[Any]
"""What makes a single case for sure; what else is given may be an ensemble."""

Scalar = TypeVar("Scalar", bound=Scalars)
"""Either of the two in a signature."""

if TYPE_CHECKING:
    # The default is Python 3.13's; type checkers bring this package's types with them.
    from typing_extensions import TypeVar as _TypeVar

    Scalar_co = _TypeVar("Scalar_co", bound=Scalars, default=Scalars, covariant=True)
else:
    Scalar_co = TypeVar("Scalar_co", bound=Scalars, covariant=True)
"""What the scalars of a class are: `Pendulum[float]`, `Pendulum[Numbers]`, or either: `Pendulum`.

Decided by what the constructor is given. An argument of the type `Scalars` counts as an array.
"""

_PLAIN_UNIT = str.maketrans({"²": "^2", "³": "^3", "·": "*"})
"""How pint, astropy and unyt all read the units of this package."""

_LONGEST = 120
"""Characters of what is no number that are shown."""


def as_array(value: ArrayLike, what: str, unit: str) -> Numbers:
    """A float64 array, the one given where it is one; NaN where an array is masked.

    Parameters
    ----------
    value
        Numbers, or a quantity of pint, astropy or unyt, which is converted.
    what
        For the sentence: the quantity, such as "drag.linear", or its spoken name.
    unit
        SI, "" for none.

    Raises
    ------
    InvalidInput
        For what is not made of real numbers, and for a quantity of another kind.
    """
    if type(value) is not np.ndarray:
        value = _without_unit(value, what, unit)
    try:
        array: NDArray[np.generic] = np.asarray(value)
        if array.dtype.kind not in "iuf":
            raise TypeError
    except (TypeError, ValueError):
        raise _wrong("not_a_number", value, what, unit) from None
    return array.astype(np.float64, copy=False)


def as_numbers(value: ArrayLike, what: str, unit: str) -> Scalars:
    """A float, or a read-only float64 array that is a copy of its own; raises as `as_array`."""
    if type(value) is float:
        return value
    array = as_array(value, what, unit)
    if array.ndim == 0:
        return float(array)
    array = array.copy()
    array.flags.writeable = False
    return array


def one_number(value: ArrayLike, what: str, unit: str) -> float:
    """A float; raises InvalidInput for what is not one number, else as `as_array`."""
    number = as_numbers(value, what, unit)
    if not isinstance(number, float):
        of = f" in {unit}" if unit else ""
        raise InvalidInput(f"{what} must be one number{of}, but it is {value!r:.60}.")
    return number


def one_truth(value: object, what: str) -> bool:
    """True or False; raises InvalidInput for anything else, which could mean either."""
    if value is True or value is False:
        return value
    if isinstance(value, np.bool_):
        return value == np.True_
    raise InvalidInput(f"{what} must be True or False, but it is {value!r:.60}.")


def together(names: str, *values: Numbers) -> tuple[Numbers, ...]:
    """The arrays in the shape that all broadcast to; raises InvalidInput where there is none."""
    try:
        return tuple(np.broadcast_arrays(*values))
    except ValueError:
        raise unfit(names, values) from None


def _without_unit(value: Any, what: str, unit: str) -> Any:
    """The numbers of a quantity in this unit, of a masked array, or what was given."""
    if isinstance(value, (float, int, str)):
        return value
    if isinstance(value, (list, tuple)):
        items = cast("Iterable[Any]", value)
        return [_without_unit(item, what, unit) for item in items]
    if isinstance(value, np.ma.MaskedArray):
        masked = cast("Any", value)  # NumPy's own types lose the mask with `astype`
        try:
            return masked.astype(np.float64).filled(np.nan)
        except (TypeError, ValueError):
            raise _wrong("not_a_number", value, what, unit) from None
    if not hasattr(value, "units") and not hasattr(value, "unit"):
        return value
    wanted = unit.translate(_PLAIN_UNIT)
    try:
        if hasattr(value, "to_value"):  # astropy, unyt
            return value.to_value(wanted)
        return value.to(wanted).magnitude  # pint
    except (TypeError, ValueError, AttributeError) as error:
        raise _wrong("other_unit", value, what, unit) from error


def _wrong(kind: str, value: Any, what: str, unit: str) -> InvalidInput:
    seen = repr(value)
    if len(seen) > _LONGEST:
        seen = f"{seen[:_LONGEST]}…"
    in_unit = "" if unit in ("", "1") else f" in {unit}"
    return InvalidInput.of(kind, what=what, seen=seen, in_unit=in_unit)


def common_shape(values: tuple[Scalars, ...]) -> tuple[int, ...]:
    """The shape that all broadcast to. Raises ValueError where there is none."""
    if all(type(value) is float for value in values):
        return ()  # by far the most frequent case, and NumPy's way takes longer than the motion
    return np.broadcast_shapes(*(np.shape(value) for value in values))


def equal(ours: tuple[Scalars, ...], theirs: tuple[Scalars, ...]) -> bool:
    """Whether all are the same, element by element; NaN is the same as NaN."""
    if len(ours) != len(theirs):
        return False
    return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(ours, theirs, strict=True))


def hashed(values: tuple[Scalars, ...]) -> int:
    """A hash that goes with `equal`, to which 0 and −0 are the same."""
    arrays = (np.asarray(value) + 0.0 for value in values)
    return hash(tuple((array.shape, array.tobytes()) for array in arrays))


def unfit(names: str, values: tuple[Scalars, ...]) -> InvalidInput:
    """What to raise where `common_shape` has found none."""
    shapes = ", ".join(str(np.shape(value)) for value in values)
    return InvalidInput.of("shapes", names=names, shapes=shapes)


def column(value: Scalars, shape: tuple[int, ...]) -> Numbers:
    """One number for all cases of a shape, or one for each."""
    if isinstance(value, float):
        return np.array([value])
    return np.ascontiguousarray(np.broadcast_to(value, shape).ravel())


def lock(values: tuple[Scalars, ...]) -> None:
    """Make the arrays read-only; those that come out of a pickle or a copy are not."""
    for value in values:
        if isinstance(value, np.ndarray):
            value.flags.writeable = False
