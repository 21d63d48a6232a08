"""Whether a step is what it is called: each kind is carried out on the premises, and compared.

The proofs of the formulas are written one by one; here each kind of step has one meaning for all
formulas, and takes its factor, function or unit vector from `Step.detail` as it is typeset. A step
must fit its own kind, and no other.
"""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra.notation import NotationError
from kugelpendel.paper.checks.remainders import drops
from kugelpendel.paper.checks.steps.approximations import (
    is_average,
    is_expansion,
    is_neglect,
    is_solution,
)
from kugelpendel.paper.checks.steps.beginnings import (
    is_ansatz,
    is_assumption,
    is_definition,
    is_law,
)
from kugelpendel.paper.checks.steps.conversions import (
    is_comparison,
    is_completion,
    is_differentiation,
    is_projection,
    is_rearrangement,
    is_scaled,
    is_substitution,
    is_sum,
)
from kugelpendel.paper.checks.steps.integrations import is_integration
from kugelpendel.paper.checks.steps.work import Work
from kugelpendel.paper.derivation.graph import FORMULAS, parts, right
from kugelpendel.paper.derivation.model import Formula, Step, StepKind

_WITH_DETAIL = {
    StepKind.PROJECT,
    StepKind.MULTIPLY,
    StepKind.DIVIDE,
    StepKind.COMPLETE,
    StepKind.SOLVE,
    StepKind.COMPARE,
}
_INEXACT = {StepKind.EXPAND, StepKind.AVERAGE, StepKind.NEGLECT, StepKind.SOLVE}


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


_MEANING: dict[StepKind, Callable[[Work], bool]] = {
    StepKind.LAW: is_law,
    StepKind.DEFINE: is_definition,
    StepKind.ASSUME: is_assumption,
    StepKind.ANSATZ: is_ansatz,
    StepKind.SUBSTITUTE: is_substitution,
    StepKind.DIFFERENTIATE: is_differentiation,
    StepKind.PROJECT: is_projection,
    StepKind.MULTIPLY: lambda work: is_scaled(work, 1),
    StepKind.DIVIDE: lambda work: is_scaled(work, -1),
    StepKind.REARRANGE: is_rearrangement,
    StepKind.COMPLETE: is_completion,
    StepKind.EXPAND: is_expansion,
    StepKind.AVERAGE: is_average,
    StepKind.NEGLECT: is_neglect,
    StepKind.SOLVE: is_solution,
    StepKind.COMPARE: is_comparison,
    StepKind.ADD: lambda work: is_sum(work, 1),
    StepKind.SUBTRACT: lambda work: is_sum(work, -1),
    StepKind.INTEGRATE: is_integration,
}
