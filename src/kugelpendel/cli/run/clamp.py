"""What an uneven clamp would do to the plane by itself, and what it does with all that acts."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.spelling import minus

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job

_QUESTIONS = {"alone": "turning_by_anisotropy", "together": "settled_rate"}


def clamp_notes(job: Job) -> dict[str, str]:
    """What the builder's answers say of a job: "alone" without drag and drive, "together" with.

    Empty where the clamp is even, without a site, and where the averaged equations or the builder's
    formulas do not hold, as for round ellipses; "together" is left out where nothing acts beside
    the clamp.
    """
    suspension = job.forces.suspension
    if job.forces.site is None or suspension is None or not float(suspension.anisotropy):
        return {}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the report has the motion's own caution
            start = kp.Portrait.of(kp.EnvelopeMotion(job.pendulum, job.launch, job.forces))
        found = kp.design(
            job.pendulum, start.a, start.b, azimuth=start.azimuth, forces=job.forces, checked=False
        )
    except kp.InvalidInput:
        return {}
    return {name: found[key].note for name, key in _QUESTIONS.items() if key in found}


def describe_clamp(notes: dict[str, str], turned: float) -> list[str]:
    """Sentences of these notes, beside the turn in rad that was seen."""
    if not notes:
        return []
    lines = [f"The clamp: {notes['alone']}."]
    if "together" in notes:
        lines.append(f"With all that acts: {notes['together']}.")
    seen = minus(f"{math.degrees(turned):+.4g}°")
    return [*lines, f"In this run the plane turned by {seen}."]
