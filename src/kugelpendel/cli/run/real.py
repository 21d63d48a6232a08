"""``kugelpendel run`` for a real pendulum: the Earth turns, the air brakes, the thread is held.

All files appear together at the end, or none, as for an ideal pendulum; with one exception, since a
real job may run for long: when the user interrupts it, the track as far as it is written, and the
results up to there, go into a folder of their own beside, DIR-interrupted. Every file in it is
whole, and DIR is as it was.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.output import staged
from kugelpendel.cli.run import ideal_json
from kugelpendel.cli.run.real_json import real_json
from kugelpendel.cli.run.real_report import real_report
from kugelpendel.cli.run.real_results import RealResults
from kugelpendel.cli.terminal.describe import describe_launch
from kugelpendel.cli.terminal.estimate import StopRequest
from kugelpendel.cli.terminal.interrupted import Interrupted
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import complain
from kugelpendel.cli.track.block import Block
from kugelpendel.cli.track.track import BLOCK, FIGURE, FILES, WORTH_A_TRIAL, WRITERS
from kugelpendel.cli.track.trial import LARGE, ROWS, require_room
from kugelpendel.observables import Follower, RealSummary, explain
from kugelpendel.spelling import grouped, spell, spell_bytes

if TYPE_CHECKING:
    from pathlib import Path

    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.job_file.sample_times import Grid

_FILES = (*FILES.values(), FIGURE, ideal_json.FILE)

_BREATH = 0.2
"""s of work between two looks at the clock and at whether the user wants to stop."""


def run_real(job: Job, target: Path, title: str) -> tuple[str, str, list[str]]:
    """Do a job with forces.

    Parameters
    ----------
    job
        With at least one of the tables of a real pendulum.
    target
        Where the files go.
    title
        Above the figure.

    Returns
    -------
    results
        As JSON.
    report
        For the terminal.
    files
        With their sizes, as they are named to the user.

    Raises
    ------
    InvalidInput
        What the motion or the folder refuses. Nothing is left half-written.
    Interrupted
        The user asked to stop; the sentence says what is kept, and where.
    """
    motion = real_motion(job)
    track = FILES[job.format]
    writes = (track, FIGURE, ideal_json.FILE) if job.figure else (track, ideal_json.FILE)
    with staged(target, _FILES, writes) as temporary:
        with StopRequest() as request:
            summary, samples = _follow(job, motion, temporary / track, request)
            explanation = explain(motion, summary)
        results = RealResults(summary, explanation, samples, request.stop)
        files = [track]
        if request.stop:
            _keep(job, results, temporary, _aside(target))
        if job.figure and len(summary.apsides.times) > 1:
            heading = f"{title}: {describe_launch(job)}"
            try:
                figure = plot.day(motion, summary.apsides, explanation.shares, heading)
                plot.save(figure, temporary / FIGURE)
            except KeyboardInterrupt:  # the track, which took long, is kept all the same
                _keep(job, replace(results, stopped=True), temporary, _aside(target))
            files.append(FIGURE)
        text = real_json(job, results, files)
        (temporary / ideal_json.FILE).write_text(text, encoding="utf-8")
    return text, real_report(job, results), _named(samples, files)


def _follow(
    job: Job, motion: kp.RealMotion, path: Path, request: StopRequest
) -> tuple[RealSummary, int]:
    """Write the track in one pass over the motion, until the job, the motion or the user ends it.

    Everything that the summary needs is noted on the way, with a bar for who waits.
    """
    grid, rows = job.grid, 0
    end = grid.duration
    follower = Follower(motion)
    asked = grid.count <= WORTH_A_TRIAL
    with (
        Progress("Following the pendulum", end, "keeps") as progress,
        WRITERS[job.format](path, None) as write,
    ):
        while follower.time < end and not follower.ending and not request.stop:
            until = min(follower.time + BLOCK * grid.step, end)
            times = grid.step * np.arange(rows, _rows(grid, until), dtype=np.float64)
            leg = follower.to(until, times, within=_BREATH)
            if leg.ending and leg.until == 0:
                with job.document.named():
                    raise kp.InvalidInput(
                        "The thread is slack at the launch, so there is no motion; start lower or "
                        "faster."
                    )
            if len(leg.times):
                write(Block(rows, leg.times, leg.position, leg.velocity, leg.tension))
            rows += len(leg.times)
            if not asked and rows >= ROWS:
                asked = True
                size = path.stat().st_size / rows * grid.count
                require_room(path.parent, grid, size)
                if size > LARGE:
                    complain(f"the track takes about {spell_bytes(size, 2)}.")
            progress.advance(leg.until - leg.start)
    return follower.summary(), rows


def _rows(grid: Grid, until: float) -> int:
    """How many samples come no later than that."""
    if until == grid.duration:
        return grid.count
    rows = min(math.floor(until / grid.step) + 1, grid.count)
    return rows if grid.step * (rows - 1) <= until else rows - 1


def real_motion(job: Job) -> kp.RealMotion:
    """The motion of a job under all of its forces.

    Raises
    ------
    InvalidInput
        With the name of the file.
    """
    with job.document.named():
        return kp.RealMotion(job.pendulum, job.launch, job.forces)


def averaged_motion(job: Job) -> kp.EnvelopeMotion:
    """The averaged motion of a job under all of its forces."""
    return kp.EnvelopeMotion(job.pendulum, job.launch, job.forces)


def _keep(job: Job, results: RealResults, temporary: Path, folder: Path) -> None:
    """Put what is done into a folder of its own and leave."""
    if results.samples == 0:
        raise Interrupted("interrupted before the first sample; nothing is written.")
    track = FILES[job.format]
    with staged(folder, _FILES) as kept:
        (temporary / track).rename(kept / track)
        text = real_json(job, results, [track])
        (kept / ideal_json.FILE).write_text(text, encoding="utf-8")
    raise Interrupted(
        f"interrupted after {spell(results.summary.until, 's', 3)} of "
        f"{spell(job.grid.duration, 's', 3)}; in {folder}: "
        f"{', '.join(_named(results.samples, [track]))}."
    )


def _aside(target: Path) -> Path:
    """Where an interrupted job goes: beside its folder, or into it if that is the present one."""
    return target.with_name(f"{target.name}-interrupted") if target.name else target / "interrupted"


def _named(samples: int, files: list[str]) -> list[str]:
    return [f"{files[0]} ({grouped(samples)} samples)", *files[1:], ideal_json.FILE]
