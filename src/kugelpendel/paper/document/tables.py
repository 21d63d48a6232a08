"""The tables of misprints and of conditions, for every format."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.paper.derivation.model import Misprint
    from kugelpendel.paper.document.outline import Document


class Pen(Protocol):
    """How a format writes what stands in a cell."""

    def say(self, sentence: str) -> str:
        """A sentence of the wording."""
        ...

    def math(self, latex: str) -> str:
        """A formula."""
        ...

    def values(self, formulas: Sequence[str]) -> str:
        """Formulas, separated by commas."""
        ...

    def links(self, labels: Sequence[str]) -> str:
        """References to formulas."""
        ...


def misprints(document: Document, pen: Pen) -> list[list[str]]:
    """Where, what kind, printed, right, how one knows, and where the error goes; a head first."""
    ui = document.words.ui
    rows = [[ui("place"), ui("kind"), ui("printed"), ui("right"), ui("known"), ui("travels")]]
    for one in document.misprints:
        goes = pen.links(one.travels) if one.travels else ui("stays")
        known = reasons(one, document, pen)
        rows.append(
            [
                pen.links([one.where]),
                ui(f"misprint_{one.kind}"),
                pen.say(document.words.printed(one)),
                pen.say(document.words.right(one)),
                known,
                goes,
            ]
        )
    return rows


def conditions(document: Document, pen: Pen) -> list[list[str]]:
    """The condition, where it is needed, and what happens where it fails; a head first."""
    ui = document.words.ui
    rows = [[ui("condition"), ui("needed"), ui("fails_or_holds")]]
    for condition, where in document.conditions:
        text = pen.say(document.words.condition(condition.key))
        if condition.latex:
            text = f"{pen.math(condition.latex)}: {text}"
        if condition.silent:
            text += f" ({ui('silent')})"
        fails = document.words.consequence(condition.consequence) if condition.consequence else "–"
        rows.append([text, pen.links(where), pen.say(fails)])
    return rows


def reasons(one: Misprint, document: Document, pen: Pen) -> str:
    """What is wrong, how one knows, and the smallest numbers that show it."""
    ui = document.words.ui
    text = f"{pen.say(document.words.misprint(one.key))} {ui('known_' + one.known)}"
    evidence = document.derivation.evidence(one.key)
    if evidence is None:
        return text
    values, excess = evidence
    given = pen.values(values)
    key = "counterexample_is" if "<" in excess else "counterexample"
    return f"{text} {ui(key, given, pen.math(excess))}"


def in_words(one: Misprint) -> bool:
    """Whether the formula alone does not show what is wrong."""
    return one.in_words or one.kind == "word"


def fate(one: Misprint, document: Document, pen: Pen) -> str:
    """Where an error comes from, and where it goes."""
    ui = document.words.ui
    places = {other.key: other.where for other in document.derivation.misprints}
    origin = f"{ui('origin')} {pen.links([places[one.origin]])}. " if one.origin else ""
    goes = f"{ui('travels')} {pen.links(one.travels)}." if one.travels else ui("stays")
    return f"{origin}{goes}"
