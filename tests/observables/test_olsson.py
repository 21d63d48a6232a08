"""Olsson's two formulas: values, arrays, bad input, and how far they are from the exact motion."""

from collections.abc import Callable
from math import inf, nan, pi, sqrt

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kugelpendel import (
    ExactMotion,
    InvalidInput,
    Launch,
    Pendulum,
    olsson,
)
from kugelpendel.parameters import Scalars

Formula = Callable[..., Scalars]
# A few roundings.
ROUNDING = 7e-16


def test_values() -> None:
    # l = 1 m, g = 9 m/s²: ω0 = 3/s.
    assert olsson.precession(0.2, 0.1, 1.0, 9.0) == pytest.approx(0.375 * 3 * 0.02, rel=ROUNDING)
    assert olsson.precession(0.2, -0.1, 1.0, 9.0) == -olsson.precession(0.2, 0.1, 1.0, 9.0)
    assert olsson.precession(0.2, 0.0, 1.0, 9.0) == 0
    expected = 3 * sqrt(1 - 0.05 / 8)
    assert olsson.frequency(0.2, 0.1, 1.0, 9.0) == pytest.approx(expected, rel=ROUNDING)
    assert olsson.frequency(0.2, -0.1, 1.0, 9.0) == olsson.frequency(0.2, 0.1, 1.0, 9.0)
    assert olsson.frequency(0.0, 0.0, 1.0, 9.0) == 3


def test_puiseux() -> None:
    # The same as 3RV/8l², with the amplitude R and the sideways speed V = b·ω0.
    length, gravity, amplitude, speed = 67.0, 9.81, 3.0, 0.004
    b = speed / sqrt(gravity / length)
    expected = 3 * amplitude * speed / (8 * length**2)
    assert olsson.precession(amplitude, b, length, gravity) == pytest.approx(expected, rel=ROUNDING)


def test_standard_gravity() -> None:
    assert olsson.precession(0.2, 0.1, 1.0) == olsson.precession(0.2, 0.1, 1.0, 9.80665)
    assert olsson.frequency(0.2, 0.1, 1.0) == olsson.frequency(0.2, 0.1, 1.0, 9.80665)


@pytest.mark.parametrize("formula", [olsson.precession, olsson.frequency])
def test_numbers_and_arrays(formula: Formula) -> None:
    assert type(formula(0.2, 0.1, 1.0)) is float
    a, length = np.array([0.1, 0.2, 0.3]), np.array([[1.0], [2.0]])
    table = formula(a, 0.1, length, 9.8)
    assert np.shape(table) == (2, 3)
    expected = [[formula(x, 0.1, y, 9.8) for x in a] for y in length[:, 0]]
    assert_array_equal(table, expected)
    assert np.shape(formula([], 0.1, 1.0)) == (0,)


@pytest.mark.parametrize("formula", [olsson.precession, olsson.frequency])
@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((nan, 0.1, 1.0), "semi-axis a must be finite, but it is nan m"),
        ((0.1, inf, 1.0), "semi-axis b must be finite, but it is inf m"),
        ((0.1, [0.1], -1.0), "length must be positive and finite, but it is -1 m; give"),
        ((0.1, 0.1, 0.0), "length must be positive and finite, but it is 0 m"),
        ((0.1, 0.1, nan), "length must be positive and finite, but it is NaN m"),
        ((0.1, 0.1, 1.0, -9.8), "Gravity must be positive and finite, but it is -9.8 m/s²; leave"),
        (("1 cm", 0.1, 1.0), "semi-axis a must be a number .* in m, but it is '1 cm'; leave unit"),
        ((0.1, None, 1.0), "semi-axis b must be a number .* but it is None"),
        ((0.1, 0.1, "1 m"), "length must be a number or an array of numbers in m, but it is '1 m'"),
        (([0.1, 0.2], [0.1] * 3, 1.0), r"a, b, length and gravity do not fit .* \(2,\), \(3,\), "),
        (([0.1, 0.2], 0.1, [1.0] * 3), r"do not fit together: \(2,\), \(\), \(3,\), \(\); give"),
    ],
)
def test_what_makes_no_sense(formula: Formula, arguments: tuple[float, ...], said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        formula(*arguments)


@pytest.mark.parametrize("formula", [olsson.precession, olsson.frequency])
def test_bad_cases_of_arrays_are_nan(formula: Formula) -> None:
    a = np.array([0.1, nan, inf, 0.1, 0.1, 0.1, 0.1])
    length = np.array([1.0, 1.0, 1.0, 0.0, -1.0, -1.0, nan])
    gravity = np.array([9.8, 9.8, 9.8, 9.8, 9.8, -9.8, 9.8])
    rates = formula(a, 0.05, length, gravity)
    assert_array_equal(np.isnan(rates), [False] + [True] * 6)


def test_swings_too_wide_for_the_formula() -> None:
    said = (
        r"has no value at a = 2.0 l, b = 2.0 l, length l = 1.5 m; it is meant for a, b ≪ l. Use "
        r"ExactMotion"
    )
    with pytest.raises(InvalidInput, match=said):
        olsson.frequency(3.0, 3.0, 1.5)
    assert_array_equal(np.isnan(olsson.frequency([5.0, 0.1], 3.0, 1.5)), [True, False])


def slope(errors: list[float], sizes: list[float]) -> float:
    return float(np.diff(np.log(errors))[-1] / np.diff(np.log(sizes))[-1])


@pytest.mark.parametrize("ratio", [0.9, 0.3, -0.3])
def test_precession_is_the_leading_order(ratio: float) -> None:
    sizes = [0.04, 0.02, 0.01]
    errors: list[float] = []
    for size in sizes:
        motion = ExactMotion(Pendulum(1.7), Launch.apsides(1.7 * size, 1.7 * ratio * size))
        formula = olsson.precession(1.7 * size, 1.7 * ratio * size, 1.7)
        errors.append(abs(float(formula / motion.precession) - 1))
        # What the docstring says it is low by.
        assert 1 - formula / motion.precession == pytest.approx(
            7 / 32 * size**2 * (1 + ratio**2), rel=3 * size**2
        )
    assert slope(errors, sizes) == pytest.approx(2, abs=0.005)


@pytest.mark.parametrize("ratio", [0.9, 0.3, 0.0])
def test_frequency_is_the_leading_order(ratio: float) -> None:
    # The amplitude's share in the frequency, which is of order 2, is met to a relative order 2.
    sizes = [0.04, 0.02, 0.01]
    errors: list[float] = []
    for size in sizes:
        pendulum = Pendulum(1.7)
        motion = ExactMotion(pendulum, Launch.apsides(1.7 * size, 1.7 * ratio * size))
        shift = float(motion.frequency / pendulum.angular_frequency) - 1
        formula = olsson.frequency(1.7 * size, 1.7 * ratio * size, 1.7)
        errors.append(abs((float(formula / pendulum.angular_frequency) - 1) / shift - 1))
    assert slope(errors, sizes) == pytest.approx(2, abs=0.01)


def test_plane_pendulum() -> None:
    # T/T0 = 1 + θ0²/16 + …, with a = l sin θ0.
    theta = 1e-3
    period = 2 * pi / olsson.frequency(np.sin(theta), 0.0, 1.0, 1.0)
    assert period / (2 * pi) == pytest.approx(1 + theta**2 / 16, abs=2 * theta**4)
