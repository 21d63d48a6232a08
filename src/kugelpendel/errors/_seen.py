"""What was seen where something is wrong, and for whom it is put into words."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple, TypeAlias

Language: TypeAlias = Literal["en", "de"]
Door: TypeAlias = Literal["python", "file"]
"""Where the words will be read: by somebody who calls Python, or who writes a job file."""

Told: TypeAlias = tuple[str, Sequence[tuple[str, float, str]]]
"""A problem as the core tells it: the kind, and name, value and unit of what was seen."""


class Seen(NamedTuple):
    """A value that was seen.

    Attributes
    ----------
    name
        What it is of, such as "drag.linear".
    value
        A number in its unit, or text for what is no number.
    unit
        As in "m/s²"; "" for what has none.
    """

    name: str
    value: float | str
    unit: str = ""


class FileLine(NamedTuple):
    """The line of a file in which something is wrong.

    Attributes
    ----------
    file
        The name of the file.
    number
        Of the line, counted from 1.
    """

    file: str
    number: int

    def said(self, language: Language) -> str:
        """In front of a sentence: "job.toml, line 6: "."""
        word = {"en": "line", "de": "Zeile"}[language]
        return f"{self.file}, {word} {self.number}: "
