"""Ways in which conditions can fail: at which steps that shows, and which conditions exclude it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import SHIFT, graded, is_zero, leading, supposing
from kugelpendel.paper.algebra.notation import denominators, read
from kugelpendel.paper.algebra.requirement import Requirement, required
from kugelpendel.paper.algebra.symbols import CIRCLES, STILL, Ddt
from kugelpendel.paper.algebra.sympy_names import Abs, Add, Expr, Pow, Rational, diff, mp, mpf
from kugelpendel.paper.checks.remainders import dropped, drops, highest
from kugelpendel.paper.derivation.graph import parts, premises, right
from kugelpendel.paper.derivation.model import Condition, Formula, StepKind
from kugelpendel.paper.proofs.numeric import EXPONENT
from kugelpendel.paper.proofs.worlds import DIGITS, World, kinematic

Breaks = Callable[[Formula], bool]
Fails = Callable[[Condition], bool]
_POSED = (StepKind.LAW, StepKind.DEFINE)
_FIRST = {s.T, s.z}  # the letters of the conditions of the first equations


@dataclass(frozen=True)
class Probe:
    """One way in which conditions fail: which of them do, and which steps break.

    `is_size`: whether something is not as small as it is taken to be. Then a condition that the
    paper states must be named, if it states one, and not only a stronger one that it does not.
    """

    name: str
    fails: Fails
    breaks: Breaks
    is_size: bool = False


def in_world(name: str, make: Callable[[int], World], key: str = "") -> Probe:
    """A world in which a law or a definition is false; what follows from it is not asked."""

    def breaks(one: Formula) -> bool:
        if one.step.kind not in _POSED or one.section > 2:
            return False
        relation = right(one.label)
        with mp.workdps(DIGITS):
            world = make(0)
            rest = world.value(relation.lhs) - world.value(relation.rhs)
        return abs(rest) > mpf(10) ** (-20)

    return Probe(name, fails_in(make, key), breaks)


def fails_in(make: Callable[[int], World], key: str = "") -> Fails:
    """A condition fails in that world; one without a formula fails where its key says so."""

    def fails(condition: Condition) -> bool:
        if not condition.latex:
            return condition.key == key
        if demands(condition).isdisjoint(_FIRST):
            return False
        with mp.workdps(DIGITS):
            return not all(is_so(one, make(0)) for one in required(condition.latex))

    return fails


def is_so(one: Requirement, world: World) -> bool:
    """Whether a requirement holds in a world; "≪" asks for six orders of magnitude."""
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


def demands(condition: Condition) -> set[Expr]:
    """Give the letters of which a condition speaks."""
    demanded = required(condition.latex)
    return {q for one in demanded for q in one.left.free_symbols | one.right.free_symbols}


def at_place(name: str, values: Mapping[Expr, Expr], above: bool = False) -> Probe:
    """A place where something divides by zero or, above the support, the root changes its sign."""

    def breaks(one: Formula) -> bool:
        if any(_is_nothing(e.subs(values)) for e in _divisors(one)):
            return True
        return above and _has_other_root(one)

    return Probe(name, fails_at(values), breaks)


def fails_at(place: Mapping[Expr, Expr]) -> Fails:
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
    if one.step.kind == StepKind.DIVIDE:
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


def with_moving(name: str, *letters: Expr) -> Probe:
    """A constant that changes with time."""
    rates = {letter: STILL[letter] for letter in letters}
    moved = set(rates.values())
    for circular, meaning in CIRCLES.items():  # they move with what they are made of
        rates[circular] = Add(*(diff(meaning, letter) * STILL[letter] for letter in letters))

    def fails(condition: Condition) -> bool:
        return bool(condition.latex) and not demands(condition).isdisjoint(moved)

    def breaks(one: Formula) -> bool:
        with supposing(rates) as asked:
            residuals = one.proof.symbolic(right(one.label), premises(one))
            if not asked and not any(residual.has(Ddt) for residual in residuals):
                return False
            return not all(is_zero(residual) for residual in residuals)

    return Probe(name, fails, breaks)


def of_size(
    name: str, counting: Mapping[Expr, int], orders: Mapping[Expr, int], at_rest: bool = False
) -> Probe:
    """A quantity that is not as small as it is taken to be, for steps that count in these orders.

    `at_rest`: for the ellipse of section 3, which does not turn.
    """

    def order(e: Expr) -> int:
        return leading(graded(e, orders))[0]

    def fails(condition: Condition) -> bool:
        if not condition.latex or "≪" not in {one.sign for one in required(condition.latex)}:
            return False
        counted = {s.omega if letter == SHIFT else letter for letter in orders}
        if demands(condition).isdisjoint(counted):
            return False
        sides = [(_bare(one.left), _bare(one.right)) for one in required(condition.latex)]
        return any(order(left) <= order(right_side) for left, right_side in sides)

    def breaks(one: Formula) -> bool:
        if not drops(one.label) or one.step.kind == StepKind.AVERAGE:
            return False
        work = dropped(one.label)
        if work.orders is not counting or (one.section == 3) != at_rest:
            return False
        return order(work.dropped) <= highest(work.kept, orders)

    return Probe(name, fails, breaks, is_size=True)


def _bare(e: Expr) -> Expr:
    """Without bars; |ω − ω0| counts as what ω² − ω0² does."""
    inner = e.args[0] if isinstance(e, Abs) else e
    return s.omega**2 - s.omega0**2 if inner == s.omega - s.omega0 else inner


def in_words(name: str, key: str, breaks: Breaks) -> Probe:
    """What only words can say."""

    def fails(condition: Condition) -> bool:
        return condition.key == key

    return Probe(name, fails, breaks)
