"""A comparison as tables for a terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.cli.terminal.describe import describe_launch, describe_pendulum
from kugelpendel.cli.terminal.tables import facts, listing, numbers
from kugelpendel.spelling import general, significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.observables import Compared

_NONE = "–"


def comparison_report(job: Job, comparison: kp.Comparison) -> str:
    """Say what was compared, the errors of each motion, and where each holds."""
    exact = comparison.exact
    duration = float(comparison.times[-1])
    frequency = float(exact.frequency)
    swings = duration * frequency / (2 * math.pi)
    count = f", {significant(swings, 3)} swings" if frequency > 0 else ""
    precession = spell_rate(float(exact.precession), 7) if exact.precession else "0"
    start = facts(
        (
            ("Pendulum", describe_pendulum(job.pendulum, job.has_mass)),
            ("Launch", describe_launch(job)),
            ("Compared", f"over {spell(duration, 's')}{count}, with the exact motion:"),
            ("", f"frequency {general(frequency, 7)} rad/s, precession {precession}"),
        )
    )
    return "\n\n".join((start, _errors(comparison), _sentences(comparison)))


def _errors(comparison: kp.Comparison) -> str:
    rises = comparison.exact.turning_heights[0] > comparison.exact.pendulum.length
    of = "of l" if rises else "of a"
    return numbers(
        ("Motion", "Equation", "Largest error", of, "At the end", "Period", "Precession"),
        ((row.name, row.equation, *_numbers(row, comparison.amplitude)) for row in comparison.rows),
        text=2,
    )


def _numbers(row: Compared, amplitude: float) -> tuple[str, ...]:
    if row.largest is None:
        return (_NONE,) * 5
    fraction = row.largest / amplitude if amplitude else 0.0
    return (
        _distance(row.largest),
        f"{significant(100 * fraction, 2)} %",
        _NONE if row.final is None else _distance(row.final),
        *(_NONE if e is None else spell_percent(e) for e in (row.period, row.precession)),
    )


def _distance(error: float) -> str:
    return spell(error, "m", 3) if error else "0"


def _sentences(comparison: kp.Comparison) -> str:
    return listing(
        (row.name, row.reason or " ".join(text for text in (row.trust, row.caution) if text))
        for row in comparison.rows
    )
