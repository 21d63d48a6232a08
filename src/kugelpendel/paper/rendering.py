"""From the derivation to a text: which formulas, which language, which format."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

from kugelpendel.paper.checks.counterexample import counterexample
from kugelpendel.paper.derivation.graph import FORMULAS, leading_to
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.derivation.model import PAPER
from kugelpendel.paper.document import handout as handouts
from kugelpendel.paper.document import html, latex, markdown, terminal
from kugelpendel.paper.document.markdown import Writer
from kugelpendel.paper.document.outline import Derivation, compose

if TYPE_CHECKING:
    from kugelpendel.paper.document.outline import Document
    from kugelpendel.paper.document.proof import Proofs


def composed(language: str, target: str = "") -> Document:
    """Put together the derivation, or what leads to one formula or display, in a language."""
    derivation = Derivation(FORMULAS, MISPRINTS, _evidence)
    return compose(derivation, language, leading_to(target), target)


def write(
    language: str,
    form: str,
    target: str = "",
    width: int = 80,
    coloured: bool = False,
    proofs: Proofs | None = None,
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
    proofs
        What a page shows as checked; without it the page does not say whether a step is proved.

    Raises
    ------
    UnknownLabel
        The derivation has no such formula or display.
    """
    whole = composed(language, target)
    match form:
        case "html":
            return html.write(whole, proofs)
        case "md":
            return markdown.write(whole)
        case "latex":
            return latex.write(whole)
        case _:
            return terminal.write(whole, width, coloured)


def handout(language: str) -> str:
    """Write the handout: the paper's numbered equations on a few sheets, as HTML to print.

    It has pictures and numbers, and shows every formula as it should be.
    """
    paper = [one for one in FORMULAS if one.section <= PAPER]
    numbered = {one.display for one in paper if one.number}
    shown = [one.label for one in paper if one.display in numbered]
    right = tuple(replace(one, printed=one.right) for one in FORMULAS)
    return handouts.write(compose(Derivation(right, (), _evidence), language, shown, ""))


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
