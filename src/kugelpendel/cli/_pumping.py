"""Whether a drive would lift the bob to the level of its support, for want of drag."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli._words import given
from kugelpendel.plot import spell

if TYPE_CHECKING:
    from kugelpendel.cli._job import Job

_STRIDE = 0.01
"""Of the length, by which the amplitude grows from one look at the balance to the next."""


def refuse_pumping(job: Job) -> None:
    """Refuse a drive that gives more than the drag takes at every amplitude.

    Gain and loss in half a swing are those of small swings: Δa = p cos φ/ω0 at the phase φ after
    the closest approach, and (π/ω0)(γa + (4/3π) c ω0 a²).

    Raises
    ------
    InvalidInput
        The bob would come level with the support within the job; the sentence says by which push
        the amplitude of the launch is kept.
    """
    drive = job.setup.drive
    exact = kp.ExactMotion(job.pendulum, job.launch)
    length = float(job.pendulum.length)
    if drive is None or float(exact.turning_heights[0]) >= length:
        return
    start = float(exact.turning_radii[0])
    amplitude, elapsed = start, 0.0
    while amplitude < length:
        growth = float(drive.push) * _leverage(drive, amplitude) - _braking(job, amplitude)
        if growth <= 0 or elapsed > job.grid.duration:
            return
        # Half swings to the next look, each of them π/ω0 long and worth growth/ω0.
        elapsed += math.pi * _STRIDE * length / growth
        amplitude += _STRIDE * length
    balance = _braking(job, start) / _leverage(drive, start) if _leverage(drive, start) else 0.0
    way_out = "give the job a [drag]"
    if balance:
        keeps = f"{1e3 * balance:.4g} mm/s"
        way_out = f'push = "{keeps}" keeps an amplitude of {given(start, "m")}'
    raise kp.InvalidInput(
        f"{job.file}: [drive] push = {float(drive.push):.4g} m/s pumps without end: within "
        f"{spell(elapsed, 's', 2)} the bob would come level with its support, as the drag takes "
        f"less than the push gives at every amplitude; {way_out}."
    )


def _leverage(drive: kp.Drive, amplitude: float) -> float:
    """Gain of amplitude times ω0, for each unit of the push: the cosine of the phase."""
    if drive.phase is not None:
        return math.cos(float(drive.phase))
    share = float(drive.radius or 0.0) / amplitude if amplitude else math.inf
    return math.sqrt(1 - share**2) if share < 1 else 0.0


def _braking(job: Job, amplitude: float) -> float:
    """Loss of amplitude in half a swing times ω0, m/s."""
    if job.setup.drag is None:
        return 0.0
    linear, quadratic = (float(value) for value in job.setup.drag.values)
    frequency = float(job.pendulum.angular_frequency)
    return math.pi * linear * amplitude + 4 / 3 * quadratic * frequency * amplitude**2
