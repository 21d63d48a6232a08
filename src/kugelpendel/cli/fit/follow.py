"""``kugelpendel fit --follow``: a line each swing, while a logger appends to a file for weeks.

Each line is the ellipse over the latest window of swings. Until six such windows are there they are
shorter, and a line is not told each swing. The lines are kept in a file of their own, and beside it
the place in the recording from which the latest ones can be made again; so a restart goes on where
the last run ended, whatever ended it.
"""

from __future__ import annotations

import csv
import json
import math
import os
import time
from collections import deque
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.fit.numbers import Shown
from kugelpendel.cli.fit.words import words
from kugelpendel.cli.output import write_file
from kugelpendel.cli.terminal.interrupted import Interrupted
from kugelpendel.spelling import spell, spell_rate
from kugelpendel.tracks.read import Appended, Place

if TYPE_CHECKING:
    from collections.abc import Iterator

    import xarray as xr

    from kugelpendel.cli.fit.asked import Asked
    from kugelpendel.errors import Language
    from kugelpendel.parameters import Numbers

LINES = "swings.csv"
STATE = "follow.json"

_HEAD = (
    *("time (s)", "a", "b", "azimuth (rad)", "a_stderr", "b_stderr", "azimuth_stderr (rad)"),
    *("rate (rad/s)", "unit"),
)
_WINDOWS = 6
"""Windows of swings that are kept: they tell the noise, and their slope the rate."""

_PAUSE = 0.5
"""s between two looks at a file that has not grown."""

_FEWEST = 60
"""Points without which nothing is tried."""


def follow(file: Path, asked: Asked, folder: Path | None, idle: float = math.inf) -> int:
    """Print a line each swing until interrupted, or until the file has not grown for so long.

    Parameters
    ----------
    file
        To which a logger appends.
    asked
        How it is to be read.
    folder
        Where the lines are kept; ``out/`` and the name of the file, unless given.
    idle
        s after which a file that does not grow ends the work.

    Raises
    ------
    InvalidInput
        The file cannot be followed, or the folder has lines of another file.
    Interrupted
        The user asked to stop; the sentence says what is kept.
    """
    target = folder if folder is not None else Path("out") / file.stem
    kept = _Kept(target, file)
    window = _Window(asked.swings)
    window.last, window.azimuth = kept.last, kept.azimuth
    rows = Appended(file, asked.reading, kept.place)
    places: deque[Place] = deque()
    patience, waited = idle, time.monotonic()
    try:
        with kept.opened() as lines:
            _print_head(asked.language)
            while True:
                track = rows.more()
                if track is None:
                    if time.monotonic() - waited > patience:
                        return 0
                    time.sleep(min(_PAUSE, patience))
                    continue
                waited = time.monotonic()
                for swing in window.add(track):
                    lines.write(swing)
                    _print(swing, asked.language)
                if rows.place is not None:
                    places.append(rows.place)
                while len(places) > 1 and places[1].time <= window.start:
                    places.popleft()
                kept.remember(places[0] if places and places[0].time <= window.start else None)
    except KeyboardInterrupt as interruption:
        said = words(asked.language)["follow_interrupted"]
        raise Interrupted(said.format(count=kept.count, file=target / LINES)) from interruption


@dataclass(frozen=True)
class Swing:
    """The ellipse around one swing, and how fast it turned over the swings before."""

    time: float
    a: float
    b: float
    azimuth: float
    a_stderr: float
    b_stderr: float
    azimuth_stderr: float
    rate: float
    unit: str


@dataclass
class _Window:
    """The latest points, some windows of swings long, and the swings that were told."""

    swings: float
    last: float = -math.inf
    start: float = -math.inf
    azimuth: float = math.nan
    _time: Numbers = field(default_factory=lambda: np.zeros(0))
    _places: Numbers = field(default_factory=lambda: np.zeros((0, 2)))
    _period: float = math.nan
    _tried: int = 0

    def add(self, track: kp.tracks.Track) -> Iterator[Swing]:
        """Take more points, and tell each swing as soon as they complete it."""
        new = np.column_stack((track.x, track.y))
        # As much as makes a swing at once: of a long file all windows are told, one after another.
        at = 0
        while at < len(track):
            step = len(track) - at
            if self._period == self._period:
                until = max(self.last, float(self._time[-1])) + self._period
                step = max(1, int(np.searchsorted(track.time[at:], until, side="right")))
            else:
                step = min(step, _FEWEST)
            self._time = np.concatenate((self._time, track.time[at : at + step]))
            self._places = np.concatenate((self._places, new[at : at + step]))
            at += step
            yield from self._told(track.unit)

    def _told(self, unit: str) -> list[Swing]:
        if not self._is_due():
            return []
        if self._period == self._period and self._time[-1] <= self.last:
            self._forget()  # an earlier run has told these swings
            return []
        track = kp.tracks.Track(self._time, self._places[:, 0], self._places[:, 1], unit)
        try:
            ellipses: xr.Dataset = kp.tracks.ellipses(track, swings=self.swings)
        except kp.InvalidInput:
            self._tried = len(self._time)
            return []
        self._period = 2 * math.pi / float(ellipses.frequency.values[-1])
        self._forget()
        when = float(ellipses.time.values[-1])
        if when <= self.last + 0.8 * self._period:
            return []
        self.last = when
        return [self._swing(ellipses, unit)]

    def _is_due(self) -> bool:
        """Whether there is another swing; without a period, another third of what was in vain."""
        if len(self._time) < _FEWEST:
            return False
        if math.isnan(self._period):
            return len(self._time) > 1.3 * self._tried
        return True

    def _forget(self) -> None:
        """Drop what is older than the windows that are kept."""
        first = self._time[-1] - _WINDOWS * self.swings * self._period
        keep = int(np.sum(self._time < first))
        self._time, self._places = self._time[keep:], self._places[keep:]
        self.start = float(self._time[0])

    def _swing(self, ellipses: xr.Dataset, unit: str) -> Swing:
        one = ellipses.isel(time=-1)
        values = {
            name: float(one[name])
            for name in ("a", "b", "azimuth", "a_stderr", "b_stderr", "azimuth_stderr")
        }
        if self.azimuth == self.azimuth:  # on the branch of the swing before
            turns = round((values["azimuth"] - self.azimuth) / math.pi)
            values["azimuth"] -= turns * math.pi
        self.azimuth = values["azimuth"]
        rate = math.nan
        if ellipses.sizes["time"] > 1:
            time = np.asarray(ellipses.time.values, dtype=float)
            azimuth = np.asarray(ellipses.azimuth.values, dtype=float)
            rate = float(np.polynomial.Polynomial.fit(time, azimuth, 1).convert().coef[1])
        return Swing(time=float(one.time), **values, rate=rate, unit=unit)


