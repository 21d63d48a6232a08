"""The derivation in Markdown: the one place where the document is put into words and formulas.

The page, the LaTeX and the terminal's text are made from it; `kugelpendel.paper.document.dialect`
says what it uses beyond CommonMark. It stays readable as it is, and GitHub shows it.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.derivation.model import PAPER
from kugelpendel.paper.document.comparison import comparison
from kugelpendel.paper.document.dialect import BREAK
from kugelpendel.paper.document.outline import counts
from kugelpendel.paper.document.proof import told
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.typeset import latex

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from kugelpendel.paper.derivation.model import Condition, Misprint, Step
    from kugelpendel.paper.document.outline import Chapter, Display, Document, Line
    from kugelpendel.paper.document.proof import Proofs

_ROOM = 70
"""Signs in a line of a formula, where the Markdown itself is the document."""

_MANY = 4
"""A chain of so many lines shows its first and last, and the others on demand."""

_SILENT = "[†](#silent)"
"""Stands at a condition that the paper does not say; the legend below the title tells so."""

_SPECIAL = re.compile(r"([\\`*_\[\]<&|~])")


@dataclass(frozen=True)
class Part:
    """A headed part of the document: its anchor, its title in plain words, and its Markdown."""

    key: str
    title: str
    text: str


def write(document: Document, room: float = _ROOM) -> str:
    """Write the whole text, with formulas broken into lines of about `room` signs."""
    writer = Writer(document, room)
    parts = [
        f'<div id="{part.key}">\n\n## {_plain(part.title)}\n\n{part.text}\n\n</div>'
        for part in writer.parts()
    ]
    return "\n\n".join([f"# {_plain(document.title())}", writer.head(), *parts]) + "\n"


def anchor(label: str) -> str:
    """Give the id of a formula or display."""
    return "eq-" + label.replace(":", "-")


class Writer:
    """Writes a document, or the parts of it that a frame is built around.

    `room` is how many signs a line of a formula may have; without it no formula is broken. With
    `proofs` each display unfolds to what was checked.
    """

    def __init__(
        self, document: Document, room: float = math.inf, proofs: Proofs | None = None
    ) -> None:
        self._document = document
        self._proofs = proofs
        self._words = document.words
        self._ui = document.words.ui
        self._room = room

    def head(self) -> str:
        """Write what stands below the title: subtitle, counts, the legend of †, what is proved."""
        document, ui = self._document, self._ui
        under = document.lead() if document.target else self._words.subtitle()
        lines = [_plain(under), _plain(ui("counts", *counts(document)))]
        if any(condition.silent for condition, _ in document.conditions):
            lines.append(f'<div id="silent">\n\n{self.say(ui("silent_legend"))}\n\n</div>')
        proofs = self._proofs
        if proofs is not None:
            text = ui("proof_all", proofs.proved, len(proofs.evidence), proofs.when)
            spoilt = ui("proof_spoilt" if proofs.rows else "proof_unspoilt")
            lines.append(f'<div id="proofs">\n\n{self.told(f"{text} {spoilt}")}\n\n</div>')
        return "\n\n".join(lines)

    def parts(self) -> list[Part]:
        """Write all parts, in order."""
        document, words, ui = self._document, self._words, self._ui
        is_whole = not document.target
        found: list[Part] = []
        if is_whole:
            agreed = "\n".join(f"- {self.say(one)}" for one in words.paragraphs("conventions"))
            found.append(self._told("introduction"))
            found.append(Part("conventions", ui("conventions"), agreed))
        found.extend(self._chapter(chapter) for chapter in document.chapters)
        if is_whole:
            found.append(self._accuracy())
            found.append(self._told("closing"))
            found.append(self._told("example"))
            found.append(self._told("history"))
        if document.misprints:
            text = f"{self.say(ui('misprints_lead'))}\n\n{self.misprints(beside_notes=True)}"
            found.append(Part("misprints", ui("misprints"), text))
        if document.conditions:
            text = f"{self.say(ui('conditions_lead'))}\n\n{self._conditions()}"
            found.append(Part("conditions", ui("conditions"), text))
        return found

    def misprints(self, beside_notes: bool = False) -> str:
        """Write the table of misprints: where, what, how one knows, and where the error goes.

        Two things share a column, since formulas need the room. With `beside_notes` how one knows
        is told by a link where a note tells it that no reader can have folded away or left out.
        """
        words, ui = self._words, self._ui
        noted = self._always_noted() if beside_notes else set[str]()
        head = [
            f"{ui('place')}{BREAK}{ui('kind')}",
            f"{ui('printed')}{BREAK}{ui('right')}",
            ui("known"),
            ui("travels"),
        ]
        body = [
            [
                f"{self._links([one.where])}{BREAK}{ui(f'misprint_{one.kind}')}",
                f"~~{self.say(words.printed(one))}~~{BREAK}**{self.say(words.right(one))}**",
                f"[{ui('in_print')} {self._document.name(one.where)}](#misprint-{one.key})"
                if one.key in noted
                else self._reasons(one),
                self._links(one.travels) if one.travels else "–",
            ]
            for one in self._document.misprints
        ]
        return _table(head, body)

    def _conditions(self) -> str:
        ui, words = self._ui, self._words
        head = [ui("condition"), ui("needed"), ui("fails_or_holds")]
        body: list[list[str]] = []
        for one, where in self._document.conditions:
            formula = f"{_math(one.latex)}: " if one.latex else ""
            text = f"{formula}{self.say(words.condition(one.key))}"
            text += f" {_SILENT}" if one.silent else ""
            fails = self.say(words.consequence(one.consequence)) if one.consequence else "–"
            body.append([text, self._links(where), fails])
        return _table(head, body)

    def _told(self, name: str) -> Part:
        paragraphs = (self.say(one) for one in self._words.paragraphs(name))
        return Part(name, self._ui(name), "\n\n".join(paragraphs))

    def _accuracy(self) -> Part:
        """Write how good (25) and (26) are at some amplitudes."""
        part = self._told("accuracy")
        return Part(part.key, part.title, f"{part.text}\n\n{_table(*comparison(self._words))}")

    def _chapter(self, chapter: Chapter) -> Part:
        lead = [] if self._document.target else [f"*{self.say(chapter.lead)}*"]
        if chapter.number > PAPER:
            lead.append(self.say(self._ui("ours")))
        displays = (self._display(display) for display in chapter.displays)
        title = f"{chapter.number} {chapter.title}"
        return Part(f"section-{chapter.number}", title, "\n\n".join([*lead, *displays]))

    def _display(self, display: Display) -> str:
        number = f"**({display.label})**" if display.is_numbered else f"({display.label})"
        tag = f'<a class="tag" href="#{anchor(display.label)}">{number}</a>'
        lines = [self._line(line) for line in display.lines]
        if _is_folded(display):
            lines = [lines[0], self._fold(display.lines[1:-1], lines[1:-1]), lines[-1]]
        style = "numbered" if display.is_numbered else "between"
        say = f"{tag} {self.say(display.say)}".rstrip()
        if number := self.number(display):
            lines.append(number)
        body = "\n\n".join([say, *lines, self._steps(display), *self._proved(display)])
        return f'<div class="display {style}" id="{anchor(display.label)}">\n\n{body}\n\n</div>'

    def number(self, display: Display) -> str:
        """Write what a display means for the pendulum of the example, or nothing."""
        said = self._words.number(display.label)
        if not said:
            return ""
        text = f"**{self._ui('in_the_example')}:** {self.say(said)}"
        return f'<div class="number">\n\n{text}\n\n</div>'

    def rests(self, labels: Sequence[str]) -> str:
        """Write which displays something rests on, or nothing."""
        if not labels:
            return ""
        return f'<div class="rests">\n\n{self._ui("rests")} {self._links(labels)}\n\n</div>'

    def _fold(self, lines: Sequence[Line], written: Iterable[str]) -> str:
        ui = self._ui
        text = ui("between_one") if len(lines) == 1 else ui("between", len(lines))
        wrong = sum(len(line.misprints) for line in lines)
        badge = _badge(f"{wrong} × {ui('misprint')}", "badge wrong") if wrong else ""
        return _details("lines", text + badge, written)

    def _line(self, line: Line) -> str:
        formula = line.formula
        identity = f' id="{anchor(formula.label)}"' if formula.label != formula.display else ""
        parts = [self.say(line.say)] if line.say else []
        parts.append(self.block(formula.right))
        if line.misprints or formula.is_misprinted:
            parts.append(self._wrong(line))
        body = "\n\n".join(parts)
        label = escape(formula.label)
        return f'<div class="line"{identity} data-label="{label}">\n\n{body}\n\n</div>'

    def _wrong(self, line: Line) -> str:
        ui, is_misprinted = self._ui, line.formula.is_misprinted
        kinds = dict.fromkeys(ui(f"misprint_{one.kind}") for one in line.misprints)
        place = self._document.name(line.formula.label)
        parts = [f"**{ui('in_print')} {place}: {', '.join(kinds)}**"]
        if is_misprinted:
            parts.extend([f"{ui('printed')}:", self.block(line.formula.printed)])
        parts.extend(self._note(one) for one in line.misprints)
        is_slight = not is_misprinted and all(one.kind == "word" for one in line.misprints)
        style = "misprint slight" if is_slight else "misprint"
        body = "\n\n".join(parts)
        return f'<blockquote class="{style}">\n\n{body}\n\n</blockquote>'

    def _note(self, one: Misprint) -> str:
        ui, words = self._ui, self._words
        parts: list[str] = []
        if one.in_words or one.kind == "word":  # the formula alone does not show what is wrong
            printed, right = self.say(words.printed(one)), self.say(words.right(one))
            parts.append(f"{ui('printed')}: ~~{printed}~~\\\n{ui('right')}: **{right}**")
        parts.extend([self._reasons(one), self._fate(one)])
        body = "\n\n".join(parts)
        return f'<div id="misprint-{escape(one.key)}">\n\n{body}\n\n</div>'

    def _always_noted(self) -> set[str]:
        """Give the misprints noted at numbered equations, on lines never folded."""
        return {
            one.key
            for chapter in self._document.chapters
            for display in chapter.displays
            if display.is_numbered
            for line in _unfolded(display)
            for one in line.misprints
        }

    def _reasons(self, one: Misprint) -> str:
        """Write what is wrong, how one knows, and the smallest numbers that show it."""
        ui = self._ui
        text = f"{self.say(self._words.misprint(one.key))} {ui('known_' + one.known)}"
        evidence = self._document.derivation.evidence(one.key)
        if evidence is None:
            return text
        values, excess = evidence
        key = "counterexample_is" if "<" in excess else "counterexample"
        return f"{text} {ui(key, ', '.join(map(_math, values)), _math(excess))}"

    def _fate(self, one: Misprint) -> str:
        """Write where an error comes from, and where it goes."""
        ui = self._ui
        places = {other.key: other.where for other in self._document.derivation.misprints}
        origin = f"{ui('origin')} {self._links([places[one.origin]])}. " if one.origin else ""
        goes = f"{ui('travels')} {self._links(one.travels)}." if one.travels else ui("stays")
        return f"{origin}{goes}"

    def _steps(self, display: Display) -> str:
        ui = self._ui
        kinds = dict.fromkeys(self._words.kind(step.kind) for _, step in display.steps)
        needed = display.conditions
        badge = _badge(f"{len(needed)} × {ui('condition')}", "badge") if needed else ""
        parts = [self._step(display, lines, step) for lines, step in display.steps]
        if needed:
            parts.append("\n".join(self._condition(one, display) for one in needed))
        used = self._document.used_in(display)
        parts.extend([f"{ui('next')} {self._links(used)}"] if used else [])
        return _details("step", escape(", ".join(kinds)) + badge, parts)

    def _proved(self, display: Display) -> list[str]:
        """Write whether the display is proved, and on demand what was compared."""
        ui, proofs = self._ui, self._proofs
        if proofs is None:
            return []
        labels = [line.formula.label for line in display.lines]
        parts: list[str] = []
        for label in labels:
            name = f"**{self._document.name(label)}** " if len(labels) > 1 else ""
            first, *others = (self.told(one) for one in told(label, proofs, self._words))
            parts.extend([f"{name}{first}", *others])
        is_proved = all(proofs.holds(label) for label in labels)
        return [_details("proof", ui("proof_holds" if is_proved else "proof_fails"), parts)]

    def told(self, text: str) -> str:
        """Write a sentence about a proof, in which only code is more than words."""
        first, *others = text.split("`")
        written = [_plain(first)]
        for number, part in enumerate(others):
            written.append(f"`{part}`" if number % 2 == 0 else _plain(part))
        return "".join(written)

    def _step(self, display: Display, lines: Sequence[Line], step: Step) -> str:
        ui, words = self._ui, self._words
        head = ""
        if len(lines) < len(display.lines):
            head = ", ".join(self._document.part(line.formula.label) for line in lines) + ": "
        text = f"{head}**{words.kind(step.kind)}**"
        text += f", {ui('from')} {self._links(step.premises)}" if step.premises else ""
        text += f", {ui('by')} {_math(step.detail)}" if step.detail else ""
        if step.neglected:
            text += f". {ui('neglected')}: {words.neglected(step.kind)} {_math(step.neglected)}"
        return f"{text}."

    def _condition(self, one: Condition, display: Display) -> str:
        words = self._words
        formula = f" {_math(one.latex)}" if one.latex else ""
        sign = f" {_SILENT}" if one.silent else ""
        text = f"- [{self._ui('condition')}](#conditions){formula}{sign}: "
        text += self.say(words.condition(one.key))
        if self._document.explains(one, display):
            told = self.say(words.consequence(one.consequence))
            text += f"\\\n  {words.fate(one.consequence)}: {told}"
        return text

    def say(self, sentence: str) -> str:
        """Write a sentence of the wording."""
        written: list[str] = []
        for span in spans(sentence):
            match span.kind:
                case "math":
                    written.append(_math(span.text))
                case "link":
                    written.append(self._links([span.text]))
                case "stress":
                    written.append(f"*{_plain(span.text)}*")
                case "code":
                    written.append(f"`{span.text}`")
                case _:
                    written.append(_plain(span.text))
        return "".join(written)

    def _links(self, labels: Iterable[str]) -> str:
        """Write references, as links where the document shows what is referred to."""
        document = self._document
        return ", ".join(
            f"[{document.name(label)}](#{anchor(label)})"
            if document.shows(label)
            else document.name(label)
            for label in labels
        )

    def block(self, source: str) -> str:
        """Write a formula on lines of its own."""
        return f"```math\n{latex.display(source, self._room)}\n```"


def _is_folded(display: Display) -> bool:
    """Whether only the first and the last line of a chain are shown at once."""
    return len(display.lines) >= _MANY and any(line.formula.head for line in display.lines)


def _unfolded(display: Display) -> Sequence[Line]:
    lines = display.lines
    return (lines[0], lines[-1]) if _is_folded(display) else lines


def _plain(text: str) -> str:
    """Write words, so that none of their signs means anything to Markdown."""
    return _SPECIAL.sub(r"\\\1", text)


def _math(source: str) -> str:
    """Write a formula within a sentence, in the form that no other sign of Markdown disturbs."""
    return f"$`{source}`$"


def _badge(text: str, style: str) -> str:
    return f' <span class="{style}">{escape(text)}</span>'


def _details(style: str, summary: str, parts: Iterable[str]) -> str:
    body = "\n\n".join(parts)
    opening = f'<details class="{style}">\n<summary>{summary}</summary>'
    return f"{opening}\n\n{body}\n\n</details>"


def _table(head: Sequence[str], body: Iterable[Sequence[str]]) -> str:
    """Write a table; a bar within a cell must not end it."""
    written = [
        "| " + " | ".join(re.sub(r"(?<!\\)\|", r"\\|", cell) for cell in row) + " |"
        for row in (head, *body)
    ]
    rule = f"| {' | '.join('---' for _ in head)} |"
    table = "\n".join([written[0], rule, *written[1:]])
    return f'<div class="table">\n\n{table}\n\n</div>'
