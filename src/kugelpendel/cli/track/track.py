"""The track: position, velocity and tension at uniform times, block by block into one file."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.track import formats
from kugelpendel.cli.track.block import Block
from kugelpendel.cli.track.trial import announce, cost

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from kugelpendel import ExactMotion
    from kugelpendel.cli.job_file.sample_times import Grid

FILES = {"csv": "track.csv", "netcdf": "track.nc", "parquet": "track.parquet"}
"""Name of the track by its format."""

FIGURE = "figure.png"

WRITERS = {
    "csv": formats.csv,
    "netcdf": formats.netcdf,
    "parquet": formats.parquet,
}
"""For each format a context that opens a file and lends what appends a block to it."""

BLOCK = 1 << 16
"""Samples held at once: 4 MiB, so that a long track takes no more memory than a short one."""


WORTH_A_TRIAL = 1_000_000
"""Samples; fewer are written in a second or two, and have less than 200 MB."""


def write_track(
    path: Path, motion: ExactMotion, grid: Grid, track_format: str, done: Callable[[int], None]
) -> None:
    """Write a track; what a long or a large one costs is said before.

    Parameters
    ----------
    path
        The file.
    motion
        One motion, not an ensemble.
    grid
        The times.
    track_format
        A key of `FILES`. CSV and Parquet have one column for each of time, x, y, z, vx, vy, vz,
        tension; NetCDF has position and velocity by time and axis. Units are in the CSV header, in
        the metadata of the Parquet fields, and in the NetCDF attributes.
    done
        Told how many samples were written since the last call.
    """
    writer = WRITERS[track_format]
    if grid.count > WORTH_A_TRIAL:
        announce(path.parent, grid, cost(path.parent, motion, grid, writer))
    with writer(path, grid.count) as write:
        for first in range(0, grid.count, BLOCK):
            stop = min(first + BLOCK, grid.count)
            write(Block.of(motion, first, grid.step * np.arange(first, stop, dtype=np.float64)))
            done(stop - first)
