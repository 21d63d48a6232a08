"""``kugelpendel run`` for a real pendulum: the Earth turns, the air brakes, the thread is held.

All files appear together at the end, or none, as for an ideal pendulum; with one exception, since a
real job may run for long: when the user interrupts it, the track as far as it is written, and the
results up to there, go into a folder of their own beside, DIR-interrupted. Every file in it is
whole, and DIR is as it was.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.output import staged
from kugelpendel.cli.run import ideal_json
from kugelpendel.cli.run.findings import find
from kugelpendel.cli.run.real_json import real_json
from kugelpendel.cli.run.real_report import real_report
from kugelpendel.cli.run.record import record
from kugelpendel.cli.terminal.describe import describe_launch
from kugelpendel.cli.terminal.estimate import Wish
from kugelpendel.cli.terminal.interrupted import Interrupted
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.track.track import FIGURE, FILES
from kugelpendel.motion import refuse_pumping
from kugelpendel.spelling import spell

if TYPE_CHECKING:
    from pathlib import Path

    from kugelpendel.cli.job_file.job import Job
    from kugelpendel.cli.run.findings import Findings
    from kugelpendel.cli.run.record import Record

_FILES = (*FILES.values(), FIGURE, ideal_json.FILE)


def run_real(job: Job, target: Path, title: str) -> tuple[str, str, list[str]]:
    """Do a job with forces.

    Parameters
    ----------
    job : Job
        With at least one of the tables of a real pendulum.
    target : Path
        Where the files go.
    title : str
        Above the figure.

    Returns
    -------
    results : str
        As JSON.
    report : str
        For the terminal.
    files : list of str
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
    with staged(target, _FILES) as temporary, Wish() as wish:
        seen = _follow(job, temporary / track, wish)
        found = find(job.setup, job.launch, motion, seen)
        files = [track]
        if seen.stopped:
            _keep(job, found, temporary, _aside(target))
        if job.figure and len(seen.course.times) > 1:
            figure = plot.day(motion, seen.course, found.shares, f"{title}: {describe_launch(job)}")
            plot.save(figure, temporary / FIGURE)
            files.append(FIGURE)
        results = real_json(job, found, files)
        (temporary / ideal_json.FILE).write_text(results, encoding="utf-8")
    return results, real_report(job, found), _named(seen, files)


def _follow(job: Job, track: Path, wish: Wish) -> Record:
    """Write the track, with a bar for who waits."""
    with Progress("Following the pendulum", job.grid.duration) as progress:
        try:
            return record(
                track, lambda: real_motion(job), job.grid, job.format, wish, progress.advance
            )
        except kp.InvalidInput as error:
            raise kp.InvalidInput(f"{job.file}: {error}") from error


def real_motion(job: Job) -> kp.RealMotion:
    """The motion of a job under all of its forces.

    Raises
    ------
    InvalidInput
        With the name of the file.
    """
    setup = job.setup
    try:
        refuse_pumping(job.pendulum, job.launch, setup.drag, setup.drive)
        return kp.RealMotion(
            job.pendulum,
            job.launch,
            site=setup.site,
            drag=setup.drag,
            suspension=setup.suspension,
            bob=setup.bob,
            drive=setup.drive,
        )
    except kp.InvalidInput as error:
        raise kp.InvalidInput(f"{job.file}: {error}") from error


def _keep(job: Job, found: Findings, temporary: Path, folder: Path) -> None:
    """Put what is done into a folder of its own and leave."""
    seen = found.record
    if seen.samples == 0:
        raise Interrupted("interrupted before the first sample; nothing is written.")
    track = FILES[job.format]
    with staged(folder, _FILES) as kept:
        (temporary / track).rename(kept / track)
        results = real_json(job, found, [track])
        (kept / ideal_json.FILE).write_text(results, encoding="utf-8")
    raise Interrupted(
        f"interrupted after {spell(seen.until, 's', 3)} of {spell(job.grid.duration, 's', 3)}; "
        f"in {folder}: {', '.join(_named(seen, [track]))}."
    )


def _aside(target: Path) -> Path:
    """Where an interrupted job goes: beside its folder, or into it if that is the present one."""
    return target.with_name(f"{target.name}-interrupted") if target.name else target / "interrupted"


def _named(seen: Record, files: list[str]) -> list[str]:
    samples = f"{seen.samples:,}".replace(",", " ")
    return [f"{files[0]} ({samples} samples)", *files[1:], ideal_json.FILE]
