"""The kinds of step that begin something: a law, a definition, an assumption, an ansatz."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import RATE, VECTORS
from kugelpendel.paper.algebra.sympy_names import Expr
from kugelpendel.paper.checks.steps.work import Work
from kugelpendel.paper.derivation.graph import FORMULAS, right

# What the paper's words introduce before any formula does.
_GIVEN = {s.m, s.g, s.l, s.T, s.r, *s.CARTESIAN, *s.SPHERICAL}
_PLACES = {vector: 0 for latex, vector in VECTORS.items() if "L" not in latex}
BASE = {dot: q for q, dot in RATE.items()}


def is_law(work: Work) -> bool:
    """Nothing is named: every quantity has a meaning before the formula relates them."""
    return work.relation.op == "=" and letters(work.relation) <= _GIVEN


def is_definition(work: Work) -> bool:
    """A letter appears for the first time, and nothing earlier is worked on."""
    named = work.relation.op == "=" and bool(_new_letters(work))
    return named and not work.step.premises


def is_assumption(work: Work) -> bool:
    """Something is said to be small, and nothing earlier is worked on."""
    return not work.step.premises and work.relation.op == "≪"


def is_ansatz(work: Work) -> bool:
    """An earlier solution with its letters exchanged, one of them for a new one."""
    if not _new_letters(work):
        return False
    renamed = {s.x: s.xp, s.y: s.yp, s.omega0: s.omega}
    return any(work.relation == p.apply(lambda e: e.xreplace(renamed)) for p in work.premises)


def letters(relation: Relation) -> set[Expr]:
    """All letters; a derivative counts as what it is the derivative of, r⃗ and its own as none."""
    sides = [side.subs(_PLACES) for side in (relation.lhs, relation.rhs)]
    found: set[Expr] = set()
    for letter in sides[0].free_symbols | sides[1].free_symbols:
        while letter in BASE:
            letter = BASE[letter]
        found.add(letter)
    return found


def _new_letters(work: Work) -> set[Expr]:
    """Those that no earlier display has, and that the paper's words have not introduced."""
    known = set(_GIVEN)
    for formula in FORMULAS:
        if formula.display == work.one.display:
            break
        known |= letters(right(formula.label))
    return letters(work.relation) - known
