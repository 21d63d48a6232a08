"""Whether the wording says only what is proved: its formulas, figures and quantities.

A sentence names its formulas and figures (`derivation.statements`). What it writes out must be a
single quantity that stands, as it is written, in the formulas that the sentence is about; and an
order or a power must be a figure that is worked out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, cast

from kugelpendel.paper.checks.wording.figures import FIGURES, figure, says
from kugelpendel.paper.derivation.graph import FORMULAS, parts
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.derivation.model import Formula
from kugelpendel.paper.derivation.statements import (
    FIGURE,
    STATEMENT,
    STATEMENTS,
    named_figures,
    named_statements,
    sentences,
)

_MATH = re.compile(r"\$([^$]+)\$")
_LINK = re.compile(r"\{([^{}]+)\}")
_CLAIM = re.compile(r"[=<>]|\\(?:approx|ll|neq|geq|leq)\b|(?<![\^_])\d")
_LAYOUT = re.compile(r"\\(?:left|right|cdot|quad)|\s")
_ORDER = re.compile(
    r"(?:zweite|dritte|vierte|fünfte|sechste)[nrs]? (?:Ordnung|Potenz)|Quadrat der Amplitude"
    r"|(?:second|third|fourth|fifth|sixth) (?:order|power)|square of the amplitude"
)


def texts(language: str) -> Iterator[tuple[str, str]]:
    """Give every text of a language with the name of its place, such as "formula.10"."""
    yield from _texts(sentences(language), "")


def _texts(entry: Any, place: str) -> Iterator[tuple[str, str]]:
    match entry:
        case str():
            yield place, entry
        case list():
            for one in cast("list[Any]", entry):
                yield from _texts(one, place)
        case _:
            for key, one in cast("Mapping[str, Any]", entry).items():
                yield from _texts(one, f"{place}.{key}" if place else key)


def faults(place: str, text: str) -> tuple[str, ...]:
    """Say what a text claims that is not proved."""
    found = [
        f"{place}: no statement is named {name}"
        for name in named_statements(text)
        if name not in STATEMENTS
    ]
    for word, name in named_figures(text):
        if name not in FIGURES:
            found.append(f"{place}: no figure is named {name}")
        elif not says(word, figure(name)):
            found.append(f"{place}: {word} should say {figure(name)}")
    rest = FIGURE.sub("", STATEMENT.sub("", text))
    found.extend(f"{place}: “{said[0]}” is no figure" for said in _ORDER.finditer(rest))
    for latex in _MATH.findall(rest):
        if latex not in ("=", r"\approx"):
            if _CLAIM.search(re.sub(r"[\^_]\{?\d", "", latex)):
                found.append(f"{place}: {latex} claims something and is no statement")
            elif not stands(latex, place, text):
                found.append(f"{place}: {latex} does not stand in the formulas it is said of")
    return tuple(found)


def stands(latex: str, place: str, text: str) -> bool:
    """Whether a quantity stands, as it is written, in the formulas that a text is about."""
    return _LAYOUT.sub("", latex) in _around(place, text)


@cache
def _around(place: str, text: str) -> str:
    """The LaTeX of all that a text may speak of, one after the other, without layout."""
    table, _, key = place.partition(".")
    linked = [name for name in _LINK.findall(text) if _is_label(name)]
    match table:
        case "formula":
            about = [*_of(key), *linked]
        case "condition" | "consequence" | "holds":
            about = [*_needing(table, key), *linked]
        case "misprint":
            where = [one.where.partition(":")[0] for one in MISPRINTS if one.key == key]
            about = [*where, *linked]
        case _:
            about = [one.label for one in FORMULAS]
    found = [piece for label in about for one in parts(label) for piece in _pieces(one)]
    for one in MISPRINTS:
        if table == "misprint" and one.key == key:
            found.extend([one.printed, one.right])
    return " | ".join(_LAYOUT.sub("", piece) for piece in found)


def _is_label(name: str) -> bool:
    return any(name in (one.label, one.display) for one in FORMULAS)


def _of(key: str) -> list[str]:
    """A formula or display, and what its steps stand on."""
    own = parts(key)
    before = [name for one in own for name in one.step.premises]
    return [*(one.label for one in own), *before, *(part.label for part in parts(own[0].display))]


def _needing(table: str, key: str) -> list[str]:
    """The formulas whose step needs a condition, with what they stand on."""
    found: list[str] = []
    for one in FORMULAS:
        for condition in one.step.conditions:
            if key == (condition.key if table == "condition" else condition.consequence):
                found.extend([one.label, *one.step.premises])
    return found


def _pieces(one: Formula) -> Iterator[str]:
    yield from (one.right, one.printed, one.step.detail, one.step.neglected)
    yield from (condition.latex for condition in one.step.conditions)
