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
