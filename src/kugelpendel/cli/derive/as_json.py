"""What ``kugelpendel derive`` finds, as JSON for other programs."""

from __future__ import annotations

from dataclasses import asdict, fields
from typing import TYPE_CHECKING, Any

from kugelpendel import paper
from kugelpendel.cli.json_text import json_text
from kugelpendel.paper.document.prose import sentence

if TYPE_CHECKING:
    from collections.abc import Sequence


def misprints(language: str) -> str:
    """Write the misprints of the paper, in its order.

    Parameters
    ----------
    language
        The language of each "explanation"; formulas are LaTeX, and what the paper prints is German.
    """
    words = paper.words(language)
    return json_text([_misprint(one, words) for one in paper.MISPRINTS])


def _misprint(one: paper.Misprint, words: paper.Words) -> dict[str, Any]:
    found = paper.counterexample(one.key)
    shown = None if found is None else {"values": dict(found.values), "excess": found.excess}
    explanation = sentence(words.misprint(one.key))
    return {**asdict(one), "explanation": explanation, "counterexample": shown}


def proofs(rows: Sequence[paper.Row]) -> str:
    """Write what a check found for each formula, and whether everything holds."""
    formulas = [_row(row) for row in rows]
    return json_text({"holds": bool(rows) and all(row.holds for row in rows), "formulas": formulas})


def _row(row: paper.Row) -> dict[str, Any]:
    """Give the verdicts of a row; what was compared is in the page."""
    said = {one.name: getattr(row, one.name) for one in fields(row) if one.name != "evidence"}
    return {**said, "mutants": row.mutants, "holds": row.holds}
