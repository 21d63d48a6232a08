"""How good (25) and (26) are, as a table of words and numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.paper.checks.accuracy import ANGLES, accuracy
from kugelpendel.spelling import significant, spell_percent

if TYPE_CHECKING:
    from kugelpendel.paper.document.wording import Words

_COLUMNS = ("angle", "turning", "exact", "error_25", "error_c12", "error_26")


def comparison(words: Words) -> tuple[list[str], list[list[str]]]:
    """Write the heads of the columns, and a row for each amplitude, rates in units of ω0."""
    rows: list[list[str]] = []
    for degrees in ANGLES:
        found = accuracy(degrees)
        rates = [_rate(float(rate), words) for rate in (found.turning, found.exact)]
        errors = (found.error_25, found.error_c12, found.error_26)
        rows.append([f"{degrees}°", *rates, *(_share(float(one), words) for one in errors)])
    return [words.ui(f"accuracy_{column}") for column in _COLUMNS], rows


def _rate(value: float, words: Words) -> str:
    return f"{significant(value, 4, language=words.language)} $`\\omega_0`$"


def _share(value: float, words: Words) -> str:
    return spell_percent(value, language=words.language)
