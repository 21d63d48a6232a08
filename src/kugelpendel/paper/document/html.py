"""The derivation as one HTML file that needs nothing else: the Markdown, in a frame."""

from __future__ import annotations

import re
from html import escape
from itertools import pairwise
from typing import TYPE_CHECKING

from markdown_it.renderer import RendererHTML
from markdown_it.token import Token

from kugelpendel.paper.document.dialect import BREAK, has_class, is_math, parser
from kugelpendel.paper.document.frame import contents, framed, tools
from kugelpendel.paper.document.markdown import Part, Writer, anchor
from kugelpendel.paper.document.outline import graph
from kugelpendel.paper.document.pictures.figure import figure
from kugelpendel.paper.document.pictures.graph import Box, contracted, draw
from kugelpendel.paper.document.prose import sentence
from kugelpendel.paper.typeset import mathml

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from markdown_it.utils import EnvType, OptionsDict

    from kugelpendel.paper.document.outline import Display, Document
    from kugelpendel.paper.document.proof import Proofs

_PUNCTUATION = re.compile(r"[,.;:)]+")
"""What must not begin a line after a formula."""

_BEFORE_UNIT = re.compile(r"(?<=\d) (?=(?:mm|cm|m|s|min|h|kg|g|N|%|°)(?!\w))")
"""The blank between a number and its unit."""

_LAST = ("misprints", "conditions")
"""The tables, before which the picture of what rests on what stands."""

_FIGURES = {"section-1": "geometry", "section-4": "ellipse", "closing": "path", "example": "sizes"}
"""Which picture stands after the first paragraph of which part."""


def write(document: Document, proofs: Proofs | None = None) -> str:
    """Write the whole page; with `proofs` each display says whether it is proved, and how."""
    writer = Writer(document, proofs=proofs)
    parts = [(part, _filled(part, document, writer)) for part in writer.parts()]
    at = next((n for n, (part, _) in enumerate(parts) if part.key in _LAST), len(parts))
    parts.insert(at, (Part("picture", document.words.ui("picture"), ""), _pictures(document)))
    body = "\n".join(
        f'<section id="{part.key}"><h2>{escape(part.title)}</h2>\n{content}</section>'
        for part, content in parts
    )
    ui = document.words.ui
    content = (
        f'<a class="skip" href="#text">{ui("skip")}</a>\n'
        f"<header><h1>{escape(document.title())}</h1>\n{rendered(writer.head())}"
        f"{tools(document)}</header>\n{contents(document, [part for part, _ in parts])}\n"
        f'<main id="text" data-copy="{ui("copy")}" data-copy-long="{ui("copy_long", "…")}"'
        f' data-copied="{ui("copied")}">\n{body}\n</main>'
    )
    return framed(document, document.title(), content, script="page.js")


def rendered(markdown: str, document: Document | None = None) -> str:
    """Render Markdown as HTML; that of a document gets what a page has between its equations."""
    markdown_it = parser(_Page)
    read = markdown_it.parse(markdown)
    _name_columns(read)
    _glue(read)
    if document is not None:
        read = _with_runs(_with_neighbours(read, document), document)
    return markdown_it.renderer.render(read, markdown_it.options, {})


def inline(markdown: str) -> str:
    """Render a sentence, without a paragraph around it."""
    return rendered(markdown).strip().removeprefix("<p>").removesuffix("</p>")


def _filled(part: Part, document: Document, writer: Writer) -> str:
    """Render a part, with its picture after the first paragraph."""
    html = rendered(part.text, document)
    if document.target or part.key not in _FIGURES:
        return html
    shown = figure(
        _FIGURES[part.key], document.words, lambda sentence: inline(writer.say(sentence))
    )
    first, end, rest = html.partition("</p>\n")
    return f"{first}{end}{shown}{rest}"


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
        """Write a formula on lines of its own, in which a narrow page may scroll.

        The right ones keep their LaTeX, for a script to hand out.
        """
        token = tokens[idx]
        if not is_math(token):
            return super().fence(tokens, idx, options, env)
        marked = token.meta.get("printed") or token.meta.get("right")
        formula = mathml.display(token.content) if marked is None else mathml.written(marked)
        if "printed" in token.meta:
            return f'<div class="formula printed" tabindex="0">{formula}</div>\n'
        source = escape(token.content.strip())
        return f'<div class="formula" tabindex="0" data-latex="{source}">{formula}</div>\n'


