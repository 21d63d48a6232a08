"""``results.json``: the numbers at full precision, units in the names of the keys."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any, cast

from kugelpendel.cli.job_file.job import LAUNCHES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.answer import Answer

FILE = "results.json"

_UNIT = {
    **dict.fromkeys(("a", "b", "x", "y"), "m"),
    **dict.fromkeys(("azimuth", "theta", "phi"), "rad"),
    **dict.fromkeys(("vx", "vy"), "m_per_s"),
    **dict.fromkeys(("theta_rate", "phi_rate"), "rad_per_s"),
}


def as_json(job: Job, answer: Answer, files: Sequence[str]) -> str:
    """All numbers as JSON text.

    Parameters
    ----------
    job : Job
        What was asked.
    answer : Answer
        What was found. What is infinite or does not exist is null.
    files : sequence of str
        Names of the other files in the output folder.
    """
    tables = {
        "about": "kugelpendel: SI units, named in the keys; azimuths and the signs of rates are "
        "positive counter-clockwise seen from above; null is infinite or not there",
        **describe_start(job),
        "motion": _motion(answer),
        "formula_25": {
            "precession_rad_per_s": answer.formula_25,
            "difference_percent": None if answer.error_25 is None else 100 * answer.error_25,
            "why_it_does_not_apply": answer.why_not or None,
        },
        "tension": {
            "least_N": answer.tension[0],
            "most_N": answer.tension[1],
            "goes_slack": answer.slack_time < math.inf,
            "first_slack_s": answer.slack_time,
        },
        "output": {
            "duration_s": job.grid.duration,
            "step_s": job.grid.step,
            "samples": job.grid.count,
            "files": list(files),
        },
    }
    return to_json(tables)


def to_json(tables: dict[str, Any]) -> str:
    """The tables as JSON text, with null in place of what is not finite."""
    return json.dumps(_finite(tables), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


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


def _motion(answer: Answer) -> dict[str, Any]:
    known = answer.known
    return {
        "regime": answer.regime,
        "sense_seen_from_above": {1: "counter-clockwise", -1: "clockwise", 0: None}[answer.sense],
        "frequency_rad_per_s": known.frequency,
        "swing_period_s": answer.swing_period,
        "radial_period_s": known.radial_period,
        "precession_rad_per_s": known.precession,
        "precession_deg_per_h": math.degrees(known.precession) * 3600,
        "turning_rad_per_s": answer.turning,
        "turning_less_whole_turns": answer.whole_turns,
        "full_turn_s": answer.full_turn,
        "once_round_s": answer.once_round,
        "apsidal_angle_rad": known.apsidal_angle,
        "outer_turning_radius_m": known.outer,
        "inner_turning_radius_m": known.inner,
        "highest_turning_point_m": known.high,
        "lowest_turning_point_m": known.low,
        "largest_angle_rad": answer.largest_angle,
        "energy_J_per_kg": answer.energy,
        "angular_momentum_m2_per_s": known.angular_momentum,
    }


def _finite(value: Any) -> Any:
    """The same tables with null in place of what JSON cannot say."""
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in cast("dict[str, Any]", value).items()}
    if isinstance(value, list):
        return [_finite(entry) for entry in cast("list[Any]", value)]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value
