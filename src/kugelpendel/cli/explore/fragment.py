"""A job file as the fragment of the page's address: its own keys, numbers in SI."""

from __future__ import annotations

from typing import TYPE_CHECKING
from urllib.parse import quote

from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.entries import take_apart
from kugelpendel.cli.job_file.job import LAUNCHES, read_job
from kugelpendel.cli.job_file.schema import Choice, Truth, Vector

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from kugelpendel.cli.job_file.entries import Entries

_OUTPUT = ("duration",)
"""Of what is written, the page has a use for its duration only."""


def fragment_of(path: Path) -> str:
    """The fragment that opens the page on a job, such as ``pendulum.length=67.0&launch.kind=…``.

    Raises
    ------
    InvalidInput
        Whatever `read_job` refuses.
    """
    job = read_job(path)
    tables = take_apart(job.document.tables, schema.JOB)
    return "&".join(f"{name}={quote(text, safe=',')}" for name, text in _said(tables))


def _said(tables: dict[str, Entries]) -> Iterator[tuple[str, str]]:
    for name, table in tables.items():
        keys = (key.name for key in table.section.keys if key.name in table)
        if name == "launch":
            keys = ("kind", *(key for key in LAUNCHES[table.word("kind")] if key in table))
        elif name == "output":
            keys = _OUTPUT
        for key in keys:
            yield f"{name}.{key}", _text(table, key)


def _text(table: Entries, key: str) -> str:
    match table.section.key(key).holds:
        case Vector():
            return ",".join(map(repr, table.vector(key)))
        case Choice():
            return table.word(key)
        case Truth():
            return "true" if table.truth(key) else "false"
        case _:
            return repr(table.number(key))
