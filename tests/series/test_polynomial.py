"""Polynomials: values, text, exactness."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.series import Polynomial

MIXED = Polynomial.of(
    {(3, 0): Fraction(-3, 128), (2, 1): Fraction(1), (0, 3): Fraction(-2), (1, 0): Fraction(1, 2)},
    ("α", "β"),
)


def test_value_is_the_sum_of_the_terms() -> None:
    for series in (MIXED, kp.series.frequency(12), *kp.series.harmonics(10).plan.values()):
        x, y = 0.3, -0.2
        exact = sum(value * Fraction(x) ** i * Fraction(y) ** j for i, j, value in series.terms)
        # A few roundings of the largest term; measured 2e-16.
        assert series(x, y) == pytest.approx(float(exact), rel=2e-15)


def test_scalars_give_floats_and_arrays_their_common_shape() -> None:
    series = kp.series.frequency(6)
    assert type(series(0.1, 0.2)) is float
    x, y = np.array([[0.1], [0.2]]), np.array([0.0, 0.1, -0.3])
    value = series(x, y)
    assert np.shape(value) == (2, 3)
    assert value[1, 2] == series(0.2, -0.3)  # pyright: ignore[reportIndexIssue]
    assert type(series([0.1, 0.2], 0.0)) is np.ndarray


def test_text() -> None:
    assert str(MIXED) == "1/2 α - 3/128 α³ + α² β - 2 β³"
    assert MIXED.latex == (
        r"\frac{1}{2}\,\alpha - \frac{3}{128}\,\alpha^{3} + \alpha^{2}\,\beta - 2\,\beta^{3}"
    )
    assert str(kp.series.frequency(2, "harmonics")) == "1 - 1/16 a² - 1/16 b²"
    assert str(kp.series.precession(2)) == "3/8 α β"
    assert str(-3 * kp.series.precession(2).homogeneous(2).terms[0][2]) == "-9/8"
    assert str(kp.series.harmonics(2).plan[3]) == "-3/128 α³ - 3/128 α² β + 3/128 α β² + 3/128 β³"


def test_nothing_is_zero() -> None:
    empty = MIXED.homogeneous(7)
    assert str(empty) == empty.latex == "0"
    assert empty(0.1, 0.2) == 0.0
    assert np.array_equal(empty([0.1, 0.2], 0.0), [0.0, 0.0])
    assert empty.degree == 0


def test_parts() -> None:
    series = kp.series.frequency(8)
    assert series.degree == 8
    assert series.truncated(4) == kp.series.frequency(4)
    parts = [series.homogeneous(n).coefficients for n in range(9)]
    assert {powers: value for part in parts for powers, value in part.items()} == (
        series.coefficients
    )


def test_is_a_value() -> None:
    copy = pickle.loads(pickle.dumps(MIXED))
    assert copy == MIXED
    assert hash(copy) == hash(MIXED)
    with pytest.raises(AttributeError):
        MIXED.terms = ()  # pyright: ignore[reportAttributeAccessIssue]


def test_not_a_number_is_refused() -> None:
    with pytest.raises(kp.InvalidInput, match="α must be a number"):
        MIXED("0.1 m", 0.2)  # pyright: ignore[reportArgumentType]
