"""What the derivation is made of: formulas, steps, conditions, misprints.

Agreed with the rendering
-------------------------
* `Formula.printed` and `Formula.right` are LaTeX in the paper's own notation, and the source of
  everything: `_notation.read` turns them into the `Relation` (SymPy) that the proofs judge, so what
  is typeset is what is proved. They are equal where nothing is wrong. No environments (aligned,
  pmatrix apart), no `&`, no number "(5a)"; a line that continues a chain starts with "=".
* Labels: "5a" is the paper's number. An unnumbered display after (10) is "10.1", "10.2", …, before
  (1) there is none. Several claims in one display are its parts, told apart by what follows a
  colon: "2:x", "2:y", "2:z", "10.7:1" … `Formula.display` is the label without the part. A display
  whose number is used twice keeps its own name here: the three displays numbered (6) are "6", "6b"
  and "6c"; `Formula.number` is the number that stands in the paper, "" without one.
* Wording is keyed: formulas by `label`, displays by `display`, conditions and misprints by `key`,
  sections by their number (1 to 4), step kinds by `Kind.value`.
* Order is the paper's order, everywhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from kugelpendel.paper.proofs.symbolic import Proof


class Kind(StrEnum):
    """The step that leads to a formula."""

    LAW = "law"  # put at the start: Newton's law, the thread's length
    DEFINE = "define"  # a name for something, a choice of coordinates, an ansatz
    SUBSTITUTE = "substitute"
    DIFFERENTIATE = "differentiate"
    PROJECT = "project"  # on a unit vector
    MULTIPLY = "multiply"
    DIVIDE = "divide"
    REARRANGE = "rearrange"  # expand, collect, cancel: an identity
    COMPLETE = "complete"  # add and subtract the same term
    EXPAND = "expand"  # in a series, and truncate
    AVERAGE = "average"  # keep the first harmonics, drop the third
    NEGLECT = "neglect"  # drop what is of higher order
    SOLVE = "solve"
    COMPARE = "compare"  # coefficients of independent functions of time
    ADD = "add"
    SUBTRACT = "subtract"


@dataclass(frozen=True)
class Condition:
    """What must hold for a step to be allowed.

    `key` names the condition and its wording; `latex` says it in a formula, "" if words alone can;
    `silent` is true where the paper does not say it. `consequence` is the name of the check (in
    `_consequences`) of what happens where it fails, and of its wording; "" where nothing can fail
    but the model itself (no thread without length).
    """

    key: str
    latex: str
    silent: bool
    consequence: str = ""


@dataclass(frozen=True)
class Step:
    """How a formula follows.

    `premises`: labels of the formulas it stands on, whole displays allowed ("2" is all of (2)).
    `neglected`: LaTeX of the order of what is dropped, "" in an exact step.
    `detail`: LaTeX of what is done, such as the factor multiplied by, "" if the kind says it.
    """

    kind: Kind
    premises: tuple[str, ...] = ()
    conditions: tuple[Condition, ...] = ()
    neglected: str = ""
    detail: str = ""


@dataclass(frozen=True)
class Misprint:
    """One place where the paper's text is wrong.

    `where` is the label of the formula, or of the one that the words follow. `kind` is "formula"
    (wrong formula), "sign" (a sign convention or a relation sign that is not meant so), "word" (a
    wrong word, number or reference).
    `printed`, `right`: LaTeX for formulas, German text for words. `known` is how it is known:
    "identity" (the step's identity fails), "dimension" (the terms do not have one dimension),
    "convention", "text". `travels`: labels of the formulas into which the error is carried, ()
    where it stays; `origin` the key of the misprint that it comes from, "" if it is one of its own.
    The smallest counterexample is worked out by `counterexample(key)` in `_misprints`.
    """

    key: str
    where: str
    printed: str
    right: str
    kind: Literal["formula", "sign", "word"]
    known: Literal["identity", "dimension", "convention", "text"]
    travels: tuple[str, ...] = ()
    origin: str = ""
    in_words: bool = False  # stands in the running text, not in the displayed formula


@dataclass(frozen=True)
class Formula:
    """One displayed claim of the paper."""

    label: str
    section: int
    printed: str
    right: str
    step: Step
    proof: Proof
    number: str = ""
    head: str = ""  # label of the line that a chain starts with, where `printed` begins with "="

    @property
    def display(self) -> str:
        """The display it stands in: the label without its part."""
        return self.label.partition(":")[0]

    @property
    def is_misprinted(self) -> bool:
        """Whether something else stands in the paper than should."""
        return self.printed != self.right


def claim(
    label: str,
    right: str,
    step: Step,
    proof: Proof,
    *,
    printed: str = "",
    number: str = "",
    head: str = "",
) -> Formula:
    """A formula of the paper; `printed` only where it differs, the section by its number."""
    return Formula(
        label, section_of(label), printed or right, right, step, proof, number=number, head=head
    )


def section_of(label: str) -> int:
    """The paper's section: (1) to (5c), (6) to (13), (16), (17) to (26)."""
    count = int("".join(q if q.isdigit() else " " for q in label).split()[0])
    if label.startswith("5.") or 6 <= count <= 13:
        return 2
    return 1 if count <= 5 else 3 if count <= 16 else 4


@dataclass(frozen=True)
class Row:
    """What `check` found for one formula.

    `symbolic` and `numeric` are true where the proof holds. `killed` mutants were rejected, `equal`
    ones proved to say the same, `survivors` (LaTeX-free text of each) neither.
    """

    label: str
    step: Kind
    symbolic: bool
    numeric: bool
    killed: int
    equal: int
    survivors: tuple[str, ...]
    seconds: float

    @property
    def mutants(self) -> int:
        """All that were tried."""
        return self.killed + self.equal + len(self.survivors)

    @property
    def holds(self) -> bool:
        """Whether everything is proved and no mutant is left."""
        return self.symbolic and self.numeric and not self.survivors
