"""Which conditions each step needs, found by violating one after the other.

A probe is a place or a world in which some condition fails. The step breaks there if what it says,
its premises or what it is done with divides by zero, if the formula no longer follows from the
premises, or if what it drops is no longer small beside what it keeps. A step must name a condition
that excludes each probe at which it breaks, and none without which another one would exclude the
same. Only what the paper says itself may stand beside something stronger that it does not say.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import (
    DISPLACEMENTS,
    SEMI_AXES,
    SHIFT,
    graded,
    is_zero,
    leading,
    supposing,
)
from kugelpendel.paper.algebra.notation import NotationError, denominators, read
from kugelpendel.paper.algebra.requirement import Requirement, required
from kugelpendel.paper.algebra.symbols import STILL, Ddt
from kugelpendel.paper.algebra.sympy_names import Abs, Expr, Integer, Pow, Rational, cos, mp, mpf, pi, sin, sqrt
from kugelpendel.paper.checks.remainders import dropped, drops, highest
from kugelpendel.paper.derivation.graph import FORMULAS, parts, premises, rests_on, right
from kugelpendel.paper.derivation.model import Condition, Formula, Kind
from kugelpendel.paper.proofs.numeric import EXPONENT
from kugelpendel.paper.proofs.violations import slack, turning_frame, upwards
from kugelpendel.paper.proofs.worlds import DIGITS, World, balanced, dynamic, kinematic

Breaks = Callable[[Formula], bool]
Fails = Callable[[Condition], bool]
_POSED = (Kind.LAW, Kind.DEFINE)


@dataclass(frozen=True)
class Probe:
    """One way in which conditions fail: which of them do, and which steps break."""

    name: str
    fails: Fails
    breaks: Breaks


def faults(one: Formula) -> tuple[str, ...]:
    """Say which conditions a step lacks, which it does not need, and which do not hold at all."""
    found: list[str] = []
    needless = list(one.step.conditions)
    for probe in PROBES:
        if not _broken(probe.name, one.label):
            continue
        excluding = [condition for condition in one.step.conditions if probe.fails(condition)]
        if not excluding:
            found.append(f"needs a condition against: {probe.name}")
        for condition in excluding:
            others = [other for other in excluding if other is not condition]
            stated = not condition.silent and all(other.silent for other in others)
            if condition in needless and (not others or stated):
                needless.remove(condition)
    found.extend(f"does not need the condition {condition.key}" for condition in needless)
    found.extend(
        f"names the condition {condition.key}, which is not met"
        for condition in one.step.conditions
        if not is_met(condition)
    )
    return tuple(found)


@cache
def _broken(name: str, label: str) -> bool:
    """Whether the step breaks at a probe; it does not depend on the conditions it names."""
    probe = next(one for one in PROBES if one.name == name)
    return probe.breaks(next(one for one in FORMULAS if one.label == label))


# -- Where a condition is met, or fails -----------------------------------------------------------


def is_met(condition: Condition) -> bool:
    """Whether a condition can be read, and holds in motions that the paper is about."""
    if not condition.latex:
        return True
    try:
        demanded = required(condition.latex)
    except NotationError:
        return False
    still = dict.fromkeys(STILL.values(), Integer(0))
    demanded = tuple(Requirement(r.left.xreplace(still), r.sign, r.right) for r in demanded)
    letters = {q for one in demanded for q in one.left.free_symbols | one.right.free_symbols}
    make = balanced if letters & {s.a, s.b, s.omega, s.Omega} else dynamic
    with mp.workdps(DIGITS + 4 * EXPONENT):
        return all(_holds(one, make(seed, EXPONENT)) for one in demanded for seed in range(3))


def _holds(one: Requirement, world: World) -> bool:
    left, right_side = world.value(one.left), world.value(one.right)
    scale = max(abs(left), abs(right_side)) * mpf(10) ** (-50)
    match one.sign:
        case "=":
            return abs(left - right_side) <= scale
        case "≠":
            return abs(left - right_side) > scale
        case "≪":
            return bool(0 <= left < right_side * mpf(10) ** (-EXPONENT / 2))
        case "≥":
            return bool(left >= right_side)
        case ">":
            return bool(left > right_side)
        case "≤":
            return bool(left <= right_side)
        case _:
            return bool(left < right_side)


def _fails_in(make: Callable[[int], World], key: str = "") -> Fails:
    """A condition fails in that world; one without a formula fails where its key says so."""

    def fails(condition: Condition) -> bool:
        if not condition.latex:
            return condition.key == key
        if _demands(condition).isdisjoint(_FIRST):
            return False
        with mp.workdps(DIGITS):
            return not all(_holds(one, make(0)) for one in required(condition.latex))

    return fails


_FIRST = {s.T, s.z}  # the letters of the conditions of the first equations


def _demands(condition: Condition) -> set[Expr]:
    demanded = required(condition.latex)
    return {q for one in demanded for q in one.left.free_symbols | one.right.free_symbols}


def _fails_at(place: Mapping[Expr, Expr]) -> Fails:
    """A condition fails at a place, where some of its letters have special values."""

    def fails(condition: Condition) -> bool:
        if not condition.latex:
            return False
        return any(_fails_for(one, place) for one in required(condition.latex))

    return fails


def _fails_for(one: Requirement, place: Mapping[Expr, Expr]) -> bool:
    left, right_side = one.left.subs(place), one.right.subs(place)
    if (left, right_side) == (one.left, one.right):
        return False
    gap = left - right_side
    match one.sign:
        case "=":
            return gap != 0
        case "≠":
            return gap == 0
        case "≪":
            return bool((Abs(left) - Abs(right_side) * Rational(1, 1000)).is_positive)
        case "≥":
            return bool(gap.is_negative)
        case ">":
            return bool(gap.is_nonpositive)
        case "≤":
            return bool(gap.is_positive)
        case _:
            return bool(gap.is_nonnegative)


# -- Probes of the single kinds -------------------------------------------------------------------


def _world(name: str, make: Callable[[int], World], key: str = "") -> Probe:
    """A world in which a law or a definition is false; what follows from it is not asked."""

    def breaks(one: Formula) -> bool:
        if one.step.kind not in _POSED or one.section > 2:
            return False
        relation = right(one.label)
        with mp.workdps(DIGITS):
            world = make(0)
            rest = world.value(relation.lhs) - world.value(relation.rhs)
        return abs(rest) > mpf(10) ** (-20)

    return Probe(name, _fails_in(make, key), breaks)


def _place(name: str, values: Mapping[Expr, Expr], above: bool = False) -> Probe:
    """A place where something divides by zero or, above the support, the root changes its sign."""

    def breaks(one: Formula) -> bool:
        if any(_is_nothing(e.subs(values)) for e in _divisors(one)):
            return True
        return above and _has_other_root(one)

    return Probe(name, _fails_at(values), breaks)


def _is_nothing(divisor: Expr) -> bool:
    return bool(divisor == 0 or divisor.is_zero or is_zero(divisor))


def _divisors(one: Formula) -> set[Expr]:
    """Everything that a step divides by, in what it says, stands on and is done with."""
    used = [part.right for name in one.step.premises for part in parts(name)]
    details = [one.step.detail] if one.step.detail and "," not in one.step.detail else []
    details += [piece for piece in one.step.detail.split(",") if "," in one.step.detail]
    found: set[Expr] = set()
    for latex in (one.right, *used, *details):
        found.update(denominators(latex.removeprefix(r"\pm")))
    if one.step.kind == Kind.DIVIDE:
        found.add(read(one.step.detail).lhs)
    return {e for e in found if e.free_symbols}


def _has_other_root(one: Formula) -> bool:
    """Whether the step fails above the support, where √(1 − sin²θ) is −cos θ."""
    residuals = one.proof.symbolic(right(one.label), premises(one)) if one.section < 3 else []
    with mp.workdps(DIGITS):
        world = kinematic(0, above=True)
        for residual in residuals:
            rooted = any(p.exp.is_Rational and p.exp.q == 2 for p in residual.atoms(Pow))
            if rooted and not is_zero(residual):
                continue
            if rooted and abs(world.value(residual)) > mpf(10) ** (-20):
                return True
    return False


def _constant(name: str, *letters: Expr) -> Probe:
    """A constant that changes with time."""
    rates = {letter: STILL[letter] for letter in letters}

    def fails(condition: Condition) -> bool:
        return bool(condition.latex) and not _demands(condition).isdisjoint(rates.values())

    def breaks(one: Formula) -> bool:
        with supposing(rates) as asked:
            residuals = one.proof.symbolic(right(one.label), premises(one))
            if not asked and not any(residual.has(Ddt) for residual in residuals):
                return False
            return not all(is_zero(residual) for residual in residuals)

    return Probe(name, fails, breaks)


def _size(name: str, section: int, orders: Mapping[Expr, int]) -> Probe:
    """A quantity that is not as small as it is taken to be."""

    def order(e: Expr) -> int:
        return leading(graded(e, orders))[0]

    def fails(condition: Condition) -> bool:
        if not condition.latex or "≪" not in {one.sign for one in required(condition.latex)}:
            return False
        counted = {s.omega if letter == SHIFT else letter for letter in orders}
        if _demands(condition).isdisjoint(counted):
            return False
        sides = [(_bare(one.left), _bare(one.right)) for one in required(condition.latex)]
        return any(order(left) <= order(right_side) for left, right_side in sides)

    def breaks(one: Formula) -> bool:
        if one.section != section or not drops(one.label) or one.step.kind == Kind.AVERAGE:
            return False
        work = dropped(one.label)
        return order(work.dropped) <= highest(work.kept, orders)

    return Probe(name, fails, breaks)


def _bare(e: Expr) -> Expr:
    """Without bars; |ω − ω0| counts as what ω² − ω0² does."""
    inner = e.args[0] if isinstance(e, Abs) else e
    return s.omega**2 - s.omega0**2 if inner == s.omega - s.omega0 else inner


def _named(name: str, key: str, breaks: Breaks) -> Probe:
    """What only words can say."""

    def fails(condition: Condition) -> bool:
        return condition.key == key

    return Probe(name, fails, breaks)


def _exchanges_gravity(one: Formula) -> bool:
    """Whether g stands in what the step is from, and ω0 in what it leads to."""
    before = {q for name in one.step.premises for part in parts(name) for q in _all(part.label)}
    return s.g in before and s.omega0 in _all(one.label) and s.g not in _all(one.label)


def _all(label: str) -> set[Expr]:
    relation = right(label)
    return relation.lhs.free_symbols | relation.rhs.free_symbols


def _is_exchanged(one: Formula) -> bool:
    """Whether ÿ comes out although no premise has it, and nothing is differentiated for it."""
    known = {q for name in one.step.premises for part in parts(name) for q in _all(part.label)}
    return one.step.kind == Kind.NEGLECT and s.ydd in _all(one.label) - known


def _leaves_an_equation_out(one: Formula) -> bool:
    """Whether the bracket that is set to zero comes from (13a) alone: (16) only lends its form."""
    before = set(rests_on(one.label))
    sources = (f for f in FORMULAS if f.label in before and f.section != 3)
    return one.step.kind == Kind.COMPARE and not any("13b" in f.step.premises for f in sources)


def _compares_dependent(one: Formula, values: Mapping[Expr, Expr]) -> bool:
    """Whether one of the functions that are compared is then no function of its own."""
    if one.step.kind != Kind.COMPARE:
        return False
    details = [part.step.detail for part in parts(one.display)]
    return any(is_zero(read(detail).lhs.subs(values)) for detail in details)


def _leaves_harmonics_out(one: Formula) -> bool:
    return one.step.kind in (Kind.AVERAGE, Kind.ANSATZ)


def _no_function(name: str, values: Mapping[Expr, Expr]) -> Probe:
    return Probe(name, _fails_at(values), lambda one: _compares_dependent(one, values))


_AXIS: dict[Expr, Expr] = {
    sin(s.theta): 0, cos(s.theta): 1, s.x: 0, s.y: 0, s.rho: 0,
}  # fmt: skip
_EQUATOR: dict[Expr, Expr] = {
    sin(s.theta): 1, cos(s.theta): 0, s.rho: s.l,
    s.x: 3 * s.l / 5, s.y: 4 * s.l / 5,
}  # fmt: skip
_ABOVE: dict[Expr, Expr] = {
    sin(s.theta): sin(2 * pi / 3), cos(s.theta): cos(2 * pi / 3), s.rho: sqrt(3) / 2 * s.l,
    s.x: s.l / 2, s.y: sqrt(2) / 2 * s.l,
}  # fmt: skip
_SMALL_PLACE = {**DISPLACEMENTS, s.x: 0, s.y: 0, s.rho: 0, s.xdd: 0, s.ydd: 0}

PROBES: tuple[Probe, ...] = (
    _world("a slack thread", slack),
    _world("a frame that turns", turning_frame, "inertial-frame"),
    _world("z counted upwards", upwards),
    _constant("a length that changes", s.l),
    _constant("a turning that changes", s.Omega),
    _constant("semi-axes that change", s.a, s.b),
    _place("on the vertical", _AXIS),
    _place("on the equator", _EQUATOR),
    _place("above the support", _ABOVE, above=True),
    _place("in the plane x = 0", {s.x: 0}),
    _place("a circle, a = b", {s.a: s.b}),
    _place("a circle, a = −b", {s.a: -s.b}),
    _named("ω0² other than g/l", "omega-zero", _exchanges_gravity),
    _size("a large displacement", 2, _SMALL_PLACE),
    _size("a large velocity", 2, {**DISPLACEMENTS, s.xd: 0, s.yd: 0}),
    _size("an ellipse that is not so small", 3, {**SEMI_AXES, s.a: 0, s.b: 0}),
    _size("a fast turning", 4, {**SEMI_AXES, s.Omega: 0}),
    _size("a narrow ellipse", 4, {**SEMI_AXES, s.b: 3}),
    _size("another frequency", 4, {**SEMI_AXES, SHIFT: 0}),
    _size("a turning as fast as the frequency shifts", 4, {**SEMI_AXES, s.Omega: 1}),
    _no_function("no turning", {s.Omega: 0}),
    _named("third harmonics", "third-harmonics", _leaves_harmonics_out),
    _named("an equation for y of its own", "y-equation", _leaves_an_equation_out),
    _named("a direction that differs", "symmetry", _is_exchanged),
)
