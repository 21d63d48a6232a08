"""What was compared to prove a formula: the expressions, the random points, what is left there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra.calculus import carry_out, is_zero
from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.algebra.symbols import LATEX
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Integer, cos, expand, mp, sin
from kugelpendel.paper.algebra.writing import written
from kugelpendel.paper.checks.pool import Progress, one_by_one
from kugelpendel.paper.checks.remainders import order_said
from kugelpendel.paper.derivation.graph import formula, premises, right
from kugelpendel.paper.derivation.model import Condition, Formula, StepKind
from kugelpendel.paper.proofs.numeric import TOLERANCE, Trial
from kugelpendel.paper.proofs.worlds import World

_MANY = 32
"""Formulas that take longer to prove than a further process takes to start."""

_ORDER = {letter: k for k, letter in enumerate(LATEX)}


@dataclass(frozen=True)
class Residual:
    """An expression that has to vanish for the formula to follow from its premises.

    Attributes
    ----------
    latex
        The expression as the proof found it, before it was simplified; "0" where the two sides
        agreed as they stood.
    terms
        How many terms it has, multiplied out and before sin² + cos² = 1 is used.
    is_zero
        Whether it vanishes identically, which is decided and not tried.
    """

    latex: str
    terms: int
    is_zero: bool


@dataclass(frozen=True)
class Point:
    """A random point at which the formula was tried.

    Attributes
    ----------
    values
        LaTeX of each letter, or of an angle such as ωt, and its number in 50 digits.
    rest
        By how much the formula fails there, such as "2.1e-61".
    allowed
        How much of that is rounding, or belongs to an order that is not kept.
    holds
        Whether the rest is not more than that.
    """

    values: tuple[tuple[str, str], ...]
    rest: str
    allowed: str
    holds: bool


@dataclass(frozen=True)
class Evidence:
    """All that was compared to prove one formula.

    Attributes
    ----------
    label, kind
        The formula, and the kind of step that leads to it.
    compared
        LaTeX of the formula as the proofs judged it, both sides written out.
    residuals
        What has to vanish identically.
    points
        Where it was tried in numbers.
    digits
        How many digits agree in an exact formula.
    kept
        In an approximation, the order up to which it was tried; None in an exact formula.
    neglected, neglected_order
        LaTeX of the leading terms that the step itself drops, and their order; "" and None where it
        drops nothing.
    conditions
        What its step needs.
    """

    label: str
    kind: StepKind
    compared: str
    residuals: tuple[Residual, ...]
    points: tuple[Point, ...]
    digits: int
    kept: int | None
    neglected: str
    neglected_order: int | None
    conditions: tuple[Condition, ...]

    @property
    def symbolic(self) -> bool:
        """Whether the proof with symbols holds."""
        return all(one.is_zero for one in self.residuals)

    @property
    def numeric(self) -> bool:
        """Whether the proof with numbers holds."""
        return all(one.holds for one in self.points)

    @property
    def holds(self) -> bool:
        """Whether both proofs hold."""
        return self.symbolic and self.numeric


@cache
def evidence(label: str) -> Evidence:
    """Prove a formula and keep what was compared.

    Raises
    ------
    UnknownLabel
        There is no such formula.
    """
    one, relation = formula(label), right(label)
    points: list[Point] = []
    kept: int | None = None
    for trial in one.proof.trials(relation):
        points.append(_point(one, relation, trial))
        kept = trial.kept
    return Evidence(
        label=label,
        kind=one.step.kind,
        compared=_compared(relation),
        residuals=tuple(_residual(q) for q in one.proof.symbolic(relation, premises(one))),
        points=tuple(points),
        digits=TOLERANCE,
        kept=kept,
        neglected=one.step.neglected,
        neglected_order=order_said(one),
        conditions=one.step.conditions,
    )


def proved(labels: Sequence[str], progress: Progress[Evidence] | None = None) -> list[Evidence]:
    """Prove several formulas, in as many processes as there are processors where that is faster.

    Parameters
    ----------
    labels
        Of formulas.
    progress
        Called after each with how many are done, of how many, and what was compared.

    Raises
    ------
    UnknownLabel
        There is no such formula.
    """
    return one_by_one(evidence, labels, progress, parallel=len(labels) >= _MANY)


def _compared(relation: Relation) -> str:
    sign = {"≈": r"\approx", "≪": r"\ll"}.get(relation.op, relation.op)
    sides = f"{written(relation.lhs)} {sign} {written(relation.rhs)}"
    return sides if relation.op else written(relation.lhs)


def _residual(expression: Expr) -> Residual:
    summed = expand(carry_out(expression))
    terms = 0 if summed == 0 else len(Add.make_args(summed))
    return Residual(written(expression), terms, is_zero(expression))


def _point(one: Formula, relation: Relation, trial: Trial) -> Point:
    sides = [relation.lhs, relation.rhs]
    sides += [read(one.proof.against).lhs] if one.proof.against else []
    return Point(
        values=_values([carry_out(side) for side in sides], trial.world),
        rest=mp.nstr(trial.rest, 2),
        allowed=mp.nstr(trial.allowed, 2),
        holds=trial.holds,
    )


def _values(sides: list[Expr], world: World) -> tuple[tuple[str, str], ...]:
    """The numbers of all letters that stand there; an angle such as ωt is one number."""
    functions = {f for side in sides for f in side.atoms(sin, cos)}
    phased = {f: f.args[0].as_coeff_Mul()[1] for f in functions}
    phased = {f: angle for f, angle in phased.items() if angle in world.phases}
    bare = [side.xreplace(dict.fromkeys(phased, Integer(1))) for side in sides]
    letters = {q for side in bare for q in side.free_symbols}
    shown = [(LATEX[q], world.value(q)) for q in sorted(letters, key=_ORDER.__getitem__)]
    angles = sorted(set(phased.values()), key=str)
    shown += [(written(angle), world.phases[angle][0]) for angle in angles]
    return tuple((name, mp.nstr(value, TOLERANCE, min_fixed=-4)) for name, value in shown)
