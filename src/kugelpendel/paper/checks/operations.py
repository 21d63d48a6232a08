"""Whether a step is what it is called: each kind is carried out on the premises, and compared.

The proofs of the formulas are written one by one; here each kind of step has one meaning for all
formulas, and takes its factor, function or unit vector from `Step.detail` as it is typeset. A step
must fit its own kind, and no other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out, is_constant_multiple, is_zero, rate, taylor
from kugelpendel.paper.algebra.calculus import small
from kugelpendel.paper.algebra.notation import NotationError, Relation, components, read
from kugelpendel.paper.algebra.symbols import RATE, VECTORS, Ddt
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Mul, Pow, cos, diff, expand, sin, sqrt
from kugelpendel.paper.checks.remainders import dropped, drops
from kugelpendel.paper.derivation.graph import FORMULAS, parts, right
from kugelpendel.paper.derivation.model import Formula, Kind, Step

# What the paper's words introduce before any formula does.
_GIVEN = {s.m, s.g, s.l, s.T, s.r, *s.CARTESIAN, *s.SPHERICAL}
_WITH_DETAIL = {Kind.PROJECT, Kind.MULTIPLY, Kind.DIVIDE, Kind.COMPLETE, Kind.SOLVE, Kind.COMPARE}
_PLACES = {vector: 0 for latex, vector in VECTORS.items() if "L" not in latex}
_INEXACT = {Kind.EXPAND, Kind.AVERAGE, Kind.NEGLECT, Kind.SOLVE}
_BASE = {dot: q for q, dot in RATE.items()}


@dataclass(frozen=True)
class Work:
    """What a step starts from and where it leads."""

    one: Formula
    step: Step
    relation: Relation
    premises: tuple[Relation, ...]
    before: Relation | None  # the line that a line of a chain goes on from

    def detail(self) -> tuple[Expr, ...]:
        """What the step is done with, as expressions; two sides of an equation are one thing."""
        pieces = [piece.replace(r"\quad", "").strip() for piece in self.step.detail.split(",")]
        relations = [read(piece) for piece in pieces if piece]
        if any(relation.op == "=" and self._differ(relation) for relation in relations):
            return ()
        return tuple(relation.lhs for relation in relations)

    def _differ(self, relation: Relation) -> bool:
        return not is_zero(_put(relation.difference, _rules(self.premises)))


def is_done(one: Formula, step: Step | None = None) -> bool:
    """Whether what leads to the formula is what its step says, or what another step would say."""
    taken = step or one.step
    premises = tuple(right(part.label) for name in taken.premises for part in parts(name))
    before = right(_previous(one)) if one.head else None
    work = Work(one, taken, right(one.label), premises, before)
    if taken.detail and taken.kind not in _WITH_DETAIL:
        return False
    if drops(one.label) and taken.kind not in _INEXACT:
        return False
    try:
        return _MEANING[taken.kind](work)
    except NotationError:
        return False


def _previous(one: Formula) -> str:
    return FORMULAS[next(k for k, f in enumerate(FORMULAS) if f.label == one.label) - 1].label


def _rules(relations: tuple[Relation, ...]) -> dict[Expr, Expr]:
    """Left side → right side, sums first: what they are made of must not be replaced before."""
    found = {relation.lhs: relation.rhs for relation in relations if relation.op not in ("", "≪")}
    return dict(sorted(found.items(), key=lambda rule: rule[0].is_Symbol))


def _put(expression: Expr, rules: dict[Expr, Expr]) -> Expr:
    for left, replaced in rules.items():
        expression = expression.subs(left, replaced)
        if left == s.rho**2:
            expression = expression.xreplace({s.rho: sqrt(replaced)})
    return expression


def _same(first: Expr, second: Expr) -> bool:
    return is_zero(first - second)


def _same_equation(first: Expr, second: Expr) -> bool:
    """Whether both vanish together: equal, or of opposite sign."""
    return _same(first, second) or is_zero(first + second)


def _letters(relation: Relation) -> set[Expr]:
    """All letters; a derivative counts as what it is the derivative of, r⃗ and its own as none."""
    sides = [side.subs(_PLACES) for side in (relation.lhs, relation.rhs)]
    found: set[Expr] = set()
    for letter in sides[0].free_symbols | sides[1].free_symbols:
        while letter in _BASE:
            letter = _BASE[letter]
        found.add(letter)
    return found


def _new_letters(work: Work) -> set[Expr]:
    """Those that no earlier display has, and that the paper's words have not introduced."""
    known = set(_GIVEN)
    for formula in FORMULAS:
        if formula.display == work.one.display:
            break
        known |= _letters(right(formula.label))
    return _letters(work.relation) - known


