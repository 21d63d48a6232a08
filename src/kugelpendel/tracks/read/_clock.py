"""From what a file says of time to seconds that ascend."""

from __future__ import annotations

import datetime
import re
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._cells import Numbers
from kugelpendel.tracks.read._columns import Column, time_of, unit_in

_DAY = 86400.0
_EPOCHS = ((1e17, 1e-9, "ns"), (1e14, 1e-6, "µs"), (1e11, 1e-3, "ms"), (1e8, 1.0, "s"))
"""From which number on a time counts from 1970, and in what: 1e8 s are the year 1973, and a track
that is three years long has other troubles."""

_DATE = re.compile(r"(\d{1,4})([-/.])(\d{1,2})\2(\d{1,4})")
_CLOCK = re.compile(
    r"(\d{1,2}):(\d{2})(?::(\d{2}))?(?:[.,](\d*))?\s*(?:([AaPp])\.?[Mm]\.?)?\s*"
    r"(Z|UTC|[+-]\d{2}:?\d{2})?"
)


def seconds(
    time: Column | None,
    date: Column | None,
    frame: Column | None,
    rate: float | None,
    count: int,
    file: str,
) -> tuple[Numbers, list[Note]]:
    """The times of all rows in s, NaN where a row has none.

    Parameters
    ----------
    time, date, frame
        The columns that tell it, as far as they are there.
    rate
        Frames a second, or None.
    count
        How many rows there are.
    file
        For the sentence of an error.

    Raises
    ------
    InvalidInput
        Nothing tells the time.
    """
    notes: list[Note] = []
    if rate is not None:
        counted = frame if frame is not None else _as_frames(time)
        if counted is None:
            notes.append(Note.of("rows_are_frames", rate=rate))
            return np.arange(count) / rate, notes
        if time is not None and counted is not time:
            notes.append(Note.of("time_by_rate", name=time.name, rate=rate))
        notes.append(Note.of("frames", name=counted.name, rate=rate))
        return counted.numbers / rate, notes
    if time is None and date is not None and date.texts and any(":" in t for t in date.texts[:9]):
        time, date = date, None
    if time is None or (time.texts is None and time_of(time.unit) == 0):
        raise InvalidInput.of("track_no_rate" if (frame or time) else "track_no_time", file=file)
    if time.texts is not None:
        return _by_clock(time.texts, date.texts if date is not None else None)
    return _by_number(time, notes), notes


def _as_frames(time: Column | None) -> Column | None:
    """The column of times itself, where it counts frames."""
    if time is None or time.texts is not None:
        return None
    values = time.numbers[np.isfinite(time.numbers)]
    whole = len(values) > 1 and bool((values == np.rint(values)).all())
    return time if whole and float(np.median(np.diff(values))) < 5 else None


def _by_number(time: Column, notes: list[Note]) -> Numbers:
    values = time.numbers
    finite = values[np.isfinite(values)]
    size = time_of(time.unit)
    largest = float(np.abs(finite).max()) if len(finite) else 0.0
    for start, unit_size, symbol in _EPOCHS:
        if largest > start and size in (None, unit_size):
            first = float(finite.min())
            since = datetime.datetime.fromtimestamp(first * unit_size, datetime.UTC)
            notes.append(Note.of("epoch", unit=symbol, start=f"{since:%Y-%m-%d %H:%M:%S} UTC"))
            return (values - first) * unit_size
    if size is None:
        size, symbol = _guessed(finite, unit_in(time.name))
        notes.append(Note.of("time_unit_assumed", unit=symbol, name=time.name or "1"))
    elif size != 1:
        notes.append(Note.of("time_unit", unit=time.unit, size=size))
    return values * size


def _guessed(values: Numbers, said: str) -> tuple[float, str]:
    """Seconds, unless whole numbers in steps that no camera needs for a frame tell otherwise."""
    if said and (size := time_of(said)):
        return size, said
    steps = np.diff(values)
    steps = steps[steps > 0]
    step = float(np.median(steps)) if len(steps) else 0.0
    if len(values) and bool((values == np.rint(values)).all()):
        if step >= 3000:
            return 1e-6, "µs"
        if step >= 3 and step < 1000:
            return 1e-3, "ms"
    return 1.0, "s"


