"""One chunk of a sweep: the same function for every engine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import MotionEnded
from kugelpendel.motion import EnvelopeMotion, Motion
from kugelpendel.parameters import Numbers
from kugelpendel.sweeps._quantities import measure
from kugelpendel.sweeps._reductions import binned, combined, moments
from kugelpendel.sweeps._store import (
    ENDED,
    GOOD,
    NOT_YET,
    REFUSED,
    SweepStore,
    opened,
    reduced_arrays,
)
from kugelpendel.sweeps.cases import (
    Sweep,
    core_seconds,
    motions,
    tried_core_seconds,
    usual_chunk,
)

if TYPE_CHECKING:
    from kugelpendel.errors import Door, Language

_PIECE = 1 << 16
"""Cases whose motions are in memory at once."""


class Done(NamedTuple):
    """What a chunk has come to: its number, its cases and the bad ones among them."""

    chunk: int
    cases: int
    bad: int


def do_chunk(path: str, chunk: int) -> Done:
    """Do a chunk of the sweep that is stored at a path, and store what it comes to.

    Nothing is handed over but these two, so that a worker elsewhere needs no more.
    """
    store = opened(path)
    start, stop = store.bounds(chunk)
    values, reduced, status = _results(store, start, stop)
    store.write(chunk, values, reduced, status)
    return Done(chunk, stop - start, int(np.count_nonzero(status >= REFUSED)))


def results_of(sweep: Sweep, start: int, stop: int) -> tuple[dict[str, Numbers], NDArray[np.uint8]]:
    """The quantities of the cases from start to stop − 1, and the status of each.

    Shapes (cases,), or (cases, times) of what is read at times; NaN for bad cases.
    """
    motion = motions(sweep.motion, sweep.tables(start, stop))
    times = np.asarray(sweep.times, dtype=np.float64)
    found = measure(motion, sweep.quantities, times)
    status = np.where(motion.status != 0, REFUSED, GOOD).astype(np.uint8)
    if sweep.motion != "exact" and times.size:
        status[(status == GOOD) & _ended(motion, times[-1])] = ENDED
    return found, status


def chunk_for(sweep: Sweep) -> int:
    """Cases of a chunk: as the sweep says, or about a second of work for one core.

    That of exact motions is known; others take a fiftieth to fifty times of what is usual, and are
    tried.
    """
    if sweep.chunk is not None:
        return sweep.chunk
    if sweep.motion == "exact":
        return usual_chunk(sweep, core_seconds(sweep))
    return usual_chunk(
        sweep, tried_core_seconds(sweep, lambda start, stop: results_of(sweep, start, stop))
    )


def why(sweep: Sweep, index: int, language: Language = "en", door: Door = "python") -> str:
    """The sentence of a bad case, made again from its index; "" where it is good.

    Parameters
    ----------
    sweep
        What the case belongs to.
    index
        Of the case.
    language
        "en" or "de".
    door
        "python" for who calls functions, "file" for who writes job files.
    """
    motion = motions(sweep.motion, sweep.tables(index, index + 1))
    if motion.problems:
        return motion.problems.error(0).sentence(language, door)
    if sweep.motion == "exact" or not sweep.times:
        return ""
    try:
        # A motion of its own says when and why it ends, where an ensemble has NaN.
        motion[0].position(sweep.times[-1])
    except MotionEnded as ended:
        return ended.sentence(language, door)
    return ""


def _results(
    store: SweepStore, start: int, stop: int
) -> tuple[dict[str, Numbers], dict[str, NDArray[Any]], NDArray[np.uint8]]:
    """Values to keep, reductions and status of a chunk, made piece by piece."""
    sweep = store.sweep
    kinds = [kind for kind, _, _ in reduced_arrays(sweep)]
    status = np.full(stop - start, NOT_YET, dtype=np.uint8)
    values: dict[str, Numbers] = {}
    fields: dict[str, list[Numbers]] = {}
    bins: dict[str, NDArray[np.uint32]] = {}
    for first in range(start, stop, _PIECE):
        last = min(first + _PIECE, stop)
        piece = slice(first - start, last - start)
        found, status[piece] = results_of(sweep, first, last)
        for name, numbers in found.items():
            if sweep.keeps_all:
                if name not in values:
                    values[name] = np.empty((stop - start, *numbers.shape[1:]))
                values[name][piece] = numbers
            if "moments" in kinds:
                fields.setdefault(f"{name}_moments", []).append(moments(numbers))
            if "bins" in kinds:
                counts = binned(numbers)
                bins[f"{name}_bins"] = counts + bins.get(f"{name}_bins", np.uint32(0))
    united = {name: combined(np.stack(made)) for name, made in fields.items()}
    return values, {**united, **bins}, status


def _ended(motion: Motion, last: float) -> NDArray[np.bool_]:
    """Whether each case of an ensemble has ended before a time."""
    at = np.array([last])
    if isinstance(motion, EnvelopeMotion):
        return np.isnan(motion.semi_axes(at)[:, 0, 0])
    return np.isnan(motion.position(at)[:, 0, 0])
