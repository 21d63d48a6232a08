"""Columns for a terminal: the one place where a report becomes lines.

Everything here returns text, as wide as the reader has room: the terminal's columns, from 60 on; in
a file 100, unless the variable COLUMNS says otherwise. Numbers are never cut: a table that is too
wide is printed in parts below one another, and text is wrapped.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from itertools import groupby
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from rich.console import RenderableType
    from rich.table import Table

_NARROWEST = 60
_IN_A_FILE = 100
_WIDEST_TEXT = 100
"""Longer lines of text are hard to read; tables may use all of a wider terminal."""

_NAME = 17
_VALUE = 21
"""Least widths of the columns of `facts`, so that those of several reports stand alike."""


_TIE = "\ue000"
"""Stands for a blank at which no line is broken; rich breaks lines at every blank there is."""

_BOUND = re.compile(r"(?<=[0-9²³⁴]) (?=[^\W\d]|[%°])")
"""The blank between a number and its unit, or what it counts."""


def room() -> int:
    """Say how many columns a line may have: those of the terminal, or of a file."""
    if sys.stdout is not None and sys.stdout.isatty():
        columns = shutil.get_terminal_size().columns
    else:
        said = os.environ.get("COLUMNS", "")
        columns = int(said) if said.isascii() and said.isdigit() and int(said) else _IN_A_FILE
    return max(columns, _NARROWEST)


def facts(rows: Iterable[Sequence[str]]) -> str:
    """Set lines of a name, a value and what the value means; or of a name and a text.

    Parameters
    ----------
    rows
        Two cells or three each. Blanks at the start of a name set it in. The last cell is wrapped
        where it is too long.
    """
    parts: list[str] = []
    for cells, group in groupby(rows, key=len):
        table = _grid()
        table.add_column(no_wrap=True, min_width=_NAME)
        if cells > 2:
            table.add_column(no_wrap=True, min_width=_VALUE)
        table.add_column(overflow="fold")
        for row in group:
            table.add_row(*_texts(row))
        parts.append(_lines(table, min(room(), _WIDEST_TEXT)))
    return "\n".join(parts)


def listing(rows: Iterable[Sequence[str]], least: int = _NAME) -> str:
    """Set names, each with a text beside it that is wrapped.

    Parameters
    ----------
    rows
        Name and text.
    least
        Columns that the names have at least.
    """
    table = _grid()
    table.add_column(no_wrap=True, min_width=least)
    table.add_column(overflow="fold")
    for row in rows:
        table.add_row(*_texts(row))
    return _lines(table, min(room(), _WIDEST_TEXT))


def paragraph(text: str) -> str:
    """Wrap a text to lines."""
    from rich.text import Text

    return _lines(Text(_BOUND.sub(_TIE, text), overflow="fold"), min(room(), _WIDEST_TEXT))


def numbers(
    headers: Sequence[str], rows: Iterable[Sequence[str]], *, text: int = 1, least: int = 0
) -> str:
    """Set a table of numbers below headers, all but the first columns to the right.

    Parameters
    ----------
    headers
        One for each column.
    rows
        As many cells each as there are headers.
    text
        How many columns at the left are text. Where the table is too wide, its numbers go on below,
        beside the first column again.
    least
        Columns that the first column has at least.
    """
    body = [tuple(row) for row in rows]
    left = list(range(text))
    parts: list[str] = []
    rest = list(range(text, len(headers)))
    while rest or not parts:
        shown = [*left, *rest[:1]]
        for column in rest[1:]:
            if _width(_numbers(headers, body, [*shown, column], text, least)) > room():
                break
            shown.append(column)
        parts.append(_lines(_numbers(headers, body, shown, text, least), room()))
        rest = [column for column in rest if column not in shown]
        left = left[:1]
    return "\n\n".join(parts)


def _numbers(
    headers: Sequence[str],
    rows: Sequence[Sequence[str]],
    shown: Sequence[int],
    text: int,
    least: int,
) -> Table:
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, header_style="")
    for column in shown:
        # What remains too wide with a single column of numbers is a text, and folded.
        name = headers[column]
        if column < text:
            table.add_column(*_texts([name]), overflow="fold", min_width=0 if column else least)
        else:
            table.add_column(*_texts([name]), justify="right", no_wrap=True)
    for row in rows:
        table.add_row(*_texts(row[column] for column in shown))
    return table


def _grid() -> Table:
    from rich.table import Table

    return Table.grid(padding=(0, 2))


def _texts(cells: Iterable[str]) -> list[RenderableType]:
    """Cells in which nothing is markup, so that "[1]" is not taken for a style."""
    from rich.text import Text

    return [Text(_BOUND.sub(_TIE, cell), overflow="fold") for cell in cells]


def _width(table: Table) -> int:
    from rich.console import Console
    from rich.measure import Measurement

    console = Console(width=10_000)
    return Measurement.get(console, console.options, table).maximum


def _lines(what: RenderableType, width: int) -> str:
    from rich.console import Console

    console = Console(highlight=False, width=width, color_system=None, force_terminal=False)
    with console.capture() as captured:
        console.print(what)
    lines = (line.replace(_TIE, " ").rstrip() for line in captured.get().splitlines())
    return "\n".join(line for line in lines if line)