def _by_clock(clocks: Sequence[str], dates: Sequence[str] | None) -> tuple[Numbers, list[Note]]:
    """Times out of clock times and dates, across midnight and changes of summer time."""
    notes: list[Note] = []
    texts = clocks if dates is None else [f"{d} {c}" for d, c in zip(dates, clocks, strict=True)]
    orders = {match for text in texts[:: max(1, len(texts) // 500)] if (match := _order(text))}
    day_first = "day" in orders or "month" not in orders
    has_date = any(_DATE.search(text) for text in texts[:20])
    values = np.array([_moment(text, day_first) for text in texts])
    if has_date:
        if "either" in orders and not orders & {"day", "month"}:
            notes.append(Note.of("day_first_assumed"))
        has_zone = any(re.search(r"(Z|UTC|[+-]\d{2}:?\d{2})$", text.strip()) for text in texts[:20])
        if not has_zone:
            values, jumps = _without_summer_time(values)
            if jumps:
                notes.append(Note.of("summer_time", count=jumps))
    else:
        finite = np.isfinite(values)
        steps = np.diff(values[finite])
        turns = np.concatenate(([0.0], np.cumsum(steps < -_DAY / 2) - np.cumsum(steps > _DAY / 2)))
        if len(turns) and turns[-1] > 0:
            values[finite] += _DAY * turns[: int(finite.sum())]
            notes.append(Note.of("midnight", count=int(turns[-1])))
    first = float(np.nanmin(values)) if np.isfinite(values).any() else 0.0
    start = texts[int(np.nanargmin(values))] if np.isfinite(values).any() else ""
    notes.append(Note.of("clock", start=start.strip()))
    return values - first, notes


def _order(text: str) -> str:
    match = _DATE.search(text)
    if match is None or len(match[1]) == 4 or match[2] == ".":
        return "" if match is None or match[2] != "." else "day"
    if int(match[1]) > 12:
        return "day"
    return "month" if int(match[3]) > 12 else "either"


def _moment(text: str, day_first: bool) -> float:
    """Of a text in s: since the year 1 with a date, since midnight without; NaN for none."""
    date = _DATE.search(text)
    rest = text if date is None else text[: date.start()] + text[date.end() :].lstrip("T ")
    clock = _CLOCK.search(rest)
    if clock is None and date is None:
        return np.nan
    days = 0.0 if date is None else _days(date[0], day_first)
    if clock is None:
        return days * _DAY
    hours, minutes, third = int(clock[1]), int(clock[2]), clock[3]
    share = float(f"0.{clock[4]}") if clock[4] else 0.0
    if third is None and clock[4] is not None:  # minutes and seconds of a stop-watch
        return days * _DAY + 60 * hours + minutes + share
    if clock[5]:
        hours = hours % 12 + (12 if clock[5] in "Pp" else 0)
    value = days * _DAY + 3600 * hours + 60 * minutes + int(third or 0) + share
    return value - _offset(clock[6])


def _offset(zone: str | None) -> float:
    if zone is None or zone in ("Z", "UTC"):
        return 0.0
    digits = zone.replace(":", "")
    return (-1 if zone[0] == "-" else 1) * (3600 * int(digits[1:3]) + 60 * int(digits[3:5]))


@lru_cache(maxsize=1024)
def _days(text: str, day_first: bool) -> float:
    parts = [int(part) for part in re.split(r"[-/.]", text)]
    if parts[0] > 31:
        year, month, day = parts
    else:
        day, month, year = parts if day_first else (parts[1], parts[0], parts[2])
    if year < 100:
        year += 2000
    try:
        return float(datetime.date(year, month, day).toordinal())
    except ValueError:
        return np.nan


def _without_summer_time(values: Numbers) -> tuple[Numbers, int]:
    """Take out jumps of just an hour on a Sunday between midnight and four, which clocks make."""
    steps = np.diff(values)
    usual = float(np.nanmedian(np.abs(steps))) if len(steps) else np.nan
    if not usual < 900:
        return values, 0
    count, values = 0, values.copy()
    for sign in (1, -1):
        for at in np.flatnonzero(np.abs(steps - sign * 3600) < 0.5 * usual + 2):
            day = datetime.date.fromordinal(int(values[at] // _DAY))
            if day.weekday() == 6 and values[at] % _DAY < 4 * 3600:
                values[at + 1 :] -= sign * 3600
                count += 1
    return values, count
