"""What a step starts from, what it is done with and where it leads; and how such things compare."""

from __future__ import annotations

from dataclasses import dataclass

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import is_zero
from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.algebra.sympy_names import Expr, sqrt
from kugelpendel.paper.derivation.model import Formula, Step


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
        return not is_zero(put_in(relation.difference, rules(self.premises)))


def rules(relations: tuple[Relation, ...]) -> dict[Expr, Expr]:
    """Left side → right side, sums first: what they are made of must not be replaced before."""
    found = {relation.lhs: relation.rhs for relation in relations if relation.op not in ("", "≪")}
    return dict(sorted(found.items(), key=lambda rule: rule[0].is_Symbol))


def put_in(expression: Expr, rules: dict[Expr, Expr]) -> Expr:
    """Replace left sides by right ones, and ρ too where the rule is one for ρ²."""
    for left, replaced in rules.items():
        expression = expression.subs(left, replaced)
        if left == s.rho**2:
            expression = expression.xreplace({s.rho: sqrt(replaced)})
    return expression


def same(first: Expr, second: Expr) -> bool:
    """Whether two expressions are identical."""
    return is_zero(first - second)


def same_equation(first: Expr, second: Expr) -> bool:
    """Whether both vanish together: equal, or of opposite sign."""
    return same(first, second) or is_zero(first + second)
