"""One display in HTML: what is said, its formulas, what is wrong in print, and the steps."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.document.html_pen import anchor
from kugelpendel.paper.document.tables import fate, in_words, reasons
from kugelpendel.paper.typeset import mathml
from kugelpendel.paper.typeset.difference import difference

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.derivation.model import Condition, Misprint, Step
    from kugelpendel.paper.document.html_pen import HtmlPen
    from kugelpendel.paper.document.outline import Display, Document, Line

_LONG = 4
"""A chain of so many lines shows its first and last, and the others on demand."""


def article(display: Display, document: Document, pen: HtmlPen) -> str:
    """Write a display."""
    style = "numbered" if display.is_numbered else "between"
    say = f'<p class="say">{pen.say(display.say)}</p>' if display.say else ""
    lines = [_line(line, document, pen) for line in display.lines]
    if len(lines) >= _LONG and any(line.formula.head for line in display.lines):
        lines = [lines[0], _fold(display.lines[1:-1], lines[1:-1], document), lines[-1]]
    tag = f'<a class="tag" href="#{anchor(display.label)}">({escape(display.label)})</a>'
    return (
        f'<article class="{style}" id="{anchor(display.label)}">{tag}{say}'
        f"{''.join(lines)}{_steps(display, document, pen)}</article>"
    )


def _fold(lines: Sequence[Line], written: Sequence[str], document: Document) -> str:
    ui = document.words.ui
    text = ui("between_one") if len(lines) == 1 else ui("between", len(lines))
    wrong = sum(len(line.misprints) for line in lines)
    badge = f' <span class="badge wrong">{wrong} × {ui("misprint")}</span>' if wrong else ""
    return f'<details class="lines"><summary>{text}{badge}</summary>{"".join(written)}</details>'


def _line(line: Line, document: Document, pen: HtmlPen) -> str:
    formula = line.formula
    identity = f' id="{anchor(formula.label)}"' if formula.label != formula.display else ""
    say = f'<p class="say">{pen.say(line.say)}</p>' if line.say else ""
    printed, right = difference(formula.printed, formula.right)
    wrong = _wrong(line, mathml.written(printed), document, pen)
    return (
        f'<div class="line"{identity} data-label="{escape(formula.label)}">{say}'
        f'<div class="formula" tabindex="0">{mathml.written(right)}</div>{wrong}</div>'
    )


def _wrong(line: Line, printed: str, document: Document, pen: HtmlPen) -> str:
    if not (line.misprints or line.formula.is_misprinted):
        return ""
    ui = document.words.ui
    kinds = dict.fromkeys(ui(f"misprint_{one.kind}") for one in line.misprints)
    head = f'<p class="what">{ui("misprint")}: {", ".join(kinds)}</p>'
    shown = ""
    if line.formula.is_misprinted:
        shown = f'<p>{ui("printed")}:</p><div class="formula printed" tabindex="0">{printed}</div>'
    notes = "".join(_note(one, document, pen) for one in line.misprints)
    style = (
        "misprint"
        if shown or any(one.kind != "word" for one in line.misprints)
        else "misprint slight"
    )
    return f'<aside class="{style}">{head}{shown}{notes}</aside>'


def _note(one: Misprint, document: Document, pen: HtmlPen) -> str:
    ui = document.words.ui
    parts: list[str] = []
    if in_words(one):
        printed, right = pen.say(document.words.printed(one)), pen.say(document.words.right(one))
        parts.append(
            f"<p>{ui('printed')}: <del>{printed}</del><br>{ui('right')}: <ins>{right}</ins></p>"
        )
    parts.append(f"<p>{reasons(one, document, pen)}</p>")
    parts.append(f"<p>{fate(one, document, pen)}</p>")
    return f'<div id="misprint-{escape(one.key)}">{"".join(parts)}</div>'


def _steps(display: Display, document: Document, pen: HtmlPen) -> str:
    ui = document.words.ui
    steps = display.steps
    kinds = dict.fromkeys(document.words.kind(step.kind) for _, step in steps)
    needed = display.conditions
    badge = f' <span class="badge">{len(needed)} × {ui("condition")}</span>' if needed else ""
    items = "".join(_step(display, lines, step, document, pen) for lines, step in steps)
    items += _conditions(display, document, pen)
    used = document.used_in(display)
    after = f'<p class="next">{ui("next")} {pen.links(used)}</p>' if used else ""
    return (
        f'<details class="step"><summary><span class="kind">{escape(", ".join(kinds))}</span>'
        f"{badge}</summary>{items}{after}</details>"
    )


def _step(
    display: Display, lines: Sequence[Line], step: Step, document: Document, pen: HtmlPen
) -> str:
    ui = document.words.ui
    head = ""
    if len(lines) < len(display.lines):
        head = ", ".join(escape(document.part(line.formula.label)) for line in lines) + ": "
    text = f"{head}<strong>{document.words.kind(step.kind)}</strong>"
    if step.premises:
        text += f", {ui('from')} {pen.links(step.premises)}"
    if step.detail:
        text += f", {ui('by')} {pen.math(step.detail)}"
    if step.neglected:
        text += (
            f". {ui('neglected')}: {document.words.neglected(step.kind)} {pen.math(step.neglected)}"
        )
    return f"<p>{text}.</p>"


def _conditions(display: Display, document: Document, pen: HtmlPen) -> str:
    items = "".join(_condition(one, display, document, pen) for one in display.conditions)
    return f'<ul class="needs">{items}</ul>' if items else ""


def _condition(one: Condition, display: Display, document: Document, pen: HtmlPen) -> str:
    ui = document.words.ui
    latex = f" {pen.math(one.latex)}" if one.latex else ""
    silent = f' <em class="silent">({ui("silent_long")})</em>' if one.silent else ""
    fails = ""
    if document.explains(one, display):
        told = pen.say(document.words.consequence(one.consequence))
        fails = f"<br>{document.words.fate(one.consequence)}: {told}"
    elif one.consequence:
        fails = f' <a class="ref" href="#conditions">{document.words.fate(one.consequence)} …</a>'
    text = pen.say(document.words.condition(one.key))
    return f"<li>{ui('condition')}{latex}: {text}{silent}{fails}</li>"
