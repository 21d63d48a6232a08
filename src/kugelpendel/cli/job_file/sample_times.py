"""The times at which a track is written: 0, step, 2 step, … up to the duration."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.kinds import TIME
from kugelpendel.cli.job_file.quantity import show

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.table import Table

MOST_SAMPLES = 100_000_000
"""More are refused: a file of 6.4 GB in binary is as much as one track can use."""

BYTES_PER_SAMPLE = 8 * 8
"""Time, three of position, three of velocity, tension, in binary64."""


@dataclass(frozen=True)
class Grid:
    """Uniform times from 0 on: step in s, number of samples; the job lasts for duration, in s."""

    duration: float
    step: float
    count: int


def read_grid(table: Table) -> Grid:
    """Duration, and step or samples, of the table ``[output]``.

    Raises
    ------
    InvalidInput
        Nothing positive, neither or both of step and samples, or more than `MOST_SAMPLES`.
    """
    duration = _positive(table, "duration")
    given = [key for key in ("step", "samples") if key in table.entries]
    if len(given) != 1:
        seen = "both step and samples" if given else "neither step nor samples"
        raise InvalidInput(
            f'[output] has {seen}; write one of them, step = "0.1 s" or samples = 1000.'
        )
    if given == ["samples"]:
        count = _samples(table)
        _affordable(count, duration)
        return Grid(duration, duration / (count - 1), count)
    step = _positive(table, "step")
    if step > duration:
        raise InvalidInput(
            f"[output] step = {step:.6g} s is longer than the duration of {duration:.6g} s; "
            "choose a shorter step."
        )
    # A duration that is a whole number of steps but for rounding ends with a sample.
    steps = duration / step * (1 + 1e-12)
    _affordable(steps + 1, duration)
    return Grid(duration, step, math.floor(steps) + 1)


def _positive(table: Table, key: str) -> float:
    value = table.quantity(key, TIME)
    if value <= 0:
        raise InvalidInput(
            f"{table.where(key)} = {show(table.entries[key])} must be longer than zero; "
            f'write a time such as "{"0.1 s" if key == "step" else TIME.example}".'
        )
    return value


def _samples(table: Table) -> int:
    value = table.entries["samples"]
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, int) or value < 2:
        raise InvalidInput(
            f"[output] samples = {show(value)} must be a whole number of at least 2; "
            "write samples = 1000."
        )
    return value


def _affordable(count: float, duration: float) -> None:
    if count <= MOST_SAMPLES:
        return
    way_out = f'step = "{duration / MOST_SAMPLES * 1.01:.2g} s" or longer'
    raise InvalidInput(
        f"[output] asks for {_count(count)} samples, which take {_memory(count)} at "
        f"{BYTES_PER_SAMPLE} bytes each; at most {MOST_SAMPLES:.0e} ({_memory(MOST_SAMPLES)}) are "
        f"written. Choose a longer step or a shorter duration: {way_out}, or samples = 1000."
    )


def _count(count: float) -> str:
    return f"{count:.3g}" if count < math.inf else "more than 1e308"


def _memory(count: float) -> str:
    size = count * BYTES_PER_SAMPLE
    if not size < 1e30:
        return "more memory than there is"
    prefixes = ["", "k", "M", "G", "T", "P", "E", "Z", "Y", "R"]
    step = min(int(math.log10(size) // 3), len(prefixes) - 1)
    return f"{size / 1000**step:.3g} {prefixes[step]}B"
