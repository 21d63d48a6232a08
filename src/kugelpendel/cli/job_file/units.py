"""Units as people write them: how many of the SI unit one is, and which are refused as ambiguous.

pint knows the units. What it would read otherwise than most people mean is refused before: Grad is
its giga-radian, grad the gon, gr the grain, Min the mega-inch.
"""

# pint's stubs leave its own generic types open.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import re
import tokenize
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    import pint

    from kugelpendel.cli.job_file.kinds import Kind

_NAME = r"[^\W\d_]+|[°%]"
_POWER = r"(?:(?:\^|\*\*)\s*-?[1-9]|⁻?[¹²³])?"
_FACTOR = rf"(?:{_NAME}){_POWER}"
_PRODUCT = rf"{_FACTOR}(?:(?:\s*[*·]\s*|\s+){_FACTOR})*"
_UNIT = re.compile(rf"(?:1|{_PRODUCT})(?:\s*/\s*(?:{_FACTOR}|\({_PRODUCT}\)))*")
"""Products and quotients of powers. Nothing else reaches pint, whose parser also calculates."""

_LOOKALIKES = {
    **dict.fromkeys(("grad", "Grad", "GRAD", "grads", "grade", "grades"), "quantity_unit_gon"),
    **dict.fromkeys(("gr", "Gr", "GR"), "quantity_unit_grain"),
}

_SMALL = ("milli", "micro", "nano", "pico", "femto")
_PREFIXES = {
    **dict.fromkeys(("radian", "arcsecond"), _SMALL),
    **dict.fromkeys(("meter", "gram", "second", "newton", "pascal", "hertz"), None),
}
"""Units that have prefixes, and which; None for all. Min, kdeg and Mrad are not meant."""


_EVERYDAY: dict[tuple[str, str], Decimal] = {
    **{(unit, "m"): Decimal(size) for unit, size in (("cm", "0.01"), ("mm", "0.001"))},
    **{(unit, "s"): Decimal(size) for unit, size in (("min", 60), ("h", 3600))},
    ("g", "kg"): Decimal("0.001"),
    ("deg", "rad"): Decimal("0.01745329251994329576923690768"),
    ("°", "rad"): Decimal("0.01745329251994329576923690768"),
}
"""How many SI units one is, for files in everyday units, which are read without pint: loading it
and its own units takes longer than most sweeps take to their first result. A test holds them
against pint."""


class UnitRefused(Exception):
    """A unit that is not known, or not unambiguous.

    Parameters
    ----------
    kind
        That of the sentence.
    values
        What the sentence has to name beside the unit.
    """

    def __init__(self, kind: str = "quantity_unit_unknown", **values: str) -> None:
        super().__init__(kind)
        self.kind = kind
        self.values = values


def size_of(unit: str, kind: Kind) -> Decimal | None:
    """Say how many SI units of its kind one of a unit is; None where it is of another kind.

    Raises
    ------
    UnitRefused
        The unit is not known, or it looks like another one.
    """
    if unit == kind.unit:
        return Decimal(1)
    if (everyday := _EVERYDAY.get((unit, kind.unit))) is not None:
        return everyday
    if _UNIT.fullmatch(unit) is None:
        raise UnitRefused
    names: list[str] = re.findall(_NAME, unit)
    for name in names:
        if name in _LOOKALIKES:
            raise UnitRefused(_LOOKALIKES[name])
    try:
        scale, root, parts = _parsed(unit)
    except _PINT_LETS_OUT as error:
        raise UnitRefused from error
    si, expected, _ = _parsed(kind.unit)
    if root != expected:
        return None
    for prefix, base in parts:
        allowed = _PREFIXES.get(base, ())
        if prefix and allowed is not None and prefix not in allowed:
            raise UnitRefused("quantity_unit_prefix", meaning=f"{prefix}{base}")
    return scale / si


_PINT_LETS_OUT = (
    # Apart from its own errors, pint lets those of its parser and of the tokenizer out.
    AssertionError,
    ValueError,
    TypeError,
    SyntaxError,
    LookupError,
    AttributeError,
    ArithmeticError,
    RecursionError,
    tokenize.TokenError,
)


@cache
def _parsed(unit: str) -> tuple[Decimal, Any, tuple[tuple[str, str], ...]]:
    """Size and root of a unit, and its names taken apart into prefix and what follows it."""
    registry = _registry()
    names = registry.parse_units_as_container(unit.replace("·", "*"))
    scale, root = registry.get_root_units(names)
    parts = tuple(registry.parse_unit_name(name)[0][:2] for name in names)
    return Decimal(cast("Decimal", scale)), root, parts


@cache
def _registry() -> pint.UnitRegistry[Any]:
    import pint

    return pint.UnitRegistry(non_int_type=Decimal)  # pyright: ignore[reportArgumentType]
