"""What the approximations drop, worked out: leading neglected terms and their order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.balance import rates
from kugelpendel.paper.algebra.calculus import (
    AXES,
    DISPLACEMENTS,
    EPS,
    RADII,
    SEMI_AXES,
    SHIFT,
    carry_out,
    graded,
    harmonic,
    is_zero,
    leading,
    parted,
    small,
    truncated,
)
from kugelpendel.paper.algebra.notation import read
from kugelpendel.paper.algebra.swing import frequency, precession, product
from kugelpendel.paper.algebra.sympy_names import Add, Dummy, Expr, cos, diff, expand, factor, sqrt
from kugelpendel.paper.derivation.graph import formula, right
from kugelpendel.paper.derivation.model import Formula, StepKind
from kugelpendel.paper.proofs.symbolic import put

_SHIFTED = Dummy("w", real=True)
_RHO = {s.rho: sqrt(s.x**2 + s.y**2)}
_SWAP = {s.x: s.y, s.y: s.x, s.xd: s.yd, s.yd: s.xd, s.xdd: s.ydd}


@dataclass(frozen=True)
class Remainder:
    """What is neglected in a formula: its leading term, of the given order in ε.

    `kept` is the order of the smallest terms that stay. Displacements count as ε; in sections 3
    and 4 a and b do, and Ω and ω² − ω0² as ε².
    """

    label: str
    kept: int
    order: int
    term: Expr


@dataclass(frozen=True)
class Dropped:
    """What a step leaves out, exactly, beside what it keeps; and how their orders are counted."""

    dropped: Expr
    kept: Expr
    orders: Mapping[Expr, int]


def motion() -> dict[Expr, Expr]:
    """Give x, y and their first two rates from (20), exactly."""
    return _moving("20")


def _moving(display: str) -> dict[Expr, Expr]:
    rules: dict[Expr, Expr] = {}
    pairs = ((f"{display}:x", (s.x, s.xd, s.xdd)), (f"{display}:y", (s.y, s.yd, s.ydd)))
    for label, letters in pairs:
        value = right(label).rhs
        for letter in letters:
            rules[letter] = value
            value = diff(value, s.t)
    return rules


def _series(label: str) -> Dropped:
    relation = right(label)
    return Dropped(relation.difference, relation.rhs, DISPLACEMENTS)


def _cubic(label: str) -> Dropped:
    exact = right("12").difference
    if label == "13b":
        exact = exact.xreplace(_SWAP)
    kept = right(label).difference
    return Dropped((exact - kept).xreplace(_RHO), kept, DISPLACEMENTS)


def _linear(label: str) -> Dropped:
    """What (13) has besides its linear terms, for the ellipse at rest."""
    law = right("13a" if label == "16:x" else "13b").difference
    rest = law - truncated(small(law), 1)
    return Dropped(put(rest, _moving("16")), s.omega0**2 * right(label).rhs, SEMI_AXES)


def _slow_speeds(label: str) -> Dropped:
    return Dropped(right("20.5:2").rhs - right("20.6").rhs, right(label).rhs, SEMI_AXES)


def _balance(label: str) -> Dropped:
    kept = right(label).difference
    return Dropped(right("23.3").difference - kept, kept, SEMI_AXES)


def _harmonics(label: str) -> Dropped:
    return Dropped(dropped_harmonics(label), right(label).rhs, SEMI_AXES)


def of_circles(expression: Expr) -> Expr:
    """The two circular motions in the letters of the ellipse, whose orders are counted."""
    return parted(expression.xreplace(s.CIRCLES))


def _circles(label: str) -> Dropped:
    """The line before, or the equation before, less what is kept."""
    before = {"A7:2": "A7:1", "A8:2": "A8:1", "A8:3": "A8:2"}[label]
    kept = right(label).rhs
    return Dropped(of_circles(right(before).rhs - kept), of_circles(kept), SEMI_AXES)


def _equation(label: str) -> Dropped:
    kept = right(label).difference
    before = {"A16": right("A15").difference, "A19:1": right("A18").difference / 2}[label]
    return Dropped(before - kept, kept, SEMI_AXES)


def _moment(label: str) -> Dropped:
    kept = right(label).rhs
    return Dropped(right("B1:1").rhs - kept, kept, SEMI_AXES)


def _angle_of_a_swing(label: str) -> Dropped:
    """By (25), what stays of it with ω0 for ω."""
    whole = right(label).lhs
    return Dropped(whole - whole.xreplace({s.omega: s.omega0}), right(label).rhs, SEMI_AXES)


def _carried(label: str) -> Dropped:
    kept = right(label).rhs
    below = {cos(s.theta): sqrt(1 - (s.x**2 + s.y**2) / s.l**2)}
    return Dropped(right("B4:1").rhs.xreplace(below) - kept, kept, DISPLACEMENTS)


def _of_radii(label: str) -> Dropped:
    """The term after those that are kept, of the series of the exact rates."""
    (time,), (azimuth,) = (right(q).integrals for q in ("C8", "C9"))
    third, moment = right("C7").rhs, (-right("C5").rhs).subs(s.u, 1)
    found = frequency(time.args[0], third)
    if label == "C11":
        found = product(found, found)
    else:
        found = precession(time.args[0], azimuth.args[0], third, moment)
    left_out = found[-1].xreplace({s.g: s.omega0**2 * s.l})
    return Dropped(left_out, right(label).rhs, RADII)


@cache
def _seventh() -> Expr:
    """The left side of (12) up to the seventh order: that is where the next terms are."""
    return truncated(small(right("12").lhs), 7).xreplace(_RHO)


def _fifth(label: str) -> Dropped:
    kept = right(label).difference
    return Dropped(expand(_seventh() - kept), kept, DISPLACEMENTS)


def _next_order(label: str) -> Dropped:
    """The term after those that are kept, by (12) up to the seventh order."""
    swing, turning = rates(_seventh())
    square = Add(*(swing[k] * swing[3 - k] for k in range(4)))
    left_out = s.omega0 * turning[3] if label == "D2" else s.omega0**2 * square
    return Dropped(left_out, right(label).rhs, AXES)


_DROPPING: dict[str, Callable[[str], Dropped]] = {
    "12.1": _series,
    "12.2": _series,
    "12.3:1": _series,
    "13a": _cubic,
    "13b": _cubic,
    "16:x": _linear,
    "16:y": _linear,
    "20.6": _slow_speeds,
    "20.8:1": _harmonics,
    "20.10:2": _harmonics,
    "23.4": _balance,
    "A7:2": _circles,
    "A8:2": _circles,
    "A8:3": _circles,
    "A16": _equation,
    "A19:1": _equation,
    "B1:2": _moment,
    "B3": _angle_of_a_swing,
    "B4:2": _carried,
    "C11": _of_radii,
    "D1": _fifth,
    "D2": _next_order,
    "D3": _next_order,
    "C12": _of_radii,
}


def drops(label: str) -> bool:
    """Whether the step to this formula drops anything."""
    return label in _DROPPING


@cache
def dropped(label: str) -> Dropped:
    """What the step to this formula drops; KeyError where it drops nothing."""
    return _DROPPING[label](label)


@cache
def remainders() -> tuple[Remainder, ...]:
    """Of every step that drops terms of a higher order, in the paper's order.

    The third harmonics that an averaging step drops are of the same order as what it keeps: they
    are in `dropped_harmonics`. 20.9:1 only passes on what 20.6 dropped.
    """
    found: list[Remainder] = []
    for label in _DROPPING:
        if formula(label).step.kind != StepKind.AVERAGE:
            one = dropped(label)
            order, term = leading(graded(one.dropped, one.orders))
            found.append(Remainder(label, highest(one.kept, one.orders), order, factor(term)))
        if label == "20.6":
            speeds, place = dropped("20.6"), right("20:x").rhs
            order, term = leading(graded(place * speeds.dropped, SEMI_AXES))
            kept = highest(right("20.9:1").rhs, SEMI_AXES)
            found.append(Remainder("20.9:1", kept, order, factor(term)))
    return tuple(found)


def highest(kept: Expr, orders: Mapping[Expr, int]) -> int:
    """Give the order of the smallest of the terms that are kept; ω² − ω0² counts as one letter."""
    letters = {q: order for q, order in orders.items() if q != SHIFT}
    letters[_SHIFTED] = orders.get(SHIFT, 0)
    whole = kept.subs(s.omega**2 - s.omega0**2, _SHIFTED)
    terms = Add.make_args(expand(graded(whole, letters)))
    return max(int(leading_power(term)) for term in terms)


def leading_power(term: Expr) -> Expr:
    """Give the power of ε with which a product begins."""
    coefficient, power = term.as_coeff_exponent(EPS)
    return power + leading(coefficient)[0] if coefficient.has(EPS) else power


def as_said(one: Formula) -> bool:
    """Whether what the step says it neglects is what it drops, to leading order: sign, factor, all.

    A step that says nothing must drop nothing.
    """
    if not drops(one.label) or not one.step.neglected:
        return drops(one.label) == bool(one.step.neglected)
    said, found = read(one.step.neglected), dropped(one.label)
    if said.op:
        return False
    if one.step.kind == StepKind.AVERAGE:
        return is_zero(of_circles(said.lhs) - found.dropped)
    claimed = _claimed(said.lhs, found.orders)
    rest, order = graded(found.dropped.xreplace(_RHO), found.orders), leading(claimed)[0]
    return leading(rest - claimed)[0] > order and is_zero(
        claimed - EPS**order * claimed.subs(EPS, 1)
    )


def _claimed(said: Expr, orders: Mapping[Expr, int]) -> Expr:
    """What is said to be neglected, in the letters whose orders are counted."""
    if orders is DISPLACEMENTS:
        return graded(said.xreplace(_RHO), orders)
    return graded(of_circles(put(said, _moving("16"))), orders)


def order_said(one: Formula) -> int | None:
    """The order of what the step says it neglects, which `as_said` holds against what it drops."""
    if not one.step.neglected:
        return None
    return leading(_claimed(read(one.step.neglected).lhs, dropped(one.label).orders))[0]


def dropped_harmonics(label: str) -> Expr:
    """The third harmonics that the averaged formula drops: "20.8:1", "20.10:2"."""
    previous = {"20.8:1": "20.7:3", "20.10:2": "20.10:1"}[label]
    return factor(harmonic(right(previous).rhs, 3))


def third_harmonic() -> Expr:
    """What the dropped third harmonics would add to x, to leading order.

    The driven oscillator ẍ3 + ω0² x3 = −(third harmonics of (13a)'s cubic terms), at 3ω0.
    """
    cubic = right("13a").difference - (s.xdd + s.omega0**2 * s.x)
    place, speed = right("20.7:3"), right("20.10:1")
    terms = put(cubic, {place.lhs: place.rhs, speed.lhs: speed.rhs})
    drive = harmonic(terms.xreplace({s.omega**2: s.omega0**2}), 3)
    return factor(drive / (8 * s.omega0**2))


def imbalance(label: str) -> Expr:
    """First harmonics of (13a) or (13b) with (20) put in exactly: cubic terms, Ω² and all."""
    return harmonic(carry_out(put(right(label).difference, motion())), 1)