class _Kept:
    """The lines of all runs in a folder, and the place from which the latest can be made again."""

    def __init__(self, folder: Path, file: Path) -> None:
        self._folder, self._file = folder, str(file.resolve())
        self.count, self.last, self.azimuth = 0, -math.inf, math.nan
        self.place: Place | None = None
        state = self._state()
        path = folder / LINES
        if path.exists():
            if state is None:
                raise kp.InvalidInput.of("follow_foreign", folder=str(folder), name=LINES)
            self._mend(path)
        if state and (place := state.get("place")):
            self.place = Place(int(place["context"]), int(place["offset"]), float(place["time"]))
        if state is None:
            folder.mkdir(parents=True, exist_ok=True)
            self.remember(None)

    def _state(self) -> dict[str, Any] | None:
        try:
            state = json.loads((self._folder / STATE).read_text(encoding="utf-8"))
        except FileNotFoundError:
            return None
        except (OSError, ValueError) as error:
            raise kp.InvalidInput.of(
                "follow_unread", file=str(self._folder / STATE), said=str(error)
            ) from error
        if state.get("file") != self._file:
            raise kp.InvalidInput.of(
                "follow_other", folder=str(self._folder), file=str(state.get("file"))
            )
        return state

    def _mend(self, path: Path) -> None:
        """Count the lines, find the last one, and cut off one that was not finished."""
        with path.open("r+b") as file:
            whole = 0
            last = b""
            for line in file:
                if not line.endswith(b"\n"):
                    break
                whole += len(line)
                self.count, last = self.count + 1, line
            file.truncate(whole)
        self.count = max(0, self.count - 1)
        if self.count:
            cells = last.split(b",")
            self.last, self.azimuth = float(cells[0]), float(cells[_HEAD.index("azimuth (rad)")])

    def opened(self) -> _Lines:
        """The file of lines, to add to."""
        return _Lines(self._folder / LINES, self)

    def remember(self, place: Place | None) -> None:
        """Keep a place from which the file can be read again."""
        if (place is None or place == self.place) and (self._folder / STATE).exists():
            return
        self.place = place
        state = {"about": "kugelpendel fit --follow: where to go on", "file": self._file}
        kept = state | {"place": None if place is None else asdict(place)}
        write_file(self._folder / STATE, json.dumps(kept, indent=2) + "\n")


class _Lines:
    """The file of lines, each on the disk before the next is found."""

    def __init__(self, path: Path, kept: _Kept) -> None:
        self._path, self._kept = path, kept
        self._file: TextIO

    def __enter__(self) -> _Lines:
        is_new = not self._path.exists() or not self._path.stat().st_size
        self._file = self._path.open("a", encoding="utf-8", newline="")
        self._writer = csv.writer(self._file, lineterminator="\n")
        if is_new:
            self._writer.writerow(_HEAD)
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def write(self, swing: Swing) -> None:
        """Add a line."""
        self._writer.writerow(asdict(swing).values())
        self._file.flush()
        os.fsync(self._file.fileno())
        self._kept.count += 1


def _print_head(language: Language) -> None:
    heads = words(language)["follow_head"].split("|")
    print(
        "".join(f"{head:>{width}}" for head, width in zip(heads, _COLUMNS, strict=True)), flush=True
    )


_COLUMNS = (12, 20, 20, 20, 19, 14)


def _print(swing: Swing, language: Language) -> None:
    said = words(language)
    sense = "follow_flat"
    if abs(swing.b) > 2 * swing.b_stderr:
        sense = "follow_ccw" if swing.b > 0 else "follow_cw"
    cells = (
        spell(swing.time, "s", 5, language=language),
        _with_error(swing.a, swing.a_stderr, swing.unit, language),
        _with_error(swing.b, swing.b_stderr, swing.unit, language),
        _with_error(math.degrees(swing.azimuth), math.degrees(swing.azimuth_stderr), "°", language),
        said[sense],
        spell_rate(swing.rate, 3, language=language) if math.isfinite(swing.rate) else "–",
    )
    print(
        "".join(f"{cell:>{width}}" for cell, width in zip(cells, _COLUMNS, strict=True)), flush=True
    )


def _with_error(value: float, error: float, unit: str, language: Language) -> str:
    shown = Shown.of("", unit, value, language)
    return shown.with_unit(shown.pair(value, error))
