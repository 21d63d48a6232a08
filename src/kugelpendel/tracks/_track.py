"""A recorded track: where the bob was seen, and when."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, final

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers
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
        for name in ("time", "x", "y"):
            values = np.array(getattr(self, name), dtype=float)
            if values.ndim != 1 or values.shape != np.shape(self.time):
                raise InvalidInput(
                    f"A track has one {name} to each time in a flat array, but the shapes are "
                    f"{values.shape} and {np.shape(self.time)}; leave out what belongs to no time."
                )
            if not np.isfinite(values).all():
                where = int(np.flatnonzero(~np.isfinite(values))[0])
                raise InvalidInput(
                    f"{name} of point {where} is {values[where]}; leave out points that were not "
                    "seen."
                )
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        steps = np.diff(self.time)
        if (steps <= 0).any():
            where = int(np.argmax(steps <= 0))
            raise InvalidInput(
                f"The times of a track ascend, but after {self.time[where]} s comes "
                f"{self.time[where + 1]} s; sort them and keep one point of each time."
            )

    def __len__(self) -> int:
        return len(self.time)
