"""The file that `kugelpendel sweep` reads: a job whose numbers may vary, and what is asked."""

from __future__ import annotations

import re
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.job_file.document import JobDocument, read_document
from kugelpendel.cli.job_file.entries import Entries, Mistake, take_apart
from kugelpendel.cli.job_file.forces import read_forces
from kugelpendel.cli.job_file.job import read_launch
from kugelpendel.cli.job_file.kinds import TIME, Kind
from kugelpendel.cli.job_file.quantity import read_quantity
from kugelpendel.cli.job_file.schema import Choice, Truth, Vector
from kugelpendel.cli.job_file.sweep_schema import SWEEP_FILE
from kugelpendel.cli.sweep.laws import read_law
from kugelpendel.sweeps import Listed, Normal, Spaced

if TYPE_CHECKING:
    from collections.abc import Generator
    from pathlib import Path

    from kugelpendel.sweeps import Law, Sweep

_COMPONENTS = {"position": ("x", "y", "z"), "velocity": ("vx", "vy", "vz")}
"""What the components of a launch's vectors are called."""

_TRIED = (0.5, 0.02, 0.98)
"""Shares of what varies at which the job is tried: one of them has to make sense."""


@dataclass(frozen=True)
class SweepFile:
    """What a file asks for, checked, in SI."""

    document: JobDocument
    sweep: Sweep

    @property
    def file(self) -> Path:
        """The name of the file."""
        return self.document.path


def read_sweep_file(path: Path) -> SweepFile:
    """Read and check a file.

    Parameters
    ----------
    path
        The file; ``-`` for standard input.

    Raises
    ------
    InvalidInput
        A sentence that names the file and the line, the key, the value seen, and the way out.
    """
    document = read_document(path, SWEEP_FILE)
    with document.named():
        tables = take_apart(document.tables, SWEEP_FILE)
        names = [name for name in document.tables if name != "sweep"]
        given = {name: _given(tables[name]) for name in names}
        _try_it(document, tables, given)
        return SweepFile(document, _sweep(tables["sweep"], given))


def _sweep(asked: Entries, given: dict[str, dict[str, Any]]) -> Sweep:
    with _placed(asked):
        return kp.Sweep(
            given,
            design=cast("Any", asked.word("design")),
            motion=cast("Any", asked.word("motion")),
            quantities=_words(asked, "quantities"),
            times=_times(asked),
            count=_whole(asked, "count", 1),
            seed=_whole(asked, "seed", 0) or 0,
            second_order=asked.truth("second_order"),
            keep=cast("Any", _words(asked, "keep") if "keep" in asked else ("all",)),
            chunk=_whole(asked, "chunk", 1),
        )


def _given(table: Entries) -> dict[str, Any]:
    """The entries of a table: numbers in SI, words, and laws for what varies."""
    found: dict[str, Any] = {}
    for key, value in table.values.items():
        holds = table.section.key(key).holds
        if isinstance(holds, Choice):
            found[key] = table.word(key)
        elif isinstance(holds, Truth):
            found[key] = table.truth(key)
        elif isinstance(holds, Vector):
            found |= _components(table, key, holds)
        elif isinstance(value, (list, dict)):
            with table.at(key):
                kind = holds if isinstance(holds, Kind) else None
                found[key] = read_law(cast("Any", value), kind, table.where(key))
        else:
            found[key] = table.given(key)
    return found


def _components(table: Entries, key: str, holds: Vector) -> dict[str, Any]:
    """Three components, each a number or a law."""
    values: object = table.values[key]
    if not isinstance(values, list) or len(cast("list[Any]", values)) != 3:
        table.vector(key)  # which says what is wrong with it
    found: dict[str, Any] = {}
    with table.at(key):
        for name, value in zip(_COMPONENTS[key], cast("list[Any]", values), strict=True):
            where = f"{table.where(key)}[{name[-1]}]"
            varies = isinstance(value, (list, dict))
            read = read_law if varies else read_quantity
            found[name] = read(value, holds.kind, where)
    return found


def _try_it(
    document: JobDocument, tables: dict[str, Entries], given: dict[str, dict[str, Any]]
) -> None:
    """Have the reader of jobs check what does not vary, with some values for what does.

    A value that makes no sense among others that do is a bad case, and none of the file.
    """
    refused: list[kp.InvalidInput] = []
    for share in _TRIED:
        tried = {
            name: Entries(table.section, _settled(given[name], table, share))
            if name in given
            else table
            for name, table in tables.items()
        }
        try:
            read_forces(tried, document.tables)
            read_launch(tried["launch"])
        except kp.InvalidInput as error:
            refused.append(error)
        else:
            return
    raise refused[0]


def _settled(values: dict[str, Any], table: Entries, share: float) -> dict[str, Any]:
    """The entries of a table as they are, with a number in SI for each that varies."""
    found = dict(table.values)
    for key, value in table.values.items():
        if key in _COMPONENTS:
            found[key] = [_typical(values[name], share) for name in _COMPONENTS[key]]
        elif isinstance(value, (list, dict)):
            found[key] = _typical(values[key], share)
    return found


def _typical(value: float | Law, share: float) -> float:
    if isinstance(value, Normal):
        return value.mean
    return value if isinstance(value, (float, int)) else float(value.drawn(np.array([share]))[0])


def _words(asked: Entries, key: str) -> tuple[str, ...]:
    """One word, or several."""
    value = asked.values.get(key)
    if value is None:
        asked.refuse("file_key_missing", key, example=asked.section.key(key).example)
    words: list[Any] = cast("list[Any]", value) if isinstance(value, list) else [value]
    if not all(isinstance(word, str) for word in words):
        asked.refuse("sweep_words", key, example=asked.section.key(key).example)
    return tuple(words)


def _times(asked: Entries) -> tuple[float, ...]:
    """A list of times, or a range of them."""
    if "times" not in asked:
        return ()
    value: object = asked.values["times"]
    where = asked.where("times")
    with asked.at("times"):
        if not isinstance(value, (list, dict)):
            return (read_quantity(value, TIME, where),)
        law = read_law(cast("Any", value), TIME, where)
        if isinstance(law, Listed):
            return law.values
        if not isinstance(law, Spaced) or law.count is None:
            asked.refuse("sweep_times", "times")
        return tuple(law.at(np.arange(law.count)).tolist())


def _whole(asked: Entries, key: str, least: int) -> int | None:
    """A whole number, or None where the file has none; how small it may be, the sweep checks."""
    if key not in asked:
        return None
    value: object = asked.values[key]
    if isinstance(value, float) and value.is_integer():
        value = int(value)  # 1e6
    if not isinstance(value, int) or isinstance(value, bool):
        asked.refuse("sweep_whole", key, name=asked.where(key), least=str(least))
    return value


@contextmanager
def _placed(asked: Entries) -> Generator[None]:
    """Say where in the file it stands what a sweep refuses."""
    try:
        yield
    except Mistake:
        raise
    except kp.InvalidInput as error:
        for seen in error.values[:1]:
            # A sweep names a number as a file does, a parameter as "pendulum.length".
            place = re.match(r"\[(\w+)\] (\w+)", str(seen.value)) or re.match(
                r"(\w+)\.(\w+)$", seen.name
            )
            if place is not None:
                raise Mistake.in_table(error, place[1], place[2]) from error
        with asked.at():
            raise
