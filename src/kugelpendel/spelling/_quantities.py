"""Numbers with their unit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.spelling._numbers import general, signed, significant
from kugelpendel.spelling._units import local_symbol, rate_unit, unit_for

if TYPE_CHECKING:
    from kugelpendel.errors import Language

_PREFIXES = ("", "k", "M", "G", "T", "P", "E", "Z", "Y", "R", "Q")


def spell(value: float, si: str, digits: int = 4, *, language: Language = "en") -> str:
    """Say a value with its unit, such as ``"3.827 mm"``.

    Parameters
    ----------
    value
        In the SI unit.
    si
        The SI unit, one of those of `unit_for`.
    digits
        Significant digits.
    language
        German has a decimal comma and German names of units.
    """
    unit = unit_for(value, si)
    number = significant(value / unit.size, digits, language=language)
    return _joined(number, unit.symbol, language)


def as_given(value: float, si: str, *, language: Language = "en") -> str:
    """Say a value as it was given, without zeros at its end that would claim digits."""
    unit = unit_for(value, si)
    return _joined(general(value / unit.size, language=language), unit.symbol, language)


def degrees(angle: float, *, language: Language = "en") -> str:
    """Say an angle, given in rad, in degrees, to at most six digits."""
    return f"{general(math.degrees(angle), language=language)}°"


def spell_rate(rate: float, digits: int = 4, *, language: Language = "en") -> str:
    """Say an angular velocity, given in rad/s, with its sign: in °/h if it is slow, else in °/s."""
    unit = rate_unit(rate)
    turned = math.degrees(rate)  # before the hours, which would overflow the largest numbers
    value = turned * 3600 if unit.symbol == "°/h" else turned
    return f"{signed(value, digits, language)} {unit.symbol}"


def spell_bytes(size: float, digits: int = 3, *, language: Language = "en") -> str:
    """Say an amount of data, such as ``"6.40 GB"``, in decimal multiples of a byte."""
    if not 1 <= size < math.inf:
        return f"{general(size, digits, language=language)} B"
    step = min(int(math.log10(size) // 3), len(_PREFIXES) - 1)
    return f"{general(size / 1000**step, digits, language=language)} {_PREFIXES[step]}B"


def _joined(number: str, symbol: str, language: Language) -> str:
    gap = "" if symbol == "°" else " "
    return f"{number}{gap}{local_symbol(symbol, language)}"


def hourly(rate: float) -> float:
    """The degrees that an angular velocity in rad/s turns in an hour."""
    return math.degrees(rate) * 3600
