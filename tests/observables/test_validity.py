"""How good the formulas are: limits, arrays, slopes, and what is refused."""

import math
import time
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kugelpendel as kp

NAN = math.nan


def test_errors_are_those_of_the_formulas() -> None:
    found = kp.validity(0.3, -0.12, 1.5)
    pendulum = kp.Pendulum(1.5)
    exact = kp.ExactMotion(pendulum, kp.Launch.apsides(0.3, -0.12))
    formula = kp.olsson.precession(0.3, -0.12, 1.5)
    assert found.formula_25 == pytest.approx(formula / exact.precession - 1, abs=1e-15)
    formula = kp.olsson.frequency(0.3, -0.12, 1.5)
    assert found.formula_26 == pytest.approx(formula / exact.frequency - 1, abs=1e-15)
    motion = kp.SeriesMotion(pendulum, kp.Launch.apsides(0.3, -0.12), order=4)
    pair = found.series[4]
    assert pair.precession == pytest.approx(motion.precession / exact.precession - 1, abs=2e-15)
    assert pair.frequency == pytest.approx(motion.frequency / exact.frequency - 1, abs=2e-15)
    assert list(found.series) == [2, 4, 6, 8, 10, 12]


def test_leading_terms_that_the_page_names() -> None:
    for ratio in (0.0, 0.3, 0.6, 1.0):
        found = kp.validity(0.02, 0.02 * ratio, 1.0)
        squares = 0.02**2 * (1 + ratio**2)
        assert found.formula_25 == pytest.approx(-7 / 32 * squares, rel=2e-3)
        leading = 19 / 1024 * (0.02**2 * (1 - ratio**2)) ** 2
        assert found.formula_26 == pytest.approx(leading, abs=3e-11)


def test_order_two_is_the_formula() -> None:
    found = kp.validity(np.linspace(0, 0.9, 10), 0.01, 1.0)
    assert_allclose(found.series[2].precession, found.formula_25, atol=1e-15)


@pytest.mark.parametrize("ratio", [0.0, 0.3, 1.0])
def test_errors_fall_with_the_order(ratio: float) -> None:
    series = kp.validity(0.3, 0.3 * ratio, 1.0).series
    for part in (0, 1):
        sizes = [abs(pair[part]) for pair in series.values()]
        assert all(fine < 0.3 * coarse for coarse, fine in pairwise(sizes)), sizes


def test_no_width_is_the_limit_of_narrow_ellipses() -> None:
    at, near = kp.validity(0.3, 0.0, 1.0), kp.validity(0.3, 1e-9, 1.0)
    assert at.formula_25 == pytest.approx(near.formula_25, abs=2e-15)
    for order, pair in at.series.items():
        assert pair.precession == pytest.approx(near.series[order].precession, abs=2e-15)


def test_a_circle_is_the_limit_of_round_ellipses() -> None:
    at, near = kp.validity(0.3, 0.3, 1.0), kp.validity(0.3, 0.3 - 1e-9, 1.0)
    assert at.formula_25 == pytest.approx(near.formula_25, abs=1e-9)
    assert at.formula_26 == pytest.approx(near.formula_26, abs=1e-9)


@pytest.mark.parametrize("a", [0.0, 1e-300, 1e-12])
def test_tiny_ellipses_have_no_error(a: float) -> None:
    found = kp.validity(a, 0.5 * a, 1.0)
    assert found.formula_25 == found.formula_26 == 0
    assert all(pair == (0, 0) for pair in found.series.values())


def test_arrays_are_their_elements() -> None:
    a, b = np.array([[0.1], [0.4]]), np.array([0.0, 0.05, 0.1])
    found = kp.validity(a, b, 2.0)
    assert np.shape(found.formula_25) == np.shape(found.series[8].frequency) == (2, 3)
    one = kp.validity(0.4, 0.05, 2.0)
    assert isinstance(one.formula_25, float)
    assert np.asarray(found.formula_25)[1, 1] == pytest.approx(one.formula_25, abs=1e-15)
    assert np.asarray(found.series[8].frequency)[1, 1] == pytest.approx(
        one.series[8].frequency, abs=1e-15
    )


def test_bad_cases_of_arrays_are_nan() -> None:
    found = kp.validity([0.1, 1.5, NAN, 0.1, 0.1, 0.0], [0.05, 0, 0, 0.2, NAN, NAN], 1.0)
    assert np.isnan(found.formula_25).tolist() == [False, True, True, True, True, True]
    assert np.isnan(found.series[6].frequency).tolist() == [False, True, True, True, True, True]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((1.0, 0.1, 1.0), ["outer turning radius", "1 m"]),
        ((2.0, 0.1, 1.0), ["outer turning radius", "2 m", "1 m"]),
        ((0.1, -0.2, 1.0), ["0.2 m", "0.1 m"]),
        ((NAN, 0.1, 1.0), ["finite"]),
        ((0.1, NAN, 1.0), ["finite"]),
        ((0.1, 0.1, NAN), ["length", "finite"]),
        ((0.1, 0.1, -1.0), ["length", "-1 m"]),
        ((-0.1, 0.0, 1.0), ["outer turning radius", "-0.1 m"]),
        (("wide", 0.0, 1.0), ["turning radius a", "'wide'"]),
    ],
)
def test_bad_input_is_a_sentence(arguments: tuple, words: list[str]) -> None:
    with pytest.raises(kp.InvalidInput) as raised:
        kp.validity(*arguments)
    for word in words:
        assert word in str(raised.value)


def test_map_has_its_limits_and_takes_less_than_two_seconds() -> None:
    started = time.process_time()
    found = kp.validity_map()
    assert time.process_time() - started < 2
    assert np.shape(found.errors.formula_25) == (400, 400)
    assert found.b_over_a[[0, -1]].tolist() == [0, 1]
    assert found.a_over_l[-1] == pytest.approx(0.99)
    one = kp.validity(found.a_over_l[57], found.a_over_l[57] * found.b_over_a[33], 1.0)
    assert np.asarray(found.errors.formula_26)[33, 57] == pytest.approx(one.formula_26, abs=1e-15)
    assert np.isfinite(found.errors.formula_25).all()
    assert all(np.isfinite(part).all() for pair in found.errors.series.values() for part in pair)


@pytest.mark.parametrize("arguments", [(1,), (2.5,), (10**6,), (10, 1.0), (10, NAN), (10, 0.0)])
def test_a_map_that_makes_no_sense(arguments: tuple) -> None:
    with pytest.raises(kp.InvalidInput, match="map"):
        kp.validity_map(*arguments)