def _is_law(work: Work) -> bool:
    """Nothing is named: every quantity has a meaning before the formula relates them."""
    return work.relation.op == "=" and _letters(work.relation) <= _GIVEN


def _is_definition(work: Work) -> bool:
    """A letter appears for the first time, and nothing earlier is worked on."""
    named = work.relation.op == "=" and bool(_new_letters(work))
    return named and not work.step.premises


def _is_assumption(work: Work) -> bool:
    return not work.step.premises and work.relation.op == "≪"


def _is_ansatz(work: Work) -> bool:
    """An earlier solution with its letters exchanged, one of them for a new one."""
    if not _new_letters(work):
        return False
    renamed = {s.x: s.xp, s.y: s.yp, s.omega0: s.omega}
    return any(work.relation == p.apply(lambda e: e.xreplace(renamed)) for p in work.premises)


def _is_rearranged(relation: Relation, premise: Relation) -> bool:
    if relation.op == "" or premise.op == "":
        return False
    sides = _same(relation.lhs, premise.lhs) and _same(relation.rhs, premise.rhs)
    return sides or (relation.op == premise.op == "=" and is_constant_multiple(relation.difference, premise.difference))


def _is_rearrangement(work: Work) -> bool:
    """An identity: no premise is needed for it but the line that it starts from."""
    if work.relation.op == "":
        return False
    if work.before is not None:
        return _same(work.relation.rhs, work.before.rhs) and not _is_differentiated(work)
    return any(_is_rearranged(work.relation, p) for p in work.premises) and not _is_differentiated(work)


def _is_substitution(work: Work) -> bool:
    """True by putting premises in, into the formula or into one of them, and not without."""
    if work.relation.op in ("", "≪") or not work.premises:
        return False
    if any(_MEANING[kind](work) for kind in _PLAINER):
        return False
    if work.before is not None:
        rest = work.relation.rhs - work.before.rhs
        others = tuple(p for p in work.premises if p != work.before)
        return bool(others) and not is_zero(rest) and _vanishes(rest, others)
    if is_zero(work.relation.difference):
        return False
    return _vanishes(work.relation.difference, work.premises) or any(_hosted(work))


def _vanishes(expression: Expr, premises: tuple[Relation, ...]) -> bool:
    if any(p.op == "" for p in premises):
        return False
    once = _put(expression, _rules(premises))
    return is_zero(once) or is_zero(_put(once, _rules(premises))) or any(
        is_zero(_put(expression, rules)) for rules in _solved(premises)
    )


def _solved(premises: tuple[Relation, ...]) -> Iterator[dict[Expr, Expr]]:
    """A premise such as xÿ = yẍ, solved for a letter."""
    for premise in premises:
        if isinstance(premise.lhs, Mul):
            for letter in premise.lhs.free_symbols - premise.rhs.free_symbols:
                if diff(premise.lhs, letter, 2) == 0:
                    yield {letter: premise.rhs / (premise.lhs / letter)}


def _hosted(work: Work) -> Iterator[bool]:
    for host in work.premises:
        others = tuple(p for p in work.premises if p.lhs != host.lhs or p is not host)
        others = tuple(p for p in others if p != host)
        if host.op != "" and others:
            yield _same_equation(_put(host.difference, _rules(others)), work.relation.difference)


