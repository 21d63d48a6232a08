"""What a real job finds out: the numbers of its report and of ``results.json``."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import kugelpendel as kp
from kugelpendel.motion import PrecessionBudget

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.record import Record

_TIMES = 2001
"""At which the causes are told apart; modulations last hours, and a day has a time every 43 s."""


@dataclass(frozen=True)
class Findings:
    """Numbers in SI; azimuths and rates positive counter-clockwise seen from above.

    Attributes
    ----------
    record : Record
        What was measured on the full equations.
    point_period, small_period : float
        Of small swings, s: of a point on a thread without weight, and with the bob's correction.
    ideal : float
        −Ω_E sin(latitude), rad/s; 0 without a site.
    shares : PrecessionBudget or None
        What turned the plane, by the averaged equations; None where they do not hold, as
        ``why_no_shares`` says.
    apart : float
        Azimuth of the plane at the end, full equations less averaged ones, rad; NaN without.
    caution : str
        What the averaged equations say about themselves; empty for nothing.
    """

    record: Record
    point_period: float
    small_period: float
    ideal: float
    shares: PrecessionBudget | None
    why_no_shares: str
    apart: float
    caution: str

    @property
    def turn(self) -> float:
        """Time for one turn at the ideal rate, s; inf without a site and on the equator."""
        return 2 * math.pi / abs(self.ideal) if self.ideal else math.inf


def find(job: Job, motion: kp.RealMotion, seen: Record) -> Findings:
    """Put together what was measured and what the averaged equations say to it."""
    shares, reason, caution, apart = None, "", "", math.nan
    course = seen.course
    if len(course.times) < 2:
        reason = "there is no full swing"
    else:
        try:
            with warnings.catch_warnings(record=True) as warned:
                warnings.simplefilter("always")
                averaged = envelope(job)
                shares = averaged.rates(np.linspace(0.0, seen.until, _TIMES))
                last = float(averaged.azimuth(course.times[-1:])[0])
            caution = " ".join(str(warning.message) for warning in warned)
            # Both azimuths are those of an axis, which has no front end.
            started = float(averaged.azimuth(course.times[:1])[0])
            apart = course.azimuth[-1] - last
            apart -= math.pi * round((course.azimuth[0] - started) / math.pi)
            if not np.isfinite(shares.total).all():
                shares, reason = None, "the swing does not stay one of a turning ellipse"
        except kp.KugelpendelError as error:
            shares, reason = None, str(error)
    site = job.forces.site
    return Findings(
        record=seen,
        point_period=2 * math.pi / float(job.pendulum.angular_frequency),
        small_period=2 * math.pi / float(motion.angular_frequency),
        ideal=-float(site.vertical_rotation) if site is not None else 0.0,
        shares=shares,
        why_no_shares=reason,
        apart=float(apart),
        caution=caution,
    )


def envelope(job: Job) -> kp.EnvelopeMotion:
    """The averaged motion of a job."""
    return kp.EnvelopeMotion(job.pendulum, job.launch, job.forces)
