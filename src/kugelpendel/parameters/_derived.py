"""Numbers that the core makes of others."""

from __future__ import annotations

from math import prod

from kugelpendel import _core
from kugelpendel.errors import InvalidInput
from kugelpendel.parameters._numbers import Scalars, column, common_shape, unfit


def derived(what: str, names: str, given: dict[str, Scalars]) -> Scalars:
    """What the core calls `what`, of numbers named as in "bob.radius".

    Parameters
    ----------
    what
        See `derived` in crates/kugelpendel-python/src/given.rs.
    names
        For the sentence where the shapes do not fit together.
    given
        A float or an array each; they broadcast.

    Returns
    -------
    float or array
        NaN for the bad cases of an ensemble.

    Raises
    ------
    InvalidInput
        For a single bad case, and for shapes that do not fit together.
    """
    values = tuple(given.values())
    try:
        shape = common_shape(values)
    except ValueError:
        raise unfit(names, values) from None
    columns = {name: column(value, shape) for name, value in given.items()}
    numbers, problem = _core.derived(what, columns, prod(shape))
    if shape == ():
        if problem is not None:
            raise InvalidInput.told(problem)
        return float(numbers[0])
    numbers = numbers.reshape(shape)
    numbers.flags.writeable = False
    return numbers
