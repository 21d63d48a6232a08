"""What stands around the text of a page: head, tools, contents, style and script."""

from __future__ import annotations

from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from kugelpendel.paper.document.markdown import anchor

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kugelpendel.paper.document.markdown import Part
    from kugelpendel.paper.document.outline import Document


def framed(document: Document, title: str, body: str, style: str = "", script: str = "") -> str:
    """Put a body into a page that needs nothing else.

    Parameters
    ----------
    document
        Tells the language.
    title
        The name of the page, in plain words.
    body
        Its content.
    style
        The class of the body, which tells the kinds of page apart.
    script
        The name of a file in ``page/``; "" leaves the page without a script.
    """
    kind = f' class="{style}"' if style else ""
    run = f"<script>\n{_file(script)}</script>\n" if script else ""
    return (
        f'<!DOCTYPE html>\n<html lang="{document.words.language}">\n<head>\n'
        '<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<link rel="icon" href="data:,">\n<title>{escape(title)}</title>\n'
        f"<style>\n{_file('page.css')}{_file('print.css')}</style>\n</head>\n<body{kind}>\n"
        f"{body}\n{run}</body>\n</html>\n"
    )


def _file(name: str) -> str:
    return (files("kugelpendel.paper.document") / "page" / name).read_text(encoding="utf-8")


def tools(document: Document) -> str:
    """Write the switches, which work without a script, and the buttons, which need one."""
    ui = document.words.ui
    lengths = ""
    if not document.target:
        lengths = (
            f"<fieldset><legend>{ui('length')}</legend>"
            '<label><input type="radio" name="length" id="length-whole" checked> '
            f"{ui('length_whole')}</label>"
            '<label><input type="radio" name="length" id="length-short"> '
            f"{ui('length_short')}</label></fieldset>"
        )
    misprints = ""
    if document.misprints:
        misprints = (
            '<label><input type="checkbox" id="show-misprints" checked> '
            f"{ui('show_misprints')}</label>"
        )
    return (
        f'<div class="tools">{lengths}{misprints}'
        f'<span><button type="button" data-open="yes" hidden>{ui("open_all")}</button>'
        f'<button type="button" data-open="no" hidden>{ui("close_all")}</button></span></div>'
    )


def contents(document: Document, parts: Iterable[Part]) -> str:
    """Write the table of contents, with the field to search in above it."""
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
        link = f'<a href="#{part.key}">{escape(part.title)}</a>'
        links.append(f'<li class="to-{part.key}">{link}{numbers}</li>')
    return (
        f'<nav aria-label="{ui("contents")}">'
        f'<form role="search" hidden><label for="find">{ui("search")}</label>'
        f'<input id="find" type="search" autocomplete="off" placeholder="{ui("search_hint")}">'
        f'<ul id="found" data-none="{ui("search_none")}" aria-live="polite"></ul></form>'
        f'<details open class="contents"><summary>'
        f"{ui('contents')}</summary><ul>{''.join(links)}</ul></details></nav>"
    )
