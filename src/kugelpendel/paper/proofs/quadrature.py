"""Integrals between two turning points, where what is integrated may have a root in its divisor."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kugelpendel.paper.algebra.sympy_names import mp, mpf

Number = Any  # mpmath's mpf, which has no types
_MOST_POINTS = 512
_HOPELESS = 1e-12  # not so near with 64 points: the integrand is not what this rule is for


def over_swing(
    integrand: Callable[[Number], Number], lower: Number, upper: Number, digits: int
) -> Number:
    """Integrate over u = middle − half cos τ, where a root that vanishes at both bounds is no harm.

    The midpoint rule of a function that is then periodic and analytic: its points are doubled until
    two values agree in so many digits.
    """
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    if half == 0:
        return mpf(0)

    def at(angle: Number) -> Number:
        return integrand(middle - half * mp.cos(angle)) * half * mp.sin(angle)

    found, points = mp.inf, 32
    while points <= _MOST_POINTS:
        angles = (mp.pi * (k + mpf(1) / 2) / points for k in range(points))
        before, found = found, mp.pi / points * mp.fsum(at(angle) for angle in angles)
        change = abs(found - before) / max(abs(found), mpf(10) ** (-digits))
        if change <= mpf(10) ** (-digits) or (points >= 64 and change > _HOPELESS):
            break
        points *= 2
    return found
