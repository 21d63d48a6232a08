"""How much work and how many bytes a sweep takes, before any of it is done."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.sweeps.cases._sweep import Sweep

_SECONDS = {"exact": 0.4e-6, "averaged": 50e-6, "real": 500e-6}
"""s of one core for a case, before anything is tried: the least that is usual."""

_WORK = 1.0
"""s of one core for a chunk."""

_TRIAL = 0.2
"""s of work by which that is judged."""

_MOST_BYTES = 1 << 25
"""Of the values of one chunk: memory is that of one chunk for each worker."""

_LARGEST = 1 << 21

LEAF = 64
"""Cases whose moments are taken together; chunks that are reduced have as many or more."""


def core_seconds(sweep: Sweep) -> float:
    """How long one core takes for a case at least, s, without trying."""
    return _SECONDS[sweep.motion]


def tried_core_seconds(sweep: Sweep, do: Callable[[int, int], object]) -> float:
    """How long one core takes for a case, s, by the cases of a fifth of a second.

    Parameters
    ----------
    do
        Does the cases from the first number to the one before the second, with all threads.
    """
    count, spread = 1, 4
    while True:
        before = time.process_time()
        for k in range(spread):
            start = min(k * sweep.size // spread, max(sweep.size - count, 0))
            do(start, min(start + count, sweep.size))
        taken = time.process_time() - before
        if taken > _TRIAL or count * spread >= sweep.size:
            return taken / (spread * min(count, sweep.size))
        count *= 4


def usual_chunk(sweep: Sweep, seconds: float) -> int:
    """Cases of a chunk that takes a core about a second: a power of two."""
    by_work = _WORK / max(seconds, 1e-9)
    by_bytes = _MOST_BYTES / max(bytes_each(sweep), 1)
    most = max(min(by_work, by_bytes, _LARGEST), 1.0 if sweep.keeps_all else float(LEAF))
    return 1 << round(math.log2(most))


def bytes_each(sweep: Sweep) -> int:
    """Bytes of the values of one case, whether they are kept or only reduced."""
    from kugelpendel.sweeps._quantities import QUANTITIES

    timed = sum(QUANTITIES[name].per_time for name in sweep.quantities)
    return 8 * (timed * len(sweep.times) + len(sweep.quantities) - timed)


def bytes_kept(sweep: Sweep) -> int:
    """Bytes that the store takes at most: the values, and one byte of status for each case."""
    from kugelpendel.sweeps._reductions import bytes_reduced

    if sweep.keeps_all:
        return (bytes_each(sweep) + 1) * sweep.size
    chunks = -(-sweep.size // usual_chunk(sweep, core_seconds(sweep)))
    return sweep.size + bytes_reduced(sweep, chunks)
