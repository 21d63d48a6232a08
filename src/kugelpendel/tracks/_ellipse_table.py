"""Ellipses that somebody else has measured, one to a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers
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

    def __post_init__(self) -> None:
        for name in ("time", "a", "b", "azimuth"):
            values = np.array(getattr(self, name), dtype=float)
            if values.ndim != 1 or values.shape != np.shape(self.time):
                raise InvalidInput(
                    f"A table of ellipses has one {name} to each time in a flat array, but the "
                    f"shapes are {values.shape} and {np.shape(self.time)}; leave out what belongs "
                    "to no time."
                )
            if not np.isfinite(values).all():
                where = int(np.flatnonzero(~np.isfinite(values))[0])
                raise InvalidInput(
                    f"{name} of ellipse {where} is {values[where]}; leave out what was not "
                    "measured."
                )
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        steps = np.diff(self.time)
        if (steps <= 0).any():
            where = int(np.argmax(steps <= 0))
            raise InvalidInput(
                f"The times of a table of ellipses ascend, but after {self.time[where]} s comes "
                f"{self.time[where + 1]} s; sort them and keep one row of each time."
            )

    def __len__(self) -> int:
        return len(self.time)
