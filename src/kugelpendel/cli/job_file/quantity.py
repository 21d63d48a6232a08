"""A number with its unit, as people write it: ``"67 m"``, ``"0,2 m"``, ``"12 ft 6 in"``.

A latitude may be ``"48°51′N"``. A plain number is in SI.
"""

from __future__ import annotations

import json
import re
from decimal import Decimal
from typing import NoReturn

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.kinds import ANGLE, LATITUDE, LENGTH, RATE, Kind
from kugelpendel.cli.job_file.units import UnitRefused, size_of

_DIGITS = r"(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d{1,9})?"
_NUMBER = re.compile(rf"([+-]?{_DIGITS})(?![\d.,])\s*(.*)", re.DOTALL)
_PARTS = re.compile(r"(?<=[°′″])\s*(?=[\d.,])|\s+(?=[\d.,])(?!1\s*/)")
"""Where the next part of ``"12 ft 6 in"`` or ``"48°51′"`` begins; that of ``"1e-5 1/s"`` is one."""

_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")
"""With a comma that may stand for thousands as well as for decimals."""

_LONGEST = 400
"""Signs; as many digits as a number that is still one may have."""

_ALIKE = str.maketrans(
    {
        "−": "-",
        **dict.fromkeys("\u00a0\u2009\u202f", " "),  # blanks that do not break
        **dict.fromkeys("º˚", "°"),
        **dict.fromkeys("'’´", "′"),
        **dict.fromkeys('"”', "″"),
    }
)
"""What looks like a sign that is meant; no quantity needs these signs in another meaning."""


def read_quantity(value: object, kind: Kind, where: str) -> float:
    """Read one finite number in the SI unit of its kind.

    Decimal units are converted in decimal arithmetic and rounded once, so ``"7 cm"`` is the
    binary64 number 0.07 and not its neighbour.

    Parameters
    ----------
    value
        A number, taken as SI, or a string of a number and a unit, or of several that go on in
        smaller units of the same kind (``"12 ft 6 in"``). The decimal mark is a point or a comma.
    kind
        What is expected. For angles and angular velocities the unit has to name an angle:
        ``"5 Hz"`` does not say whether turns or radians are meant.
    where
        The place in the file, for the error sentence.

    Raises
    ------
    InvalidInput
        No number, no unit, a unit that is unknown, ambiguous or of another kind, or nothing finite.
    """
    shown = show(value)
    if isinstance(value, str):
        number = _from_string(value, kind, where)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        number = _as_float(value)
    else:
        raise InvalidInput(f"{where} = {shown} is not a number; write {_way_out(kind)}.")
    if not abs(number) < float("inf"):
        raise InvalidInput(f"{where} = {shown} is not a finite number; write {_way_out(kind)}.")
    if abs(number) > kind.most:
        raise InvalidInput(_beyond_a_turn(value, where))
    return number


def show(value: object) -> str:
    """Show a value as the file has it, cut to a length that fits into a sentence."""
    if isinstance(value, (str, bool)):
        text = json.dumps(value, ensure_ascii=False)
    elif isinstance(value, dict):
        text = "{…}"
    else:
        text = str(value)
    return text if len(text) <= 60 else f"{text[:57]}…"


def _way_out(kind: Kind) -> str:
    return f'{kind.name} such as "{kind.example}", or a plain number in {kind.unit}'


def _beyond_a_turn(value: object, where: str) -> str:
    if isinstance(value, str):
        return (
            f"{where} = {show(value)} is more than a full turn; write an angle from "
            '"-360 deg" to "360 deg".'
        )
    return (
        f"{where} = {show(value)} is in rad, which is more than a full turn; if degrees are meant, "
        f'write "{show(value)} deg".'
    )


def _as_float(value: float | Decimal) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("inf")


def _from_string(text: str, kind: Kind, where: str) -> float:
    """The number of a string, or a sentence that shows the string."""
    start = f"{where} = {show(text)}"
    if len(text) > _LONGEST:
        raise InvalidInput(f"{start} is too long for a quantity; write {_way_out(kind)}.")
    plain = text.translate(_ALIKE).replace("′′", "″").strip()
    sign = 1
    if kind is LATITUDE:
        plain, sign = _hemisphere(plain, start)
    parts = _PARTS.split(plain)
    if len(parts) > 1 and all(re.search(r"[^\W\d]|[°′″]", part) for part in parts):
        return sign * _composed(parts, kind, start)
    number, unit = _split(plain, kind, start)
    if not unit:
        raise InvalidInput(f"{start} has no unit; write {_way_out(kind)}.")
    size = _size(unit, kind, start)
    if abs(float(number)) == float("inf"):
        return float(number)
    return sign * _as_float(number * size)


