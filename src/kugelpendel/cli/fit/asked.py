"""What was asked on the command line, checked option by option, in SI."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.kinds import ACCELERATION, LATITUDE, LENGTH, TIME, Kind
from kugelpendel.cli.job_file.quantity import read_quantity
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.parameters import Site

if TYPE_CHECKING:
    import argparse

    from kugelpendel.errors import Language

_STANDARD_GRAVITY = 9.80665


@dataclass(frozen=True)
class Asked:
    """What a fit takes from its options.

    Attributes
    ----------
    reading
        The arguments of `kugelpendel.tracks.read`.
    length, gravity, latitude
        m, m/s² and rad; None for what was not given, but for gravity.
    unevenness, tilt
        Shares.
    swings
        In a window.
    """

    reading: dict[str, Any]
    length: float | None
    gravity: float
    latitude: float | None
    unevenness: float
    tilt: float
    swings: float
    language: Language


def read_options(options: argparse.Namespace) -> Asked:
    """Check the options of a fit.

    Raises
    ------
    InvalidInput
        A sentence that names the option, the value seen and the way out.
    """
    latitude = quantity(options, "latitude", LATITUDE)
    gravity = quantity(options, "gravity", ACCELERATION)
    if gravity is None:
        gravity = _STANDARD_GRAVITY if latitude is None else float(Site(latitude).gravity)
    length = quantity(options, "length", LENGTH)
    _require_positive(gravity, "gravity", ACCELERATION)
    _require_positive(length, "length", LENGTH)
    y_down = True if options.y_down else False if options.y_up else None
    return Asked(
        {
            "columns": _columns(options.columns),
            "mass": options.mass,
            "rate": number(options, "rate", least=0.0),
            "scale": quantity(options, "scale", LENGTH),
            "y_down": y_down,
        },
        length,
        gravity,
        latitude,
        share(options, "damping_unevenness"),
        share(options, "tilt"),
        number_of(options.swings, "--swings", least=2.999),
        known_language(options.lang),
    )


def quantity(options: argparse.Namespace, name: str, kind: Kind) -> float | None:
    """An option that is a quantity: a number in SI, or a number with a unit; None if not given."""
    text = getattr(options, name)
    return None if text is None else quantity_of(text, kind, _option(name))


def quantity_of(text: str, kind: Kind, option: str) -> float:
    """What is written after an option: a number in SI, or a number with a unit."""
    try:
        value: object = float(text)
    except ValueError:
        value = text.strip()
    return read_quantity(value, kind, option)


def needed(options: argparse.Namespace, name: str, kind: Kind, example: str) -> float:
    """An option without which there is no answer."""
    value = quantity(options, name, kind)
    if value is None:
        raise InvalidInput.of("option_needed", option=_option(name), example=example)
    _require_positive(value, name, kind)
    return value


def _require_positive(value: float | None, name: str, kind: Kind) -> None:
    if value is not None and value <= 0:
        raise InvalidInput.of(
            "option_positive", seen=value, option=_option(name), si=kind.unit, example=kind.example
        )


def half_life(options: argparse.Namespace) -> float | None:
    """The half life of the amplitude in s, or None."""
    return None if options.half_life is None else needed(options, "half_life", TIME, "2 h")


def number(options: argparse.Namespace, name: str, *, least: float) -> float | None:
    """An option that is a plain number above some least one; None if not given."""
    text = getattr(options, name)
    return None if text is None else number_of(text, _option(name), least=least)


def number_of(text: str, option: str, *, least: float) -> float:
    """What is written after an option: a plain number above some least one."""
    value = _float(text)
    if value is None or not least < value < float("inf"):
        raise InvalidInput.of("option_number", option=option, seen=repr(text), least=least)
    return value


def share(options: argparse.Namespace, name: str) -> float:
    """An option in per cent, with or without the sign, as a share."""
    text: str = getattr(options, name)
    value = _float(text.strip().removesuffix("%").strip())
    if value is None or not 0 <= value < 100:
        raise InvalidInput.of("option_share", option=_option(name), seen=repr(text))
    return value / 100


def _float(text: str) -> float | None:
    try:
        return float(text.replace(",", "."))
    except ValueError:
        return None


def _columns(text: str | None) -> dict[str, str | int] | None:
    if text is None:
        return None
    found: dict[str, str | int] = {}
    for part in re.split(r",(?=\s*\w+\s*=)", text):
        role, equals, name = part.partition("=")
        if not equals or not role.strip() or not name.strip():
            raise InvalidInput.of("option_columns", seen=repr(text))
        found[role.strip()] = name.strip()
    return found


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"
