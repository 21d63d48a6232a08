"""What the derivation is made of: formulas, steps, conditions, misprints.

Agreed with the documents
-------------------------
* `Formula.printed` and `Formula.right` are LaTeX in the paper's own notation, and the source of
  everything: `notation.read` turns them into the `Relation` (SymPy) that the proofs judge, so what
  is typeset is what is proved. They are equal where nothing is wrong. No environments (aligned,
  pmatrix apart), no `&`, no number "(5a)"; a line that continues a chain starts with its relation.
* Sections after the paper's four are ours. Their formulas are numbered A1, A2, …, B1, …: every
  display has a number, `Formula.is_ours` holds, and `printed` is `right`.
* Labels: "5a" is the paper's number. An unnumbered display after (10) is "10.1", "10.2", …, before
  (1) there is none. Several claims in one display are its parts, told apart by what follows a
  colon: "2:x", "2:y", "2:z", "10.7:1" … `Formula.display` is the label without the part. A display
  whose number is used twice keeps its own name here: the three displays numbered (6) are "6", "6b"
  and "6c"; `Formula.number` is the number that stands in the paper, "" without one.
* Wording is keyed: formulas by `label`, displays by `display`, conditions and misprints by `key`,
  sections by their number (1 to 8), step kinds by `StepKind.value`.
* Order is the paper's order, everywhere.
* Nothing of a step is mere description: kind, detail, what is neglected and the conditions are
  checked by `checks.operations`, `checks.remainders` and `checks.requirements`.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from kugelpendel.paper.proofs.symbolic import Proof


PAPER = 4
"""How many sections the paper has; later ones are ours."""

CHAPTERS = "ABCD"
"""The letters that the formulas of our own chapters begin with."""


class StepKind(StrEnum):
    """The step that leads to a formula."""

    LAW = "law"  # put at the start: Newton's law, the thread's length
    DEFINE = "define"  # a name for something, a choice of coordinates
    ASSUME = "assume"  # something is small
    ANSATZ = "ansatz"  # the form of an earlier solution, with a new unknown
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
    INTEGRATE = "integrate"  # over a swing, from one turning point to the next
    STATE = "state"  # no step of the paper: said in the wording


@dataclass(frozen=True)
class Condition:
    """What must hold for a step to be allowed.

    Attributes
    ----------
    key
        Names the condition and its wording.
    latex
        Says it in a formula that `requirement.required` reads; "" if words alone can.
    silent
        Whether the paper does not say it.
    consequence
        The name of the check (in `checks.conditions_violated`) of what happens where it fails, or
        of why it holds, and of its wording; "" where nothing can fail but the model itself.
    """

    key: str
    latex: str
    silent: bool
    consequence: str = ""


@dataclass(frozen=True)
class Step:
    """How a formula follows.

    Attributes
    ----------
    premises
        Labels of the formulas that it stands on; "2" is all of (2).
    conditions
        Those without which this step breaks although all before it hold.
    neglected
        LaTeX of the leading terms that this step drops, with sign and factor; "" in an exact step.
    detail
        LaTeX of what is done it with, such as the factor multiplied by; "" if the kind says it.
    """

    kind: StepKind
    premises: tuple[str, ...] = ()
    conditions: tuple[Condition, ...] = ()
    neglected: str = ""
    detail: str = ""


@dataclass(frozen=True)
class Misprint:
    """One place where the paper's text is wrong, or where a sign is meant otherwise.

    Attributes
    ----------
    key
        Names the misprint and its wording.
    where
        The label of the formula that it is in, or that its words speak of.
    printed, right
        LaTeX for formulas, German text for words.
    kind
        "formula" is a false formula, "word" a false word, number or reference. "loose" is a sign
        that nobody misunderstands and that still does not say what is meant: "=" between two
        expressions of which one only approximates the other, bars left out at an absolute value,
        an orientation that is not said. A gap in the numbering is none of these.
    known
        How it is known: "identity" (the step's identity fails), "dimension" (the terms do not have
        one dimension), "size" (bars are missing: anything negative would be small), "convention"
        (it hangs on what is agreed), "text".
    travels
        Labels of the formulas into which the error is carried, () where it is not carried on.
    origin
        The key of the misprint that it comes from, "" if it is one of its own.
    in_words
        Whether it stands in the running text and not in the displayed formula.
    alone
        LaTeX of what stands in the place of `right` when this error only is made; `printed` by
        default. It differs where two errors meet in one term.
    """

    key: str
    where: str
    printed: str
    right: str
    kind: Literal["formula", "word", "loose"]
    known: Literal["identity", "dimension", "size", "convention", "text"]
    travels: tuple[str, ...] = ()
    origin: str = ""
    in_words: bool = False
    alone: str = ""


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
    def is_ours(self) -> bool:
        """Whether it is not in the paper, but of the chapters that this project adds."""
        return self.section > PAPER

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
    """A formula; `printed` only where it differs in the paper, the section by its number."""
    section = section_of(label)
    named = number or (label.partition(":")[0] if section > PAPER else "")
    return Formula(label, section, printed or right, right, step, proof, number=named, head=head)


def section_of(label: str) -> int:
    """The paper's section: (1) to (5c), (6) to (13), (16), (17) to (26); ours: A, B, C, D."""
    if label[0] in CHAPTERS:
        return PAPER + 1 + CHAPTERS.index(label[0])
    count = int("".join(q if q.isdigit() else " " for q in label).split()[0])
    if label.startswith("5.") or 6 <= count <= 13:
        return 2
    return 1 if count <= 5 else 3 if count <= 16 else 4
