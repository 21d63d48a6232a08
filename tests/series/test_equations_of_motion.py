"""The series solve the equations of motion, exactly, order by order.

The bob stays on the sphere, energy and angular momentum stay constant, and the turning radii are
the variables: that makes the motion, whatever way the coefficients were found. All in fractions.
"""

from fractions import Fraction
from itertools import product

import pytest

import kugelpendel as kp

Terms = dict[tuple[int, int], Fraction]
ORDERS = (2, 4, 8)
FOURIER = dict[int, Terms]


def add(*series: Terms) -> Terms:
    total: Terms = {}
    for terms in series:
        for powers, value in terms.items():
            total[powers] = total.get(powers, Fraction(0)) + value
    return total


def times(first: Terms, second: Terms, degree: int) -> Terms:
    total: Terms = {}
    for ((i, j), x), ((k, m), y) in product(first.items(), second.items()):
        if i + j + k + m <= degree:
            total[i + k, j + m] = total.get((i + k, j + m), Fraction(0)) + x * y
    return total


def scaled(factor: Fraction | int, terms: Terms) -> Terms:
    return {powers: factor * value for powers, value in terms.items()}


def vanishes(terms: Terms, degree: int) -> bool:
    return not any(value for (i, j), value in terms.items() if i + j <= degree)


class Motion:
    """x + iy = e^{iΩt} Σ plan[n] e^{inωt} and s = Σ s[n] e^{inωt}, as fractions."""

    def __init__(self, order: int, variables: str) -> None:
        found = kp.series.harmonics(order, variables)  # pyright: ignore[reportArgumentType]
        self.order = order
        self.degree = order + 2  # to which everything quadratic in the amplitudes is right
        self.frequency = kp.series.frequency(order, variables).coefficients  # pyright: ignore[reportArgumentType]
        self.precession = kp.series.precession(order, variables).coefficients  # pyright: ignore[reportArgumentType]
        self.plan: FOURIER = {n: series.coefficients for n, series in found.plan.items()}
        self.height: FOURIER = {0: found.height[0].coefficients}
        for n, series in found.height.items():
            if n:
                self.height[n] = self.height[-n] = scaled(Fraction(1, 2), series.coefficients)

    def times(self, first: Terms, second: Terms) -> Terms:
        return times(first, second, self.degree)

    def rate(self, n: int) -> Terms:
        return add(self.precession, scaled(n, self.frequency))

    def convolved(self, first: FOURIER, second: FOURIER, sign: int) -> FOURIER:
        """Of Σ first e^{in…} with Σ second e^{in…} (sign 1) or its conjugate (sign −1)."""
        total: FOURIER = {}
        for (n, x), (m, y) in product(first.items(), second.items()):
            key = n + sign * m
            total[key] = add(total.get(key, {}), self.times(x, y))
        return total


@pytest.fixture(params=list(product(ORDERS, ("radii", "harmonics"))), ids=str, scope="module")
def motion(request: pytest.FixtureRequest) -> Motion:
    return Motion(*request.param)


def test_the_bob_stays_on_the_sphere(motion: Motion) -> None:
    radius = motion.convolved(motion.plan, motion.plan, -1)
    square = motion.convolved(motion.height, motion.height, 1)
    for n in radius:
        height = scaled(2, motion.height.get(n, {}))
        residue = add(radius[n], scaled(-1, height), square.get(n, {}))
        assert vanishes(residue, motion.degree), n


def test_the_angular_momentum_is_constant(motion: Motion) -> None:
    rates: FOURIER = {n: motion.times(x, motion.rate(n)) for n, x in motion.plan.items()}
    momentum = motion.convolved(rates, motion.plan, -1)
    for n in range(2, max(motion.plan) + 1, 2):
        assert vanishes(add(momentum.get(n, {}), momentum.get(-n, {})), motion.degree), n


def test_the_energy_is_constant(motion: Motion) -> None:
    rates: FOURIER = {n: motion.times(x, motion.rate(n)) for n, x in motion.plan.items()}
    plan = motion.convolved(rates, rates, -1)
    climb = {n: scaled(n, motion.times(x, motion.frequency)) for n, x in motion.height.items()}
    vertical = motion.convolved(climb, climb, 1)
    for n in range(2, max(motion.plan) + 1, 2):
        twice = scaled(2, motion.height.get(n, {}))
        residue = add(plan.get(n, {}), scaled(-1, vertical.get(n, {})), twice)
        assert vanishes(residue, motion.degree), n


def test_the_turning_radii_are_the_variables() -> None:
    for order in ORDERS:
        motion = Motion(order, "radii")
        highest = add(*motion.plan.values())
        lowest = add(*(scaled(1 if n % 4 == 1 else -1, x) for n, x in motion.plan.items()))
        assert {powers: value for powers, value in highest.items() if value} == {(1, 0): 1}
        assert {powers: value for powers, value in lowest.items() if value} == {(0, 1): 1}


def test_the_first_harmonics_are_the_variables() -> None:
    half = Fraction(1, 2)
    for order in ORDERS:
        plan = kp.series.harmonics(order, "harmonics").plan
        assert plan[1].coefficients == {(1, 0): half, (0, 1): half}
        assert plan[-1].coefficients == {(1, 0): half, (0, 1): -half}
