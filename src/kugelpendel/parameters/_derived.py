"""Numbers that the core makes of others."""

from __future__ import annotations

from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from kugelpendel import _core
from kugelpendel.errors import InvalidInput, Told
from kugelpendel.parameters._numbers import Scalars, column, common_shape, unfit


def derived(what: str, names: str, given: dict[str, Scalars]) -> Any:
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


@dataclass(frozen=True)
class Origin:
    """What a number was derived from: a bad case of an ensemble is told by what was given.

    Attributes
    ----------
    what
        What the core calls the number's derivation, as in `derived`.
    given
        The numbers that it was derived from, as in `derived`.
    """

    what: str
    given: dict[str, Scalars]

    def problem(self, index: tuple[int, ...], shape: tuple[int, ...]) -> Told | None:
        """What is wrong with what was given for one case of an ensemble of that shape, if it is."""
        cases = (np.broadcast_to(value, shape)[index] for value in self.given.values())
        columns = {name: np.array([case]) for name, case in zip(self.given, cases, strict=True)}
        return _core.derived(self.what, columns, 1)[1]
