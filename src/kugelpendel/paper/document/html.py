"""The derivation as one HTML file that needs nothing else."""

from __future__ import annotations

from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from kugelpendel.paper.document.graph_svg import Box, contracted, draw
from kugelpendel.paper.document.html_display import article
from kugelpendel.paper.document.html_pen import HtmlPen, table
from kugelpendel.paper.document.outline import counts, graph
from kugelpendel.paper.document.prose import sentence
from kugelpendel.paper.document.tables import conditions, misprints

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kugelpendel.paper.document.outline import Chapter, Display, Document


def write(document: Document) -> str:
    """Write the whole page."""
    pen = HtmlPen(document)
    folder = files("kugelpendel.paper.document") / "page"
    style = (folder / "page.css").read_text(encoding="utf-8")
    script = (folder / "page.js").read_text(encoding="utf-8")
    body = "\n".join(
        f'<section id="{key}">{content}</section>' for key, content in _sections(document, pen)
    )
    return (
        f'<!DOCTYPE html>\n<html lang="{document.words.language}">\n<head>\n'
        '<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<link rel="icon" href="data:,">\n<title>{escape(document.title())}</title>\n'
        f"<style>\n{style}</style>\n</head>\n<body>\n{_contents(document, pen)}\n<main>\n"
        f"{_head(document)}\n{body}\n</main>\n<script>\n{script}</script>\n</body>\n</html>\n"
    )


def _sections(document: Document, pen: HtmlPen) -> list[tuple[str, str]]:
    """Ids and contents, in order."""
    words, ui = document.words, document.words.ui

    def headed(key: str, content: str) -> tuple[str, str]:
        return key, f"<h2>{ui(key)}</h2>{content}"

    def paragraphs(name: str) -> str:
        return "".join(f"<p>{pen.say(one)}</p>" for one in words.paragraphs(name))

    is_whole = not document.target
    found: list[tuple[str, str]] = []
    if is_whole:
        agreed = "".join(f"<li>{pen.say(one)}</li>" for one in words.paragraphs("conventions"))
        found.append(headed("introduction", paragraphs("introduction")))
        found.append(headed("conventions", f"<ul>{agreed}</ul>"))
    found.extend(_chapter(chapter, document, pen) for chapter in document.chapters)
    if is_whole:
        found.append(headed("closing", paragraphs("closing")))
    found.append(headed("picture", _pictures(document)))
    if document.misprints:
        lead = f"<p>{pen.say(ui('misprints_lead'))}</p>"
        found.append(headed("misprints", lead + table(_merged(misprints(document, pen)))))
    if document.conditions:
        lead = f"<p>{pen.say(ui('conditions_lead'))}</p>"
        found.append(headed("conditions", lead + table(conditions(document, pen))))
    return found


def _merged(rows: list[list[str]]) -> list[list[str]]:
    """Six columns as four: the formulas need the room."""
    return [
        [
            f"{place}<br>{kind}",
            f"{printed}<br>{right}"
            if number == 0
            else f"<del>{printed}</del><br><ins>{right}</ins>",
            known,
            goes,
        ]
        for number, (place, kind, printed, right, known, goes) in enumerate(rows)
    ]


def _head(document: Document) -> str:
    ui = document.words.ui
    under = escape(document.lead() if document.target else document.words.subtitle())
    return (
        f'<header><h1>{escape(document.title())}</h1><p class="subtitle">{under}</p>'
        f'<p class="counts">{ui("counts", *counts(document))}</p><p class="tools">'
        f'<button type="button" data-open="yes">{ui("open_all")}</button>'
        f'<button type="button" data-open="no">{ui("close_all")}</button></p></header>'
    )


def _contents(document: Document, pen: HtmlPen) -> str:
    ui = document.words.ui

    def entries(*keys: str) -> list[str]:
        return [f'<li><a href="#{key}">{ui(key)}</a></li>' for key in keys]

    links = [] if document.target else entries("introduction", "conventions")
    for chapter in document.chapters:
        numbered = "".join(
            f"<li>{pen.link(display.label)}</li>"
            for display in chapter.displays
            if display.is_numbered
        )
        links.append(
            f'<li><a href="#section-{chapter.number}">{chapter.number} {escape(chapter.title)}</a>'
            f'<ul class="numbers">{numbered}</ul></li>'
        )
    links.extend([] if document.target else entries("closing"))
    links.extend(entries("picture"))
    links.extend(entries("misprints") if document.misprints else [])
    links.extend(entries("conditions") if document.conditions else [])
    return (
        f'<nav aria-label="{ui("contents")}"><details open class="contents"><summary>'
        f"{ui('contents')}</summary><ul>{''.join(links)}</ul></details></nav>"
    )


def _chapter(chapter: Chapter, document: Document, pen: HtmlPen) -> tuple[str, str]:
    displays = "\n".join(article(display, document, pen) for display in chapter.displays)
    lead = "" if document.target else f'<p class="lead">{pen.say(chapter.lead)}</p>'
    title = f"<h2>{chapter.number} {escape(chapter.title)}</h2>"
    return f"section-{chapter.number}", f"{title}{lead}\n{displays}"


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
