"""``results.json`` of a real job: the numbers at full precision, units in the names of the keys."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.run.clamp import clamp_notes
from kugelpendel.cli.run.ideal_json import describe_start, described
from kugelpendel.motion import CAUSES
from kugelpendel.parameters import FORCE_PARTS
from kugelpendel.spelling import hourly

if TYPE_CHECKING:
    from collections.abc import Sequence

    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.real_results import RealResults
    from kugelpendel.motion import PrecessionBudget
    from kugelpendel.observables import RealSummary

_ABOUT = (
    "kugelpendel: a real pendulum, full equations; SI units, named in the keys; azimuths, b and "
    "rates are positive counter-clockwise seen from above; null is infinite or not there"
)


def real_json(job: Job, found: RealResults, files: Sequence[str]) -> str:
    """All numbers of a real job as JSON text.

    Parameters
    ----------
    job
        What was asked.
    found
        What was found.
    files
        Names of the other files in the output folder.
    """
    seen, told = found.summary, found.explanation
    tables = {
        "about": _ABOUT,
        **describe_start(job),
        "forces": _forces(job.forces),
        "periods": {
            "small_swings_of_a_point_s": seen.point_period,
            "small_swings_s": seen.small_period,
            "first_swing_s": seen.swing_periods[0],
            "last_swing_s": seen.swing_periods[1],
        },
        "plane": _plane(seen),
        "revolutions": _revolutions(seen),
        "swing": _swing(seen),
        "shares": None if told.shares is None else _shares(told.shares),
        "why_no_shares": told.why_not or None,
        "clamp": clamp_notes(job) or None,
        "averaged_equations": {
            "full_less_averaged_azimuth_at_the_end_rad": told.apart,
            "caution": told.caution or None,
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
            "samples": found.samples,
            "followed_until_s": seen.until,
            "interrupted": found.stopped,
            "files": list(files),
        },
    }
    return json_text(tables)


def _forces(acting: kp.Forces) -> dict[str, Any]:
    """What acted, None for what did not."""
    told = {name: described(part) for name, part in acting.parts.items()}
    return {name: told.get(name) for name in FORCE_PARTS}


def _plane(seen: RealSummary) -> dict[str, Any]:
    apsides = seen.apsides
    there = len(apsides.times) > 1 and seen.revolutions is None
    mean = apsides.mean_rate if there else math.nan
    end = apsides.rate_at_the_end if there else math.nan
    since = apsides.stands_since if there else None
    return {
        "ideal_rad_per_s": seen.foucault_rate,
        "ideal_deg_per_h": hourly(seen.foucault_rate),
        "ideal_turn_s": seen.foucault_turn,
        "stands_since_s": since,
        "stands_at_rad": None if since is None else float(apsides.azimuth[-1]),
        "at_the_end_rad_per_s": end,
        "at_the_end_deg_per_h": hourly(end),
        "mean_rad_per_s": mean,
        "mean_deg_per_h": hourly(mean),
        "mean_less_ideal_deg_per_h": hourly(mean - seen.foucault_rate),
        "first_azimuth_rad": float(apsides.azimuth[0]) if there else math.nan,
        "last_azimuth_rad": float(apsides.azimuth[-1]) if there else math.nan,
        "first_turning_point_s": float(apsides.times[0]) if there else math.nan,
        "last_turning_point_s": float(apsides.times[-1]) if there else math.nan,
    }


def _revolutions(seen: RealSummary) -> dict[str, Any] | None:
    """Of a circle, which has no plane; None for a swing."""
    round_ = seen.revolutions
    if round_ is None:
        return None
    return {
        "sense": "counter-clockwise" if round_.sense > 0 else "clockwise",
        "period_s": round_.period,
        "last_period_s": round_.last_period,
        "period_in_the_other_sense_s": round_.other_period,
    }


def _swing(seen: RealSummary) -> dict[str, Any]:
    apsides = seen.apsides
    there = len(apsides.times) > 0
    return {
        "first_a_m": float(apsides.a[0]) if there else math.nan,
        "last_a_m": float(apsides.a[-1]) if there else math.nan,
        "first_b_m": float(apsides.b[0]) if there else math.nan,
        "last_b_m": float(apsides.b[-1]) if there else math.nan,
        "largest_b_m": apsides.widest,
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
