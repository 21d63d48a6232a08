"""The turning ellipse with its harmonics put into a law of motion, order by order, in fractions.

The motion is x + iy = e^{iΩt} Σ c_k e^{ikωt} with odd k, where c_1 and c_−1 are (a + b)/2 and
(a − b)/2: first harmonics of the turning ellipse (20). A law ẍ + xF = 0, with an F that is the same
in all directions, asks of each k that (Ω + kω)² c_k be the k-th harmonic of the motion times F.
Lengths are in l and times in 1/ω0 here; e = ε² counts orders as in `swing`.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import (
    QQ,
    Expr,
    Symbol,
    cancel,
    expand,
    ring,
    sqrt,
)

_MOST = 3  # the power of e up to which all series are kept: three terms of each rate, and one more
_ROUNDS = 5
_RING, _A, _B = ring("a,b", QQ)
_R, _V, _S = (Symbol(name) for name in ("R", "V", "S"))  # x² + y², ẋ² + ẏ², xẋ + yẏ
Series = list[Any]  # coefficients of e⁰, e¹, …, polynomials in a and b
Harmonics = dict[int, Series]  # by the multiple of ωt


@cache
def rates(law: Expr) -> tuple[tuple[Expr, ...], tuple[Expr, ...]]:
    """Give ω/ω0 and Ω/ω0 of a law's left side, as terms of the orders 0, 2, 4, 6 in a and b."""
    force = _force(law)
    waves: Harmonics = {k: _zero() for k in (-5, -3, -1, 1, 3, 5)}
    waves[1][0], waves[-1][0] = (_A + _B) / 2, (_A - _B) / 2
    swing, turning = _number(1), _zero()
    for _ in range(_ROUNDS):
        driven = _driven(force, waves, swing, turning)
        sums = [_root(_quotient(driven[k], waves[k][0])) for k in (1, -1)]
        swing = [(p + q) / 2 for p, q in zip(*sums, strict=True)]
        turning = [(p - q) / 2 for p, q in zip(*sums, strict=True)]
        for k in (-5, -3, 3, 5):
            rest = [p - q for p, q in zip(driven[k], waves[k], strict=True)]
            own = _times(*(2 * [_own(k, swing, turning)]))
            waves[k] = _over(rest, [own[0] - 1, *own[1:]])
    return _terms(swing), _terms(turning)


def _force(law: Expr) -> dict[tuple[int, int, int], Any]:
    """F as powers of R, V and S and their coefficients: the law where y is 0 and x is √R."""
    place = sqrt(_R)
    there = {s.l: 1, s.omega0: 1, s.y: 0, s.x: place, s.xd: _S / place}
    there |= {s.yd: sqrt(_V - _S**2 / _R), s.rho: place}
    whole = expand(cancel(expand((law - s.xdd).subs(there) / place)))
    polynomial = whole.as_poly(_R, _V, _S)
    return {powers: QQ(int(value.p), int(value.q)) for powers, value in polynomial.terms()}


def _driven(
    force: dict[tuple[int, int, int], Any], waves: Harmonics, swing: Series, turning: Series
) -> Harmonics:
    """The harmonics of the motion times F; the one of S is imaginary, so that its square is −S²."""
    speeds = {k: _times(wave, _own(k, swing, turning)) for k, wave in waves.items()}
    square, rush = (_shifted(_squared(one)) for one in (waves, speeds))
    change = {k: [k * q / 2 for q in _times(wave, swing)] for k, wave in square.items()}
    total: Harmonics = {}
    for (r, v, t), value in force.items():
        if t % 2:
            raise ValueError("The law is not the same for a motion run backwards.")
        term = {0: _number(value * (-1) ** (t // 2))}
        for factor in (*r * (square,), *v * (rush,), *t * (change,)):
            term = _product(term, factor)
        _add(total, term)
    return _product(total, waves)


def _own(k: int, swing: Series, turning: Series) -> Series:
    """Ω + kω."""
    return [p + k * q for p, q in zip(turning, swing, strict=True)]


def _squared(waves: Harmonics) -> Harmonics:
    """The square of the size: each harmonic times each other one turned round."""
    return _product(waves, {-k: wave for k, wave in waves.items()})


def _product(first: Harmonics, second: Harmonics) -> Harmonics:
    found: Harmonics = {}
    for j, one in first.items():
        for k, other in second.items():
            _add(found, {j + k: _times(one, other)})
    return found


def _add(found: Harmonics, more: Harmonics) -> None:
    for k, wave in more.items():
        found[k] = [p + q for p, q in zip(found.get(k, _zero()), wave, strict=True)]


def _shifted(waves: Harmonics) -> Harmonics:
    """Times e: a square of lengths is one order higher than they are."""
    return {k: [_RING(0), *wave[:-1]] for k, wave in waves.items()}


def _zero() -> Series:
    return [_RING(0)] * (_MOST + 1)


def _number(value: Any) -> Series:
    return [_RING(value), *_zero()[1:]]


def _times(first: Series, second: Series) -> Series:
    return [
        sum((first[j] * second[k - j] for j in range(k + 1)), _RING(0)) for k in range(_MOST + 1)
    ]


def _over(above: Series, below: Series) -> Series:
    """A quotient of series; the first coefficient of the divisor is a number."""
    found: Series = []
    for k in range(_MOST + 1):
        rest = above[k] - sum((below[j] * found[k - j] for j in range(1, k + 1)), _RING(0))
        found.append(_exactly(rest, below[0]))
    return found


def _quotient(series: Series, divisor: Any) -> Series:
    return [_exactly(term, divisor) for term in series]


def _exactly(term: Any, divisor: Any) -> Any:
    return term.exquo(_RING(divisor)) if term else term


def _root(series: Series) -> Series:
    """The root of a series that begins with 1."""
    found: Series = [_RING(1)]
    for k in range(1, _MOST + 1):
        rest = series[k] - sum((found[j] * found[k - j] for j in range(1, k)), _RING(0))
        found.append(rest / 2)
    return found


def _terms(series: Iterable[Any]) -> tuple[Expr, ...]:
    letters = {Symbol("a"): s.a / s.l, Symbol("b"): s.b / s.l}
    return tuple(term.as_expr().xreplace(letters) for term in series)
