"""A recorded track: where the bob was seen, and when."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, final

from kugelpendel.parameters import Numbers
from kugelpendel.tracks._columns import keep_columns
from kugelpendel.tracks._note import Note


@final
@dataclass(frozen=True, eq=False)
class Track:
    """Times and positions of the bob in the horizontal plane, seen from above.

    Attributes
    ----------
    time
        s, ascending, no two alike; shape (n,). They need not be evenly spaced.
    x, y
        Position in `unit`, from any fixed point; shape (n,). A turn from x to y is
        counter-clockwise seen from above.
    unit
        What the positions are counted in: "m", or what the recording has, such as "px".
    notes
        What was changed, dropped or assumed on the way from a file.
    axes
        Of what x and y are the axes: "room", or "phone" for a phone that swings itself; its axes
        turn with it, so that such a track tells period, decay and a, but never a precession.

    Raises
    ------
    InvalidInput
        For arrays of other shapes or of different lengths, numbers that are not finite, and times
        that do not ascend.
    """

    time: Numbers
    x: Numbers
    y: Numbers
    unit: str = "m"
    notes: tuple[Note, ...] = ()
    axes: Literal["room", "phone"] = "room"

    def __post_init__(self) -> None:
        keep_columns(self, "x", "y")

    def __len__(self) -> int:
        return len(self.time)
