"""Sentences of the wording: words, formulas, links to equations, emphasis, code."""

from __future__ import annotations

import re
from dataclasses import dataclass

from kugelpendel.paper.typeset.unicode import plain

_SPAN = re.compile(
    r"\$(?P<math>[^$]+)\$|\{(?P<link>[^{}]+)\}|\*(?P<stress>[^*]+)\*|`(?P<code>[^`]+)`"
)


@dataclass(frozen=True)
class Span:
    """A stretch of a sentence.

    Attributes
    ----------
    kind
        "text", "math" (LaTeX), "link" (a label), "stress" or "code".
    """

    kind: str
    text: str


def spans(sentence: str) -> tuple[Span, ...]:
    """Take a sentence of the wording apart."""
    found: list[Span] = []
    end = 0
    for match in _SPAN.finditer(sentence):
        if match.start() > end:
            found.append(Span("text", sentence[end : match.start()]))
        kind = match.lastgroup or "text"
        found.append(Span(kind, match[kind]))
        end = match.end()
    if end < len(sentence):
        found.append(Span("text", sentence[end:]))
    return tuple(found)


def sentence(source: str) -> str:
    """Write a sentence of the wording as plain text, with references in brackets."""
    written_spans: list[str] = []
    for span in spans(source):
        match span.kind:
            case "math":
                written_spans.append(plain(span.text))
            case "link":
                written_spans.append(f"({span.text})")
            case _:
                written_spans.append(span.text)
    return "".join(written_spans)
