"""The few operations that the derivation needs, each exact."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache, lru_cache

from kugelpendel.paper.algebra.symbols import (
    RATE,
    Ddt,
    Integrated,
    Omega,
    a,
    alpha,
    b,
    beta,
    l,
    omega,
    omega0,
    phi,
    rho,
    t,
    theta,
    x,
    xd,
    xdd,
    y,
    yd,
    ydd,
)
from kugelpendel.paper.algebra.sympy_names import (
    Abs,
    Add,
    Dummy,
    Expr,
    I,
    Integer,
    Mul,
    Pow,
    Rational,
    Symbol,
    chebyshevt,
    chebyshevu,
    cos,
    diff,
    expand,
    expand_trig,
    factorial,
    fraction,
    prem,
    sin,
    together,
)

EPS = Symbol("varepsilon", positive=True)  # the bookkeeping parameter
SHIFT = Symbol("w", real=True)  # (ω² − ω0²)/ε²

# The order that each quantity has, as a power of ε. Two tables, since section 2 counts
# displacements and section 4 the semi-axes that they are made of.
DISPLACEMENTS: dict[Expr, int] = dict.fromkeys((x, y, xd, yd, xdd, ydd, rho), 1)
SEMI_AXES: dict[Expr, int] = {a: 1, b: 1, Omega: 2, SHIFT: 2}
AXES: dict[Expr, int] = {a: 1, b: 1}  # where Ω and ω are what is sought
RADII: dict[Expr, int] = {alpha: 1, beta: 1}


_supposed: ContextVar[tuple[tuple[Expr, Expr], ...]] = ContextVar("_supposed", default=())
_differentiated: ContextVar[list[bool] | None] = ContextVar("_differentiated", default=None)


@contextmanager
def supposing(rates: Mapping[Expr, Expr]) -> Generator[list[bool]]:
    """Let constants move, to see which steps need that they do not.

    What is yielded is no longer empty as soon as anything has been differentiated.
    """
    asked: list[bool] = []
    token, other = _supposed.set(tuple(rates.items())), _differentiated.set(asked)
    try:
        yield asked
    finally:
        _supposed.reset(token)
        _differentiated.reset(other)


def rate(expression: Expr) -> Expr:
    """d/dt along the motion."""
    asked = _differentiated.get()
    if asked is not None:
        asked.append(True)
    rates = (*RATE.items(), *_supposed.get())
    moving = (Mul(diff(expression, q), dot) for q, dot in rates)
    return Add(diff(expression, t), *moving)


def carry_out(expression: Expr) -> Expr:
    """Every d/dt that only stands there, done."""
    return expression.replace(Ddt, rate) if expression.has(Ddt) else expression


@cache
def _sine(angle: Expr) -> Expr:
    return Dummy(f"s({angle})", real=True)


@cache
def _cosine(angle: Expr) -> Expr:
    return Dummy(f"c({angle})", real=True)


def _without_integrals(expression: Expr) -> Expr:
    """A letter for each integral, one for those between equal bounds of what is the same."""
    letters: dict[Expr, Expr] = {}
    for one in sorted(expression.atoms(Integrated), key=str):
        known = next((other for other in letters if _is_same_integral(one, other)), None)
        letters[one] = letters[known] if known is not None else Dummy("integral", real=True)
    return expression.xreplace(letters) if letters else expression


def _is_same_integral(one: Expr, other: Expr) -> bool:
    return all(is_zero(part - with_it) for part, with_it in zip(one.args, other.args, strict=True))


def parted(expression: Expr) -> Expr:
    """Sines and cosines of a sum of angles by those of the angles themselves."""
    sums = {
        function: expand_trig(function.func(expand(function.args[0])))
        for function in expression.atoms(sin, cos)
        if function.args[0].has(Add)
    }
    return expression.xreplace(sums) if sums else expression


def _polynomial_angles(expression: Expr) -> tuple[Expr, list[Expr]]:
    """Sines and cosines of multiples of an angle, as polynomials in two symbols."""
    table: dict[Expr, Expr] = {}
    angles: list[Expr] = []
    for function in expression.atoms(sin, cos):
        factor, angle = function.args[0].as_coeff_Mul()
        s, c = _sine(angle), _cosine(angle)
        if function.func == cos:
            table[function] = chebyshevt(factor, c)
        else:
            table[function] = s * chebyshevu(factor - 1, c)
        if angle not in angles:
            angles.append(angle)
    return expression.xreplace(table), angles


def _numerator(expression: Expr) -> Expr:
    return expand(fraction(together(expression))[0])


def _reduced(numerator: Expr, angles: list[Expr]) -> Expr:
    for angle in angles:
        s, c = _sine(angle), _cosine(angle)
        if numerator.has(s):
            numerator = expand(prem(numerator, s**2 + c**2 - 1, s))
    return numerator


def is_zero(expression: Expr) -> bool:
    """Whether the expression vanishes identically: decided, not tried.

    Sines, cosines and square roots become symbols with s² = 1 − c² and W² = radicand; a rational
    expression in them is zero if its numerator's remainder is. √(1 − sin²θ) counts as cos θ: the
    lower half of the sphere.
    """
    return expression == 0 or _vanishes(expression, _supposed.get())


@lru_cache(maxsize=20_000)
def _vanishes(expression: Expr, _: tuple[tuple[Expr, Expr], ...]) -> bool:
    """Decide it once for an expression and what is supposed to move."""
    expression, angles = _polynomial_angles(parted(_without_integrals(carry_out(expression))))
    roots = {p for p in expression.atoms(Pow) if p.exp.is_Rational and p.exp.q == 2}
    rules: list[tuple[Expr, Expr]] = []
    for bars in sorted(expression.atoms(Abs), key=str):  # |u| is the root of u²
        root = Dummy("W", nonnegative=True)
        rules.append((root, bars.args[0] ** 2))
        expression = expression.xreplace({bars: root})
    for power in sorted(roots, key=str):
        radicand = power.base
        root = next((_cosine(q) for q in angles if _same_square(radicand, q, angles)), None)
        if root is None:
            root = next((w for w, u in rules if u == radicand), None)
        if root is None:
            root = Dummy("W", positive=True)
            rules.append((root, radicand))
        expression = expression.xreplace({power: root ** (2 * power.exp)})
    numerator = _numerator(expression)
    for root, radicand in rules:
        above, below = fraction(together(radicand))
        if numerator.has(root):
            numerator = expand(prem(numerator, expand(below * root**2 - above), root))
    return _reduced(numerator, angles) == 0


def _same_square(radicand: Expr, angle: Expr, angles: list[Expr]) -> bool:
    return _reduced(_numerator(radicand - _cosine(angle) ** 2), angles) == 0


def taylor(expression: Expr, order: int, letter: Expr = EPS) -> list[Expr]:
    """Coefficients of ε⁰ … ε^order, or of another letter's powers."""
    coefficients: list[Expr] = []
    for k in range(order + 1):
        coefficients.append(expression.subs(letter, 0) / factorial(k))
        expression = diff(expression, letter)
    return coefficients


