"""The derivation as a document: what stands where, before any format."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING

from kugelpendel.paper.document.wording import words

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from kugelpendel.paper.derivation.model import Condition, Formula, Misprint, Step
    from kugelpendel.paper.document.wording import Words


@dataclass(frozen=True)
class Derivation:
    """The data that documents are made of.

    Attributes
    ----------
    formulas
        All formulas, in the paper's order.
    misprints
        All misprints, in the paper's order.
    evidence
        A function from the key of a misprint to the smallest counterexample: LaTeX of its values,
        and of what the equality fails by there; None where a number says nothing.
    """

    formulas: tuple[Formula, ...]
    misprints: tuple[Misprint, ...]
    evidence: Callable[[str], tuple[Sequence[str], str] | None]


@dataclass(frozen=True)
class Line:
    """One formula of a display, and what is wrong with it in print."""

    formula: Formula
    say: str
    misprints: tuple[Misprint, ...]


@dataclass(frozen=True)
class Display:
    """The formulas that stand together, and what is said about them."""

    label: str
    say: str
    lines: tuple[Line, ...]

    @property
    def is_numbered(self) -> bool:
        """Tell whether the paper gives it a number."""
        return any(line.formula.number for line in self.lines)

    @property
    def has_wrong_formula(self) -> bool:
        """Tell whether one of its formulas is printed wrongly."""
        return any(line.formula.is_misprinted for line in self.lines)

    @property
    def steps(self) -> tuple[tuple[tuple[Line, ...], Step], ...]:
        """Give its steps, each with the lines that it leads to."""
        grouped = groupby(self.lines, key=lambda line: line.formula.step)
        return tuple((tuple(lines), step) for step, lines in grouped)

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """Give what its steps need, each condition once, however many lines need it."""
        needed = {one.key: one for _, step in self.steps for one in step.conditions}
        return tuple(needed.values())


@dataclass(frozen=True)
class Chapter:
    """A section of the paper."""

    number: int
    title: str
    lead: str
    displays: tuple[Display, ...]


@dataclass(frozen=True)
class Document:
    """Everything to write, in one language.

    Attributes
    ----------
    target
        The label that the document leads to, "" for the whole derivation.
    conditions
        Each condition once, with the displays that need it.
    """

    words: Words
    derivation: Derivation
    target: str
    chapters: tuple[Chapter, ...]
    misprints: tuple[Misprint, ...]
    conditions: tuple[tuple[Condition, tuple[str, ...]], ...]

    @property
    def displays(self) -> tuple[Display, ...]:
        """Give all displays in order."""
        return tuple(display for chapter in self.chapters for display in chapter.displays)

    def shows(self, label: str) -> bool:
        """Tell whether a display or formula stands in this document."""
        return any(
            label == display.label or any(label == line.formula.label for line in display.lines)
            for display in self.displays
        )

    def name(self, label: str) -> str:
        """Write a label as a reference: (5a), (10.7) line 2, (2:x)."""
        display, _, part = label.partition(":")
        if not part:
            return f"({display})"
        return f"({display}) {self.words.ui('line')} {part}" if part.isdigit() else f"({label})"

    def title(self) -> str:
        """Give the title, of the whole or of a part."""
        if not self.target:
            return self.words.title()
        return self.words.ui("rests_on", self.name(self.target))

    def lead(self) -> str:
        """Say below the title of a part how many formulas lead to its target."""
        ui = self.words.ui
        name = self.name(self.target)
        shown, _, _ = counts(self)
        if shown == 1:
            return ui("rests_on_nothing", name)
        return ui("rests_on_lead", shown, len(self.derivation.formulas), name)

    def part(self, label: str) -> str:
        """Name a formula within its display: line 2, x."""
        part = label.partition(":")[2]
        return f"{self.words.ui('line')} {part}" if part.isdigit() else part

    def explains(self, condition: Condition, display: Display) -> bool:
        """Tell whether a display is the first that needs a condition, and so explains it."""
        first = {one.key: where[0] for one, where in self.conditions}
        return bool(condition.consequence) and first[condition.key] == display.label

    def used_in(self, display: Display) -> tuple[str, ...]:
        """Give the displays whose steps stand on this one."""
        own = {display.label, *(line.formula.label for line in display.lines)}
        return tuple(
            other.label
            for other in self.displays
            if other.label != display.label
            and any(own.intersection(line.formula.step.premises) for line in other.lines)
        )


def premises(formulas: Sequence[Formula]) -> dict[str, tuple[str, ...]]:
    """Find the displays that each display rests on."""
    found: dict[str, dict[str, None]] = {}
    for formula in formulas:
        before = found.setdefault(formula.display, {})
        for label in (*formula.step.premises, formula.head):
            display = label.partition(":")[0]
            if display and display != formula.display:
                before[display] = None
    return {label: tuple(before) for label, before in found.items()}


def compose(derivation: Derivation, language: str, labels: Sequence[str], target: str) -> Document:
    """Put a document together.

    Parameters
    ----------
    derivation
        What the document is made of.
    language
        "de" or "en".
    labels
        The formulas to show; all others are left out.
    target
        The label that they lead to, "" for the whole derivation.
    """
    text = words(language)
    chosen = set(labels)
    formulas = [formula for formula in derivation.formulas if formula.label in chosen]
    shown = {formula.label for formula in formulas} | {formula.display for formula in formulas}
    misprints = tuple(one for one in derivation.misprints if one.where in shown)
    return Document(
        words=text,
        derivation=derivation,
        target=target,
        chapters=_chapters(formulas, misprints, text),
        misprints=misprints,
        conditions=_conditions(formulas),
    )


def _chapters(
    formulas: Sequence[Formula], misprints: Sequence[Misprint], text: Words
) -> tuple[Chapter, ...]:
    chapters: list[Chapter] = []
    for number, in_section in groupby(formulas, key=lambda formula: formula.section):
        displays = tuple(
            _display(label, tuple(parts), misprints, text)
            for label, parts in groupby(in_section, key=lambda formula: formula.display)
        )
        chapters.append(Chapter(number, *text.section(number), displays))
    return tuple(chapters)


def _display(
    label: str, formulas: Sequence[Formula], misprints: Sequence[Misprint], text: Words
) -> Display:
    first = formulas[0].label
    lines = tuple(
        Line(
            formula,
            text.formula(formula.label) if formula.label != label else "",
            tuple(
                one
                for one in misprints
                if one.where == formula.label or (one.where == label and formula.label == first)
            ),
        )
        for formula in formulas
    )
    return Display(label, text.formula(label), lines)


def _conditions(formulas: Sequence[Formula]) -> tuple[tuple[Condition, tuple[str, ...]], ...]:
    needed: dict[str, tuple[Condition, dict[str, None]]] = {}
    for formula in formulas:
        for condition in formula.step.conditions:
            _, where = needed.setdefault(condition.key, (condition, {}))
            where[formula.display] = None
    return tuple((condition, tuple(where)) for condition, where in needed.values())


def counts(document: Document) -> tuple[int, int, int]:
    """Count the formulas, displays and misprints of the document."""
    displays = document.displays
    return sum(len(display.lines) for display in displays), len(displays), len(document.misprints)


def graph(document: Document) -> Mapping[str, tuple[str, ...]]:
    """Find what each display of the document rests on."""
    return premises([line.formula for display in document.displays for line in display.lines])
