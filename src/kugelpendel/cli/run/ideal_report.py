"""The answer in words, for a terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.cli.terminal.describe import describe_launch, describe_pendulum
from kugelpendel.cli.terminal.tables import facts
from kugelpendel.spelling import degrees, general, significant, spell, spell_percent, spell_rate

if TYPE_CHECKING:
    from kugelpendel import IdealSummary
    from kugelpendel.cli.job_file.job import Job

_SENSE = {1: "counter-clockwise", -1: "clockwise", 0: "neither way"}

_WHY_NOT_25 = {
    "rest": "there is no ellipse at rest",
    "balance": "there is no ellipse at rest",
    "separatrix": "the motion never comes back",
    "plane": "the swing stays in a vertical plane",
    "rotation": "the bob turns over the top in a vertical plane",
    "above": "it holds for small ellipses, below the support",
}

_Row = tuple[str, str, str]
"""Name, value with its unit, and what the value means."""


def report(job: Job, summary: IdealSummary) -> str:
    """What moves and how: one line for each number, with what it means beside it."""
    rows: list[_Row] = [
        *_periods(job, summary),
        *_precession(summary),
        *_extent(summary),
        *_tension(job, summary),
    ]
    start = facts(
        (
            ("Pendulum", describe_pendulum(job.pendulum, job.has_mass)),
            ("Launch", describe_launch(job)),
            ("Motion", _motion(summary)),
        )
    )
    return f"{start}\n\n{facts(rows)}"


def why_no_25(summary: IdealSummary) -> str:
    """Why the paper's (25) says nothing of a motion; empty where it does."""
    return _WHY_NOT_25.get(summary.regime, "")


def _motion(summary: IdealSummary) -> str:
    outer, inner, high, low = (
        spell(value, "m") for value in (summary.outer, summary.inner, summary.high, summary.low)
    )
    match summary.regime:
        case "rest":
            return "hangs at rest"
        case "balance":
            return "stands at rest above the support; the least push topples it"
        case "separatrix":
            return "creeps up to the top and never comes back"
        case "plane":
            return f"swings to and fro in a vertical plane, between heights 0 and {high}"
        case "rotation":
            return "turns over the top in a vertical plane"
        case "cone":
            wobble = summary.high - summary.low
            aside = f", wobbling by {spell(wobble, 'm', 2)} in height" if wobble else ""
            return f"circles on a cone, {outer} from the vertical{aside}"
        case "above":
            return f"rises above the support, between heights {low} and {high}"
        case _:
            return f"an ellipse between {outer} and {inner} from the vertical"


def _periods(job: Job, summary: IdealSummary) -> list[_Row]:
    small = 2 * math.pi / float(job.pendulum.angular_frequency)
    rows = [("Small swings", spell(small, "s", 7), "period 2π√(l/g)")]
    if summary.regime in ("rest", "balance"):
        return rows
    if summary.regime == "separatrix":
        return [*rows, ("Swing period", "infinite", "ω = 0")]
    meaning = {
        "rotation": "2π/ω, once round",
        "cone": "2π/ω, twice the radial period",
        "above": "2π/ω, twice the radial period",
    }.get(summary.regime, "2π/ω, there and back")
    rows.append(("Swing period", spell(summary.swing_period, "s", 7), meaning))
    if summary.frequency_26 is not None and summary.frequency_26 > 0:
        approximate = 2 * math.pi / summary.frequency_26
        error = spell_percent(summary.period_error_26 or 0.0)
        note = f"{error} against the exact one"
        rows.append(("  by formula (26)", spell(approximate, "s", 7), note))
    apart = "from one highest point to the next"
    if summary.regime == "cone":
        apart = "of a slight wobble about the cone"
    rows.append(("Radial period", spell(float(summary.motion.radial_period), "s", 7), apart))
    rows.append(("Frequency ω", f"{general(summary.frequency, 7)} rad/s", "exact"))
    return rows


def _precession(summary: IdealSummary) -> list[_Row]:
    if summary.regime in ("rest", "balance", "separatrix"):
        return []
    if summary.regime in ("plane", "rotation"):
        return [("Precession Ω", "0", "exactly: the plane of the swing does not turn")]
    turns = _SENSE[(summary.precession > 0) - (summary.precession < 0)]
    rows = [
        ("Sense", _SENSE[summary.sense], "of the bob, seen from above"),
        ("Precession Ω", spell_rate(summary.precession, 7), f"exact, {turns}"),
    ]
    if summary.formula_25 is None:
        rows.append(("  by formula (25)", "does not apply:", why_no_25(summary)))
    elif summary.error_25 is not None:
        note = f"{spell_percent(summary.error_25)} against the exact one"
        rows.append(("  by formula (25)", spell_rate(summary.formula_25, 7), note))
    step = degrees(float(summary.motion.apsidal_angle))
    rows.append(("Apsidal angle", step, "from one highest point to the next"))
    what = "the ellipse"
    if summary.whole_turns:
        what = "the highest point"
        rows.append(("Highest point", spell_rate(summary.turning, 7), "less whole turns"))
    if math.isfinite(summary.full_turn):
        rows.append(("One full turn", spell(summary.full_turn, "s", 6), f"of {what}"))
    if math.isfinite(summary.once_round):
        note = "of the bob about the vertical"
        rows.append(("One full turn", spell(summary.once_round, "s", 7), note))
    return rows


def _extent(summary: IdealSummary) -> list[_Row]:
    if summary.regime in ("rest", "balance"):
        return []
    note = f"from the vertical, at height {spell(summary.high, 'm')}"
    return [("Largest angle", degrees(summary.largest_angle), note)]


def _tension(job: Job, summary: IdealSummary) -> list[_Row]:
    negligible = 1e-12 * max(abs(tension) for tension in summary.tension)
    least, most = (
        significant(tension if abs(tension) > negligible else 0.0, 6) for tension in summary.tension
    )
    note = "" if job.has_mass else "for 1 kg; "
    if summary.slack_time < math.inf:
        when = f"after {spell(summary.slack_time, 's')}" if summary.slack_time > 0 else "at once"
        note += f"a thread goes slack {when}, a rod goes on"
    else:
        note += "a thread never goes slack"
    return [("Tension", f"{least} N" if least == most else f"{least} to {most} N", note)]
