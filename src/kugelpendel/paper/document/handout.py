"""The derivation on a few sheets: the numbered equations, the pictures, the numbers to measure."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.document.frame import framed
from kugelpendel.paper.document.html import inline, rendered
from kugelpendel.paper.document.markdown import Writer, anchor
from kugelpendel.paper.document.outline import premises
from kugelpendel.paper.document.pictures.figure import figure
from kugelpendel.paper.document.pictures.graph import contracted

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from kugelpendel.paper.document.outline import Display, Document

_FIGURES = {1: "geometry", 4: "ellipse"}
"""Which picture stands in which of the paper's sections."""


def write(document: Document) -> str:
    """Write the handout, a page to print on A4.

    Parameters
    ----------
    document
        Its displays are those to show; its derivation is the whole one.
    """
    writer, words = Writer(document), document.words
    rests = contracted(
        [display.label for display in document.displays], premises(document.derivation.formulas)
    )
    parts = [
        f"<header><h1>{escape(document.title())}</h1>\n<p>{escape(words.subtitle())}</p></header>",
        _paragraphs(words.paragraphs("introduction")[:1], writer),
        f"<h2>{escape(words.ui('conventions'))}</h2>",
        _list(words.paragraphs("conventions"), writer),
    ]
    for chapter in document.chapters:
        parts.append(f"<h2>{chapter.number} {escape(chapter.title)}</h2>")
        if chapter.number in _FIGURES:
            parts.append(_figure(_FIGURES[chapter.number], document, writer))
        parts.append(rendered(f"*{writer.say(chapter.lead)}*"))
        parts.extend(_display(display, rests, writer) for display in chapter.displays)
    for name, key in (("closing", "path"), ("example", "sizes")):
        parts.append(f"<h2>{escape(words.ui(name))}</h2>")
        parts.append(_figure(key, document, writer))
        parts.append(_paragraphs(words.paragraphs(name), writer))
    parts.append(f"<footer>{rendered(writer.told(words.ui('handout_whole')))}</footer>")
    body = "<main>\n" + "\n".join(parts) + "\n</main>"
    return framed(document, document.title(), body, "handout")


def _paragraphs(texts: Sequence[str], writer: Writer) -> str:
    return rendered("\n\n".join(writer.say(one) for one in texts))


def _list(texts: Sequence[str], writer: Writer) -> str:
    return rendered("\n".join(f"- {writer.say(one)}" for one in texts))


def _figure(key: str, document: Document, writer: Writer) -> str:
    return figure(key, document.words, lambda sentence: inline(writer.say(sentence)))


def _display(display: Display, rests: Mapping[str, Sequence[str]], writer: Writer) -> str:
    """Write an equation: what is said of it, the formula, in numbers, what it rests on.

    Of a chain of formulas that continue each other only the first and the last are shown.
    """
    lines = display.lines
    if len(lines) > 2 and any(line.formula.head for line in lines):
        lines = (lines[0], lines[-1])
    tag = f'<a class="tag" href="#{anchor(display.label)}">**({display.label})**</a>'
    parts = [f"{tag} {writer.say(display.say)}"]
    parts.extend(
        f'<div class="line">\n\n{writer.block(line.formula.right)}\n\n</div>' for line in lines
    )
    notes = [writer.number(display), writer.rests(rests[display.label])]
    body = "\n\n".join([*parts, *(note for note in notes if note)])
    return rendered(f'<div class="display" id="{anchor(display.label)}">\n\n{body}\n\n</div>')
