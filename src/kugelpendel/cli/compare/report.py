"""A comparison as tables for a terminal."""

from __future__ import annotations

import math
import sys
from typing import TYPE_CHECKING

from kugelpendel.cli.terminal.describe import describe_launch, describe_pendulum
from kugelpendel.spelling import minus, significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    from rich.table import Table

    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.observables import Compared

WIDTH = 100
"""Columns where the output is no terminal."""

_NONE = "–"


def print_comparison(job: Job, comparison: kp.Comparison) -> None:
    """Print what was compared, the errors of each motion, and where each holds."""
    exact = comparison.exact
    duration = float(comparison.times[-1])
    frequency = float(exact.frequency)
    swings = duration * frequency / (2 * math.pi)
    count = f", {significant(swings, 3)} swings" if frequency > 0 else ""
    precession = minus(spell_rate(float(exact.precession), 7)) if exact.precession else "0"
    for name, text in (
        ("Pendulum", describe_pendulum(job.pendulum, job.has_mass)),
        ("Launch", describe_launch(job)),
        ("Compared", f"over {spell(duration, 's')}{count}, with the exact motion:"),
        ("", f"frequency {frequency:.7g} rad/s, precession {precession}"),
    ):
        print(f"{name:<19}{text}".rstrip())
    print_table(_errors(comparison))
    print_table(_sentences(comparison))


def print_table(table: Table) -> None:
    """Print it after a blank line, as wide as the terminal, or 100 columns where there is none."""
    from rich.console import Console

    console = Console(highlight=False, width=None if sys.stdout.isatty() else WIDTH)
    with console.capture() as captured:
        console.print(table)
    lines = [line.rstrip() for line in captured.get().splitlines()]
    print("\n" + "\n".join(line for line in lines if line))


def plain_table(*columns: str, text: int = 1) -> Table:
    """A table without a frame; all columns but the first few are numbers, to the right."""
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, header_style="")
    for index, column in enumerate(columns):
        table.add_column(column, justify="left" if index < text else "right", no_wrap=True)
    return table


def _errors(comparison: kp.Comparison) -> Table:
    table = plain_table(
        "Motion", "Equation", "Largest error", "of a", "At the end", "Period", "Precession", text=2
    )
    if comparison.exact.turning_heights[0] > comparison.exact.pendulum.length:
        table.columns[3].header = "of l"
    for row in comparison.rows:
        table.add_row(row.name, row.equation, *_numbers(row, comparison.amplitude))
    return table


def _numbers(row: Compared, amplitude: float) -> tuple[str, ...]:
    if row.largest is None:
        return (_NONE,) * 5
    fraction = row.largest / amplitude if amplitude else 0.0
    return (
        _distance(row.largest),
        minus(f"{significant(100 * fraction, 2)} %"),
        _NONE if row.final is None else _distance(row.final),
        *(_NONE if e is None else spell_percent(e) for e in (row.period, row.precession)),
    )


def _distance(error: float) -> str:
    return minus(spell(error, "m", 3)) if error else "0"


def _sentences(comparison: kp.Comparison) -> Table:
    from rich.table import Table

    table = Table.grid(padding=(0, 2))
    table.add_column(no_wrap=True, min_width=17)
    table.add_column()
    for row in comparison.rows:
        said = row.reason or " ".join(text for text in (row.trust, row.caution) if text)
        table.add_row(row.name, said)
    return table