def _split(text: str, kind: Kind, start: str) -> tuple[Decimal, str]:
    """Number and unit."""
    match = _NUMBER.fullmatch(text)
    if match is None:
        if text.lower().lstrip("+-").split(" ")[0] in {"nan", "inf", "infinity"}:
            raise InvalidInput(f"{start} is not a finite number; write {_way_out(kind)}.")
        marks = re.match(r"[+-]?[\d.,]+", text)
        if marks is not None and any(sign.isdigit() for sign in marks[0]):
            raise InvalidInput(
                f"{start} has more than one point or comma in its number; write it with a single "
                f'decimal mark, such as "{kind.example}".'
            )
        raise InvalidInput(f"{start} does not start with a number; write {_way_out(kind)}.")
    digits, unit = match.groups()
    if _THOUSANDS.fullmatch(digits) and kind.most == float("inf") and kind is not LATITUDE:
        point, whole = digits.replace(",", "."), digits.replace(",", "")
        raise InvalidInput(
            f'{start} may mean {point} or {whole}; write "{point} {unit}" or "{whole} {unit}".'
        )
    return Decimal(digits.replace(",", ".")), unit


def _size(unit: str, kind: Kind, start: str) -> Decimal:
    """How many SI units one of the given unit is."""
    try:
        size = size_of(_spelled_out(unit, kind), kind)
    except UnitRefused as error:
        raise InvalidInput(
            f"{start}: the unit {show(unit)} {error}; write {_way_out(kind)}."
        ) from error
    if size is None:
        hint = " (Hz does not say whether turns or radians are meant)" if kind is RATE else ""
        raise InvalidInput(f"{start} is not {kind.name}{hint}; write {_way_out(kind)}.")
    return size


def _spelled_out(unit: str, kind: Kind) -> str:
    """One and two strokes are minutes and seconds of an angle, feet and inches of a length."""
    if kind in (ANGLE, LATITUDE):
        return {"′": "arcmin", "″": "arcsec"}.get(unit, unit)
    return {"′": "ft", "″": "in"}.get(unit, unit) if kind is LENGTH else unit


def _composed(parts: list[str], kind: Kind, start: str) -> float:
    """The sum of several numbers, each in a smaller unit than the one before."""
    total, last = Decimal(0), Decimal(0)
    sign = -1 if parts[0].startswith("-") else 1
    parts = [parts[0].lstrip("+-"), *parts[1:]]
    for index, part in enumerate(parts):
        number, unit = _split(part, kind, start)
        if index and kind in (ANGLE, LATITUDE):
            # Behind degrees, min and s are those of arc.
            unit = {"min": "arcmin", "m": "arcmin", "s": "arcsec", "sec": "arcsec"}.get(unit, unit)
        if not unit:
            _cannot_be_added(start, kind)
        size = _size(unit, kind, start)
        whole = number == number.to_integral_value() or index == len(parts) - 1
        if (index and number * size >= last) or not whole or size <= 0:
            _cannot_be_added(start, kind)
        total += number * size
        last = size
    return sign * _as_float(total)


def _cannot_be_added(start: str, kind: Kind) -> NoReturn:
    raise InvalidInput(
        f"{start} is not one number in ever smaller units, each less than one of the unit before, "
        f"such as {'29 deg 43.281 min' if kind is not LENGTH else '12 ft 6 in'}; write "
        f"{_way_out(kind)}."
    )


def _hemisphere(text: str, start: str) -> tuple[str, int]:
    """A latitude without its N or S, in degrees where it has no unit then; and its sign."""
    match = re.fullmatch(r"(?:([NS])\s*(?=[\d.,]))?(.*?[\d\s°′″a-z])??\s*([NSEWO])?", text)
    if match is None or not (match[1] or match[3]) or not match[2]:
        return text, 1
    side, number = match[1] or match[3], match[2].strip()
    if (match[1] and match[3]) or side in "EWO":
        raise InvalidInput(f'{start} is not a latitude; write it like "48.85 N" or "33.9 S".')
    if number.startswith(("+", "-")):
        raise InvalidInput(
            f'{start} has both a sign and {side}; write one of them: "-33.9 deg" or "33.9 S".'
        )
    if _NUMBER.fullmatch(number + " ") is not None and re.fullmatch(_DIGITS, number):
        number += "°"
    return number, -1 if side == "S" else 1
