"""Measured numbers: a value with its error to two digits, in a unit that reads well."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel.spelling import hourly, localised, unit_for

if TYPE_CHECKING:
    from kugelpendel.errors import Language
    from kugelpendel.tracks import Estimate

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Shown:
    """How a quantity is shown.

    Attributes
    ----------
    factor
        Of one SI unit in the unit shown.
    symbol
        The unit shown, with a power of ten before it where that reads better.
    """

    factor: float
    symbol: str
    language: Language

    @classmethod
    def of(cls, name: str, unit: str, value: float, language: Language) -> Shown:
        """The unit for a quantity of this size: °/h for turning, ° for angles, mm for lengths."""
        if name == "rotation":
            return cls(hourly(1.0), "°/h", language)
        if unit == "rad":
            return cls(math.degrees(1.0), "°", language)
        if unit == "m":
            chosen = unit_for(value, "m")
            return cls(1 / chosen.size, chosen.symbol, language)
        symbol = "" if unit == "1" else unit
        power = math.floor(math.log10(abs(value))) if value and math.isfinite(value) else 0
        if -3 <= power < 6:
            return cls(1.0, symbol, language)
        power = 3 * (power // 3)
        return cls(10.0**-power, f"·10{str(power).translate(_RAISED)} {symbol}".strip(), language)

    def number(self, value: float, error: float | None = None) -> str:
        """A number in the unit shown, to the second digit of its error, or to three digits."""
        shown = value * self.factor
        size = abs((error or value) * self.factor)
        if not math.isfinite(shown) or not math.isfinite(size):
            return "–"
        digits = 2 if error else 3
        places = digits - 1 - math.floor(math.log10(size)) if size else 0
        text = f"{round(shown, places):.{max(0, min(places, 12))}f}"
        return localised(text, self.language)

    def with_unit(self, number: str) -> str:
        """A number that was made so with its unit; several with one power of ten in brackets."""
        if self.symbol.startswith("·"):
            return f"({number}){self.symbol}" if " " in number else f"{number}{self.symbol}"
        gap = "" if self.symbol == "°" else " "
        return f"{number}{gap}{self.symbol}".strip()

    def whole(self, value: float) -> str:
        """A number to three digits with its unit."""
        return self.with_unit(self.number(value))

    def pair(self, value: float, error: float) -> str:
        """A value and its standard error, both to the second digit of the error."""
        if not error or not math.isfinite(error):
            return self.number(value)
        return f"{self.number(value, error)} ± {self.number(error, error)}"


def shown_in(name: str, estimate: Estimate, language: Language) -> Shown:
    """How an estimate is shown; one without a number by its upper bound."""
    size = estimate.value if math.isfinite(estimate.value) else estimate.high
    largest = max((abs(one) for one in (size, estimate.stderr) if math.isfinite(one)), default=0.0)
    return Shown.of(name, estimate.unit, largest, language)


def plus_minus(estimate: Estimate, shown: Shown) -> str:
    """The value of an estimate with its standard error and its unit."""
    return shown.with_unit(shown.pair(estimate.value, estimate.stderr))


def interval(estimate: Estimate, shown: Shown) -> tuple[str, str] | None:
    """Both ends of the 95 % interval with the unit, or None where one of them is open."""
    if not (math.isfinite(estimate.low) and math.isfinite(estimate.high)):
        return None
    low, high = (shown.number(one, estimate.stderr) for one in (estimate.low, estimate.high))
    if shown.symbol.startswith("·"):
        return shown.with_unit(low), shown.with_unit(high)
    return low, shown.with_unit(high)
