"""The kinds of exact step that turn one formula, or two, into another."""

from __future__ import annotations

from collections.abc import Iterator

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out, is_constant_multiple, is_zero, rate
from kugelpendel.paper.algebra.notation import Relation, components, read
from kugelpendel.paper.algebra.symbols import Ddt
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Mul, Pow, diff, expand, sqrt
from kugelpendel.paper.checks.steps.work import Work, put_in, rules, same, same_equation


def is_rearrangement(work: Work) -> bool:
    """An identity: no premise is needed for it but the line that it starts from."""
    if work.relation.op == "":
        return False
    if work.before is not None:
        return same(work.relation.rhs, work.before.rhs) and not _is_differentiated(work)
    return any(_is_rearranged(work.relation, p) for p in work.premises) and not _is_differentiated(
        work
    )


def _is_rearranged(relation: Relation, premise: Relation) -> bool:
    if relation.op == "" or premise.op == "":
        return False
    sides = same(relation.lhs, premise.lhs) and same(relation.rhs, premise.rhs)
    return sides or (
        relation.op == premise.op == "="
        and is_constant_multiple(relation.difference, premise.difference)
    )


def is_differentiation(work: Work) -> bool:
    """Both sides of a premise differentiated, or a d/dt that stands there carried out."""
    if work.relation.op == "":
        return False
    if _is_differentiated(work):
        return True
    moved = (p for p in work.premises if p.op == "=")
    return work.before is None and any(
        not is_zero(rate(p.lhs))
        and same(work.relation.lhs, rate(p.lhs))
        and same(work.relation.rhs, rate(p.rhs))
        for p in moved
    )


def _is_differentiated(work: Work) -> bool:
    if work.relation.rhs.has(Ddt) or (
        work.before is None and work.relation.lhs.has(Ddt) and not work.premises
    ):
        return False
    if work.before is not None:
        return (
            work.before.rhs.has(Ddt)
            and work.relation.rhs != 0
            and same(work.relation.rhs, work.before.rhs)
        )
    if work.relation.lhs.has(Ddt):
        return same(work.relation.lhs, work.relation.rhs)
    sources = (side for p in work.premises for side in (p.lhs, p.rhs) if side.has(Ddt))
    return any(same_equation(work.relation.difference, source) for source in sources)


def is_substitution(work: Work) -> bool:
    """True by putting premises in, into the formula or into one of them, and not without."""
    if work.relation.op in ("", "≪") or not work.premises:
        return False
    if is_rearrangement(work) or is_differentiation(work) or is_sum(work, 1) or is_sum(work, -1):
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
    once = put_in(expression, rules(premises))
    return (
        is_zero(once)
        or is_zero(put_in(once, rules(premises)))
        or any(is_zero(put_in(expression, rules)) for rules in _solved(premises))
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
            yield same_equation(put_in(host.difference, rules(others)), work.relation.difference)


def is_projection(work: Work) -> bool:
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
        same_equation(
            factor * components(p.difference.expand(), s.SPHERICAL)[s.SPHERICAL.index(unit)],
            work.relation.difference,
        )
        for p in work.premises
        if p.difference.has(*s.SPHERICAL)
    )


def _is_resolved(work: Work, scales: tuple[Expr, ...]) -> bool:
    """The units e_r, e_θ, e_φ are scales times the changes of the position with l, θ, φ."""
    place = {p.lhs: p.rhs for p in work.premises}
    if set(place) != {s.x, s.y, s.z} or len(scales) != 3:
        return False
    rules = {
        unit: scale
        * Add(
            *(diff(place[q], letter) * e for q, e in zip((s.x, s.y, s.z), s.CARTESIAN, strict=True))
        )
        for unit, letter, scale in zip(s.SPHERICAL, (s.l, s.theta, s.phi), scales, strict=True)
    }
    lengths = [
        Add(*(part**2 for part in components(unit.expand(), s.CARTESIAN)))
        for unit in rules.values()
    ]
    rest = work.relation.difference.xreplace(rules).expand()
    parts_left = components(rest, s.CARTESIAN)
    return all(is_zero(e) for e in (*parts_left, *(length - 1 for length in lengths)))


def is_scaled(work: Work, power: int) -> bool:
    """A premise, both of its sides times the factor, or divided by it where the power is −1."""
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
        if same(claimed, given):
            return True
        given_by = rules(others)
        natural = {s.omega0: sqrt(s.g / s.l)}
        if others and same(
            put_in(claimed, given_by).xreplace(natural), put_in(given, given_by).xreplace(natural)
        ):
            return True
    return False


def is_completion(work: Work) -> bool:
    """A term to be added, or a sum in which it stands with each sign and nothing else changes."""
    if work.relation.op == "":
        return bool(work.step.premises) and not work.step.detail
    term = work.step.detail.removeprefix(r"\pm").strip()
    bare, text = term.replace(" ", ""), work.one.right.replace(" ", "")
    added = work.step.detail.startswith(r"\pm") and f"+{bare}" in text and f"-{bare}" in text
    if not added or read(term).op:
        return False
    sides = text.partition("=")
    unchanged = sides[2].replace(f"+{bare}-{bare}", "", 1)
    return unchanged == sides[0] and any(
        p.op == "" and same(p.lhs, read(term).lhs) for p in work.premises
    )


def is_comparison(work: Work) -> bool:
    """The factor of one function of time."""
    detail = work.detail()
    if len(detail) != 1 or work.relation.rhs != 0 or not detail[0].has(s.t, s.u):
        return False
    return any(
        same_equation(expand(p.difference).coeff(detail[0]), work.relation.lhs)
        for p in work.premises
    )


def is_sum(work: Work, way: int) -> bool:
    """Two premises added, or the second taken from the first where the way is −1."""
    if len(work.premises) != 2 or work.before is not None:
        return False
    first, second = work.premises
    return same(work.relation.lhs, first.lhs + way * second.lhs) and same(
        work.relation.rhs, first.rhs + way * second.rhs
    )
