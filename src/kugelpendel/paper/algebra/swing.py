"""Integrals between the turning points as series in the turning radii, in exact fractions.

With 1 − u = eσ, the height σ goes to and fro between σ1 and σ2 like a cosine of an angle, and the
mean of every power of σ over that angle is elementary: of 1/σ it is 1/√(σ1 σ2). Here e = ε² counts
orders; α² is of first order in it.
"""

from __future__ import annotations

from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import taylor
from kugelpendel.paper.algebra.sympy_names import (
    Add,
    Expr,
    Integer,
    Rational,
    Symbol,
    binomial,
    cancel,
    expand,
    sqrt,
)

_E = Symbol("e", positive=True)
_HEIGHT, _LOW, _HIGH, _ROOT = (
    Symbol(name, positive=True) for name in ("sigma", "sigma_1", "sigma_2", "root")
)  # the root is that of σ1 σ2, with the sign of the sense
_MOST = 3  # the power of e up to which all series are kept
_HEIGHTS = {s.u: 1 - _E * _HEIGHT, s.u_1: 1 - _E * _LOW, s.u_2: 1 - _E * _HIGH}
Series = tuple[Expr, ...]


@cache
def mean(integrand: Expr, third: Expr, moment: Expr) -> Series:
    """Give 1/π times an integral over u from u2 to u1, as its terms of the orders 0, 2, 4, 6.

    Parameters
    ----------
    integrand
        Something over a root that vanishes at u1 and u2; perhaps h over 1 − u² stands before it.
    third
        u3, by u1 and u2.
    moment
        h², by u1, u2 and u3.
    """
    is_azimuth = integrand.has(s.h)
    square = cancel(integrand**2 * (s.u_1 - s.u) * (s.u - s.u_2)).subs(s.h**2, moment)
    square = square.xreplace({s.u_3: third}).xreplace(_HEIGHTS)
    before = _LOW * _HIGH / _HEIGHT**2 if is_azimuth else Integer(1)
    root, found = sqrt(cancel(square / before)), Integer(0)
    for k, coefficient in enumerate(taylor(root, _MOST, _E)):
        term = expand(coefficient)
        found += _E**k * Add(
            *(term.coeff(_HEIGHT, j) * _power(j, is_azimuth) for j in range(k + 1))
        )
    low, high = (_height(radius) for radius in (s.beta, s.alpha))
    of_root = s.alpha * s.beta * _root(s.alpha) * _root(s.beta)
    return terms(found.xreplace({_LOW: low, _HIGH: high, _ROOT: of_root}))


def _power(k: int, is_azimuth: bool) -> Expr:
    """The mean of σᵏ over the angle, or of σᵏ √(σ1 σ2)/σ."""
    if is_azimuth:
        return Integer(1) if k == 0 else _ROOT * _power(k - 1, is_azimuth=False)
    middle, half = (_LOW + _HIGH) / 2, (_HIGH - _LOW) / 2
    cosines = {j: binomial(j, j // 2) * Rational(1, 2**j) for j in range(0, k + 1, 2)}
    return Add(
        *(binomial(k, j) * middle ** (k - j) * half**j * even for j, even in cosines.items())
    )


def _height(radius: Expr) -> Expr:
    """(1 − √(1 − eρ²))/e at a turning radius ρ."""
    return radius**2 * Add(
        *(binomial(Rational(1, 2), k + 1) * (-_E * radius**2) ** k for k in range(_MOST + 1))
    )


def _root(radius: Expr) -> Expr:
    """The root of that over ρ."""
    over = sqrt(_height(radius) / radius**2)
    return Add(*(_E**k * one for k, one in enumerate(taylor(over, _MOST, _E))))


def terms(expression: Expr) -> Series:
    """Give the coefficients of e⁰ … of a polynomial in e."""
    whole = expand(expression)
    return tuple(whole.coeff(_E, k) for k in range(_MOST + 1))


def product(first: Series, second: Series) -> Series:
    """Multiply two series."""
    return tuple(
        expand(Add(*(first[j] * second[k - j] for j in range(k + 1)))) for k in range(_MOST + 1)
    )


def inverse(series: Series) -> Series:
    """Divide 1 by a series."""
    found: list[Expr] = [1 / series[0]]
    for k in range(1, _MOST + 1):
        rest = Add(*(series[j] * found[k - j] for j in range(1, k + 1)))
        found.append(expand(-rest / series[0]))
    return tuple(found)


def frequency(time: Expr, third: Expr) -> Series:
    """Give the series of ω, from the integrand of π/2ω and u3."""
    return inverse(tuple(2 * term for term in mean(time, third, Integer(0))))


def precession(time: Expr, azimuth: Expr, third: Expr, moment: Expr) -> Series:
    """Give the series of Ω, from the integrands of π/2ω and of half the azimuth, u3 and h²."""
    first, *others = (2 * term for term in mean(azimuth, third, moment))
    return product(frequency(time, third), (first - 1, *others))
