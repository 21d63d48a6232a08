"""``results.json``: the numbers at full precision, units in the names of the keys."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from kugelpendel.cli.job_file.job import LAUNCHES
from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.run.ideal_report import why_no_25

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel import IdealSummary
    from kugelpendel.cli.job_file.job import Job

FILE = "results.json"

_UNIT = {
    **dict.fromkeys(("a", "b", "x", "y"), "m"),
    **dict.fromkeys(("azimuth", "theta", "phi"), "rad"),
    **dict.fromkeys(("vx", "vy"), "m_per_s"),
    **dict.fromkeys(("theta_rate", "phi_rate"), "rad_per_s"),
}


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
        "pendulum": {
            "length_m": float(job.pendulum.length),
            "gravity_m_per_s2": float(job.pendulum.gravity),
            "mass_kg": float(job.pendulum.mass),
        },
        "launch": {"kind": job.launch.kind, **_launch(job, LAUNCHES[job.launch.kind])},
    }


def _launch(job: Job, arguments: Sequence[str]) -> dict[str, Any]:
    values = [float(value) for value in job.launch.values]
    if job.launch.kind == "state":
        return {"position_m": values[:3], "velocity_m_per_s": values[3:]}
    # at_rest names the first two of the values of angles.
    named = zip(arguments, values, strict=False)
    return {f"{name}_{_UNIT[name]}": value for name, value in named}


def _motion(summary: IdealSummary) -> dict[str, Any]:
    return {
        "regime": summary.regime,
        "sense_seen_from_above": {1: "counter-clockwise", -1: "clockwise", 0: None}[summary.sense],
        "frequency_rad_per_s": summary.frequency,
        "swing_period_s": summary.swing_period,
        "radial_period_s": float(summary.motion.radial_period),
        "precession_rad_per_s": summary.precession,
        "precession_deg_per_h": math.degrees(summary.precession) * 3600,
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