def graded(expression: Expr, orders: Mapping[Expr, int]) -> Expr:
    """The expression with ε to its order before each quantity; angles stay as they are.

    An order of `SHIFT` is that of ω² − ω0², and ω is written as √(ω0² + w).
    """
    functions = {f: Dummy() for f in expression.atoms(sin, cos)}
    letters = {q: Mul(Pow(EPS, order), q) for q, order in orders.items() if q != SHIFT}
    masked = expression.xreplace(functions).xreplace(letters)
    if SHIFT in orders:
        square = Add(omega0**2, Mul(Pow(EPS, orders[SHIFT]), SHIFT))
        masked = masked.xreplace({omega: Pow(square, Rational(1, 2))})
    return masked.xreplace({dummy: function for function, dummy in functions.items()})


def small(expression: Expr) -> Expr:
    """Displacements, their rates and ρ marked as of first order."""
    return graded(expression, DISPLACEMENTS)


def slow(expression: Expr) -> Expr:
    """a, b marked as of first order, Ω and ω² − ω0² of second; angles stay as they are."""
    return graded(expression, SEMI_AXES)


def truncated(expression: Expr, order: int) -> Expr:
    """Terms up to the order, with ε = 1 again and ω² back for ω0² + w."""
    return Add(*taylor(expression, order)).xreplace({SHIFT: omega**2 - omega0**2})


@lru_cache(maxsize=4096)
def leading(expression: Expr, most: int = 8) -> tuple[int, Expr]:
    """The lowest order in ε that does not vanish, and its coefficient."""
    for order in range(most + 1):
        if not is_zero(coefficient := expression.subs(EPS, 0) / factorial(order)):
            return order, coefficient.xreplace({SHIFT: omega**2 - omega0**2})
        expression = diff(expression, EPS)
    return most + 1, Integer(0)


def harmonics(expression: Expr, angle: Expr = omega * t) -> dict[int, tuple[Expr, Expr]]:
    """Order k → (factor of cos k·angle, factor of sin k·angle)."""
    u = Dummy("u")
    table: dict[Expr, Expr] = {}
    for function in expression.atoms(sin, cos):
        factor, base = function.args[0].as_coeff_Mul()
        if base == angle:
            up, down = u**factor, u ** (-factor)
            table[function] = (up + down) / 2 if function.func == cos else (up - down) / (2 * I)
    expanded = expand(expression.xreplace(table))
    powers: dict[int, Expr] = {}
    for term in Add.make_args(expanded):
        exponent = int(term.as_coeff_exponent(u)[1])
        powers[exponent] = Add(powers.get(exponent, Integer(0)), term * u ** (-exponent))
    result: dict[int, tuple[Expr, Expr]] = {}
    for k in sorted({abs(exponent) for exponent in powers}):
        plus, minus = powers.get(k, Integer(0)), powers.get(-k, Integer(0))
        if k == 0:
            result[k] = (expand(plus), Integer(0))
        else:
            result[k] = (expand(plus + minus), expand(I * (plus - minus)))
    return {k: pair for k, pair in result.items() if pair != (0, 0)}


def harmonic(expression: Expr, order: int) -> Expr:
    """The part of that order in ωt."""
    factor_cos, factor_sin = harmonics(expression).get(order, (Integer(0), Integer(0)))
    return factor_cos * cos(order * omega * t) + factor_sin * sin(order * omega * t)


def is_constant_multiple(first: Expr, second: Expr) -> bool:
    """Whether first = k·second with a number k ≠ 0, identically."""
    if is_zero(second):
        return is_zero(first)
    symbols = sorted((first.free_symbols | second.free_symbols) - {theta, phi}, key=str)
    point = {s: Rational(3 * k + 2, 2 * k + 3) for k, s in enumerate(symbols, 1)}
    point |= {l: Rational(31, 5)}  # longer than all that is measured by it: roots are real
    above, below = carry_out(first).evalf(30, subs=point), carry_out(second).evalf(30, subs=point)
    angle = {theta: Rational(7, 10), phi: Rational(11, 10)}
    above, below = above.evalf(30, subs=angle), below.evalf(30, subs=angle)
    if not (above.is_Float and below.is_Float and below != 0 and above != 0):
        return False
    ratio = Rational(str((above / below).round(12))).limit_denominator(64)
    return ratio != 0 and is_zero(first - ratio * second)
