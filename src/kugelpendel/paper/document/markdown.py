"""The derivation as Markdown, with formulas as GitHub shows them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.paper.document.outline import counts
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.document.tables import conditions, fate, in_words, misprints, reasons
from kugelpendel.paper.typeset import latex

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.document.outline import Display, Document, Line

_ROOM = 70
"""Signs in a line of a formula."""


def write(document: Document) -> str:
    """Write the whole text."""
    pen = MarkdownPen(document)
    words, ui = document.words, document.words.ui
    is_whole = not document.target
    under = words.subtitle() if is_whole else document.lead()
    parts = [f"# {document.title()}", under, ui("counts", *counts(document))]
    if is_whole:
        parts.append(f"## {ui('introduction')}")
        parts.extend(pen.say(one) for one in words.paragraphs("introduction"))
        parts.append(f"## {ui('conventions')}")
        parts.append("\n".join(f"- {pen.say(one)}" for one in words.paragraphs("conventions")))
    for chapter in document.chapters:
        parts.append(f"## {chapter.number} {chapter.title}")
        parts.extend([f"*{pen.say(chapter.lead)}*"] if is_whole else [])
        for display in chapter.displays:
            parts.extend(_display(display, document, pen))
    if is_whole:
        parts.append(f"## {ui('closing')}")
        parts.extend(pen.say(one) for one in words.paragraphs("closing"))
    if document.misprints:
        parts.extend([f"## {ui('misprints')}", pen.say(ui("misprints_lead"))])
        parts.append(_table(misprints(document, pen)))
    if document.conditions:
        parts.extend([f"## {ui('conditions')}", pen.say(ui("conditions_lead"))])
        parts.append(_table(conditions(document, pen)))
    return "\n\n".join(parts) + "\n"


class MarkdownPen:
    """Sentences, formulas and references in Markdown."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def say(self, sentence: str) -> str:
        """A sentence of the wording."""
        written: list[str] = []
        for span in spans(sentence):
            match span.kind:
                case "math":
                    written.append(self.math(span.text))
                case "link":
                    written.append(self.links([span.text]))
                case "stress":
                    written.append(f"*{span.text}*")
                case "code":
                    written.append(f"`{span.text}`")
                case _:
                    written.append(span.text.replace("*", "\\*"))
        return "".join(written)

    def math(self, latex: str) -> str:
        """A formula within a sentence, in the form that no other sign of Markdown disturbs."""
        return f"$`{latex}`$"

    def values(self, formulas: Sequence[str]) -> str:
        """Formulas, separated by commas."""
        return ", ".join(self.math(formula) for formula in formulas)

    def links(self, labels: Sequence[str]) -> str:
        """References, separated by commas."""
        return ", ".join(
            f"[{self._document.name(label)}](#eq-{label.replace(':', '-')})"
            if self._document.shows(label)
            else self._document.name(label)
            for label in labels
        )


def _display(display: Display, document: Document, pen: MarkdownPen) -> list[str]:
    number = f"({display.label})"
    name = f"**{number}**" if display.is_numbered else number
    identity = f'<a id="eq-{display.label}"></a>'
    parts = [f"{identity}{name} {pen.say(display.say)}".rstrip()]
    for line in display.lines:
        parts.extend(_line(line, display, document, pen))
    parts.append(_steps(display, document, pen))
    return parts


def _line(line: Line, display: Display, document: Document, pen: MarkdownPen) -> list[str]:
    formula, words, ui = line.formula, document.words, document.words.ui
    parts: list[str] = []
    if formula.label != display.label:
        parts.append(f'<a id="eq-{formula.label.replace(":", "-")}"></a>{pen.say(line.say)}')
    parts.append(_block(formula.right))
    if formula.is_misprinted or line.misprints:
        parts.append(f"> **{ui('misprint')}**")
    if formula.is_misprinted:
        block = _block(formula.printed).replace("\n", "\n> ")
        parts.append(f"> {ui('printed')}:\n>\n> {block}")
    for one in line.misprints:
        text = f"{words.misprint_kind(one.kind)}. "
        if in_words(one):
            printed, right = pen.say(words.printed(one)), pen.say(words.right(one))
            text += f"{ui('printed')}: ~~{printed}~~ {ui('right')}: **{right}** "
        text += reasons(one, document, pen)
        parts.append(f"> {text} {fate(one, document, pen)}")
    return parts


def _block(tex: str) -> str:
    return f"```math\n{latex.display(tex, _ROOM)}\n```"


def _steps(display: Display, document: Document, pen: MarkdownPen) -> str:
    words, ui = document.words, document.words.ui
    kinds = dict.fromkeys(words.kind(step.kind) for _, step in display.steps)
    lines = [f"<details><summary>{ui('step')}: {', '.join(kinds)}</summary>", ""]
    for covered, step in display.steps:
        head = ""
        if len(covered) < len(display.lines):
            head = ", ".join(document.part(line.formula.label) for line in covered) + ": "
        text = f"- {head}**{words.kind(step.kind)}**"
        text += f", {ui('from')} {pen.links(step.premises)}" if step.premises else ""
        text += f", {ui('by')} {pen.math(step.detail)}" if step.detail else ""
        if step.neglected:
            text += f". {ui('neglected')}: {words.neglected(step.kind)} {pen.math(step.neglected)}"
        lines.append(f"{text}.")
    for one in display.conditions:
        latex = f" {pen.math(one.latex)}" if one.latex else ""
        silent = f" ({ui('silent_long')})" if one.silent else ""
        text = f"  - {ui('condition')}{latex}: {pen.say(words.condition(one.key))}{silent}"
        if document.explains(one, display):
            text += f" {words.fate(one.consequence)}: {pen.say(words.consequence(one.consequence))}"
        lines.append(text)
    return "\n".join([*lines, "", "</details>"])


def _table(rows: Sequence[Sequence[str]]) -> str:
    head, *body = [[cell.replace("|", "\\|") for cell in row] for row in rows]
    lines = [head, ["---"] * len(head), *body]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
