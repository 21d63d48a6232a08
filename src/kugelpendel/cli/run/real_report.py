"""The answer to a real job in words, for a terminal."""

from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.run.budget import describe_pace, shares_table
from kugelpendel.cli.terminal.describe import describe_launch, describe_pendulum
from kugelpendel.cli.terminal.describe_forces import describe_surroundings
from kugelpendel.spelling import significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.findings import Findings

_WIDTH = 96
"""Of a sentence on the terminal: that of the table and what stands beside numbers."""

_Row = tuple[str, str, str]
"""Name, value with its unit, and what the value means."""


def real_report(job: Job, found: Findings) -> str:
    """What swings, under which forces, where its plane goes and why."""
    rows = [*_periods(found), *_plane(found), *_size(found), _tension(job, found)]
    lines = [
        f"{'Pendulum':<19}{describe_pendulum(job.pendulum, job.has_mass)}",
        f"{'Launch':<19}{describe_launch(job)}",
        *(f"{name:<19}{text}" for name, text in describe_surroundings(job.setup)),
        "",
        *(f"{name:<19}{value:<21}  {meaning}".rstrip() for name, value, meaning in rows),
        "",
        *_why(found),
    ]
    ending = _ending(job, found)
    return "\n".join([*lines, "", ending] if ending else lines)


def _periods(found: Findings) -> list[_Row]:
    rows = [("Small swings", spell(found.point_period, "s", 7), "period of a point, 2π√(l/g)")]
    if found.small_period != found.point_period:
        change = spell_percent(found.small_period / found.point_period - 1)
        rows.append(("  with this bob", spell(found.small_period, "s", 7), change))
    first, last = found.record.swing_periods
    if math.isfinite(first):
        rows.append(("First swing", spell(first, "s", 7), "there and back"))
        rows.append(("Last swing", spell(last, "s", 7), spell_percent(last / first - 1)))
    return rows


def _plane(found: Findings) -> list[_Row]:
    course = found.record.course
    rows: list[_Row] = []
    if found.ideal:
        turn = f"−Ω_E sin(latitude), a turn in {spell(found.turn, 's')}"
        rows.append(("Foucault's rate", spell_rate(found.ideal, 5), turn))
    if len(course.times) < 2:
        return rows
    mean = course.mean_rate
    over = f"mean over {spell(float(np.ptp(course.times)), 's')}"
    rows.append(("Rate of the plane", spell_rate(mean, 5), over))
    if found.ideal:
        less = mean - found.ideal
        share = spell_percent(less / abs(found.ideal))
        rows.append(("  less Foucault's", spell_rate(less), f"{share}, + is counter-clockwise"))
    turned = f"{math.degrees(course.azimuth[-1] - course.azimuth[0]):+.6g}°".replace("-", "−")
    rows.append(("Turned by", turned, "by the last turning point"))
    return rows


def _size(found: Findings) -> list[_Row]:
    course = found.record.course
    if len(course.times) == 0:
        return []
    a, b = course.a, course.b
    rows = [
        (name, f"{spell(first, 'm')} → {spell(last, 'm')}".replace("-", "−"), meaning)
        for name, (first, last), meaning in (
            ("Amplitude a", (float(a[0]), float(a[-1])), "at the first and last turning point"),
            ("Half-width b", (float(b[0]), float(b[-1])), "there, + is counter-clockwise"),
        )
    ]
    return [*rows, ("Largest |b|", spell(found.record.course.widest, "m"), "")]


def _tension(job: Job, found: Findings) -> _Row:
    least, most = (significant(pull, 6).replace("-", "−") for pull in found.record.tension)
    note = "" if job.has_mass else "for 1 kg; "
    slack = found.record.slack_time
    if slack < math.inf:
        note += f"the thread goes slack after {spell(slack, 's')}"
    else:
        note += "the thread never goes slack"
    return ("Tension", f"{least} to {most} N", note)


def _why(found: Findings) -> list[str]:
    if found.shares is None:
        says = f"What turns the plane cannot be told apart: {found.why_no_shares.rstrip('.')}."
        return [textwrap.fill(says, _WIDTH)]
    if not np.any(found.shares.total):
        return ["The plane does not turn: nothing turns it."]
    apart = spell(abs(found.apart), "rad", 2)
    sentences = [
        *describe_pace(found.shares, found.ideal),
        "These shares are those of the averaged equations, whose plane ends "
        f"{apart} from that of the full ones.",
        found.caution,
    ]
    table = shares_table(found.shares)
    return [*table, "", *(textwrap.fill(each, _WIDTH) for each in sentences if each)]


def _ending(job: Job, found: Findings) -> str:
    seen = found.record
    if seen.slack_time < math.inf:
        return (
            f"The thread goes slack after {spell(seen.slack_time, 's')}: there the bob leaves the "
            "sphere, and the track ends."
        )
    if seen.stopped:
        whole = spell(job.grid.duration, "s")
        return f"Interrupted: the track goes to {spell(seen.until, 's')} of {whole}."
    return ""
