"""From the derivation to a text: which formulas, which language, which format."""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

from kugelpendel.paper.checks.counterexample import counterexample
from kugelpendel.paper.derivation.graph import FORMULAS, parts, rests_on
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.document import html, latex, markdown, terminal
from kugelpendel.paper.document.markdown import Writer
from kugelpendel.paper.document.outline import Derivation, compose

if TYPE_CHECKING:
    from kugelpendel.paper.document.outline import Document


def composed(language: str, target: str = "") -> Document:
    """Put together the derivation, or what leads to one formula or display, in a language."""
    labels = [formula.label for formula in FORMULAS]
    if target:
        labels = [*rests_on(target), *(formula.label for formula in parts(target))]
    return compose(Derivation(FORMULAS, MISPRINTS, _evidence), language, labels, target)


def write(
    language: str, form: str, target: str = "", width: int = 80, coloured: bool = False
) -> str:
    """Write the derivation.

    Parameters
    ----------
    language
        One of `LANGUAGES`.
    form
        "html", "md", "latex" or "text".
    target
        A label, to show only what leads to it; "" shows everything.
    width
        The number of signs in a line, of text.
    coloured
        Whether text may hold a terminal's colours.

    Raises
    ------
    UnknownLabel
        The derivation has no such formula or display.
    """
    whole = composed(language, target)
    match form:
        case "html":
            return html.write(whole)
        case "md":
            return markdown.write(whole)
        case "latex":
            return latex.write(whole)
        case _:
            return terminal.write(whole, width, coloured)


def misprint_list(language: str, width: int = 80, coloured: bool = False) -> str:
    """Write all misprints as text, `width` signs wide."""
    return terminal.text(Writer(composed(language)).misprints(), width, coloured)


@cache
def _evidence(key: str) -> tuple[tuple[str, ...], str] | None:
    found = counterexample(key)
    if found is None:
        return None
    values = tuple(f"{name} = {_fraction(value)}" for name, value in found.values)
    return values, _fraction(found.excess)


def _fraction(number: str) -> str:
    return re.sub(r"(\d+)/(\d+)", r"\\frac{\1}{\2}", number)
