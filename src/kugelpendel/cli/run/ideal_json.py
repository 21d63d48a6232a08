"""``results.json``: the numbers at full precision, units in the names of the keys."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.run.ideal_report import why_no_25
from kugelpendel.parameters import Launch
from kugelpendel.spelling import hourly

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel import IdealSummary
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.parameters import Given

FILE = "results.json"


def as_json(job: Job, summary: IdealSummary, files: Sequence[str]) -> str:
    """All numbers as JSON text.

    Parameters
    ----------
    job
        What was asked.
    summary
        What was found. What is infinite or does not exist is null.
    files
        Names of the other files in the output folder.
    """
    tables = {
        "about": "kugelpendel: SI units, named in the keys; azimuths and the signs of rates are "
        "positive counter-clockwise seen from above; null is infinite or not there",
        **describe_start(job),
        "motion": _motion(summary),
        "formula_25": {
            "precession_rad_per_s": summary.formula_25,
            "difference_percent": None if summary.error_25 is None else 100 * summary.error_25,
            "why_it_does_not_apply": why_no_25(summary) or None,
        },
        "tension": {
            "least_N": summary.tension[0],
            "most_N": summary.tension[1],
            "goes_slack": summary.slack_time < math.inf,
            "first_slack_s": summary.slack_time,
        },
        "output": {
            "duration_s": job.grid.duration,
            "step_s": job.grid.step,
            "samples": job.grid.count,
            "files": list(files),
        },
    }
    return json_text(tables)


def describe_start(job: Job) -> dict[str, Any]:
    """The job's name, its pendulum and its launch."""
    return {
        "job": job.file.name,
        "pendulum": described(job.pendulum),
        "launch": {"kind": job.launch.kind, **_launch(job.launch)},
    }


def described(given: Given) -> dict[str, Any]:
    """The numbers of what is given, and what follows from them, under names with their units."""
    units = {**given.units, **given.follows}
    return {_with_unit(name, unit): getattr(given, name) for name, unit in units.items()}


def _launch(launch: Launch) -> dict[str, Any]:
    if launch.kind == "state":
        return {"position_m": launch.values[:3], "velocity_m_per_s": launch.values[3:]}
    units = Launch.kinds[launch.kind].items()
    named = zip(units, launch.values, strict=True)
    return {_with_unit(name, unit): value for (name, unit), value in named}


def _with_unit(name: str, unit: str) -> str:
    """A name such as gravity_m_per_s2."""
    spelled = unit.replace("²", "2").replace("³", "3").replace("1/", "per_").replace("/", "_per_")
    return f"{name}_{spelled}".rstrip("_")


def _motion(summary: IdealSummary) -> dict[str, Any]:
    return {
        "regime": summary.regime,
        "sense_seen_from_above": {1: "counter-clockwise", -1: "clockwise", 0: None}[summary.sense],
        "frequency_rad_per_s": summary.frequency,
        "swing_period_s": summary.swing_period,
        "radial_period_s": float(summary.motion.radial_period),
        "precession_rad_per_s": summary.precession,
        "precession_deg_per_h": hourly(summary.precession),
        "turning_rad_per_s": summary.turning,
        "turning_less_whole_turns": summary.whole_turns,
        "full_turn_s": summary.full_turn,
        "once_round_s": summary.once_round,
        "apsidal_angle_rad": float(summary.motion.apsidal_angle),
        "outer_turning_radius_m": summary.outer,
        "inner_turning_radius_m": summary.inner,
        "highest_turning_point_m": summary.high,
        "lowest_turning_point_m": summary.low,
        "largest_angle_rad": summary.largest_angle,
        "energy_J_per_kg": float(summary.motion.energy),
        "angular_momentum_m2_per_s": float(summary.motion.angular_momentum),
    }
