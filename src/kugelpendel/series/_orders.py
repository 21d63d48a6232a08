"""Which orders and which variables there are."""

from __future__ import annotations

from operator import index
from typing import Literal, TypeAlias

from kugelpendel.parameters import InvalidInput

Variables: TypeAlias = Literal["radii", "harmonics"]

NAMES: dict[Variables, tuple[str, str]] = {"radii": ("α", "β"), "harmonics": ("a", "b")}
LIMIT = 40
"""The highest order; how long it takes is measured by benchmarks/series.py."""


def checked_order(order: object) -> int:
    """An even whole number from 2 to LIMIT. Raises InvalidInput for anything else."""
    try:
        number = index(order)  # pyright: ignore[reportArgumentType]
    except TypeError:
        number = None
    if number is None or isinstance(order, bool):
        raise InvalidInput(
            f"The order of the series must be a whole number, but it is {order!r}; use 2, 4, 6, …"
        )
    if number % 2:
        raise InvalidInput(
            f"The order of the series must be even, but it is {number}: by symmetry the series go "
            f"up in twos; use {max(number - 1, 2)} or {max(number + 1, 4)}."
        )
    if number < 2:
        raise InvalidInput(
            f"The order of the series must be at least 2, but it is {number}; order 2 is Olsson's "
            f"theory, and without any correction LinearMotion is the one to use."
        )
    if number > LIMIT:
        raise InvalidInput(
            f"The order of the series can be {LIMIT} at most, but it is {number}; use "
            f"order={LIMIT}, or ExactMotion, which is right at every amplitude."
        )
    return number


def checked_variables(variables: object) -> Variables:
    """One of the two names. Raises InvalidInput for anything else."""
    for name in NAMES:
        if isinstance(variables, str) and name == variables:
            return name
    raise InvalidInput(
        f'The variables of the series must be "radii" (the turning radii over the length) or '
        f'"harmonics" (the amplitudes of the first harmonics over the length), but they are '
        f"{variables!r}."
    )
