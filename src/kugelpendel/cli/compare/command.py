"""``kugelpendel compare``: all motions of a job beside the exact one."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.compare.report import comparison_report
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.output import staged
from kugelpendel.cli.terminal.describe import describe_launch
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_json

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.job import Job

FIGURE = "comparison.png"
RESULTS = "comparison.json"


def compare(file: Path, folder: Path | None, as_json: bool) -> None:
    """Compare the motions over the duration of a job.

    Parameters
    ----------
    file
        The job file.
    folder
        Where the files go; ``out/`` and the name of the job, unless given.
    as_json
        Print the results as JSON in place of the table.

    Raises
    ------
    InvalidInput
        Anything wrong with the file or the folder. Nothing is left half-written.
    """
    job = read_job(file)
    if job.is_real:
        tables = ", ".join(f"[{name}]" for name in job.forces.parts)
        raise kp.InvalidInput(
            f"{job.file}: the motions that are compared know no forces but gravity, and the job "
            f"has {tables}; leave that out, or use `kugelpendel run`."
        )
    with job.document.named():
        comparison = _compared(job)
    target = folder if folder is not None else Path("out") / job.file.stem
    results = _as_json(job, comparison)
    with staged(target, (FIGURE, RESULTS)) as temporary:
        if job.figure:
            title = f"Errors against the exact motion: {describe_launch(job)}"
            plot.save(plot.compared(comparison, title), temporary / FIGURE)
        (temporary / RESULTS).write_text(results, encoding="utf-8")
    if as_json:
        write_json(results)
    else:
        print(comparison_report(job, comparison))
        files = [FIGURE, RESULTS] if job.figure else [RESULTS]
        print(f"\nIn {target}: {', '.join(files)}")


def _compared(job: Job) -> kp.Comparison:
    with Progress("Following the motions", 1.0) as progress:
        return kp.compare(job.pendulum, job.launch, job.grid.duration, done=progress.reach)


def _as_json(job: Job, comparison: kp.Comparison) -> str:
    tables: dict[str, Any] = {
        "about": "kugelpendel: each motion beside the exact one; SI units, named in the keys; "
        "relative errors are approximate over exact, less 1; amplitude_m is the outer turning "
        "radius, or the length where the path rises above the support; null is not there",
        "job": job.file.name,
        "duration_s": float(comparison.times[-1]),
        "times_compared": len(comparison.times),
        "amplitude_m": comparison.amplitude,
        "exact": {
            "frequency_rad_per_s": float(comparison.exact.frequency),
            "precession_rad_per_s": float(comparison.exact.precession),
        },
        "motions": {
            row.name: {
                "equation": row.equation,
                "holds": row.trust or None,
                "why_it_does_not_apply": row.reason or None,
                "caution": row.caution or None,
                "largest_error_m": row.largest,
                "final_error_m": row.final,
                "period_relative_error": row.period,
                "precession_relative_error": row.precession,
            }
            for row in comparison.rows
        },
    }
    return json_text(tables)
