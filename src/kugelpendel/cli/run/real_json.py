"""``results.json`` of a real job: the numbers at full precision, units in the names of the keys."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kugelpendel.cli.run.clamp import clamp_notes
from kugelpendel.cli.run.ideal_json import describe_start, to_json
from kugelpendel.motion import CAUSES

if TYPE_CHECKING:
    from collections.abc import Sequence

    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.findings import Findings
    from kugelpendel.motion import PrecessionBudget

_ABOUT = (
    "kugelpendel: a real pendulum, full equations; SI units, named in the keys; azimuths, b and "
    "rates are positive counter-clockwise seen from above; null is infinite or not there"
)


def real_json(job: Job, found: Findings, files: Sequence[str]) -> str:
    """All numbers of a real job as JSON text.

    Parameters
    ----------
    job : Job
        What was asked.
    found : Findings
        What was found.
    files : sequence of str
        Names of the other files in the output folder.
    """
    seen = found.record
    tables = {
        "about": _ABOUT,
        **describe_start(job),
        "forces": _forces(job.forces),
        "periods": {
            "small_swings_of_a_point_s": found.point_period,
            "small_swings_s": found.small_period,
            "first_swing_s": seen.swing_periods[0],
            "last_swing_s": seen.swing_periods[1],
        },
        "plane": _plane(found),
        "swing": _swing(found),
        "shares": None if found.shares is None else _shares(found.shares),
        "why_no_shares": found.why_no_shares or None,
        "clamp": clamp_notes(job) or None,
        "averaged_equations": {
            "full_less_averaged_azimuth_at_the_end_rad": found.apart,
            "caution": found.caution or None,
        },
        "tension": {
            "least_N": seen.tension[0],
            "most_N": seen.tension[1],
            "goes_slack": seen.slack_time < math.inf,
            "first_slack_s": seen.slack_time,
        },
        "output": {
            "duration_s": job.grid.duration,
            "step_s": job.grid.step,
            "samples": seen.samples,
            "followed_until_s": seen.until,
            "interrupted": seen.stopped,
            "files": list(files),
        },
    }
    return to_json(tables)


def _forces(acting: kp.Forces) -> dict[str, Any]:
    """What acted, None for what did not."""
    forces: dict[str, Any] = dict.fromkeys(("site", "drag", "suspension", "bob", "drive"))
    if acting.site is not None:
        forces["site"] = {
            "latitude_rad": float(acting.site.latitude),
            "gravity_m_per_s2": float(acting.site.gravity),
            "height_m": float(acting.site.height),
        }
    if acting.drag is not None:
        forces["drag"] = {
            "linear_per_s": float(acting.drag.linear),
            "quadratic_per_m": float(acting.drag.quadratic),
        }
    if acting.suspension is not None:
        forces["suspension"] = {
            "anisotropy_rad_per_s": float(acting.suspension.anisotropy),
            "axis_rad": float(acting.suspension.axis),
            "damping_anisotropy_per_s": float(acting.suspension.damping_anisotropy),
            "damping_axis_rad": float(acting.suspension.damping_axis),
        }
    if acting.bob is not None:
        forces["bob"] = {
            "radius_m": float(acting.bob.radius),
            "density_kg_per_m3": float(acting.bob.density),
            "mass_kg": float(acting.bob.mass),
            "thread_mass_kg": float(acting.bob.thread_mass),
            "air_density_kg_per_m3": float(acting.bob.air_density),
        }
    if acting.drive is not None:
        phase, radius = acting.drive.phase, acting.drive.radius
        forces["drive"] = {
            "push_m_per_s": float(acting.drive.push),
            "phase_rad": None if phase is None else float(phase),
            "radius_m": None if radius is None else float(radius),
        }
    return forces


def _plane(found: Findings) -> dict[str, Any]:
    course = found.record.course
    there = len(course.times) > 1
    mean = course.mean_rate if there else math.nan
    return {
        "ideal_rad_per_s": found.ideal,
        "ideal_deg_per_h": _hourly(found.ideal),
        "ideal_turn_s": found.turn,
        "mean_rad_per_s": mean,
        "mean_deg_per_h": _hourly(mean),
        "mean_less_ideal_deg_per_h": _hourly(mean - found.ideal),
        "first_azimuth_rad": float(course.azimuth[0]) if there else math.nan,
        "last_azimuth_rad": float(course.azimuth[-1]) if there else math.nan,
        "first_turning_point_s": float(course.times[0]) if there else math.nan,
        "last_turning_point_s": float(course.times[-1]) if there else math.nan,
    }


def _swing(found: Findings) -> dict[str, Any]:
    course = found.record.course
    there = len(course.times) > 0
    return {
        "first_a_m": float(course.a[0]) if there else math.nan,
        "last_a_m": float(course.a[-1]) if there else math.nan,
        "first_b_m": float(course.b[0]) if there else math.nan,
        "last_b_m": float(course.b[-1]) if there else math.nan,
        "largest_b_m": course.widest,
    }


def _shares(shares: PrecessionBudget) -> dict[str, Any]:
    total = shares.total
    way = float(np.sign(shares.earth.mean())) or 1.0
    slow, fast = int(np.argmin(way * total)), int(np.argmax(way * total))
    named = [*((cause, getattr(shares, cause)) for cause in CAUSES), ("sum", total)]
    return {
        **{
            name: {
                "mean_rad_per_s": float(share.mean()),
                "least_rad_per_s": float(share.min()),
                "most_rad_per_s": float(share.max()),
                "at_the_slowest_rad_per_s": float(share[slow]),
                "at_the_fastest_rad_per_s": float(share[fast]),
            }
            for name, share in named
        },
        "slowest_s": float(shares.times[slow]),
        "slowest_azimuth_rad": float(shares.azimuth[slow]),
        "fastest_s": float(shares.times[fast]),
        "fastest_azimuth_rad": float(shares.azimuth[fast]),
        "paces": [
            {
                "pace": stretch.pace,
                "from_s": stretch.start,
                "to_s": stretch.stop,
                "mostly_by": stretch.cause or None,
                "against": stretch.against or None,
            }
            for stretch in shares.stretches()
        ],
    }


def _hourly(rate: float) -> float:
    return math.degrees(rate) * 3600
