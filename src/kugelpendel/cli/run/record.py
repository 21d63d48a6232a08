"""The track of a real motion, written while it is integrated; and what was seen on the way."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.run.passes import Passes
from kugelpendel.cli.run.watch import Watch
from kugelpendel.cli.terminal.estimate import Estimate
from kugelpendel.cli.track.block import Block
from kugelpendel.cli.track.track import BLOCK, WRITERS

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from kugelpendel.cli.job_file.sample_times import Grid
    from kugelpendel.cli.terminal.estimate import Wish
    from kugelpendel.observables import Course

_BREATH = 0.2
"""s of work between two looks at the clock and at whether the user wants to stop."""

_FIRST = 8
"""Swings of the first stretch; how far the next ones reach follows from the time it took."""


@dataclass(frozen=True)
class Record:
    """What was seen while the track was written.

    Attributes
    ----------
    course : Course
        The swing at its outer turning points.
    swing_periods : tuple of float
        Of the first and of the last swing, s; NaN where there is none.
    tension : tuple of float
        Smallest and largest at the samples and in the first two swings, N.
    samples : int
        Rows of the track.
    until : float
        How far the motion was followed, s.
    slack_time : float
        When the thread went slack, which ended the motion, s; inf where it did not.
    stopped : bool
        Whether the user stopped it.
    """

    course: Course
    swing_periods: tuple[float, float]
    tension: tuple[float, float]
    samples: int
    until: float
    slack_time: float
    stopped: bool


def record(
    path: Path,
    make: Callable[[], kp.RealMotion],
    grid: Grid,
    track_format: str,
    wish: Wish,
    done: Callable[[float], None],
) -> Record:
    """Write the track of a real motion, until the job, the motion or the user ends it.

    Parameters
    ----------
    path : Path
        The file.
    make : callable
        Makes the motion, as for `Passes`.
    grid : Grid
        The times.
    track_format : str
        As in `write_track`.
    wish : Wish
        Whether to stop, looked at several times a second.
    done : callable
        Told how many seconds the motion has gone on since the last call.
    """
    samples, watch, estimate = Passes(make), Watch(make, grid.duration), Estimate(grid.duration)
    swing = 2 * math.pi / float(samples.angular_frequency)
    end, slack_time = _reach(make, min(2 * swing, grid.duration))
    if end == 0:
        raise kp.InvalidInput(
            "The thread is slack at the launch, so there is no motion; start lower or faster."
        )
    early = make().tension(np.linspace(0.0, end, 400, endpoint=False))
    least, most = float(early.min()), float(early.max())
    now, rows, stretch = 0.0, 0, _FIRST * swing
    with WRITERS[track_format](path, None) as write:
        while now < min(grid.duration, slack_time) and not wish.stop:
            started = time.monotonic()
            until = min(now + min(stretch, BLOCK * grid.step), grid.duration, slack_time)
            times = grid.step * np.arange(rows, _rows(grid, until), dtype=np.float64)
            try:
                block = Block.of(samples, rows, times)
                if until < slack_time:
                    samples.reach(until)
            except kp.MotionEnded:
                known = slack_time < math.inf
                samples, (_, slack_time) = Passes(make), _reach(make, until)
                if known or slack_time == math.inf:
                    raise
                continue
            if len(times):
                least = min(least, float(block.tension.min()))
                most = max(most, float(block.tension.max()))
                write(block)
            rows += len(times)
            watch.advance(until)
            done(until - now)
            now = until
            estimate.after(now)
            pace = _BREATH / max(time.monotonic() - started, 1e-3)
            stretch *= min(pace, 4.0)
    least = min(least, 0.0) if slack_time < math.inf else least
    stopped = wish.stop and now < min(grid.duration, slack_time)
    return Record(
        watch.course(), watch.swing_periods, (least, most), rows, now, slack_time, stopped
    )


def _rows(grid: Grid, until: float) -> int:
    """How many samples come no later than that."""
    if until == grid.duration:
        return grid.count
    rows = min(math.floor(until / grid.step) + 1, grid.count)
    return rows if grid.step * (rows - 1) <= until else rows - 1


def _reach(make: Callable[[], kp.RealMotion], until: float) -> tuple[float, float]:
    """How far the motion goes up to that time, and when the thread goes slack; inf for not yet."""
    slack = make().events("slack", 0.0, until)
    return (float(slack[0]), float(slack[0])) if len(slack) else (until, math.inf)
