"""A number with its unit, as people write it: ``"67 m"``, ``"0,2 m"``, ``"12 ft 6 in"``.

A latitude may be ``"48°51′N"``. A plain number is in SI.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
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
    given = _Given(value, kind, where)
    if isinstance(value, str):
        number = _from_string(value, given)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        number = _as_float(value)
    else:
        raise given.refused("quantity_no_number")
    if not abs(number) < float("inf"):
        raise given.refused("quantity_not_finite")
    if abs(number) > kind.most:
        bare = not isinstance(value, str)
        raise given.refused("quantity_turn_bare" if bare else "quantity_turn")
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


@dataclass(frozen=True)
class _Given:
    """What stands in a place of the file, and what it should measure."""

    value: object
    kind: Kind
    where: str

    def refused(self, kind: str, **values: str) -> InvalidInput:
        """What is wrong with it, with the way out."""
        return InvalidInput.of(
            kind,
            where=self.where,
            seen=show(self.value),
            measure=self.kind.name,
            example=self.kind.example,
            si=self.kind.unit,
            **values,
        )


def _as_float(value: float | Decimal) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("inf")


def _from_string(text: str, given: _Given) -> float:
    """The number of a string, or a sentence that shows the string."""
    if len(text) > _LONGEST:
        raise given.refused("quantity_long")
    plain = text.translate(_ALIKE).replace("′′", "″").strip()
    sign = 1
    if given.kind is LATITUDE:
        plain, sign = _hemisphere(plain, given)
    parts = _PARTS.split(plain)
    if len(parts) > 1 and all(re.search(r"[^\W\d]|[°′″]", part) for part in parts):
        return sign * _composed(parts, given)
    number, unit = _split(plain, given)
    if not unit:
        raise given.refused("quantity_no_unit")
    size = _size(unit, given)
    if abs(float(number)) == float("inf"):
        return float(number)
    return sign * _as_float(number * size)


def _split(text: str, given: _Given) -> tuple[Decimal, str]:
    """Number and unit."""
    match = _NUMBER.fullmatch(text)
    if match is None:
        if text.lower().lstrip("+-").split(" ")[0] in {"nan", "inf", "infinity"}:
            raise given.refused("quantity_not_finite")
        marks = re.match(r"[+-]?[\d.,]+", text)
        if marks is not None and any(sign.isdigit() for sign in marks[0]):
            raise given.refused("quantity_marks")
        raise given.refused("quantity_no_start")
    digits, unit = match.groups()
    kind = given.kind
    if _THOUSANDS.fullmatch(digits) and kind.most == float("inf") and kind is not LATITUDE:
        point, whole = digits.replace(",", "."), digits.replace(",", "")
        raise given.refused("quantity_thousands", point=point, whole=whole, unit_seen=unit)
    return Decimal(digits.replace(",", ".")), unit


def _size(unit: str, given: _Given) -> Decimal:
    """How many SI units one of the given unit is."""
    try:
        size = size_of(_spelled_out(unit, given.kind), given.kind)
    except UnitRefused as error:
        raise given.refused(error.kind, unit_seen=show(unit), **error.values) from error
    if size is None:
        is_rate = given.kind is RATE
        raise given.refused("quantity_other_rate" if is_rate else "quantity_other")
    return size


def _spelled_out(unit: str, kind: Kind) -> str:
    """One and two strokes are minutes and seconds of an angle, feet and inches of a length."""
    if kind in (ANGLE, LATITUDE):
        return {"′": "arcmin", "″": "arcsec"}.get(unit, unit)
    return {"′": "ft", "″": "in"}.get(unit, unit) if kind is LENGTH else unit


def _composed(parts: list[str], given: _Given) -> float:
    """The sum of several numbers, each in a smaller unit than the one before."""
    total, last = Decimal(0), Decimal(0)
    sign = -1 if parts[0].startswith("-") else 1
    parts = [parts[0].lstrip("+-"), *parts[1:]]
    for index, part in enumerate(parts):
        number, unit = _split(part, given)
        if index and given.kind in (ANGLE, LATITUDE):
            # Behind degrees, min and s are those of arc.
            unit = {"min": "arcmin", "m": "arcmin", "s": "arcsec", "sec": "arcsec"}.get(unit, unit)
        if not unit:
            _cannot_be_added(given)
        size = _size(unit, given)
        whole = number == number.to_integral_value() or index == len(parts) - 1
        if (index and number * size >= last) or not whole or size <= 0:
            _cannot_be_added(given)
        total += number * size
        last = size
    return sign * _as_float(total)


def _cannot_be_added(given: _Given) -> NoReturn:
    parts = "12 ft 6 in" if given.kind is LENGTH else "29 deg 43.281 min"
    raise given.refused("quantity_parts", parts=parts)


def _hemisphere(text: str, given: _Given) -> tuple[str, int]:
    """A latitude without its N or S, in degrees where it has no unit then; and its sign."""
    match = re.fullmatch(r"(?:([NS])\s*(?=[\d.,]))?(.*?[\d\s°′″a-z])??\s*([NSEWO])?", text)
    if match is None or not (match[1] or match[3]) or not match[2]:
        return text, 1
    side, number = match[1] or match[3], match[2].strip()
    if (match[1] and match[3]) or side in "EWO":
        raise given.refused("quantity_side")
    if number.startswith(("+", "-")):
        raise given.refused("quantity_sign", side=side)
    if _NUMBER.fullmatch(number + " ") is not None and re.fullmatch(_DIGITS, number):
        number += "°"
    return number, -1 if side == "S" else 1
