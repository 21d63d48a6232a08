"""The derivation as one HTML file that needs nothing else: the Markdown, in a frame."""

from __future__ import annotations

import re
from html import escape
from importlib.resources import files
from itertools import pairwise
from typing import TYPE_CHECKING

from markdown_it.renderer import RendererHTML

from kugelpendel.paper.document.dialect import BREAK, is_math, parser
from kugelpendel.paper.document.markdown import Part, Writer, anchor
from kugelpendel.paper.document.outline import graph
from kugelpendel.paper.document.pictures.graph import Box, contracted, draw
from kugelpendel.paper.document.prose import sentence
from kugelpendel.paper.typeset import mathml

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from markdown_it.token import Token
    from markdown_it.utils import EnvType, OptionsDict

    from kugelpendel.paper.document.outline import Display, Document

_PUNCTUATION = re.compile(r"[,.;:)]+")
"""What must not begin a line after a formula."""


_LAST = ("misprints", "conditions")
"""The tables, before which the picture stands."""


def write(document: Document) -> str:
    """Write the whole page."""
    writer = Writer(document)
    folder = files("kugelpendel.paper.document") / "page"
    style = (folder / "page.css").read_text(encoding="utf-8")
    script = (folder / "page.js").read_text(encoding="utf-8")
    contents = [(part, rendered(part.text)) for part in writer.parts()]
    at = next((n for n, (part, _) in enumerate(contents) if part.key in _LAST), len(contents))
    contents.insert(at, (Part("picture", document.words.ui("picture"), ""), _pictures(document)))
    body = "\n".join(
        f'<section id="{part.key}"><h2>{escape(part.title)}</h2>\n{content}</section>'
        for part, content in contents
    )
    nav = _contents(document, [part for part, _ in contents])
    return (
        f'<!DOCTYPE html>\n<html lang="{document.words.language}">\n<head>\n'
        '<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<link rel="icon" href="data:,">\n<title>{escape(document.title())}</title>\n'
        f"<style>\n{style}</style>\n</head>\n<body>\n{nav}\n<main>\n"
        f"{_head(document, writer)}\n{body}\n</main>\n"
        f"<script>\n{script}</script>\n</body>\n</html>\n"
    )


def rendered(markdown: str) -> str:
    """Render the document's Markdown as HTML."""
    markdown_it = parser(_Page)
    read = markdown_it.parse(markdown)
    _name_cells(read)
    _glue(read)
    return markdown_it.renderer.render(read, markdown_it.options, {})


class _Page(RendererHTML):
    """markdown-it's own HTML, with formulas as MathML."""

    def math_inline(
        self, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType
    ) -> str:
        """Write a formula within a sentence, with the sign after it on the same line."""
        formula, sign = mathml.inline(tokens[idx].content), tokens[idx].meta.get("sign", "")
        if not sign:
            return formula
        # a word joiner is not enough: Chromium breaks the line beside a formula all the same
        before, wbr, last = formula.rpartition("<wbr>")
        return f'{before}{wbr}<span class="glued">{last}{sign}</span>'

    def fence(self, tokens: Sequence[Token], idx: int, options: OptionsDict, env: EnvType) -> str:
        """Write a formula on lines of its own, in which a narrow page may scroll."""
        token = tokens[idx]
        if not is_math(token):
            return super().fence(tokens, idx, options, env)
        style = "formula printed" if "printed" in token.meta else "formula"
        marked = token.meta.get("printed") or token.meta.get("right")
        formula = mathml.display(token.content) if marked is None else mathml.written(marked)
        return f'<div class="{style}" tabindex="0">{formula}</div>\n'


def _name_cells(read: Sequence[Token]) -> None:
    """Give each cell the name of its column, since a narrow page shows a table as a list."""
    names: list[str] = []
    column = 0
    for before, token in pairwise(read):
        if token.type == "table_open":
            names = []
        elif before.type == "tr_open":
            column = 0
        if before.type == "th_open":
            before.attrSet("scope", "col")
            names.append(token.content.partition(BREAK)[0])
        elif before.type == "td_open":
            before.attrSet("data-head", names[column])
            column += 1


def _glue(read: Iterable[Token]) -> None:
    """Give each formula within a sentence the sign after it, which must not begin a line."""
    for token in read:
        for formula, text in pairwise(token.children or []):
            match = _PUNCTUATION.match(text.content)
            if formula.type == "math_inline" and text.type == "text" and match:
                formula.meta["sign"] = match[0]
                text.content = text.content[match.end() :]


def _head(document: Document, writer: Writer) -> str:
    ui = document.words.ui
    return (
        f"<header><h1>{escape(document.title())}</h1>\n{rendered(writer.head())}"
        f'<p class="tools"><button type="button" data-open="yes">{ui("open_all")}</button>'
        f'<button type="button" data-open="no">{ui("close_all")}</button></p></header>'
    )


def _contents(document: Document, parts: Iterable[Part]) -> str:
    ui = document.words.ui
    chapters = {f"section-{chapter.number}": chapter for chapter in document.chapters}
    links: list[str] = []
    for part in parts:
        numbers = ""
        if part.key in chapters:
            numbered = "".join(
                f'<li><a href="#{anchor(display.label)}">({display.label})</a></li>'
                for display in chapters[part.key].displays
                if display.is_numbered
            )
            numbers = f'<ul class="numbers">{numbered}</ul>'
        links.append(f'<li><a href="#{part.key}">{escape(part.title)}</a>{numbers}</li>')
    return (
        f'<nav aria-label="{ui("contents")}"><details open class="contents"><summary>'
        f"{ui('contents')}</summary><ul>{''.join(links)}</ul></details></nav>"
    )


def _pictures(document: Document) -> str:
    ui = document.words.ui
    rests = graph(document)
    target = document.target.partition(":")[0]
    few = [one for one in document.displays if one.is_numbered or one.label == target]
    title = ui("picture")
    overview = draw(_boxes(few), contracted([one.label for one in few], rests), title)
    whole = draw(_boxes(document.displays), rests, ui("picture_all"))
    return (
        f'<p>{ui("picture_numbered")}</p><div class="picture" tabindex="0">{overview}</div>'
        f'<details class="all"><summary>{ui("picture_all")}</summary>'
        f'<div class="picture" tabindex="0">{whole}</div></details>'
    )


def _boxes(displays: Iterable[Display]) -> list[Box]:
    boxes: list[Box] = []
    for display in displays:
        style = "numbered" if display.is_numbered else "between"
        style += " wrong" if display.has_wrong_formula else ""
        boxes.append(Box(display.label, style, sentence(display.say)))
    return boxes