def _name_columns(read: Sequence[Token]) -> None:
    """Give each table the names of its columns, since a narrow page shows a table as a list."""
    names: list[str] = []
    table = read[0] if read else None
    for before, token in pairwise(read):
        if token.type == "table_open":
            table, names = token, []
        elif before.type == "th_open" and table is not None:
            before.attrSet("scope", "col")
            names.append(token.content.partition(BREAK)[0])
            said = (f"--column-{n}: '{name}'" for n, name in enumerate(names, 1))
            table.attrSet("style", "; ".join(said))


def _glue(read: Iterable[Token]) -> None:
    """Keep together what must not stand on two lines.

    A formula within a sentence has the sign after it, and a number its unit, by a no-break blank.
    """
    for token in read:
        for text in token.children or []:
            if text.type == "text":
                text.content = _BEFORE_UNIT.sub("\N{NO-BREAK SPACE}", text.content)
        for formula, text in pairwise(token.children or []):
            match = _PUNCTUATION.match(text.content)
            if formula.type == "math_inline" and text.type == "text" and match:
                formula.meta["sign"] = match[0]
                text.content = text.content[match.end() :]


def _with_neighbours(read: Sequence[Token], document: Document) -> list[Token]:
    """Put links to the numbered equations before and after beside the number of each display."""
    ui = document.words.ui
    labels = [display.label for display in document.displays]
    numbered = [display.label for display in document.displays if display.is_numbered]
    for token in read:
        children = token.children or []
        if not children or not has_class(children[0], "tag"):
            continue
        label = next(q for q in labels if f"#{anchor(q)}" == children[0].attrGet("href"))
        if label in numbered:
            children[0].attrSet("title", ui("permanent", f"({label})"))
        at = labels.index(label)
        before = next((q for q in reversed(labels[:at]) if q in numbered), "")
        after = next((q for q in labels[at + 1 :] if q in numbered), "")
        links = "".join(
            f'<a href="#{anchor(q)}" aria-label="{ui(key)}: ({q})">{sign}</a>'
            for q, key, sign in ((before, "previous", "‹"), (after, "following", "›"))
            if q
        )
        end = next(n for n, child in enumerate(children) if child.type == "link_close")
        children.insert(
            end + 1, Token("html_inline", "", 0, content=f'<span class="around">{links}</span>')
        )
    return list(read)


def _with_runs(read: Sequence[Token], document: Document) -> list[Token]:
    """Put the displays between two numbered ones into one element, which can be left out.

    Where they are left out, links to them stand in their place; following one shows them all, for
    which the page needs no script.
    """
    found: list[Token] = []
    run: list[Token] = []
    labels: list[str] = []
    depth = 0
    for token in read:
        if depth == 0 and token.type == "div_open" and has_class(token, "between"):
            labels.append(str(token.attrGet("id")))
            depth = 1
        elif depth > 0:
            depth += token.nesting if token.tag == "div" else 0
        elif run:
            found.extend(_run(run, labels, document))
            run, labels = [], []
        if depth > 0 or (labels and token.type == "div_close"):
            run.append(token)
        else:
            found.append(token)
    return [*found, *_run(run, labels, document)] if run else found


def _run(displays: list[Token], anchors: Sequence[str], document: Document) -> list[Token]:
    links = ", ".join(f'<a href="#{one}">({one.removeprefix("eq-")})</a>' for one in anchors)
    lead = f'<p class="skipped">{document.words.ui("skipped")}: {links}</p>'
    opening = f'<div class="run">\n{lead}\n' if not document.target else '<div class="run">\n'
    return [
        Token("html_block", "", 0, content=opening),
        *displays,
        Token("html_block", "", 0, content="</div>\n"),
    ]


def _pictures(document: Document) -> str:
    ui = document.words.ui
    rests = graph(document)
    target = document.target.partition(":")[0]
    few = [one for one in document.displays if one.is_numbered or one.label == target]
    title = ui("picture")
    overview = draw(_boxes(few), contracted([one.label for one in few], rests), title)
    whole = draw(_boxes(document.displays, is_told=False), rests, ui("picture_all"))
    return (
        f'<p>{ui("picture_numbered")}</p><div class="picture" tabindex="0">{overview}</div>'
        f'<details class="all"><summary>{ui("picture_all")}</summary>'
        f'<div class="picture" tabindex="0">{whole}</div></details>'
    )


def _boxes(displays: Iterable[Display], is_told: bool = True) -> list[Box]:
    boxes: list[Box] = []
    for display in displays:
        style = "numbered" if display.is_numbered else "between"
        style += " wrong" if display.has_wrong_formula else ""
        boxes.append(Box(display.label, style, sentence(display.say) if is_told else ""))
    return boxes
