"""``kugelpendel run``: from a job file to a report, a track, a figure and the results."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli import _results
from kugelpendel.cli._answer import find
from kugelpendel.cli._folder import staged
from kugelpendel.cli._job import LAUNCHES, read_job
from kugelpendel.cli._progress import Progress
from kugelpendel.cli._report import describe_launch, report
from kugelpendel.cli._track import FILES, write_track

if TYPE_CHECKING:
    from kugelpendel.cli._job import Job

FIGURE = "figure.png"


def run(file: Path, folder: Path | None, as_json: bool, track_format: str | None) -> None:
    """Do a job.

    Parameters
    ----------
    file : Path
        The job file.
    folder : Path or None
        Where the files go; ``out/`` and the name of the job, unless given.
    as_json : bool
        Print the results as JSON in place of the report.
    track_format : str or None
        Format of the track, in place of the one in the file.

    Raises
    ------
    InvalidInput
        Anything wrong with the file or the folder. Nothing is left half-written.
    """
    job = read_job(file)
    if track_format is not None:
        job = replace(job, format=track_format)
    try:
        motion = kp.ExactMotion(job.pendulum, job.launch)
    except kp.InvalidInput as error:
        raise kp.InvalidInput(f"{file}: {error}") from error
    answer = find(motion)
    target = folder if folder is not None else Path("out") / file.stem
    track = FILES[job.format]
    files = [track, FIGURE] if job.figure else [track]
    results = _results.as_json(job, answer, LAUNCHES[job.kind], files)
    with staged(target, (*FILES.values(), FIGURE, _results.FILE)) as temporary:
        with Progress("Writing the track", job.grid.count) as progress:
            write_track(temporary / track, motion, job.grid, job.format, progress.advance)
        if job.figure:
            title = f"{_capitalised(file.stem)}: {describe_launch(job)}"
            figure = plot.overview(motion, job.grid.duration, answer.formula_25, title)
            plot.save(figure, temporary / FIGURE)
        (temporary / _results.FILE).write_text(results, encoding="utf-8")
    if as_json:
        sys.stdout.write(results)
    else:
        print(report(job, answer))
        print(f"\n{_written(job, target, files)}")


def _written(job: Job, target: Path, files: list[str]) -> str:
    samples = f"{job.grid.count:,}".replace(",", " ")
    named = [f"{files[0]} ({samples} samples)", *files[1:], _results.FILE]
    return f"In {target}: {', '.join(named)}"


def _capitalised(stem: str) -> str:
    words = stem.replace("-", " ").replace("_", " ")
    return words[:1].upper() + words[1:]
