"""The chapters that are not from the paper: their rates and series are those of the library."""

from collections.abc import Callable
from fractions import Fraction
from math import radians, sin

import pytest

import kugelpendel as kp
from kugelpendel import paper
from kugelpendel.olsson import precession as precession_25
from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.balance import rates as balanced_rates
from kugelpendel.paper.algebra.calculus import is_zero
from kugelpendel.paper.algebra.notation import NotationError, read
from kugelpendel.paper.algebra.swing import frequency, precession
from kugelpendel.paper.algebra.symbols import Integrated
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Rational, mp, mpf
from kugelpendel.paper.checks.accuracy import ANGLES, RATIO, accuracy, measured, swing
from kugelpendel.paper.proofs.exact import rates, swinging
from kugelpendel.paper.proofs.harmonics import harmonic
from kugelpendel.paper.proofs.worlds import World

UNIT = kp.Pendulum(1.0, 1.0)


def integrand(label: str) -> Expr:
    (integral,) = paper.right(label).rhs.atoms(Integrated)
    return integral.args[0]


def in_fractions(expression: Expr, first: Expr, second: Expr) -> dict[tuple[int, ...], Fraction]:
    polynomial = expression.as_poly(first, second)
    return {powers: Fraction(int(q.p), int(q.q)) for powers, q in polynomial.terms() if q}


@pytest.mark.parametrize(("alpha", "beta"), [(0.5, 0.2), (0.5, -0.2), (0.9, 0.6), (0.1, 0.003)])
def test_carlsons_rates_are_those_of_the_exact_motion(alpha: float, beta: float) -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(alpha, beta))
    with mp.workdps(40):
        swings, turns = rates(mpf(alpha), mpf(beta))
    assert float(swings) == pytest.approx(motion.frequency, rel=1e-14)
    assert float(turns) == pytest.approx(motion.precession, rel=1e-13)


def test_the_integrals_are_carlsons_to_fifty_digits() -> None:
    with mp.workdps(60):
        for alpha, beta in ((mpf("0.5"), mpf("0.2")), (mpf("0.8"), mpf("-0.5"))):
            for found, wanted in zip(measured(swing(alpha, beta)), rates(alpha, beta), strict=True):
                assert abs(found - wanted) < mpf(10) ** -50


def test_series_of_the_integrals_are_those_of_the_library() -> None:
    natural = {s.g: 1, s.l: 1}
    third, moment = paper.right("C7").rhs, (-paper.right("C5").rhs).subs(s.u, 1)
    time, azimuth = integrand("C8"), integrand("C9")
    for found, wanted in (
        (frequency(time, third), kp.series.frequency(6)),
        (precession(time, azimuth, third, moment), kp.series.precession(6)),
    ):
        series = Add(*found).subs(natural)
        assert in_fractions(series, s.alpha, s.beta) == dict(wanted.coefficients)


def test_series_of_the_harmonics_are_those_of_the_library() -> None:
    law = paper.right("D1").lhs
    for found, wanted in zip(
        balanced_rates(law), (kp.series.frequency, kp.series.precession), strict=True
    ):
        series = Add(*found[:3]).subs(s.l, 1)
        known = dict(wanted(4, "harmonics").coefficients)
        assert in_fractions(series, s.a, s.b) == known


def test_13_alone_is_low_by_another_share() -> None:
    _, turning = balanced_rates(paper.right("13a").lhs)
    share = turning[2] / turning[1] * s.l**2 / (s.a**2 + s.b**2)
    assert share.simplify() == Rational(13, 96)


@pytest.mark.parametrize("degrees", ANGLES)
def test_accuracy_is_that_of_the_library(degrees: int) -> None:
    found, wide = accuracy(degrees), sin(radians(degrees))
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(wide, wide / RATIO))
    by_25 = precession_25(wide, wide / RATIO, 1.0, 1.0)
    assert float(found.exact) == pytest.approx(motion.precession, rel=1e-13)
    assert float(found.turning) == pytest.approx(by_25, rel=1e-15)
    assert float(found.error_25) == pytest.approx(by_25 / motion.precession - 1, abs=1e-13)
    assert found.error_25 < 0 < found.error_26 < abs(found.error_c12) < abs(found.error_25)


def test_errors_grow_as_the_words_say() -> None:
    small, large = accuracy(5), accuracy(10)
    assert float(mp.log(large.error_25 / small.error_25, 2)) == pytest.approx(2, abs=0.02)
    for name in ("error_c12", "error_26"):
        power = mp.log(getattr(large, name) / getattr(small, name), 2)
        assert float(power) == pytest.approx(4, abs=0.03)


@pytest.mark.parametrize("make", [swinging, harmonic])
def test_worlds_of_small_ellipses_obey_25_and_26(make: Callable[[int, int], World]) -> None:
    with mp.workdps(160):
        world = make(1, 12)
        for label in ("25", "26"):
            relation = paper.right(label)
            rest = world.value(relation.lhs) - world.value(relation.rhs)
            assert 0 < abs(rest) < mpf(10) ** -46


def test_an_integral_is_read_whole_or_not_at_all() -> None:
    good = r"\int_{u_2}^{u_1} \frac{du}{1 - u^2}"
    found = read(good).lhs
    assert isinstance(found, Integrated)
    assert is_zero(found - read(good).lhs)
    assert not is_zero(found - read(good.replace("u^2", "u")).lhs)
    product = r"\int_{u_2}^{u_1} \frac{h}{1 - u^2} \cdot \frac{du}{u}"
    in_one = r"\int_{u_2}^{u_1} \frac{h \, du}{(1 - u^2) u}"
    assert is_zero(read(product).lhs - read(in_one).lhs)
    for wrong in (
        r"\int \frac{du}{1 - u^2}",
        r"\int_{u_2}^{u_1} u",
        r"\int_{u_2}^{u_1} \frac{dx}{1 - u^2}",
        rf"{good} h",
        r"\int_{u_2}^{u_1} h \cdot \frac{du}{u}",
        r"\int_{u_2}^{u_1} \frac{h}{u} \frac{du}{u}",
        r"\int_{u_2}^{u_1}",
    ):
        with pytest.raises(NotationError):
            read(wrong)


@pytest.mark.parametrize("language", ["de", "en"])
def test_the_document_has_the_chapters_and_says_whose_they_are(language: str) -> None:
    text = paper.write(language, "md")
    words = paper.words(language)
    assert text.count(words.ui("ours")) == 4
    for name in ("accuracy", "history"):
        assert f"## {words.ui(name)}" in text
    assert "−6,2 %" in text if language == "de" else "−6.2 %" in text
