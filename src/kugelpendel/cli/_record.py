"""The track of a real motion, written while it is integrated; and what was seen on the way."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli._block import Block
from kugelpendel.cli._estimate import Estimate
from kugelpendel.cli._passes import Passes
from kugelpendel.cli._track import BLOCK, WRITERS
from kugelpendel.cli._watch import Watch

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    import kugelpendel as kp
    from kugelpendel.cli._estimate import Wish
    from kugelpendel.cli._grid import Grid
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
    samples, slack, watch = Passes(make), make(), Watch(make, grid.duration)
    swing = 2 * math.pi / float(slack.angular_frequency)
    slack_time = _first(slack.events("slack", 0.0, min(2 * swing, grid.duration)))
    early = np.linspace(0.0, min(2 * swing, grid.duration, slack_time), 401)
    pulls = make().tension(early)
    least, most = float(pulls.min()), float(pulls.max())
    estimate = Estimate(grid.duration)
    now, rows, stretch = 0.0, 0, min(_FIRST * swing, BLOCK * grid.step)
    with WRITERS[track_format](path, None) as write:
        while now < grid.duration and slack_time == math.inf and not wish.stop:
            started = time.monotonic()
            until = min(now + stretch, grid.duration)
            slack_time = _first(slack.events("slack", now, until))
            until = min(until, slack_time)
            last = _rows(grid, until)
            for first in range(rows, last, BLOCK):
                times = grid.step * np.arange(first, min(first + BLOCK, last), dtype=np.float64)
                block = Block.of(samples, first, times)
                least = min(least, float(block.tension.min()))
                most = max(most, float(block.tension.max()))
                write(block)
            rows = max(rows, last)
            watch.advance(until)
            done(until - now)
            now = until
            estimate.after(now)
            pace = _BREATH / max(time.monotonic() - started, 1e-3)
            stretch = min(stretch * min(pace, 4.0), BLOCK * grid.step * 16)
    stopped = wish.stop and now < grid.duration and slack_time == math.inf
    return Record(
        watch.course(), watch.swing_periods, (least, most), rows, now, slack_time, stopped
    )


def _rows(grid: Grid, until: float) -> int:
    """How many samples come no later than that."""
    if until == grid.duration:
        return grid.count
    rows = min(math.floor(until / grid.step) + 1, grid.count)
    return rows if grid.step * (rows - 1) <= until else rows - 1


def _first(times: np.ndarray) -> float:
    return float(times[0]) if len(times) else math.inf
