"""``kugelpendel synth``: a track of a known motion, spoilt as cameras spoil it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.fit.asked import number_of, quantity, quantity_of, share
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.job_file.kinds import ANGLE, LENGTH, TIME
from kugelpendel.cli.output import write_file
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_bytes
from kugelpendel.spelling import grouped, spell

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

_STDOUT = Path("-")
_COLOURS = ("white", "slow", "t3")


def synth(options: argparse.Namespace) -> int:
    """Write the track that the options ask for.

    Raises
    ------
    InvalidInput
        Anything wrong with the job, the options or the file. Nothing is left half-written.
    """
    job = read_job(options.file)
    duration = quantity(options, "duration", TIME)
    rate = number_of(options.rate, "--rate", least=0.0)
    with job.document.named():
        motion = kp.RealMotion(job.pendulum, job.launch, job.forces)
    with Progress("Following the pendulum", 1.0) as bar:
        track = kp.tracks.synthesise(
            motion,
            job.grid.duration if duration is None else duration,
            rate,
            noise=quantity_of(options.noise, LENGTH, "--noise"),
            colour=_colour(options.colour),
            noise_ratio=number_of(options.noise_ratio, "--noise-ratio", least=0.0),
            jitter=share(options, "jitter"),
            gaps=[_gap(text) for text in options.gap],
            outliers=share(options, "outliers"),
            tilt=share(options, "tilt"),
            tilt_axis=quantity_of(options.tilt_axis, ANGLE, "--tilt-axis"),
            pixel=quantity(options, "pixel", LENGTH),
            seed=_seed(options.seed),
            done=bar.reach,
        )
    text = "".join(_lines(track))
    out = options.out or Path(f"{job.file.stem}-track.csv")
    if out == _STDOUT:
        write_bytes(text.encode())
        return 0
    write_file(out, text)
    length = spell(float(track.time[-1]), "s", 3)
    print(f"In {out}: {grouped(len(track))} points of {length}, in {track.unit}.")
    return 0


def _lines(track: kp.tracks.Track) -> Iterator[str]:
    """The track as CSV: times to the microsecond, positions to 0.1 µm, or whole pixels."""
    yield f"time (s),x ({track.unit}),y ({track.unit})\n"
    form = "{:.6f},{:.0f},{:.0f}\n" if track.unit == "px" else "{:.6f},{:.7f},{:.7f}\n"
    for row in zip(track.time, track.x, track.y, strict=True):
        yield form.format(*row)


def _colour(text: str) -> kp.tracks.Colour:
    for known in _COLOURS:
        if text == known:
            return known
    try:
        return float(text)
    except ValueError as error:
        raise kp.InvalidInput(
            f"--colour is {text!r}; write one of {', '.join(_COLOURS)}, or a number as 0.8."
        ) from error


def _gap(text: str) -> tuple[float, float]:
    parts = text.split(",")
    if len(parts) != 2:
        raise kp.InvalidInput(f'--gap is {text!r}; write its start and its length, as "60 s,5 s".')
    start, length = (quantity_of(part, TIME, "--gap") for part in parts)
    return start, length


def _seed(text: str) -> int:
    if not text.isascii() or not text.isdigit():
        raise kp.InvalidInput(f"--seed is {text!r}; write a whole number from 0 on.")
    return int(text)
