"""The answers of a design as tables for a terminal."""

from __future__ import annotations

import math
from itertools import groupby
from typing import TYPE_CHECKING

from kugelpendel.cli._compared import plain_table, print_table
from kugelpendel.cli._words import degrees, describe_pendulum, given, minus
from kugelpendel.plot import significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    from rich.table import Table

    import kugelpendel as kp
    from kugelpendel.cli._design_file import Questions

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
_LARGE = {"Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")), "W": ((1.0, "W"), (1e-3, "mW"))}


def print_design(questions: Questions, design: kp.Design) -> None:
    """Print the numbers, group by group, and then where they come from."""
    case = design.case
    lines = [("Pendulum", describe_pendulum(case.pendulum, questions.setup.has_mass))]
    swing = f"a = {given(case.a, 'm')}, b = {given(case.b, 'm')}"
    angle = math.degrees(math.asin(case.a / case.length))
    lines.append(("Swing", f"{swing}, {significant(angle, 4)}° to either side"))
    if case.site is not None:
        place = f"latitude {degrees(float(case.site.latitude))}"
        lines.append(("Site", f"{place}, g = {float(case.site.gravity):.6g} m/s²"))
    for name, text in lines:
        print(f"{name:<19}{text}")
    for group, answers in groupby(design.answers, key=lambda answer: answer.group):
        print_table(_numbers(_TITLES[group], list(answers)))
    print_table(_sources(design))


def _numbers(title: str, answers: list[kp.Answer]) -> Table:
    table = plain_table(title, "By formula", "Measured", "Off by", "Remark")
    table.columns[-1].justify = "left"
    table.columns[-1].no_wrap = False
    for answer in answers:
        measured = off = ""
        check = answer.check
        if check is not None:
            measured = shown(check.measured, answer)
            off = "–" if check.relative is None else spell_percent(-check.relative)
        table.add_row(answer.name, shown(answer.value, answer), measured, off, answer.note)
    return table


def _sources(design: kp.Design) -> Table:
    from rich.table import Table

    table = Table.grid(padding=(0, 2))
    table.add_column(no_wrap=True, min_width=17)
    table.add_column()
    for answer in design.answers:
        table.add_row(answer.name, f"{answer.formula}  [{answer.source}]".replace("[", r"\["))
    return table


def shown(value: float, answer: kp.Answer) -> str:
    """A value in the units that a reader takes in at a glance."""
    unit = answer.unit
    if math.isinf(value):
        return "never"
    if value == 0:
        return "0"
    if unit == "rad/s":
        return spell_rate(value, 5)
    if unit == "1" and answer.group == "period":
        return f"{significant(100 * value, 4)} %".replace("-", "−")
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
