"""Coefficients against derivatives of the elliptic integrals, taken with 40 digits on a circle."""

from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import pytest

import kugelpendel as kp

mp: Any = mpmath.mp.clone()
mp.dps = 40
ORDER = 16
POINTS = 64
# Where the rates are evaluated; what aliases is of the order RADIUS^POINTS = 3e-39.
RADIUS = mp.mpf(1) / 4
# Rounding of the sum, over RADIUS^ORDER.
TOLERANCE = mp.mpf(10) ** -38 / RADIUS**ORDER * 100
RAYS = (Fraction(1, 10), Fraction(1, 3), Fraction(4, 5), Fraction(-5, 7))


def rates(alpha: Any, beta: Any) -> tuple[Any, Any]:
    """ω and Ω of turning radii, from K and Π (physics as in Landau & Lifshitz, Mechanics, §14)."""
    high, low = (1 - mp.sqrt(1 - radius**2) for radius in (alpha, beta))
    third = 2 + high * low / (2 - high - low)
    momentum = alpha * beta * mp.sqrt(2 * third / ((2 - high) * (2 - low)))
    w = mp.sqrt((third - low) / 2)
    m = (high - low) / (third - low)
    below = mp.ellippi(-(high - low) / low, m) / low
    above = mp.ellippi((high - low) / (2 - low), m) / (2 - low)
    azimuth = momentum / w * (below + above)
    period = 2 * mp.ellipk(m) / w
    sign = 1 if beta.real / alpha.real > 0 else -1
    return mp.pi / period, (azimuth - sign * mp.pi) / period


@cache
def derivatives(ratio: Fraction) -> list[list[Any]]:
    """Taylor coefficients of ω and Ω in t, α = t, β = ratio · t."""
    share = mp.mpf(ratio.numerator) / ratio.denominator
    circle = [RADIUS * mp.expjpi(mp.mpf(2 * k + 1) / POINTS) for k in range(POINTS)]
    values = [rates(t, share * t) for t in circle]
    return [
        [
            mp.fsum(value[which] / t**n for value, t in zip(values, circle, strict=True)) / POINTS
            for n in range(ORDER + 1)
        ]
        for which in (0, 1)
    ]


@pytest.mark.parametrize("ratio", RAYS, ids=str)
@pytest.mark.parametrize("which", [0, 1], ids=["frequency", "precession"])
def test_coefficients_are_derivatives(which: int, ratio: Fraction) -> None:
    series = (kp.series.frequency, kp.series.precession)[which](ORDER)
    for n in range(ORDER + 1):
        terms = series.homogeneous(n).coefficients.items()
        exact = sum((value * ratio**j for (_, j), value in terms), Fraction(0))
        difference = derivatives(ratio)[which][n] - mp.mpf(exact.numerator) / exact.denominator
        assert abs(difference) < TOLERANCE, n


def test_order_two_is_the_paper() -> None:
    assert kp.series.precession(2).coefficients == {(1, 1): Fraction(3, 8)}  # (25)
    square = kp.series.frequency(2).coefficients  # its square to second order is (26)
    assert square[0, 0] == 1
    assert {powers: 2 * value for powers, value in square.items() if sum(powers) == 2} == {
        (2, 0): Fraction(-1, 8),
        (0, 2): Fraction(-1, 8),
    }
    assert kp.series.frequency(2, "harmonics").coefficients == square
    assert kp.series.precession(2, "harmonics").coefficients == {(1, 1): Fraction(3, 8)}


def test_plane_swings_have_the_known_period() -> None:
    """T0/T in α = sin θ0, from the textbook's T/T0 = 1 + θ0²/16 + 11θ0⁴/3072 + …."""
    frequency = kp.series.frequency(4)
    # θ0² = α² + α⁴/3 + …; 1/T = 1 − θ0²/16 + (1/256 − 11/3072)θ0⁴
    quartic = -Fraction(1, 48) + Fraction(1, 256) - Fraction(11, 3072)
    assert frequency.coefficients[4, 0] == quartic


@pytest.mark.parametrize("order", [2, 6, 16])
def test_exchange_and_mirror(order: int) -> None:
    for variables in ("radii", "harmonics"):
        for series in (kp.series.frequency, kp.series.precession):
            coefficients = series(order, variables).coefficients
            assert coefficients == {(j, i): value for (i, j), value in coefficients.items()}
        plan = kp.series.harmonics(order, variables).plan
        for n, amplitude in plan.items():
            mirrored = {(i, j): (-1) ** j * value for i, j, value in amplitude.terms}
            assert plan[-n].coefficients == mirrored
