"""The answers of a design as tables for a terminal."""

from __future__ import annotations

import math
from itertools import groupby
from typing import TYPE_CHECKING

from kugelpendel.cli.compare.report import plain_table, print_table
from kugelpendel.cli.terminal.describe import describe_pendulum
from kugelpendel.spelling import (
    as_given,
    degrees,
    minus,
    significant,
    spell,
    spell_percent,
    spell_rate,
)

if TYPE_CHECKING:
    from rich.table import Table

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

_LADDERS = ("m", "m/s", "s", "N")
_SMALL = {"1/s": (0.01 / 3600, "%/h"), "1/K": (1e-6, "ppm/K")}
_LARGE = {"Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")), "W": ((1.0, "W"), (1e-3, "mW"))}


def print_design(questions: Questions, design: kp.Design) -> None:
    """Print the numbers, group by group, and then where they come from."""
    lines = [("Pendulum", describe_pendulum(design.pendulum, questions.has_mass))]
    swing = f"a = {as_given(design.a, 'm')}, b = {as_given(design.b, 'm')}"
    angle = math.degrees(math.asin(design.a / float(design.pendulum.length)))
    lines.append(("Swing", f"{swing}, {significant(angle, 4)}° to either side"))
    if design.forces.site is not None:
        place = f"latitude {degrees(float(design.forces.site.latitude))}"
        lines.append(("Site", f"{place}, g = {float(design.forces.site.gravity):.6g} m/s²"))
    for name, key in (("Clamp alone", "turning_by_anisotropy"), ("All together", "settled_rate")):
        if key in design:
            lines.append((name, design[key].note))
    for name, text in lines:
        print(f"{name:<19}{text}")
    for group, answers in groupby(design.answers, key=lambda answer: answer.group):
        print_table(_numbers(_TITLES[group], list(answers)))
    for table in _sources(design):
        print_table(table)


def _numbers(title: str, answers: list[kp.DesignAnswer]) -> Table:
    table = plain_table(title, "By formula", "By RealMotion", "Off by")
    table.columns[0].min_width = 38
    for answer in answers:
        measured = off = ""
        if answer.check is not None:
            measured = shown(answer.check.measured, answer)
            off = _off(answer.check)
        table.add_row(answer.name, shown(answer.value, answer), measured, off)
    return table


def _off(check: kp.DesignCheck) -> str:
    """By how much the formula misses, of the number by RealMotion unless it says of what."""
    if check.relative is None:
        return "–"
    return spell_percent(-check.relative) + (f" of {check.of}" if check.of else "")


def _sources(design: kp.Design) -> tuple[Table, Table]:
    """Formulas with numbers of their sources, and the sources."""
    from rich.table import Table
    from rich.text import Text

    formulas = Table.grid(padding=(0, 2))
    formulas.add_column(no_wrap=True, min_width=38)
    formulas.add_column()
    numbers: dict[str, int] = {}
    for answer in design.answers:
        marks = [
            f"[{numbers.setdefault(source, len(numbers) + 1)}]"
            for source in answer.source.split("; ")
        ]
        said = f"{answer.formula} {' '.join(marks)}" + (f"; {answer.note}" if answer.note else "")
        formulas.add_row(answer.name, Text(said))
    sources = Table.grid(padding=(0, 2))
    for source, number in numbers.items():
        sources.add_row(Text(f"[{number}]"), Text(source))
    return formulas, sources


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
        return minus(f"{significant(1e6 * value, 4)} ppm")
    if unit in _SMALL:
        size, symbol = _SMALL[unit]
        return minus(f"{significant(value / size, 4)} {symbol}")
    if unit == "1":
        return minus(significant(value, 4))
    if unit == "rad":
        return minus(f"{significant(math.degrees(value), 5)}°")
    if unit in _LADDERS:
        return minus(spell(value, unit, 7 if answer.group == "period" else 4))
    for size, symbol in _LARGE.get(unit, ()):
        if abs(value) >= size:
            return minus(f"{significant(value / size, 4)} {symbol}")
    return f"{significant(value, 4)} {unit}".replace("-", "−")
