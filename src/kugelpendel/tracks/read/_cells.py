"""What one cell may say: a number in any of the usual spellings, a time, a word for "not found"."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kugelpendel.tracks.read._units import is_unit

Numbers: TypeAlias = NDArray[np.float64]

_MISSING = """
- -- --- – — . ? * nan na n/a n.a. #n/a #nv nv null none nil missing lost notfound fehlt k.a.
nat <na> inf -inf +inf #div/0! #value! undefined -nan -nan(ind) 1.#qnan 1.#snan -1.#ind 1.#inf
"""
MISSING = frozenset(_MISSING.split()) | {"", "not found", "nicht gefunden"}
"""Cells, in small letters, that stand for what was not seen."""

_BLANKS = str.maketrans(dict.fromkeys("\u00a0\u2009\u202f\u2007'’", " ") | {"−": "-", "‐": "-"})
_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eEdD][+-]?\d+)?")
_GROUPED = re.compile(r"[+-]?\d{1,3}(?:[.,' ]\d{3})+(?:[.,]\d*)?")
_WITH_UNIT = re.compile(r"(.*?\d[.,]?)\s*([a-zA-Zµμ°]{1,6})")
_TIME = re.compile(
    r"(?:\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4})?[T ]*(?:\d{1,2}:\d{2}(?::\d{2})?(?:[.,]\d*)?)?"
    r"\s*(?:[AaPp]\.?[Mm]\.?)?\s*(?:Z|UTC|[+-]\d{2}:?\d{2})?"
)


@dataclass(frozen=True)
class Marks:
    """The marks of a file's numbers: which is the decimal one, and which groups thousands.

    Attributes
    ----------
    decimal
        "." or ",".
    thousands
        The sign between groups of three digits beside a blank and an apostrophe, which always may
        be; "" where there is none.
    doubtful
        Whether the numbers seen could be read with the other mark too.
    """

    decimal: str = "."
    thousands: str = ""
    doubtful: bool = False


def is_missing(cell: str) -> bool:
    """Say whether a cell stands for what was not seen."""
    return cell.strip().lower() in MISSING


def is_number(cell: str) -> bool:
    """Say whether a cell is a number, with either decimal mark, grouped thousands or a unit."""
    plain = cell.strip().translate(_BLANKS)
    if _NUMBER.fullmatch(plain) or _GROUPED.fullmatch(plain):
        return True
    parts = _WITH_UNIT.fullmatch(plain)
    return parts is not None and is_unit(parts[2]) and is_number(parts[1])


def is_time(cell: str) -> bool:
    """Say whether a cell is a date, a clock time or both."""
    plain = cell.strip()
    return len(plain) > 3 and (":" in plain or plain[0].isdigit()) and bool(_TIME.fullmatch(plain))


def marks_of(columns: Iterable[Sequence[str]], separator: str) -> Marks:
    """Find the decimal mark of a file out of some cells of each of its columns.

    A mark that comes twice in a number groups thousands; one that is not followed by just three
    digits, or follows a lone 0 or more than three digits, is the decimal one. Where neither is
    seen, as in "1,234" alone, numbers below a thousand without a mark in the same column say that
    the mark groups thousands, since decimals are written for all of a column or for none.
    """
    seen = {".": [0, 0, 0], ",": [0, 0, 0]}  # as decimal, as thousands, either way
    for column in columns:
        cells = [cell.strip().translate(_BLANKS) for cell in column]
        either: set[str] = set()
        small = 0
        for cell in cells:
            marks = [sign for sign in cell if sign in ".,"]
            if not marks or not (_NUMBER.fullmatch(cell) or _GROUPED.fullmatch(cell)):
                small += bool(re.fullmatch(r"[+-]?\d{1,3}", cell))
                continue
            last = marks[-1]
            if len(set(marks)) == 2:
                seen[last][0] += 1
                seen[marks[0]][1] += 1
            elif len(marks) > 1:
                seen[last][1] += 1
            elif re.fullmatch(r"[+-]?[1-9]\d{0,2}[.,]\d{3}", cell):
                either.add(last)
            else:
                seen[last][0] += 1
        for mark in either:
            seen[mark][1 if small else 2] += 1
    (point, grouped_by_point, _), (comma, grouped_by_comma, open_comma) = seen["."], seen[","]
    if comma and comma >= point:
        return Marks(",", ".")
    if point or grouped_by_comma:
        return Marks(".", "," if separator != "," else "")
    if grouped_by_point and not point:
        return Marks(",", ".")
    if open_comma:
        return Marks(",", "", doubtful=True)
    return Marks(".", "," if separator != "," else "")


def numbers_of(cells: Sequence[str], marks: Marks) -> tuple[Numbers, NDArray[np.bool_], str]:
    """Turn the cells of a column into numbers.

    Returns
    -------
    numbers
        NaN where nothing was seen; shape (n,).
    strange
        Whether a cell is neither a number nor a word for what was not seen; shape (n,).
    unit
        The unit that the cells themselves carry, as in "12.3 px", or "".
    """
    try:
        # Whatever NumPy reads as a number is one, but for a comma, which it never takes.
        if marks.decimal == "." or not any("." in cell for cell in cells):
            text = cells if marks.decimal == "." else "\n".join(cells).replace(",", ".").split("\n")
            numbers = np.array(text, dtype=np.float64)
            numbers[~np.isfinite(numbers)] = np.nan
            return numbers, np.zeros(len(cells), dtype=bool), ""
    except ValueError:
        pass
    return _one_by_one(cells, marks)


def _one_by_one(cells: Sequence[str], marks: Marks) -> tuple[Numbers, NDArray[np.bool_], str]:
    numbers = np.full(len(cells), np.nan)
    strange = np.zeros(len(cells), dtype=bool)
    unit = ""
    for index, cell in enumerate(cells):
        value = number_of(cell, marks)
        if value is None and (parts := _WITH_UNIT.fullmatch(cell.strip())):
            value = number_of(parts[1], marks)
            unit = parts[2] if value is not None else unit
        if value is None:
            strange[index] = not is_missing(cell)
        elif np.isfinite(value):
            numbers[index] = value
    return numbers, strange, unit


def number_of(cell: str, marks: Marks) -> float | None:
    """Read a single number; None where the cell is none with these marks."""
    plain = cell.strip().translate(_BLANKS)
    if _GROUPED.fullmatch(plain) and not _NUMBER.fullmatch(plain):
        plain = plain.replace(" ", "")
    if marks.thousands and marks.thousands in plain:
        whole = plain.partition(marks.decimal)[0]
        if not re.fullmatch(rf"[+-]?\d{{1,3}}(?:{re.escape(marks.thousands)}\d{{3}})+", whole):
            return None
        plain = plain.replace(marks.thousands, "")
    if marks.decimal == ",":
        if "." in plain:
            return None
        plain = plain.replace(",", ".")
    plain = plain.replace("d", "e").replace("D", "e")
    return float(plain) if _NUMBER.fullmatch(plain) and "," not in plain else None
