"""``kugelpendel run``: from a job file to a report, a track, a figure and the results."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.output import staged
from kugelpendel.cli.run import ideal_json
from kugelpendel.cli.run.ideal_report import report
from kugelpendel.cli.run.real import run_real
from kugelpendel.cli.terminal.describe import describe_launch
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_json
from kugelpendel.cli.track.track import FIGURE, FILES, write_track

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job


def run(file: Path, folder: Path | None, as_json: bool, track_format: str | None) -> None:
    """Do a job.

    Parameters
    ----------
    file
        The job file; ``-`` for standard input.
    folder
        Where the files go; ``out/`` and the name of the job, unless given.
    as_json
        Print the results as JSON in place of the report.
    track_format
        Format of the track, in place of the one in the file.

    Raises
    ------
    InvalidInput
        Anything wrong with the file or the folder. Nothing is left half-written.
    """
    job = read_job(file)
    if track_format is not None:
        job = replace(job, format=track_format)
    target = folder if folder is not None else Path("out") / job.file.stem
    do = run_real if job.is_real else _run_ideal
    results, said, files = do(job, target, _capitalised(job.file.stem))
    if as_json:
        write_json(results)
    else:
        print(said)
        print(f"\nIn {target}: {', '.join(files)}")


def _run_ideal(job: Job, target: Path, title: str) -> tuple[str, str, list[str]]:
    """As `run_real`, for a job without forces: the exact motion in closed form."""
    with job.document.named():
        motion = kp.ExactMotion(job.pendulum, job.launch)
    summary = kp.IdealSummary.of(motion)
    track = FILES[job.format]
    files = [track, FIGURE] if job.figure else [track]
    results = ideal_json.as_json(job, summary, files)
    replaced = (*FILES.values(), FIGURE, ideal_json.FILE)
    with staged(target, replaced, (*files, ideal_json.FILE)) as temporary:
        with Progress("Writing the track", job.grid.count, ctrl_c=None) as progress:
            write_track(temporary / track, motion, job.grid, job.format, progress.advance)
        if job.figure:
            title = f"{title}: {describe_launch(job)}"
            figure = plot.overview(motion, job.grid.duration, summary.formula_25, title)
            plot.save(figure, temporary / FIGURE)
        (temporary / ideal_json.FILE).write_text(results, encoding="utf-8")
    samples = f"{job.grid.count:,}".replace(",", " ")
    named = [f"{files[0]} ({samples} samples)", *files[1:], ideal_json.FILE]
    return results, report(job, summary), named


def _capitalised(stem: str) -> str:
    words = stem.replace("-", " ").replace("_", " ")
    return words[:1].upper() + words[1:]