def _is_differentiation(work: Work) -> bool:
    """Both sides of a premise differentiated, or a d/dt that stands there carried out."""
    if work.relation.op == "":
        return False
    if _is_differentiated(work):
        return True
    moved = (p for p in work.premises if p.op == "=")
    return work.before is None and any(
        not is_zero(rate(p.lhs)) and _same(work.relation.lhs, rate(p.lhs)) and _same(work.relation.rhs, rate(p.rhs))
        for p in moved
    )


def _is_differentiated(work: Work) -> bool:
    if work.relation.rhs.has(Ddt) or (work.before is None and work.relation.lhs.has(Ddt) and not work.premises):
        return False
    if work.before is not None:
        return work.before.rhs.has(Ddt) and work.relation.rhs != 0 and _same(work.relation.rhs, work.before.rhs)
    if work.relation.lhs.has(Ddt):
        return _same(work.relation.lhs, work.relation.rhs)
    sources = (side for p in work.premises for side in (p.lhs, p.rhs) if side.has(Ddt))
    return any(_same_equation(work.relation.difference, source) for source in sources)


def _is_projection(work: Work) -> bool:
    """The part of a vector equation along a unit vector; or a unit vector's parts along others."""
    detail = work.detail()
    if not detail or work.relation.op != "=":
        return False
    if work.relation.lhs in s.CARTESIAN:
        return _is_resolved(work, detail)
    unit, factor = detail[0], Mul(*detail[1:])
    if unit not in s.SPHERICAL:
        return False
    return any(
        _same_equation(factor * components(p.difference.expand(), s.SPHERICAL)[s.SPHERICAL.index(unit)], work.relation.difference)
        for p in work.premises
        if p.difference.has(*s.SPHERICAL)
    )


def _is_resolved(work: Work, scales: tuple[Expr, ...]) -> bool:
    """e_r, e_θ, e_φ are the directions in which the place changes with l, θ, φ, times the scales."""
    place = {p.lhs: p.rhs for p in work.premises}
    if set(place) != {s.x, s.y, s.z} or len(scales) != 3:
        return False
    rules = {
        unit: scale * Add(*(diff(place[q], letter) * e for q, e in zip((s.x, s.y, s.z), s.CARTESIAN, strict=True)))
        for unit, letter, scale in zip(s.SPHERICAL, (s.l, s.theta, s.phi), scales, strict=True)
    }
    lengths = [
        Add(*(part**2 for part in components(unit.expand(), s.CARTESIAN))) for unit in rules.values()
    ]
    rest = work.relation.difference.xreplace(rules).expand()
    parts_left = components(rest, s.CARTESIAN)
    return all(is_zero(e) for e in (*parts_left, *(length - 1 for length in lengths)))


def _scaled(work: Work, power: int) -> bool:
    detail = work.detail()
    if len(detail) != 1 or work.relation.op != "=":
        return False
    factor = Pow(detail[0], power)
    if factor in (1, -1):
        return False
    for premise in work.premises:
        if premise.op != "=" or premise.rhs != work.relation.rhs:
            continue
        others = tuple(p for p in work.premises if p is not premise)
        claimed, given = carry_out(work.relation.lhs), factor * premise.lhs
        if _same(claimed, given):
            return True
        rules = _rules(others)
        natural = {s.omega0: sqrt(s.g / s.l)}
        if others and _same(_put(claimed, rules).xreplace(natural), _put(given, rules).xreplace(natural)):
            return True
    return False


def _is_completion(work: Work) -> bool:
    """A term to be added, or a sum in which it stands once with each sign and nothing else changes."""
    if work.relation.op == "":
        return bool(work.step.premises) and not work.step.detail
    term = work.step.detail.removeprefix(r"\pm").strip()
    bare, text = term.replace(" ", ""), work.one.right.replace(" ", "")
    added = work.step.detail.startswith(r"\pm") and f"+{bare}" in text and f"-{bare}" in text
    if not added or read(term).op:
        return False
    sides = text.partition("=")
    unchanged = sides[2].replace(f"+{bare}-{bare}", "", 1)
    return unchanged == sides[0] and any(p.op == "" and _same(p.lhs, read(term).lhs) for p in work.premises)


