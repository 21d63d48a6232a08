"""The answer to a real job in words, for a terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.run.budget import describe_pace, shares_table
from kugelpendel.cli.run.clamp import clamp_notes, describe_clamp
from kugelpendel.cli.terminal.describe import describe_launch, describe_pendulum
from kugelpendel.cli.terminal.describe_forces import describe_forces
from kugelpendel.cli.terminal.tables import facts, paragraph
from kugelpendel.spelling import minus, significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.real_results import RealResults
    from kugelpendel.observables import RealSummary

_Row = tuple[str, str, str]
"""Name, value with its unit, and what the value means."""


def real_report(job: Job, found: RealResults) -> str:
    """What swings, under which forces, where its plane goes and why."""
    seen = found.summary
    plane = _plane(seen) if seen.revolutions is None else _round(seen)
    rows = [*_periods(seen), *plane, *_size(seen), _tension(job, seen)]
    start = facts(
        (
            ("Pendulum", describe_pendulum(job.pendulum, job.has_mass)),
            ("Launch", describe_launch(job)),
            *describe_forces(job.pendulum, job.forces),
        )
    )
    parts = [start, facts(rows), _why(job, found)]
    if ending := _ending(job, found):
        parts.append(paragraph(ending))
    return "\n\n".join(parts)


def _periods(seen: RealSummary) -> list[_Row]:
    rows = [("Small swings", spell(seen.point_period, "s", 7), "period of a point, 2π√(l/g)")]
    if seen.small_period != seen.point_period:
        change = spell_percent(seen.small_period / seen.point_period - 1)
        rows.append(("  with this bob", spell(seen.small_period, "s", 7), change))
    first, last = seen.swing_periods
    if math.isfinite(first) and seen.revolutions is None:
        rows.append(("First swing", spell(first, "s", 7), "there and back"))
        rows.append(("Last swing", spell(last, "s", 7), spell_percent(last / first - 1)))
    return rows


def _foucault(seen: RealSummary) -> list[_Row]:
    if not seen.foucault_rate:
        return []
    turn = f"−Ω_E sin(latitude), a turn in {spell(seen.foucault_turn, 's')}"
    return [("Foucault's rate", spell_rate(seen.foucault_rate, 5), turn)]


def _round(seen: RealSummary) -> list[_Row]:
    """Of a circle: it has no plane, and its two senses differ by what the Earth turns."""
    found = seen.revolutions
    if found is None:
        return []
    senses = ("counter-clockwise", "clockwise")
    this, other = senses if found.sense > 0 else reversed(senses)
    difference = spell(abs(found.other_period - found.period), "s", 3)
    shorter = "longer" if found.other_period > found.period else "shorter"
    return [
        *_foucault(seen),
        ("One revolution", spell(found.period, "s", 8), f"{this}; a circle has no plane"),
        ("  the other way", spell(found.other_period, "s", 8), f"{other}, {difference} {shorter}"),
        ("Last revolution", spell(found.last_period, "s", 8), this),
    ]


def _plane(seen: RealSummary) -> list[_Row]:
    apsides = seen.apsides
    rows = _foucault(seen)
    if len(apsides.times) < 2:
        return rows
    # A mean can hide that a plane stands: where, since when and how fast now come first.
    if (since := apsides.stands_since) is not None:
        at = minus(f"{math.degrees(math.remainder(apsides.azimuth[-1], math.pi)):.3g}°")
        rows.append(("The plane stands", f"at {at}", f"since {spell(since, 's', 3)}, to the end"))
    rows.append(("Rate at the end", spell_rate(apsides.rate_at_the_end), "of the plane"))
    mean = apsides.mean_rate
    over = f"mean over {spell(float(np.ptp(apsides.times)), 's')}"
    rows.append(("Rate of the plane", spell_rate(mean, 5), over))
    if seen.foucault_rate:
        less = mean - seen.foucault_rate
        share = spell_percent(less / abs(seen.foucault_rate))
        rows.append(("  less Foucault's", spell_rate(less), f"{share}, + is counter-clockwise"))
    turned = minus(f"{math.degrees(apsides.azimuth[-1] - apsides.azimuth[0]):+.6g}°")
    rows.append(("Turned by", turned, "by the last turning point"))
    return rows


def _size(seen: RealSummary) -> list[_Row]:
    apsides = seen.apsides
    if len(apsides.times) == 0:
        return []
    a, b = apsides.a, apsides.b
    rows = [
        (name, minus(f"{spell(first, 'm')} → {spell(last, 'm')}"), meaning)
        for name, (first, last), meaning in (
            ("Amplitude a", (float(a[0]), float(a[-1])), "at the first and last turning point"),
            ("Half-width b", (float(b[0]), float(b[-1])), "there, + is counter-clockwise"),
        )
    ]
    return [*rows, ("Largest |b|", spell(apsides.widest, "m"), "")]


def _tension(job: Job, seen: RealSummary) -> _Row:
    least, most = (minus(significant(pull, 6)) for pull in seen.tension)
    note = "" if job.has_mass else "for 1 kg; "
    if seen.slack_time < math.inf:
        note += f"the thread goes slack after {spell(seen.slack_time, 's')}"
    else:
        note += "the thread never goes slack"
    return ("Tension", f"{least} to {most} N", note)


def _turned(seen: RealSummary) -> float:
    azimuth = seen.apsides.azimuth
    return float(azimuth[-1] - azimuth[0])


def _why(job: Job, found: RealResults) -> str:
    told = found.explanation
    if found.summary.revolutions is not None:
        return paragraph(
            "What turns a plane is not asked of a circle; give the launch another b for that."
        )
    if told.shares is None:
        says = f"What turns the plane cannot be told apart: {told.why_not.rstrip('.')}."
        return paragraph(says)
    if not np.any(told.shares.total):
        return "The plane does not turn: nothing turns it."
    apart = spell(abs(told.apart), "rad", 2)
    sentences = [
        *describe_pace(told.shares, found.summary.foucault_rate),
        *describe_clamp(clamp_notes(job), _turned(found.summary)),
        "These shares are those of the averaged equations, whose plane ends "
        f"{apart} from that of the full ones.",
        told.caution,
    ]
    said = "\n".join(paragraph(sentence) for sentence in sentences if sentence)
    return f"{shares_table(told.shares)}\n\n{said}"


def _ending(job: Job, found: RealResults) -> str:
    seen = found.summary
    if seen.slack_time < math.inf:
        return (
            f"The thread goes slack after {spell(seen.slack_time, 's')}: there the bob leaves the "
            "sphere, and the track ends."
        )
    if found.stopped:
        whole = spell(job.grid.duration, "s")
        return f"Interrupted: the track goes to {spell(seen.until, 's')} of {whole}."
    return ""
