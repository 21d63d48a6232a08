"""The derivation as a LaTeX document."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.paper.document.outline import counts
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.document.tables import conditions, fate, in_words, misprints, reasons
from kugelpendel.paper.typeset import latex
from kugelpendel.paper.typeset.difference import difference
from kugelpendel.paper.typeset.tex import IDENTIFIERS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.document.outline import Display, Document, Line

_ROOM = 62
"""Signs in a line of a formula."""

_ESCAPES = {
    "\\": "\\textbackslash{}", "&": "\\&", "%": "\\%", "$": "\\$", "#": "\\#", "_": "\\_",
    "{": "\\{", "}": "\\}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "×": "$\\times$",
    "…": "\\dots{}", "−": "$-$",
}  # fmt: skip
_GREEK = {sign: f"$\\{name}$" for name, sign in IDENTIFIERS.items() if sign.isalpha()}
_DIGITS = {"₀": "$_0$", "²": "$^2$"}
_TRANSLATED = str.maketrans(_ESCAPES | _GREEK | _DIGITS)
_BABEL = {"de": "ngerman", "en": "english"}

_PREAMBLE = """\
\\documentclass[11pt,a4paper]{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\usepackage{lmodern}
\\usepackage[%s]{babel}
\\usepackage[margin=2.5cm]{geometry}
\\usepackage{amsmath}
\\usepackage[hidelinks]{hyperref}
\\setlength{\\parindent}{0pt}
\\setlength{\\parskip}{0.5em plus 0.2em}
\\setlength{\\emergencystretch}{3em}
\\allowdisplaybreaks
\\newenvironment{misprint}{\\begin{quote}\\small}{\\end{quote}}
\\newenvironment{steps}{\\begin{quote}\\footnotesize}{\\end{quote}}
"""


def write(document: Document) -> str:
    """Write the whole document."""
    pen = LatexPen(document)
    words, ui = document.words, document.words.ui
    is_whole = not document.target
    under = words.subtitle() if is_whole else document.lead()
    title = f"{escape(document.title())}\\\\[0.5ex]\\large {escape(under)}"
    parts = [
        _PREAMBLE % _BABEL[words.language] + f"\\title{{{title}}}\n\\author{{}}\n\\date{{}}",
        "\\begin{document}\n\\maketitle",
        escape(ui("counts", *counts(document))),
    ]
    if is_whole:
        parts.extend(["\\tableofcontents", _section(ui("introduction"))])
        parts.extend(pen.say(one) for one in words.paragraphs("introduction"))
        agreed = "\n".join(f"\\item {pen.say(one)}" for one in words.paragraphs("conventions"))
        parts.append(_section(ui("conventions")))
        parts.append(f"\\begin{{itemize}}\n{agreed}\n\\end{{itemize}}")
    for chapter in document.chapters:
        parts.append(_section(f"{chapter.number} {chapter.title}"))
        parts.extend([f"\\emph{{{pen.say(chapter.lead)}}}"] if is_whole else [])
        for display in chapter.displays:
            parts.extend(_display(display, document, pen))
    if is_whole:
        parts.append(_section(ui("closing")))
        parts.extend(pen.say(one) for one in words.paragraphs("closing"))
    if document.misprints:
        parts.extend([_section(ui("misprints")), pen.say(ui("misprints_lead"))])
        parts.append(_described(misprints(document, pen)))
    if document.conditions:
        parts.extend([_section(ui("conditions")), pen.say(ui("conditions_lead"))])
        parts.append(_described(conditions(document, pen)))
    return "\n\n".join([*parts, "\\end{document}"]) + "\n"


def escape(text: str) -> str:
    """Words, with what LaTeX would take for commands made harmless."""
    return text.translate(_TRANSLATED)


class LatexPen:
    """Sentences, formulas and references in LaTeX."""

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
                    written.append(f"\\emph{{{escape(span.text)}}}")
                case "code":
                    written.append(f"\\texttt{{{escape(span.text).replace('--', '-{}-')}}}")
                case _:
                    written.append(escape(span.text))
        return "".join(written)

    def math(self, latex: str) -> str:
        """A formula within a sentence."""
        return f"${latex}$"

    def values(self, formulas: Sequence[str]) -> str:
        """Formulas, separated by commas."""
        return ", ".join(self.math(formula) for formula in formulas)

    def links(self, labels: Sequence[str]) -> str:
        """References, separated by commas."""
        return ", ".join(
            f"\\hyperlink{{eq-{label}}}{{{escape(self._document.name(label))}}}"
            if self._document.shows(label)
            else escape(self._document.name(label))
            for label in labels
        )


def _section(title: str) -> str:
    return f"\\section*{{{escape(title)}}}\n\\addcontentsline{{toc}}{{section}}{{{escape(title)}}}"


def _display(display: Display, document: Document, pen: LatexPen) -> list[str]:
    parts = [f"\\hypertarget{{eq-{display.label}}}{{}}{pen.say(display.say)}"]
    for number, line in enumerate(display.lines):
        parts.extend(_line(line, display, number == 0, document, pen))
    parts.append(_steps(display, document, pen))
    return parts


def _line(
    line: Line, display: Display, is_first: bool, document: Document, pen: LatexPen
) -> list[str]:
    formula, words, ui = line.formula, document.words, document.words.ui
    parts: list[str] = []
    if formula.label != display.label:
        parts.append(f"\\hypertarget{{eq-{formula.label}}}{{}}{pen.say(line.say)}")
    tag = f" \\tag{{{display.label}}}" if is_first else ""
    parts.append(_equation(latex.display(formula.right, _ROOM), tag))
    if not (formula.is_misprinted or line.misprints):
        return parts
    parts.append(f"\\begin{{misprint}}\n\\textbf{{{ui('misprint')}}}")
    if formula.is_misprinted:
        printed, _ = difference(formula.printed, formula.right)
        parts.append(f"{ui('printed')}:\n{_equation(latex.written(printed, _ROOM - 8))}")
    for one in line.misprints:
        text = f"{words.misprint_kind(one.kind)}. "
        if in_words(one):
            printed, right = pen.say(words.printed(one)), pen.say(words.right(one))
            text += f"{ui('printed')}: \\emph{{{printed}}} {ui('right')}: \\textbf{{{right}}} "
        text += reasons(one, document, pen)
        parts.append(f"{text} {fate(one, document, pen)}")
    parts.append("\\end{misprint}")
    return parts


def _equation(tex: str, tag: str = "") -> str:
    return f"\\begin{{equation*}}\n{tex}{tag}\n\\end{{equation*}}"


def _steps(display: Display, document: Document, pen: LatexPen) -> str:
    words, ui = document.words, document.words.ui
    lines: list[str] = []
    for covered, step in display.steps:
        head = ""
        if len(covered) < len(display.lines):
            head = ", ".join(escape(document.part(line.formula.label)) for line in covered) + ": "
        text = f"{head}\\textbf{{{words.kind(step.kind)}}}"
        text += f", {ui('from')} {pen.links(step.premises)}" if step.premises else ""
        text += f", {ui('by')} {pen.math(step.detail)}" if step.detail else ""
        if step.neglected:
            text += f". {ui('neglected')}: {words.neglected(step.kind)} {pen.math(step.neglected)}"
        text += "."
        lines.append(text)
    for one in display.conditions:
        tex = f" {pen.math(one.latex)}" if one.latex else ""
        silent = f" ({ui('silent_long')})" if one.silent else ""
        text = f"{ui('condition')}{tex}: {pen.say(words.condition(one.key))}{silent}"
        if document.explains(one, display):
            text += f" {words.fate(one.consequence)}: {pen.say(words.consequence(one.consequence))}"
        lines.append(text)
    body = "\n\n".join(lines)
    return f"\\begin{{steps}}\n{body}\n\\end{{steps}}"


def _described(rows: Sequence[Sequence[str]]) -> str:
    """A table as a list of entries: long formulas do not fit into columns."""
    head, *body = rows
    items: list[str] = []
    for first, *rest in body:
        told = " ".join(
            f"\\emph{{{escape(name)}}}: {cell}" for name, cell in zip(head[1:], rest, strict=True)
        )
        items.append(f"\\item {first} {told}")
    listed = "\n".join(items)
    return f"\\begin{{itemize}}\n{listed}\n\\end{{itemize}}"
