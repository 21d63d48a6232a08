"""Orders and variables that there are not, and those beyond the table."""

from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.series import _table

FUNCTIONS = (
    kp.series.frequency,
    kp.series.precession,
    kp.series.harmonics,
    lambda order: kp.series.trusted(0.1, 0.1, order),
)


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize(
    ("order", "message"),
    [
        (3, r"must be even, but it is 3: .* use 2 or 4\.$"),
        (-1, r"must be even, but it is -1: .* use 2 or 4\.$"),
        (0, r"must be at least 2, but it is 0; .* LinearMotion"),
        (-4, "must be at least 2, but it is -4"),
        (42, r"can be 40 at most, but it is 42; use order=40, or ExactMotion"),
        (6.0, r"must be a whole number, but it is 6\.0; use 2, 4, 6, …"),
        ("6", "must be a whole number, but it is '6'"),
        (True, "must be a whole number, but it is True"),
        (None, "must be a whole number, but it is None"),
        (np.array([2, 4]), "must be a whole number"),
    ],
)
def test_bad_orders(function: Any, order: object, message: str) -> None:
    with pytest.raises(kp.InvalidInput, match=message):
        function(order)


def test_numpy_integers_are_orders() -> None:
    assert kp.series.frequency(np.int64(6)) == kp.series.frequency(6)  # pyright: ignore[reportArgumentType]


def test_bad_variables() -> None:
    message = r'must be "radii" \(.*\) or "harmonics" \(.*\), but they are \'angles\''
    for function in (kp.series.frequency, kp.series.precession, kp.series.harmonics):
        with pytest.raises(kp.InvalidInput, match=message):
            function(4, "angles")  # pyright: ignore[reportArgumentType]
    with pytest.raises(kp.InvalidInput, match="but they are 3"):
        kp.series.radius(0.1, 3)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("variables", ["radii", "harmonics"])
def test_orders_beyond_the_table_go_on_where_it_ends(variables: Any) -> None:
    order = _table.SHIPPED + 2
    for series in (kp.series.frequency, kp.series.precession):
        assert series(order, variables).truncated(_table.SHIPPED) == series(
            _table.SHIPPED, variables
        )
    beyond = kp.series.harmonics(order, variables)
    for n, amplitude in kp.series.harmonics(_table.SHIPPED, variables).plan.items():
        assert beyond.plan[n].truncated(_table.SHIPPED + 1) == amplitude
    assert max(beyond.plan) == order + 1
    assert max(beyond.height) == order + 2
