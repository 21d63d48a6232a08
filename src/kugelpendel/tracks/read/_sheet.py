"""The columns of a file, filled from the rows below its header."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._cells import (
    Marks,
    Numbers,
    is_missing,
    is_number,
    is_time,
    marks_of,
    numbers_of,
)

_SAMPLE = 400
"""Lines, evenly spread, out of which the marks of the numbers are found."""
_CHUNK = 50_000
"""Lines that are taken apart at once, so that memory is bound."""
_SHOWN = 60


@dataclass(eq=False)
class Column:
    """A column of a file before anyone knows what it means.

    Attributes
    ----------
    name, unit
        As the file has them; "" where it has none.
    body
        The mass to which the column belongs, "" where the file does not say.
    numbers
        NaN where nothing was seen; shape (n,).
    texts
        The cells, where most of them are no numbers.
    """

    name: str
    unit: str
    body: str
    numbers: Numbers
    texts: list[str] | None = None


@dataclass
class Sheet:
    """The columns of a file, with what was noted on the way to them.

    Attributes
    ----------
    columns
        All of the same length.
    bodies
        The mass named above each block of rows, by the row with which the block starts.
    named
        Whether the columns have names.
    """

    columns: list[Column]
    bodies: list[tuple[int, str]] = field(default_factory=list[tuple[int, str]])
    named: bool = True
    notes: list[Note] = field(default_factory=list[Note])


@dataclass
class Layout:
    """How lines become cells, and how many of these a row has."""

    split: Callable[[Sequence[str]], Iterator[list[str]]]
    separator: str
    width: int


def body(
    lines: Sequence[str],
    first: int,
    head: Sequence[Sequence[str]],
    layout: Layout,
    progress: Callable[[float], None] | None,
) -> Sheet:
    """The rows below the header, chunk by chunk."""
    width = layout.width
    sample = [
        row
        for row in layout.split(lines[first :: max(1, len(lines) // _SAMPLE)])
        if len(row) == width
    ]
    columns = list(zip(*sample, strict=True))
    marks = marks_of(columns, layout.separator)
    is_text = [_is_text(column, marks) for column in columns]
    parts: list[list[Numbers]] = [[] for _ in range(width)]
    texts: list[list[str]] = [[] for _ in range(width)]
    units = [""] * width
    headings = {tuple(cell.strip() for cell in row) for row in head}
    odd = _Odd(headings)
    count = 0
    for start in range(first, len(lines), _CHUNK):
        if progress is not None:
            progress(start / len(lines))
        chunk = lines[start : start + _CHUNK]
        table = None if any(is_text) else _at_once(chunk, layout, marks)
        if table is not None:
            for part, column in zip(parts, table.T, strict=True):
                part.append(np.ascontiguousarray(column))
            count += len(table)
            continue
        rows: list[list[str]] = []
        for row in layout.split(chunk):
            cells = trimmed(row, width) if len(row) != width else row
            if len(cells) == 1 and width > 1 and (is_number(cells[0]) or is_time(cells[0])):
                cells += [""] * (width - 1)  # a time at which nothing was seen
            if len(cells) != width:
                odd.add(cells, count + len(rows))
            else:
                rows.append(cells)
        kept = np.ones(len(rows), dtype=bool)
        found: dict[int, Numbers] = {}
        cells_of = list(zip(*rows, strict=True)) if rows else [()] * width
        for index in range(width):
            if not is_text[index]:
                found[index], strange, unit = numbers_of(cells_of[index], marks)
                units[index] = unit or units[index]
                kept &= ~strange
        before = np.cumsum(kept) - kept
        for index in np.flatnonzero(~kept):
            odd.add(rows[index], count + int(before[index]))
        for index in range(width):
            if is_text[index]:
                texts[index] += [
                    cell.strip() for cell, keep in zip(cells_of[index], kept, strict=True) if keep
                ]
            else:
                parts[index].append(found[index][kept])
        count += int(kept.sum())
    notes = [Note.of("decimal_comma")] if marks.decimal == "," else []
    if marks.doubtful:
        notes.append(Note.of("decimal_comma_doubtful"))
    made = [
        Column("", units[i], "", np.full(count, np.nan), texts[i])
        if is_text[i]
        else Column("", units[i], "", np.concatenate(parts[i]))
        for i in range(width)
    ]
    return Sheet(made, odd.bodies, True, [*notes, *odd.notes()])


def _at_once(lines: Sequence[str], layout: Layout, marks: Marks) -> NDArray[np.float64] | None:
    """Lines that are numbers in NumPy's spelling and nothing else, which most are; else None."""
    if marks.decimal == ",":
        if any("." in line for line in lines):
            return None
        lines = [line.replace(",", ".") for line in lines]
    separator = None if layout.separator == " " else layout.separator
    try:
        table = np.loadtxt(lines, delimiter=separator, comments=None, ndmin=2)
    except ValueError:
        return None
    table[~np.isfinite(table)] = np.nan
    return table if table.shape == (len(lines), layout.width) else None


def _is_text(column: Sequence[str], marks: Marks) -> bool:
    """Say whether most cells of a column that say something are no numbers."""
    said = [cell for cell in column if not is_missing(cell)]
    _, strange, _ = numbers_of(said, marks)
    return bool(len(said)) and bool(strange.mean() > 0.5)


class _Odd:
    """Rows that are no rows of the table: headers once more, names of masses, summaries."""

    def __init__(self, headings: set[tuple[str, ...]]) -> None:
        self._headings = headings
        self._repeated = 0
        self._foreign: list[str] = []
        self._count = 0
        self.bodies: list[tuple[int, str]] = []

    def add(self, row: Sequence[str], at: int) -> None:
        cells = tuple(cell.strip() for cell in row)
        name = alone(cells)
        if cells in self._headings and not re.match(r"(?i)mass\b", name):
            self._repeated += 1
            self.bodies += [(at, "")] if not self.bodies or self.bodies[-1][0] != at else []
        elif name and (re.match(r"(?i)(mass|body|bob|object|track|pendulum|masse|pendel)\b", name)):
            self.bodies.append((at, name))
        else:
            self._count += 1
            if len(self._foreign) < 3:
                self._foreign.append(cut(" ".join(cell for cell in cells if cell)))

    def notes(self) -> list[Note]:
        """What was dropped."""
        notes = [Note.of("headers_repeated", count=self._repeated)] if self._repeated else []
        if self._count:
            notes.append(
                Note.of("rows_foreign", count=self._count, examples=" | ".join(self._foreign))
            )
        return notes


def cut(text: str) -> str:
    """A text that fits into a sentence."""
    return text if len(text) <= _SHOWN else f"{text[: _SHOWN - 1]}…"


def alone(row: Sequence[str]) -> str:
    """The only cell of a row that has text, or ""."""
    cells = [cell.strip() for cell in row if cell.strip()]
    return " ".join(cells) if len(cells) == 1 or re.match(r"(?i)mass\b", " ".join(cells)) else ""


def trimmed(row: Sequence[str], width: int) -> list[str]:
    """A row without empty cells at its end that are beyond its width."""
    cells = list(row)
    while len(cells) > width and not cells[-1].strip():
        cells.pop()
    return cells
