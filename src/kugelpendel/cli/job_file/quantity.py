"""A number with its unit: ``"67 m"``, ``"30 deg/s"``, or a plain number in SI."""

# pint's stubs leave its own generic types open.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Any, cast

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    import pint

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,9})?)(?![\d.,])\s*(.*?)\s*")


@dataclass(frozen=True)
class Kind:
    """What a number measures: its name, the SI unit it is turned into, and an example to paste."""

    name: str
    unit: str
    example: str


LENGTH = Kind("a length", "m", "3 cm")
TIME = Kind("a time", "s", "10 min")
MASS = Kind("a mass", "kg", "28 kg")
ACCELERATION = Kind("an acceleration", "m/s^2", "9.81 m/s^2")
SPEED = Kind("a speed", "m/s", "5 cm/s")
ANGLE = Kind("an angle", "rad", "30 deg")
RATE = Kind("an angular velocity", "rad/s", "30 deg/s")


def read_quantity(value: object, kind: Kind, where: str) -> float:
    """One finite number in the SI unit of its kind.

    Decimal units are converted in decimal arithmetic and rounded once, so ``"7 cm"`` is the
    binary64 number 0.07 and not its neighbour.

    Parameters
    ----------
    value : object
        A number, taken as SI, or a string of a number and a unit.
    kind : Kind
        What is expected. For angles and angular velocities the unit has to name an angle:
        ``"5 Hz"`` does not say whether turns or radians are meant.
    where : str
        The place in the file, for the error sentence.

    Raises
    ------
    InvalidInput
        No number, no unit, an unknown unit, a unit of another kind, or nothing finite.
    """
    shown = show(value)
    if isinstance(value, str):
        number = _from_string(value, kind, where)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        number = _as_float(value)
    else:
        raise InvalidInput(
            f"{where} = {shown} is not a number; write {_way_out(kind)}.",
        )
    if not abs(number) < float("inf"):
        raise InvalidInput(f"{where} = {shown} is not a finite number; write {_way_out(kind)}.")
    return number


def show(value: object) -> str:
    """A value as the file has it, cut to a length that fits into a sentence."""
    if isinstance(value, (str, bool)):
        text = json.dumps(value, ensure_ascii=False)
    elif isinstance(value, dict):
        text = "{…}"
    else:
        text = str(value)
    return text if len(text) <= 60 else f"{text[:57]}…"


def _way_out(kind: Kind) -> str:
    return f'{kind.name} such as "{kind.example}", or a plain number in {kind.unit}'


def _as_float(value: float | Decimal) -> float:
    try:
        return float(value)
    except OverflowError:
        return float("inf")


def _from_string(text: str, kind: Kind, where: str) -> float:
    match = _NUMBER.fullmatch(text)
    if match is None:
        if text.strip().lower().lstrip("+-").split(" ")[0] in {"nan", "inf", "infinity"}:
            raise InvalidInput(
                f"{where} = {show(text)} is not a finite number; write {_way_out(kind)}."
            )
        comma = " (with a decimal point, not a comma)" if re.match(r"\s*[+-]?\d+,\d", text) else ""
        raise InvalidInput(
            f"{where} = {show(text)} does not start with a number{comma}; write {_way_out(kind)}."
        )
    number, unit = match.groups()
    if not unit:
        raise InvalidInput(f"{where} = {show(text)} has no unit; write {_way_out(kind)}.")
    factor = _factor(unit, kind, where, text)
    if abs(float(number)) == float("inf"):
        return float(number)
    return _as_float(Decimal(number) * factor)


def _factor(unit: str, kind: Kind, where: str, text: str) -> Decimal:
    """How many SI units one of the given unit is."""
    import pint

    registry = _registry()
    try:
        scale, root = registry.get_root_units(registry.parse_units(unit))
    # Apart from its own errors, pint lets those of its parser and of the tokenizer out.
    except (pint.PintError, AssertionError, ValueError, TypeError, SyntaxError, KeyError) as error:
        raise InvalidInput(
            f"{where} = {show(text)}: the unit {show(unit)} is not known; write {_way_out(kind)}."
        ) from error
    si, expected = registry.get_root_units(registry.parse_units(kind.unit))
    if root != expected:
        hint = " (Hz does not say whether turns or radians are meant)" if kind is RATE else ""
        raise InvalidInput(
            f"{where} = {show(text)} is not {kind.name}{hint}; write {_way_out(kind)}."
        )
    return Decimal(cast("Decimal", scale)) / Decimal(cast("Decimal", si))


@cache
def _registry() -> pint.UnitRegistry[Any]:
    import pint

    return pint.UnitRegistry(non_int_type=Decimal)  # pyright: ignore[reportArgumentType]
