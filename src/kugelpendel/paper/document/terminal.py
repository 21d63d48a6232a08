"""The derivation as text for a terminal."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING

from kugelpendel.paper.document.outline import counts
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.document.tables import conditions, fate, in_words, misprints, reasons
from kugelpendel.paper.typeset import unicode

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.document.outline import Display, Document, Line


def write(document: Document, width: int = 80) -> str:
    """Write the whole text, `width` signs wide."""
    return "\n".join(_Text(document, width).parts()) + "\n"


class TextPen:
    """Sentences, formulas and references as plain text."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def say(self, sentence: str) -> str:
        """A sentence of the wording."""
        return "".join(
            self.links([span.text])
            if span.kind == "link"
            else self.math(span.text)
            if span.kind == "math"
            else span.text
            for span in spans(sentence)
        )

    def math(self, latex: str) -> str:
        """A formula."""
        return unicode.plain(latex)

    def values(self, formulas: Sequence[str]) -> str:
        """Formulas, separated by commas."""
        return ", ".join(self.math(formula) for formula in formulas)

    def links(self, labels: Sequence[str]) -> str:
        """References, separated by commas."""
        return ", ".join(self._document.name(label) for label in labels)


class _Text:
    def __init__(self, document: Document, width: int) -> None:
        self._document = document
        self._words = document.words
        self._ui = document.words.ui
        self._width = width
        self._pen = TextPen(document)

    def parts(self) -> list[str]:
        document, words, ui = self._document, self._words, self._ui
        is_whole = not document.target
        under = words.subtitle() if is_whole else document.lead()
        lines = [document.title(), "=" * len(document.title()), "", *self._wrapped(under)]
        lines.extend([ui("counts", *counts(document))])
        if is_whole:
            for name in ("introduction", "conventions"):
                lines.extend(self._headed(ui(name)))
                for one in words.paragraphs(name):
                    lines.extend([*self._wrapped(self._pen.say(one)), ""])
        for chapter in document.chapters:
            lines.extend(self._headed(f"{chapter.number} {chapter.title}"))
            lines.extend(self._wrapped(self._pen.say(chapter.lead)) if is_whole else [])
            for display in chapter.displays:
                lines.extend(self._display(display))
        if is_whole:
            lines.extend(self._headed(ui("closing")))
            for one in words.paragraphs("closing"):
                lines.extend([*self._wrapped(self._pen.say(one)), ""])
        if document.misprints:
            lines.extend(self._headed(ui("misprints")))
            lines.extend(listed(misprints(document, self._pen), self._width))
        if document.conditions:
            lines.extend(self._headed(ui("conditions")))
            lines.extend(listed(conditions(document, self._pen), self._width))
        return lines

    def _headed(self, title: str) -> list[str]:
        return ["", title, "-" * len(title), ""]

    def _wrapped(self, text: str, indent: str = "") -> list[str]:
        return fill(text, self._width, initial_indent=indent, subsequent_indent=indent).splitlines()

    def _display(self, display: Display) -> list[str]:
        lines = ["", *self._wrapped(f"({display.label})  {self._pen.say(display.say)}"), ""]
        for line in display.lines:
            lines.extend(self._line(line))
        lines.extend(self._steps(display))
        return lines

    def _line(self, line: Line) -> list[str]:
        formula, ui = line.formula, self._ui
        lines = self._wrapped(self._pen.say(line.say), "    ") if line.say else []
        lines.extend(self._formula(formula.right))
        if not (formula.is_misprinted or line.misprints):
            return lines
        lines.append(f"    ! {ui('misprint')}")
        if formula.is_misprinted:
            lines.append(f"    ! {ui('printed')}:")
            lines.extend(f"    !{text}" for text in self._formula(formula.printed))
        for one in line.misprints:
            text = f"{self._words.misprint_kind(one.kind)}. "
            if in_words(one):
                printed = self._pen.say(self._words.printed(one))
                right = self._pen.say(self._words.right(one))
                text += f"{ui('printed')}: {printed} {ui('right')}: {right} "
            text += reasons(one, self._document, self._pen)
            text += f" {fate(one, self._document, self._pen)}"
            lines.extend(self._wrapped(text, "    ! "))
        return lines

    def _formula(self, latex: str) -> list[str]:
        first, *others = unicode.broken(latex, self._width - 12)
        return [f"      {first}", *(f"          {line}" for line in others)]

    def _steps(self, display: Display) -> list[str]:
        words, ui = self._words, self._ui
        lines: list[str] = []
        for covered, step in display.steps:
            head = ""
            if len(covered) < len(display.lines):
                head = ", ".join(self._document.part(line.formula.label) for line in covered) + ": "
            text = f"{head}{words.kind(step.kind)}"
            text += f", {ui('from')} {self._pen.links(step.premises)}" if step.premises else ""
            text += f", {ui('by')} {self._pen.math(step.detail)}" if step.detail else ""
            if step.neglected:
                terms = f"{words.neglected(step.kind)} {self._pen.math(step.neglected)}"
                text += f". {ui('neglected')}: {terms}"
            lines.extend(self._wrapped(f"– {text}.", "    "))
        for one in display.conditions:
            latex = f" {self._pen.math(one.latex)}" if one.latex else ""
            silent = f" ({ui('silent_long')})" if one.silent else ""
            text = f"{ui('condition')}{latex}: {self._pen.say(words.condition(one.key))}{silent}"
            if self._document.explains(one, display):
                told = self._pen.say(words.consequence(one.consequence))
                text += f" {words.fate(one.consequence)}: {told}"
            lines.extend(self._wrapped(text, "        "))
        return lines


def listed(rows: Sequence[Sequence[str]], width: int) -> list[str]:
    """A table as entries below each other: name and content on each line; the first row names."""
    head, *body = rows
    lines: list[str] = []
    for row in body:
        for number, (name, cell) in enumerate(zip(head, row, strict=True)):
            indent = "" if number == 0 else "  "
            text = cell if number == 0 else f"{name}: {cell}"
            lines.extend(
                fill(
                    text, width, initial_indent=indent, subsequent_indent=f"{indent}  "
                ).splitlines()
            )
        lines.append("")
    return lines
