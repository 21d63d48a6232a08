"""What a check found for one subject."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.paper.checks.evidence import Evidence
    from kugelpendel.paper.derivation.model import StepKind


@dataclass(frozen=True)
class Row:
    """What `check` found for one formula, or for one statement in the wording.

    Attributes
    ----------
    symbolic, numeric
        Whether the two proofs hold.
    killed, equal, survivors
        How many mutants of the formula were rejected, how many were proved to say the same, and
        what was done to those that were neither.
    faults
        Sentences about everything else that is not as it says: the relation sign, the step, what
        it neglects, its conditions, its premises, what is printed.
    sabotages
        For each kind of sabotage besides the mutants, how many were made and how many noticed.
    unnoticed
        What was done in those that were not noticed.
    evidence
        What was compared to prove a formula; None for what is no formula, or cannot be read.
    """

    label: str
    step: StepKind
    symbolic: bool
    numeric: bool
    killed: int
    equal: int
    survivors: tuple[str, ...]
    seconds: float
    faults: tuple[str, ...] = ()
    sabotages: tuple[tuple[str, int, int], ...] = ()
    unnoticed: tuple[str, ...] = ()
    evidence: Evidence | None = None

    @property
    def mutants(self) -> int:
        """All that were tried."""
        return self.killed + self.equal + len(self.survivors)

    @property
    def holds(self) -> bool:
        """Whether everything is proved and no mutant or sabotage is left."""
        proved = self.symbolic and self.numeric and not self.faults
        return proved and not self.survivors and not self.unnoticed
