"""From a text to columns: comments, separators, headers, units, blocks and what does not belong."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from typing import NoReturn

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._note import Note
from kugelpendel.tracks.read._cells import is_missing, is_number, is_time
from kugelpendel.tracks.read._sheet import Layout, Sheet, alone, body, cut, trimmed
from kugelpendel.tracks.read._units import is_unit

_COMMENTS = ("#", "%", "//", "!", '"#')
_SEPARATORS = ("\t", ";", "|", ",", " ")
_SAMPLE = 400
"""Lines, evenly spread, out of which the layout is found."""


def take_apart(text: str, file: str, progress: Callable[[float], None] | None = None) -> Sheet:
    """Take a text apart into columns.

    Raises
    ------
    InvalidInput
        There are no rows of numbers, or only one column of them.
    """
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    comments = [line for line in lines[:200] if line.lstrip().startswith(_COMMENTS)]
    lines = _told(text, lines)
    layout = _layout(lines, file)
    first = next(i for i, row in enumerate(layout.split(lines)) if _is_data(row))
    head = list(layout.split(lines[:first]))
    names, units, bodies = _header(head, comments, layout)
    sheet = body(lines, first, head, layout, progress)
    for index, column in enumerate(sheet.columns):
        column.name = names[index] if index < len(names) else ""
        column.unit = units[index] if index < len(units) else column.unit
        column.body = bodies[index] if index < len(bodies) else ""
    sheet.named = any(names)
    sheet.notes[:0] = [
        *(Note.of("comment", text=cut(comment.strip())) for comment in comments[:3]),
    ]
    above = alone(head[0]) if head and not any(bodies) else ""
    sheet.bodies.insert(0, (0, above))
    return sheet


def data_starts(text: str, file: str) -> int:
    """How many lines of a text stand above its first row of numbers.

    Raises
    ------
    InvalidInput
        There are no rows of numbers.
    """
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    told = _told(text, lines)
    layout = _layout(told, file)
    for number, line in enumerate(lines):
        is_told = bool(line.strip()) and not line.lstrip().startswith(_COMMENTS)
        if is_told and _is_data(next(layout.split([line]))):
            return number
    return len(lines)


def _told(text: str, lines: Sequence[str]) -> list[str]:
    """The lines that are neither blank nor comments."""
    if not any(mark in text for mark in _COMMENTS):  # most files have none
        return [line for line in lines if line and not line.isspace()]
    return [line for line in lines if line.strip() and not line.lstrip().startswith(_COMMENTS)]


def _layout(lines: Sequence[str], file: str) -> Layout:
    """Find the separator with which most cells of most lines are numbers, times or missing."""
    if not lines:
        raise InvalidInput.of("track_empty", file=file)
    step = max(1, len(lines) // _SAMPLE)
    sample = [*lines[: _SAMPLE // 8], *lines[_SAMPLE // 8 :: step]]
    best: tuple[float, Layout] | None = None
    for separator in _SEPARATORS:
        splits = [_splitter(separator)]
        if separator == " ":
            splits.append(_fixed_width(sample))
        for split in splits:
            rows = [row for row in split(sample) if _is_data(row)]
            if not rows:
                continue
            width, rows_of_it = Counter(len(row) for row in rows).most_common(1)[0]
            understood = sum(
                (is_number(cell) or is_time(cell) or is_missing(cell)) / width
                for row in rows
                if len(row) == width
                for cell in row
            )
            score = understood / len(sample) * (0.5 + 0.5 * rows_of_it / len(rows))
            if best is None or score > best[0] + 1e-3:
                best = score, Layout(split, separator, width)
    if best is None:
        _refuse_without_rows(sample, file)
    return best[1]


def _refuse_without_rows(sample: Sequence[str], file: str) -> NoReturn:
    """Say whether there is one column only or no number at all."""
    lonely = sum(is_number(line) or is_time(line) for line in sample)
    if lonely > len(sample) / 2:
        raise InvalidInput.of("track_one_column", file=file, example=cut(sample[-1].strip()))
    raise InvalidInput.of("track_no_numbers", file=file, example=cut(sample[0].strip()))


def _splitter(separator: str) -> Callable[[Sequence[str]], Iterator[list[str]]]:
    if separator == " ":
        return lambda lines: (line.split() for line in lines)

    def split(lines: Sequence[str]) -> Iterator[list[str]]:
        # A quote that is never closed would swallow the rest of the file: lines stand alone.
        if any('"' in line for line in lines):
            for line in lines:
                yield from csv.reader([line], delimiter=separator, skipinitialspace=True)
        else:
            yield from (line.split(separator) for line in lines)

    return split


def _fixed_width(sample: Sequence[str]) -> Callable[[Sequence[str]], Iterator[list[str]]]:
    """Cut lines where all rows of numbers have a blank, so that empty cells stay in their place."""
    rows = [line.expandtabs() for line in sample if _is_data(line.split())]
    most = Counter(len(row.split()) for row in rows).most_common(1)
    full = [row for row in rows if len(row.split()) == (most[0][0] if most else 0)]
    length = max((len(row) for row in rows), default=0)
    used = np.zeros(length + 1, dtype=bool)
    for row in full:
        used[: len(row)] |= np.array([not sign.isspace() for sign in row], dtype=bool)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], used)).astype(int)))
    stops = [*edges[1::2], length]
    cuts = [0, *(int(stop) for stop in stops[: len(edges) // 2 - 1])]
    slices = [slice(cut, after) for cut, after in zip(cuts, [*cuts[1:], None], strict=True)]

    def split(lines: Sequence[str]) -> Iterator[list[str]]:
        for line in lines:
            row = line.expandtabs()
            yield [row[one].strip() for one in slices]

    return split


def _is_data(row: Sequence[str]) -> bool:
    """Say whether a row has two numbers or times, and no more words than these."""
    seen = sum(is_number(cell) or is_time(cell) for cell in row)
    words = sum(not (is_number(cell) or is_time(cell) or is_missing(cell)) for cell in row)
    found = sum(is_missing(cell) and bool(cell.strip()) for cell in row)
    return (seen >= 2 or (seen == 1 and found >= 2)) and words < seen


def _header(
    head: Sequence[Sequence[str]], comments: Sequence[str], layout: Layout
) -> tuple[list[str], list[str], list[str]]:
    """Names, units and masses of the columns, as the lines above the first row have them."""
    width = layout.width
    rows = [trimmed(_with_units(row) if layout.separator == " " else row, width) for row in head]
    units: list[str] = []
    if rows and _are_units(rows[-1]):
        units = [cell.strip().strip("[]()") for cell in rows.pop()]
        units = ["" if unit in ("-", "–") else unit for unit in units]
    names: list[str] = []
    if rows and sum(bool(cell.strip()) for cell in rows[-1]) >= 2:
        names = [cell.strip() for cell in rows.pop()]
        if len(names) == width - 1:
            names.insert(0, "")  # an index column, which has no name
    elif comments:
        last = comments[-1].strip().strip('"').lstrip("#%!/ \t")
        cells = next(layout.split([last]))
        cells = cells if len(cells) == width else last.replace(",", " ").split()
        if len(cells) == width and not all(is_number(cell) for cell in cells):
            names = [cell.strip() for cell in cells]
    bodies: list[str] = []
    if rows and sum(bool(cell.strip()) for cell in rows[-1]) >= 1 and len(rows[-1]) > 1:
        name = ""
        for cell in [*rows[-1], *[""] * (width - len(rows[-1]))]:
            name = cell.strip() or name
            bodies.append(name)
        if len({body for body in bodies if body}) < 2:
            bodies = []
    return names, units, bodies


def _with_units(row: Sequence[str]) -> list[str]:
    """Names that were parted from their units at a blank, such as "t (s)", in one again."""
    cells: list[str] = []
    for cell in row:
        if cells and cell[:1] in ("(", "["):
            cells[-1] += f" {cell}"
        else:
            cells.append(cell)
    return cells


def _are_units(row: Sequence[str]) -> bool:
    cells = [cell.strip() for cell in row]
    named = [cell for cell in cells if cell not in ("", "-", "–", "1")]
    return len(named) >= 2 and all(is_unit(cell.strip("[]()")) for cell in named)
