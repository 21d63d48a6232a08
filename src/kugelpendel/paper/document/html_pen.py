"""Sentences, formulas and references in HTML."""

from __future__ import annotations

import re
from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.typeset import mathml

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.document.outline import Document

_GLUED = re.compile(r"</math>(?=[,.;:)])")
"""A formula and the punctuation after it, which must not begin a line."""


def anchor(label: str) -> str:
    """The id of a formula or display."""
    return "eq-" + label.replace(":", "-")


class HtmlPen:
    """Writes into one document, whose formulas it can refer to."""

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
                    written.append(self.link(span.text))
                case "stress":
                    written.append(f"<em>{escape(span.text)}</em>")
                case "code":
                    written.append(f"<code>{escape(span.text)}</code>")
                case _:
                    written.append(escape(span.text, quote=False))
        return _GLUED.sub("</math>&#8288;", "".join(written))

    def math(self, latex: str) -> str:
        """A formula within a sentence."""
        return mathml.inline(latex)

    def values(self, formulas: Sequence[str]) -> str:
        """Formulas, separated by commas."""
        return "&#8288;, ".join(self.math(formula) for formula in formulas)

    def link(self, label: str) -> str:
        """A reference, as a link where the document shows what is referred to."""
        name = escape(self._document.name(label))
        if not self._document.shows(label):
            return f'<span class="ref">{name}</span>'
        return f'<a class="ref" href="#{anchor(label)}">{name}</a>'

    def links(self, labels: Sequence[str]) -> str:
        """References, separated by commas."""
        return ", ".join(self.link(label) for label in labels)


def table(rows: Sequence[Sequence[str]]) -> str:
    """A table that a narrow page shows as a list; the first row is its head."""
    head, *body = rows
    heads = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    lines = "".join(
        "<tr>"
        + "".join(
            f'<td data-head="{name.partition("<br>")[0]}">{cell}</td>'
            for name, cell in zip(head, row, strict=True)
        )
        + "</tr>"
        for row in body
    )
    return (
        f'<div class="table"><table><thead><tr>{heads}</tr></thead>'
        f"<tbody>{lines}</tbody></table></div>"
    )
