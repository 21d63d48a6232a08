"""Numbers without a unit: their digits, signs and decimal marks."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language

_SAME = {"de": "gleich", "en": "the same"}

_LAST_DIGIT = 5e-15
"""Relative differences below this are those of rounding, a few units of the last place."""


def minus(text: str) -> str:
    """Put minus signs in place of the hyphens of a number."""
    return text.replace("-", "−")


def significant(value: float, digits: int = 4, *, language: Language = "en") -> str:
    """Say a number to so many significant digits, without an exponent where it reads as well.

    Parameters
    ----------
    value
        Any number; zero is ``"0"``, and what is not finite is ``"inf"`` or ``"nan"``.
    digits
        Significant digits; integers below a million keep all of theirs.
    language
        German has a decimal comma.
    """
    if value == 0 or not math.isfinite(value):
        return minus(f"{value:g}") if value else "0"
    text = f"{value:.{digits - 1}e}"
    exponent = int(text.partition("e")[2])  # as it is after rounding: 9.9996 is 10.00
    if -5 <= exponent < max(digits, 6):
        return localised(f"{value:.{max(digits - 1 - exponent, 0)}f}", language)
    return localised(text, language)


def general(value: float, digits: int = 6, *, language: Language = "en") -> str:
    """Say a number to at most so many digits, without zeros at its end that would claim more."""
    return localised(f"{value:.{digits}g}", language)


def grouped(count: int) -> str:
    """Say a whole number with a blank between its thousands, as in ``"36 001"``."""
    return minus(f"{count:,}".replace(",", " "))


def signed(value: float, digits: int, language: Language = "en") -> str:
    """Say a number with its sign, also where that is plus; zero has none."""
    return ("+" if value > 0 else "") + significant(value, digits, language=language)


def spell_percent(fraction: float, *, language: Language = "en") -> str:
    """Say a relative difference in per cent with its sign, or that there is none.

    Differences below 5e-15 are called none: they are the rounding of the two numbers compared.
    """
    if abs(fraction) < _LAST_DIGIT:
        return _SAME[language]
    return f"{signed(100 * fraction, 2, language)} %"


def localised(text: str, language: Language) -> str:
    """Give the digits of a number the signs that are read: a minus, and a comma in German."""
    return minus(text.replace(".", ",") if language == "de" else text)
