"""How long a track takes and how large it gets, found by writing a little of it."""

from __future__ import annotations

import shutil
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel import InvalidInput
from kugelpendel.cli.terminal.streams import complain
from kugelpendel.cli.track.block import Block
from kugelpendel.spelling import grouped, spell, spell_bytes

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager
    from pathlib import Path

    from kugelpendel import ExactMotion
    from kugelpendel.cli.job_file.sample_times import Grid
    from kugelpendel.cli.track.formats import Write

    Writer = Callable[[Path, int | None], AbstractContextManager[Write]]

ROWS = 1 << 14
"""Of a trial: some 2 MB of text, written in less than a tenth of a second."""

WORTH_SAYING = 10.0
"""s; tracks that are written sooner are not announced, unless they are large."""

LARGE = 1e9
"""Bytes that are worth a sentence."""


@dataclass(frozen=True)
class Cost:
    """The cost of a track.

    Attributes
    ----------
    seconds
        To work out and to write.
    size
        Bytes of the file.
    """

    seconds: float
    size: float


def cost(folder: Path, motion: ExactMotion, grid: Grid, writer: Writer) -> Cost:
    """Write rows from all over a track into a file that is removed again, and take the whole to it.

    Parameters
    ----------
    folder
        Where there is room for a trial.
    motion
        One motion, not an ensemble.
    grid
        The times of the whole.
    writer
        That of the format.
    """
    rows = min(ROWS, grid.count)
    times = grid.step * np.linspace(0, grid.count - 1, rows).round()
    path = folder / "trial"
    try:
        started = time.monotonic()
        with writer(path, rows) as write:
            write(Block.of(motion, 0, times))
        taken = time.monotonic() - started
        size = path.stat().st_size
    finally:
        path.unlink(missing_ok=True)
    return Cost(taken * grid.count / rows, size * grid.count / rows)


def require_room(folder: Path, grid: Grid, size: float) -> None:
    """Raise InvalidInput unless the disk has room for a track of so many bytes."""
    free = shutil.disk_usage(folder).free
    if size > free:
        fit = int(free / size * grid.count * 0.9)
        raise InvalidInput(
            f"the track of {grouped(grid.count)} samples would take about {spell_bytes(size)},"
            f" and the disk has {spell_bytes(free)} free; choose samples = {max(fit, 2)} or fewer, "
            "a binary format, or another disk with --out."
        )


def announce(folder: Path, grid: Grid, cost: Cost) -> None:
    """Say what a long or large track costs, before it is written.

    Raises
    ------
    InvalidInput
        The disk has no room for it.
    """
    require_room(folder, grid, cost.size)
    if cost.seconds > WORTH_SAYING or cost.size > LARGE:
        complain(
            f"this takes about {spell(cost.seconds, 's', 2)} and writes about "
            f"{spell_bytes(cost.size, 2)}; Ctrl-C leaves everything as it was."
        )
