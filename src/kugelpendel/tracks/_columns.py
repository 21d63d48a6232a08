"""What every recording is made of: columns of one length, beside times that ascend."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers


class _Timed(Protocol):
    @property
    def time(self) -> Numbers: ...


def keep_columns(
    recording: _Timed, *names: str, whole: str, point: str, row: str, unseen: str
) -> None:
    """Check the columns of a recording, and keep copies of them that cannot be changed.

    Parameters
    ----------
    recording
        A frozen dataclass that has been given them.
    names
        Those beside `time`.
    whole, point, row
        What the recording, what belongs to one time, and a line of it are called.
    unseen
        What may be left out.

    Raises
    ------
    InvalidInput
        For arrays of other shapes or of different lengths, numbers that are not finite, and times
        that do not ascend.
    """
    shape = np.shape(recording.time)
    for name in ("time", *names):
        values = np.array(getattr(recording, name), dtype=float)
        if values.ndim != 1 or values.shape != shape:
            raise InvalidInput(
                f"A {whole} has one {name} to each time in a flat array, but the shapes are "
                f"{values.shape} and {shape}; leave out what belongs to no time."
            )
        if not np.isfinite(values).all():
            where = int(np.flatnonzero(~np.isfinite(values))[0])
            raise InvalidInput(f"{name} of {point} {where} is {values[where]}; leave out {unseen}.")
        values.flags.writeable = False
        object.__setattr__(recording, name, values)
    time = recording.time
    steps = np.diff(time)
    if (steps <= 0).any():
        where = int(np.argmax(steps <= 0))
        raise InvalidInput(
            f"The times of a {whole} ascend, but after {time[where]} s comes "
            f"{time[where + 1]} s; sort them and keep one {row} of each time."
        )
