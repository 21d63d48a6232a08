"""The first proof: a formula follows from its premises, and only from those it names.

A proof takes any relation and answers whether that relation is what the step yields, so the same
proof that accepts the right formula rejects the printed one and the mutants.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

from kugelpendel.paper.algebra.calculus import carry_out, is_zero
from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.algebra.sympy_names import Expr
from kugelpendel.paper.proofs.numeric import Numeric, Trial

Rules = dict[Expr, Expr]
Symbolic = Callable[[Relation, "Premises"], list[Expr]]


class Premises:
    """The right relations that a step stands on; asking for one it does not name is a KeyError."""

    def __init__(self, named: tuple[str, ...], relations: Mapping[str, Relation]):
        self._named = named
        self._relations = relations
        self.used: set[str] = set()

    def unrestricted(self) -> Premises:
        """All of the paper: to refute with, not to prove with."""
        return Premises(tuple(self._relations), self._relations)

    def __getitem__(self, label: str) -> Relation:
        display = label.partition(":")[0]
        named = next((name for name in (label, display) if name in self._named), None)
        if named is None:
            raise KeyError(f"The step does not name ({label}) as a premise, only {self._named}.")
        self.used.add(named)
        return self._relations[label]

    def rules(self, *labels: str) -> Rules:
        """Left side → right side, of formulas or whole displays."""
        found: Rules = {}
        for label in labels:
            parts = [label] if label in self._relations else _parts(label, self._relations)
            for part in parts:
                relation = self[part]
                found[relation.lhs] = relation.rhs
        return found


def _parts(display: str, relations: Mapping[str, Relation]) -> list[str]:
    return [label for label in relations if label.partition(":")[0] == display]


def put(expression: Expr, rules: Rules) -> Expr:
    """Replaces left sides by right sides, one after the other."""
    for left, right in rules.items():
        if left.is_Symbol:
            expression = expression.xreplace({left: right})
        else:
            expression = expression.subs(left, right)
    return expression


@dataclass(frozen=True)
class Proof:
    """Both proofs of a formula: what must vanish, and what must be true in numbers.

    `against`: LaTeX of an expression that the numbers compare the difference of the sides with.
    `if_equal`: the proof that an approximation has to pass where it is printed with "=".
    """

    symbolic: Symbolic
    numeric: Numeric
    against: str = ""
    if_equal: Proof | None = None

    def __call__(self, relation: Relation, premises: Premises) -> bool:
        """Whether the relation is what the step yields."""
        if self.if_equal is not None and relation.op == "=":
            return self.if_equal(relation, premises.unrestricted())
        return all(is_zero(expression) for expression in self.symbolic(relation, premises))

    def true_in_numbers(self, relation: Relation, quick: bool = False) -> bool:
        """Whether it is true at random points; `quick`: at the first one."""
        trials = self.trials(relation)
        return next(trials).holds if quick else all(trial.holds for trial in trials)

    def trials(self, relation: Relation) -> Iterator[Trial]:
        """Try it at one random point after the other."""
        if self.if_equal is not None and relation.op == "=":
            return self.if_equal.trials(relation)
        if self.against:
            relation = Relation(read(self.against).lhs, "=", relation.difference)
        return self.numeric(relation)


def follows(derive: Callable[[Premises], Expr | Relation]) -> Symbolic:
    """The difference of the sides is the derived one."""

    def symbolic(relation: Relation, premises: Premises) -> list[Expr]:
        derived = derive(premises)
        wanted = derived.difference if isinstance(derived, Relation) else derived
        return [relation.difference - wanted]

    return symbolic


def identity(rules: Callable[[Premises], Rules] | None = None, *labels: str) -> Symbolic:
    """Both sides become equal under the rules, then under the labelled definitions."""

    def symbolic(relation: Relation, premises: Premises) -> list[Expr]:
        first = rules(premises) if rules else {}
        difference = put(put(relation.difference, first), premises.rules(*labels))
        return [carry_out(difference)]

    return symbolic


def given(*labels: str) -> Symbolic:
    """Both sides become equal when the labelled formulas are put in."""
    return identity(None, *labels)


def continued(
    previous: str,
    *labels: str,
    rules: Callable[[Premises], Rules] | None = None,
    change: Callable[[Expr], Expr] = lambda e: e,
) -> Symbolic:
    """The right side is the previous line's, changed (into its first harmonics, for example)."""

    def symbolic(relation: Relation, premises: Premises) -> list[Expr]:
        difference = relation.rhs - change(premises[previous].rhs)
        if rules is not None:
            difference = put(difference, rules(premises))
        return [put(difference, premises.rules(*labels))]

    return symbolic


def both(*several: Symbolic) -> Symbolic:
    """All of them."""

    def symbolic(relation: Relation, premises: Premises) -> list[Expr]:
        return [e for one in several for e in one(relation, premises)]

    return symbolic
