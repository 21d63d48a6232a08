"""A file to which a logger appends, read piece by piece with bounded memory."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, final

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._track import Track
from kugelpendel.tracks.read._read import told
from kugelpendel.tracks.read._rows import data_starts, take_apart
from kugelpendel.tracks.read._text import decode

_PIECE = 1 << 22
"""Bytes that are read at once."""

_CONTEXT = 120
"""Rows before a piece that are read with it again, so that its layout, its clock and its units are
found as in the whole file."""

_ALIKE = 1e-6
"""s; rows closer in time than that are one."""


@final
@dataclass(frozen=True)
class Place:
    """A place in a file from which it can be read on.

    Attributes
    ----------
    context, offset
        Bytes from the start: where the rows before the place begin, and the place itself.
    time
        s, of the last row before it.
    """

    context: int
    offset: int
    time: float


@final
class Appended:
    """The rows of a text file as they come.

    Parameters
    ----------
    path
        The file; it may be there in part only.
    options
        Those of `kugelpendel.tracks.read`.
    place
        Where to go on; at the start unless given.
    """

    def __init__(self, path: Path, options: Mapping[str, Any], place: Place | None = None) -> None:
        self._path = path
        self._options = {"columns": None, "mass": None, "rate": None, "scale": None, "y_down": None}
        self._options.update(options)
        self._head = b""
        self.place = place

    def more(self) -> Track | None:
        """The rows that came since the last call, at most some megabytes; None for none.

        The times go on from those before, across midnight too.

        Raises
        ------
        InvalidInput
            The file cannot be read, is shorter than it was, or has no track in it.
        """
        try:
            with self._path.open("rb") as file:
                size = file.seek(0, 2)
                if self.place is not None and size < self.place.offset:
                    raise InvalidInput.of("track_replaced", file=self._path.name)
                file.seek(0)
                if not self._head and not self._read_head(file.read(_PIECE)):
                    return None
                return self._next(file)
        except OSError as error:
            raise InvalidInput.of(
                "track_not_read", file=str(self._path), what=error.strerror or str(error)
            ) from error

    def _read_head(self, start: bytes) -> bool:
        """Find the lines above the first row; false while there are too few to tell."""
        whole = start[: start.rfind(b"\n") + 1]
        if whole.count(b"\n") < _CONTEXT:
            return False
        text, _ = decode(whole, self._path.name)
        above = data_starts(text, self._path.name)
        lines = whole.splitlines(keepends=True)
        self._head = b"".join(lines[:above])
        return True

    def _next(self, file: Any) -> Track | None:
        at = self.place.offset if self.place else len(self._head)
        file.seek(at)
        piece: bytes = file.read(_PIECE)
        piece = piece[: piece.rfind(b"\n") + 1]
        if not piece:
            return None
        context, shift = b"", 0.0
        if self.place is not None:
            file.seek(self.place.context)
            context = file.read(at - self.place.context)
            shift = self.place.time - float(self._track(self._head + context).time[-1])
        track = self._track(self._head + context + piece)
        time = track.time + shift
        # Times out of a clock are right to the rounding of their differences.
        is_new = time > (self.place.time + _ALIKE if self.place else -np.inf)
        if not is_new.any():
            return None
        rows = (context + piece).splitlines(keepends=True)
        kept = sum(map(len, rows[-_CONTEXT:]))
        self.place = Place(at + len(piece) - kept, at + len(piece), float(time[-1]))
        new = (time[is_new], track.x[is_new], track.y[is_new])
        return Track(*new, track.unit, track.notes, track.axes)

    def _track(self, content: bytes) -> Track:
        text, notes = decode(content, self._path.name)
        sheet = take_apart(text, self._path.name)
        sheet.notes[:0] = notes
        track = told(sheet, self._path, **self._options)
        counted = any(note.kind == "rows_are_frames" for note in track.notes)
        if not isinstance(track, Track) or counted or track.axes != "room":
            raise InvalidInput.of("track_not_followed", file=self._path.name)
        return track
