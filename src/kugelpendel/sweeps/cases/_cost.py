"""How much work and how many bytes a sweep takes, before any of it is done."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from kugelpendel.sweeps.cases._sweep import Sweep

_EXACT, _EXACT_TIME = 0.4e-6, 0.15e-6
_AVERAGED, _AVERAGED_DAY, _AVERAGED_TIME = 15e-6, 40e-6, 0.5e-6
_REAL, _REAL_SWING = 20e-6, 5.5e-6
"""s of one core for a case; and for each time, day or swing of it (benchmarks/sweeps.py)."""

_WORK = 1.0
"""s of one core for a chunk."""

_MOST_BYTES = 1 << 25
"""Of the values of one chunk: memory is that of one chunk for each worker."""

_LARGEST = 1 << 21


def core_seconds(sweep: Sweep) -> float:
    """How long one core takes for one case, s: right to a factor of three on most processors."""
    if sweep.motion == "exact":
        return _EXACT + _EXACT_TIME * len(sweep.times)
    last = sweep.times[-1] if sweep.times else 0.0
    if sweep.motion == "averaged":
        return _AVERAGED + _AVERAGED_DAY * last / 86400 + _AVERAGED_TIME * len(sweep.times)
    length, gravity = _typical(sweep, "pendulum.length", 1.0), 9.8
    swings = last / (2 * math.pi * math.sqrt(max(length, 1e-6) / gravity))
    return _REAL + _REAL_SWING * swings


def usual_chunk(sweep: Sweep) -> int:
    """Cases of a chunk that takes a core about a second: a power of two."""
    by_work = _WORK / core_seconds(sweep)
    by_bytes = _MOST_BYTES / max(bytes_each(sweep), 1)
    most = max(min(by_work, by_bytes, _LARGEST), 1.0)
    return 1 << round(math.log2(most))


def bytes_each(sweep: Sweep) -> int:
    """Bytes of the values of one case, whether they are kept or only reduced."""
    from kugelpendel.sweeps._quantities import QUANTITIES

    timed = sum(QUANTITIES[name].per_time for name in sweep.quantities)
    return 8 * (timed * len(sweep.times) + len(sweep.quantities) - timed)


def bytes_kept(sweep: Sweep) -> int:
    """Bytes that the store takes at most: the values, and one byte of status for each case."""
    from kugelpendel.sweeps._reductions import bytes_reduced

    kept = bytes_each(sweep) * sweep.size if sweep.keeps_all else bytes_reduced(sweep)
    return kept + sweep.size


def _typical(sweep: Sweep, name: str, default: float) -> float:
    """A number in the middle of what varies, or as it is given."""
    law = sweep.varied.get(name)
    if law is None:
        section, _, key = name.partition(".")
        value = sweep.given.get(section, {}).get(key, default)
        return float(value)
    if law.levels is not None:
        return float(law.at(np.array([law.levels // 2]))[0])
    return float(law.drawn(np.array([0.5]))[0])
