"""The answers of a design as tables for a terminal."""

from __future__ import annotations

import math
from itertools import groupby
from typing import TYPE_CHECKING

from kugelpendel.cli.terminal.describe import describe_pendulum
from kugelpendel.cli.terminal.tables import facts, listing, numbers
from kugelpendel.spelling import (
    as_given,
    degrees,
    general,
    significant,
    spell,
    spell_percent,
    spell_rate,
)

if TYPE_CHECKING:
    import kugelpendel as kp
    from kugelpendel.cli.design.design_file import Questions

_TITLES = {
    "period": "Period",
    "turning": "Turning",
    "decay": "Decay",
    "suspension": "Suspension",
    "drive": "Drive",
    "passage": "Passage",
    "wire": "Wire",
}

_NAMES = 38
"""Columns of the names of answers, so that the tables stand alike."""

_LADDERS = ("m", "m/s", "s", "N")
_SMALL = {"1/s": (0.01 / 3600, "%/h"), "1/K": (1e-6, "ppm/K")}
_LARGE = {"Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")), "W": ((1.0, "W"), (1e-3, "mW"))}


def design_report(questions: Questions, design: kp.Design) -> str:
    """Set the numbers, group by group, and then where they come from."""
    parts = [_start(questions, design)]
    for group, answers in groupby(design.answers, key=lambda answer: answer.group):
        parts.append(_numbers(_TITLES[group], list(answers)))
    return "\n\n".join((*parts, *_sources(design)))


def _start(questions: Questions, design: kp.Design) -> str:
    swing = f"a = {as_given(design.a, 'm')}, b = {as_given(design.b, 'm')}"
    angle = math.degrees(math.asin(design.a / float(design.pendulum.length)))
    rows = [
        ("Pendulum", describe_pendulum(design.pendulum, questions.has_mass)),
        ("Swing", f"{swing}, {significant(angle, 4)}° to either side"),
    ]
    site = design.forces.site
    if site is not None:
        gravity = general(float(site.gravity))
        rows.append(("Site", f"latitude {degrees(float(site.latitude))}, g = {gravity} m/s²"))
    for name, key in (("Clamp alone", "turning_by_anisotropy"), ("All together", "settled_rate")):
        if key in design:
            rows.append((name, design[key].note))
    return facts(rows)


def _numbers(title: str, answers: list[kp.DesignAnswer]) -> str:
    rows: list[tuple[str, ...]] = []
    for answer in answers:
        measured = off = ""
        if answer.check is not None:
            measured = shown(answer.check.measured, answer)
            off = _off(answer.check)
        rows.append((answer.name, shown(answer.value, answer), measured, off))
    headers = (title, "By formula", "By RealMotion", "Off by")
    if all(answer.check is None for answer in answers):
        headers, rows = headers[:2], [row[:2] for row in rows]
    return numbers(headers, rows, least=_NAMES)


def _off(check: kp.DesignCheck) -> str:
    """By how much the formula misses, of the number by RealMotion unless it says of what."""
    if check.relative is None:
        return "–"
    return spell_percent(-check.relative) + (f" of {check.of}" if check.of else "")


def _sources(design: kp.Design) -> tuple[str, str]:
    """Formulas with numbers of their sources, and the sources."""
    formulas: list[tuple[str, str]] = []
    marks: dict[str, int] = {}
    for answer in design.answers:
        found = [f"[{marks.setdefault(one, len(marks) + 1)}]" for one in answer.source.split("; ")]
        said = f"{answer.formula} {' '.join(found)}" + (f"; {answer.note}" if answer.note else "")
        formulas.append((answer.name, said))
    sources = ((f"[{number}]", source) for source, number in marks.items())
    return listing(formulas, _NAMES), listing(sources, 0)


def shown(value: float, answer: kp.DesignAnswer) -> str:
    """A value in the units that a reader takes in at a glance."""
    unit = answer.unit
    if math.isinf(value):
        return "never"
    if value == 0:
        return "0"
    if unit == "rad/s":
        return spell_rate(value, 5)
    if unit == "1" and answer.group == "period":
        return f"{significant(1e6 * value, 4)} ppm"
    if unit in _SMALL:
        size, symbol = _SMALL[unit]
        return f"{significant(value / size, 4)} {symbol}"
    if unit == "1":
        return significant(value, 4)
    if unit == "rad":
        return f"{significant(math.degrees(value), 5)}°"
    if unit in _LADDERS:
        return spell(value, unit, 7 if answer.group == "period" else 4)
    for size, symbol in _LARGE.get(unit, ()):
        if abs(value) >= size:
            return f"{significant(value / size, 4)} {symbol}"
    return f"{significant(value, 4)} {unit}"
