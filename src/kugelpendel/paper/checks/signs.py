"""Which relation sign a formula must have, found by numbers and not by what it says.

"≪" where the left side is smaller by orders. Where the left side is a single letter, or one side is
0, the formula poses or solves an equation, and "=" says so, even if the equation only approximates
the pendulum. Between two expressions that both are known, "=" claims that they are the same, in
every digit; where they are not, the sign is "≈". A sum that ends in "+ …" says itself that more
follows: there "=" is right.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import VECTORS
from kugelpendel.paper.algebra.sympy_names import Expr, Pow, mp, mpf
from kugelpendel.paper.derivation.graph import FORMULAS, right
from kugelpendel.paper.derivation.model import PAPER, Formula
from kugelpendel.paper.proofs.exact import swinging
from kugelpendel.paper.proofs.numeric import POINTS, much_less
from kugelpendel.paper.proofs.worlds import DIGITS, World, balanced, dynamic, ellipse

_SAME = 50  # digits
_EXACT = 7  # the chapter on the exact motion


@cache
def sign(label: str) -> str:
    """Give the relation sign that stands rightly in the formula of that label, "" for a term."""
    one = next(formula for formula in FORMULAS if formula.label == label)
    relation = right(label)
    if relation.op == "":
        return ""
    if one.section == 4 and all(trial.holds for trial in much_less(balanced)(relation)):
        return "≪"
    if not one.head and poses(relation):
        return "="
    left = _before(one).rhs if one.head else relation.lhs
    exact = _is_same(left, relation.rhs, _world(one))
    if r"\dots" in one.right:
        return "≈" if exact else "="
    return "=" if exact else "≈"


def poses(relation: Relation) -> bool:
    """Whether the relation poses or solves an equation, for a letter or against 0."""
    left = relation.lhs.base if isinstance(relation.lhs, Pow) else relation.lhs
    return relation.rhs == 0 or left.is_Symbol or relation.lhs in VECTORS.values()


def _before(one: Formula) -> Relation:
    """The line that a line of a chain goes on from."""
    at = next(k for k, other in enumerate(FORMULAS) if other.label == one.label)
    return right(FORMULAS[at - 1].label)


def _world(one: Formula) -> Callable[[int], World]:
    """Where a formula's letters have a meaning: in the ansatz, or in a motion on the sphere."""
    if one.section == _EXACT:
        return swinging
    relation = right(one.label)
    angles = relation.lhs.has(s.theta, s.phi) or relation.rhs.has(s.theta, s.phi)
    return dynamic if one.section < PAPER or angles else ellipse


def _is_same(left: Expr, right_side: Expr, make: Callable[[int], World]) -> bool:
    """Whether two expressions have one value at random points, to 50 digits."""
    with mp.workdps(DIGITS):
        for seed in range(POINTS):
            world = make(seed)
            one, other = world.value(left), world.value(right_side)
            if abs(one - other) > max(abs(one), abs(other), 1) * mpf(10) ** (-_SAME):
                return False
    return True