def _is_expansion(work: Work) -> bool:
    """A function that is no polynomial, and the beginning of its series, without a premise."""
    relation = work.relation
    if work.step.premises or not drops(work.one.label) or r"\dots" not in work.one.right:
        return False
    beginning = Add(*taylor(small(relation.lhs), 3))
    return is_zero(relation.rhs - beginning) and not is_zero(relation.difference)


def _is_average(work: Work) -> bool:
    """Third harmonics are dropped, and nothing else."""
    if not drops(work.one.label) or not work.premises:
        return False
    gone = dropped(work.one.label).dropped
    kept = (work.before or work.premises[-1]).rhs - gone
    multiples = {f.args[0].as_coeff_Mul()[0] for f in gone.atoms(sin, cos) if f.has(s.omega)}
    return multiples == {3} and _same(work.relation.rhs, kept)


def _is_neglect(work: Work) -> bool:
    """Terms of a higher order are dropped, from something that a premise says."""
    if not drops(work.one.label) or not work.step.premises or _is_average(work):
        return False
    return not _is_solution(work)


def _is_solution(work: Work) -> bool:
    """A single letter on the left that is not on the right, and that satisfies a premise."""
    left = work.relation.lhs
    letter = left.base if isinstance(left, Pow) else left
    if not letter.is_Symbol or work.relation.op != "=" or work.relation.rhs.has(letter) or work.before:
        return False
    return any(_satisfies(work, letter, premise) for premise in work.premises if premise.lhs != left)


def _satisfies(work: Work, letter: Expr, premise: Relation) -> bool:
    if not premise.difference.has(letter) or premise.op != "=":
        return False
    equation = premise.difference - (read(work.step.neglected).lhs if work.step.neglected else 0)
    factor = work.detail()
    if letter not in RATE:  # a number to be found: what stands before it is divided by
        if len(factor) != 1 or not _same(diff(premise.difference, letter), factor[0]):
            return False
    elif factor:
        return False
    rules, found, place = {letter: work.relation.rhs}, work.relation.rhs, letter
    while place in RATE:
        place, found = RATE[place], diff(found, s.t)
        rules[place] = found
    return is_zero(equation.xreplace(rules))


def _is_comparison(work: Work) -> bool:
    """The factor of one function of time."""
    detail = work.detail()
    if len(detail) != 1 or work.relation.rhs != 0 or not detail[0].has(s.t):
        return False
    return any(
        _same_equation(expand(p.difference).coeff(detail[0]), work.relation.lhs) for p in work.premises
    )


def _summed(work: Work, way: int) -> bool:
    if len(work.premises) != 2 or work.before is not None:
        return False
    first, second = work.premises
    return _same(work.relation.lhs, first.lhs + way * second.lhs) and _same(
        work.relation.rhs, first.rhs + way * second.rhs
    )


_MEANING: dict[Kind, Callable[[Work], bool]] = {
    Kind.LAW: _is_law,
    Kind.DEFINE: _is_definition,
    Kind.ASSUME: _is_assumption,
    Kind.ANSATZ: _is_ansatz,
    Kind.SUBSTITUTE: _is_substitution,
    Kind.DIFFERENTIATE: _is_differentiation,
    Kind.PROJECT: _is_projection,
    Kind.MULTIPLY: lambda work: _scaled(work, 1),
    Kind.DIVIDE: lambda work: _scaled(work, -1),
    Kind.REARRANGE: _is_rearrangement,
    Kind.COMPLETE: _is_completion,
    Kind.EXPAND: _is_expansion,
    Kind.AVERAGE: _is_average,
    Kind.NEGLECT: _is_neglect,
    Kind.SOLVE: _is_solution,
    Kind.COMPARE: _is_comparison,
    Kind.ADD: lambda work: _summed(work, 1),
    Kind.SUBTRACT: lambda work: _summed(work, -1),
}
_PLAINER = (Kind.REARRANGE, Kind.DIFFERENTIATE, Kind.ADD, Kind.SUBTRACT)
