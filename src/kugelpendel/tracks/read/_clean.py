"""Rows that tell nothing, tell it twice or in disorder, taken out and listed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._cells import Numbers

LEAST = 10
"""Points; a track with fewer has no ellipse."""

_GAP = 1.8
"""Steps that are longer than this many usual ones are gaps: one frame was dropped, or more."""

_SHARED = 0.5
"""Rows at another place than the first of their time, for each time: more are another pendulum."""


def cleaned(time: Numbers, values: Numbers, file: str) -> tuple[Numbers, Numbers, list[Note]]:
    """Sort the rows by time and keep one of each time.

    Parameters
    ----------
    time
        s, NaN where a row has none; shape (n,).
    values
        What was seen at it, NaN where nothing was; shape (n, k).
    file
        For the sentence of an error.

    Returns
    -------
    time, values
        Finite, the time ascending.
    notes
        What was dropped.

    Raises
    ------
    InvalidInput
        Nothing, or next to nothing, remains; or most times have more than one position.
    """
    notes: list[Note] = []
    if not np.isfinite(values).any():
        raise InvalidInput.of("track_nothing_seen", file=file, count=len(time))
    timed = np.isfinite(time)
    if not timed.any():
        raise InvalidInput.of("track_no_time", file=file)
    _note(notes, "rows_without_time", int((~timed & np.isfinite(values).any(axis=1)).sum()))
    seen = np.isfinite(values).all(axis=1)
    _note(notes, "rows_not_seen", int((timed & ~seen).sum()))
    time, values = time[timed & seen], values[timed & seen]
    disordered = int((np.diff(time) < 0).sum())
    if disordered:
        order = np.argsort(time, kind="stable")
        time, values = time[order], values[order]
    first = np.concatenate(([True], np.diff(time) > 0))
    alike = ~first & (
        values == values[np.maximum.accumulate(np.where(first, np.arange(len(time)), 0))]
    ).all(axis=1)
    _note(notes, "rows_doubled", int(alike.sum()))
    elsewhere, times = int((~first & ~alike).sum()), int(first.sum())
    if elsewhere > _SHARED * times:
        raise InvalidInput.of("track_times_shared", file=file, count=elsewhere, times=times)
    _note(notes, "times_doubled", elsewhere)
    time, values = time[first], values[first]
    if disordered:
        notes.append(Note.of("rows_sorted", count=disordered))
    if len(time) < LEAST:
        raise InvalidInput.of("track_too_few", file=file, count=len(time), least=LEAST)
    return time, values, notes


def _note(notes: list[Note], kind: str, count: int) -> None:
    if count:
        notes.append(Note.of(kind, count=count))


def without_marks(x: Numbers, y: Numbers) -> tuple[Numbers, Numbers, list[Note]]:
    """Take out −1, −1 and 0, 0 where these stand for "not found": all other points are beyond."""
    notes: list[Note] = []
    for mark in (-1.0, 0.0):
        marked = (x == mark) & (y == mark)
        others = ~marked & np.isfinite(x) & np.isfinite(y)
        if not marked.any() or not others.any():
            continue
        if min(float(x[others].min()), float(y[others].min())) > mark:
            x, y = np.where(marked, np.nan, x), np.where(marked, np.nan, y)
            notes.append(Note.of("marked_not_found", mark=mark, count=int(marked.sum())))
    return x, y, notes


def without_stale(time: Numbers, places: Numbers, file: str) -> tuple[Numbers, Numbers, list[Note]]:
    """Take out repeated pictures and a standstill at the start.

    A row that repeats the position of the row before, while its neighbours tell that the bob was
    moving, is a picture that was stored twice: it says nothing new, and says it at a wrong time.
    Repetitions near the turning points, where the bob is slow, are kept.

    Raises
    ------
    InvalidInput
        The position never changes.
    """
    notes: list[Note] = []
    steps = np.abs(np.diff(places, axis=0)).max(axis=1)
    if not steps.any():
        raise InvalidInput.of(
            "track_motionless", file=file, x=float(places[0, 0]), y=float(places[0, 1])
        )
    start = int(np.argmax(steps > 0))
    rest = _longest_rest(steps[start:])
    if start >= 3 and start > 2 * rest + 2:
        notes.append(Note.of("standstill", count=start, until=float(time[start])))
        time, places, steps = time[start:], places[start:], steps[start:]
    resolution = float(steps[steps > 0].min())
    across = np.abs(places[2:] - places[:-2]).max(axis=1)  # from the row before to the one after
    stale = np.zeros(len(time), dtype=bool)
    stale[1:-1] = (steps[:-1] == 0) & (across > max(4 * resolution, 0.5 * float(np.median(steps))))
    _note(notes, "pictures_repeated", int(stale.sum()))
    time, places = time[~stale], places[~stale]
    if len(time) < LEAST:
        raise InvalidInput.of("track_too_few", file=file, count=len(time), least=LEAST)
    return time, places, notes


def _longest_rest(steps: Numbers) -> int:
    """How many rows in a row keep their place at most."""
    moving = np.flatnonzero(np.concatenate(([True], steps > 0, [True])))
    return int(np.diff(moving).max()) - 1


def gaps(time: Numbers) -> list[Note]:
    """Tell of steps that are longer than usual; nothing is done about them."""
    steps: NDArray[np.float64] = np.diff(time)
    usual = float(np.median(steps))
    longer = steps > _GAP * usual
    if not longer.any():
        return []
    return [
        Note.of(
            "gaps",
            count=int(longer.sum()),
            longest=float(steps.max()),
            usual=usual,
            share=100 * float((steps[longer] - usual).sum() / (time[-1] - time[0])),
        )
    ]
