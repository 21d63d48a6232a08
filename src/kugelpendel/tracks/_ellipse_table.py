"""Ellipses that somebody else has measured, one to a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, final

from kugelpendel.parameters import Numbers
from kugelpendel.tracks._columns import keep_columns
from kugelpendel.tracks._note import Note


@final
@dataclass(frozen=True, eq=False)
class EllipseTable:
    """A table of ellipses, where a recording was reduced to them already.

    Attributes
    ----------
    time
        s, ascending, no two alike; shape (n,).
    a
        Half the length of the swing in `unit`, positive; shape (n,).
    b
        Half its width in `unit`, positive counter-clockwise seen from above; shape (n,).
    azimuth
        Of the major axis, rad, counter-clockwise seen from above, on one branch; shape (n,).
    unit
        What a and b are counted in: "m", or what the file has, such as "px".
    notes
        What was changed, dropped or assumed on the way.

    Raises
    ------
    InvalidInput
        For arrays of different lengths, numbers that are not finite, times that do not ascend.
    """

    time: Numbers
    a: Numbers
    b: Numbers
    azimuth: Numbers
    unit: str = "m"
    notes: tuple[Note, ...] = ()

    axes: ClassVar[Literal["room"]] = "room"
    """No phone writes tables of ellipses."""

    def __post_init__(self) -> None:
        keep_columns(self, "a", "b", "azimuth")

    def __len__(self) -> int:
        return len(self.time)
