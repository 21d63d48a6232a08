"""Units that a reader takes in at a glance: 3.8 mm and not 0.0038 m, 31.8 h and not 114480 s.

The ladders are our own, since those of the libraries go by thousands: centimetres, minutes, hours,
days, and degrees an hour are what pendulums are measured in.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language

_DEGREE = math.pi / 180
_HOUR = 3600.0
_DAY = 24 * _HOUR
_YEAR = 365.25 * _DAY


@dataclass(frozen=True)
class Unit:
    """A unit to read.

    Attributes
    ----------
    symbol
        As it is written behind a number, in English.
    size
        Of one of it, in the SI unit.
    start
        The value in the SI unit from which on it is used.
    """

    symbol: str
    size: float
    start: float


_LADDERS: dict[str, list[Unit]] = {
    "m": [
        Unit("fm", 1e-15, 1e-15),
        Unit("pm", 1e-12, 1e-12),
        Unit("nm", 1e-9, 1e-9),
        Unit("µm", 1e-6, 1e-6),
        Unit("mm", 1e-3, 1e-3),
        Unit("cm", 1e-2, 1e-2),
        Unit("m", 1.0, 1.0),
        Unit("km", 1e3, 1e4),
    ],
    "m/s": [
        Unit("pm/s", 1e-12, 1e-12),
        Unit("nm/s", 1e-9, 1e-9),
        Unit("µm/s", 1e-6, 1e-6),
        Unit("mm/s", 1e-3, 1e-3),
        Unit("cm/s", 1e-2, 1e-2),
        Unit("m/s", 1.0, 1.0),
        Unit("km/s", 1e3, 1e4),
    ],
    "s": [
        Unit("ns", 1e-9, 1e-9),
        Unit("µs", 1e-6, 1e-6),
        Unit("ms", 1e-3, 1e-3),
        Unit("s", 1.0, 1.0),
        Unit("min", 60.0, 120.0),
        Unit("h", _HOUR, 2 * _HOUR),
        Unit("d", _DAY, 3 * _DAY),
        Unit("years", _YEAR, 2 * _YEAR),
    ],
    "rad": [
        Unit("prad", 1e-12, 1e-12),
        Unit("nrad", 1e-9, 1e-9),
        Unit("µrad", 1e-6, 1e-6),
        Unit("arcsec", _DEGREE / 3600, _DEGREE / 3600),
        Unit("arcmin", _DEGREE / 60, _DEGREE / 60),
        Unit("°", _DEGREE, _DEGREE),
    ],
    "kg": [
        Unit("mg", 1e-6, 1e-6),
        Unit("g", 1e-3, 1e-3),
        Unit("kg", 1.0, 1.0),
        Unit("t", 1e3, 1e3),
    ],
    "N": [
        Unit("nN", 1e-9, 1e-9),
        Unit("µN", 1e-6, 1e-6),
        Unit("mN", 1e-3, 1e-3),
        Unit("N", 1.0, 1.0),
        Unit("kN", 1e3, 1e4),
        Unit("MN", 1e6, 1e7),
    ],
}


_GERMAN = {"years": "Jahre", "arcsec": "Bogensekunden", "arcmin": "Bogenminuten"}


def unit_for(magnitude: float, si: str) -> Unit:
    """Choose the unit in which a value of this magnitude reads best.

    Parameters
    ----------
    magnitude
        The value, or the largest of several that share an axis, in the SI unit.
    si
        ``"m"``, ``"m/s"``, ``"s"``, ``"rad"``, ``"kg"`` or ``"N"``.

    Returns
    -------
    Unit
        For zero, and for what is smaller than the smallest unit, the SI unit itself.
    """
    ladder = _LADDERS[si]
    size = abs(magnitude) * (1 + 1e-9)  # 0.01 m is 1 cm, however it was rounded
    fitting = [unit for unit in ladder if unit.start <= size < math.inf]
    return fitting[-1] if fitting else Unit(si, 1.0, 0.0)


def rate_unit(rate: float) -> Unit:
    """Choose the unit for angular velocities of this size in rad/s: °/h if slow, else °/s."""
    if abs(rate) / _DEGREE * _HOUR < 3600:
        return Unit("°/h", _DEGREE / _HOUR, 0.0)
    return Unit("°/s", _DEGREE, _DEGREE)


def local_symbol(symbol: str, language: Language) -> str:
    """Say the symbol of a unit in a language; most are international."""
    return _GERMAN.get(symbol, symbol) if language == "de" else symbol
