"""The times at which a track is written: 0, step, 2 step, … up to the duration."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.entries import Mistake
from kugelpendel.cli.job_file.quantity import show
from kugelpendel.spelling import spell_bytes

if TYPE_CHECKING:
    from kugelpendel.cli.job_file.entries import Entries

MOST_SAMPLES = 100_000_000
"""More are refused: a file of 6.4 GB in binary is as much as one track can use."""

BYTES_PER_SAMPLE = 8 * 8
"""Time, three of position, three of velocity, tension, in binary64."""


@dataclass(frozen=True)
class Grid:
    """Uniform times from 0 on.

    Attributes
    ----------
    duration
        How long the job lasts, s.
    step
        From one sample to the next, s.
    count
        Number of samples.
    """

    duration: float
    step: float
    count: int


def read_grid(output: Entries) -> Grid:
    """Read duration, and step or samples, of the table ``[output]``.

    Raises
    ------
    InvalidInput
        Nothing positive, neither of step and samples, or more than `MOST_SAMPLES`.
    """
    duration = _positive(output, "duration")
    if "samples" in output:
        count = _samples(output)
        _affordable(count, duration, "samples")
        return Grid(duration, duration / (count - 1), count)
    if "step" not in output:
        raise _mistake(
            'has neither step nor samples; write one of them, step = "0.1 s" or samples = 1000.'
        )
    step = _positive(output, "step")
    if step > duration:
        raise _mistake(
            f"step = {step:.6g} s is longer than the duration of {duration:.6g} s; choose a "
            "shorter step.",
            "step",
        )
    # A duration that is a whole number of steps but for rounding ends with a sample.
    steps = duration / step * (1 + 1e-12)
    _affordable(steps + 1, duration, "step")
    return Grid(duration, step, math.floor(steps) + 1)


def _positive(output: Entries, key: str) -> float:
    value = output.number(key)
    if value <= 0:
        example = "0.1 s" if key == "step" else "10 min"
        seen = show(output.values[key])
        raise _mistake(
            f'{key} = {seen} must be longer than zero; write a time such as "{example}".', key
        )
    return value


def _samples(output: Entries) -> int:
    value: object = output.values["samples"]
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, int) or value < 2:
        raise _mistake(
            f"samples = {show(value)} must be a whole number of at least 2; write samples = 1000.",
            "samples",
        )
    return value


def _affordable(count: float, duration: float, key: str) -> None:
    if count <= MOST_SAMPLES:
        return
    way_out = f'step = "{duration / MOST_SAMPLES * 1.01:.2g} s" or longer'
    raise _mistake(
        f"asks for {_count(count)} samples, which take {_memory(count)} at {BYTES_PER_SAMPLE} "
        f"bytes each; at most {MOST_SAMPLES:.0e} ({_memory(MOST_SAMPLES)}) are written. Choose a "
        f"longer step or a shorter duration: {way_out}, or samples = 1000.",
        key,
    )


def _mistake(said: str, key: str = "") -> Mistake:
    """What is wrong with the table: in English, which is what all commands with a track speak."""
    return Mistake.placed(InvalidInput(f"[output] {said}"), "output", key)


def _count(count: float) -> str:
    return f"{count:.3g}" if count < math.inf else "more than 1e308"


def _memory(count: float) -> str:
    size = count * BYTES_PER_SAMPLE
    return spell_bytes(size) if size < 1e30 else "more memory than there is"
