"""The kinds of step that leave something out, and those that solve for a letter."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import is_zero, small, taylor
from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.algebra.symbols import RATE
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Pow, cos, diff, sin
from kugelpendel.paper.checks.remainders import dropped, drops, of_circles
from kugelpendel.paper.checks.steps.work import Work, same


def is_expansion(work: Work) -> bool:
    """A function that is no polynomial, and the beginning of its series, without a premise."""
    relation = work.relation
    if work.step.premises or not drops(work.one.label) or r"\dots" not in work.one.right:
        return False
    beginning = Add(*taylor(small(relation.lhs), 3))
    return is_zero(relation.rhs - beginning) and not is_zero(relation.difference)


def is_average(work: Work) -> bool:
    """Third harmonics are dropped, and nothing else."""
    if not drops(work.one.label) or not work.premises:
        return False
    gone = dropped(work.one.label).dropped
    kept = of_circles((work.before or work.premises[-1]).rhs) - gone
    multiples = {f.args[0].as_coeff_Mul()[0] for f in gone.atoms(sin, cos) if f.has(s.omega)}
    return multiples == {3} and same(of_circles(work.relation.rhs), kept)


def is_neglect(work: Work) -> bool:
    """Terms of a higher order are dropped, from something that a premise says."""
    if not drops(work.one.label) or not work.step.premises or is_average(work):
        return False
    return not is_solution(work)


def is_solution(work: Work) -> bool:
    """A single letter on the left that is not on the right, and that satisfies a premise."""
    left = work.relation.lhs
    letter = left.base if isinstance(left, Pow) else left
    if (
        not letter.is_Symbol
        or work.relation.op != "="
        or work.relation.rhs.has(letter)
        or work.before
    ):
        return False
    return any(
        _satisfies(work, letter, premise) for premise in work.premises if premise.lhs != left
    )


def _satisfies(work: Work, letter: Expr, premise: Relation) -> bool:
    if not premise.difference.has(letter) or premise.op != "=":
        return False
    equation = premise.difference - (read(work.step.neglected).lhs if work.step.neglected else 0)
    factor = work.detail()
    if letter not in RATE:  # a number to be found: what stands before it is divided by
        if len(factor) != 1 or not same(diff(premise.difference, letter), factor[0]):
            return False
    elif factor:
        return False
    rules, found, place = {letter: work.relation.rhs}, work.relation.rhs, letter
    while place in RATE:
        place, found = RATE[place], diff(found, s.t)
        rules[place] = found
    return is_zero(equation.xreplace(rules))
