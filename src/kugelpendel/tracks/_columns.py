"""What every recording is made of: columns of one length, beside times that ascend."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers, as_array, wrong_type


class _Timed(Protocol):
    @property
    def time(self) -> Numbers: ...
    @property
    def unit(self) -> str: ...


def keep_columns(recording: _Timed, *names: str) -> None:
    """Check the columns of a recording, and keep copies of them that cannot be changed.

    Parameters
    ----------
    recording
        A frozen dataclass that has been given them.
    names
        Those beside `time`.

    Raises
    ------
    InvalidInput
        For what is not made of numbers, arrays of other shapes or of different lengths, numbers
        that are not finite, times that do not ascend, and a unit that is no text.
    """
    if not isinstance(recording.unit, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise wrong_type("unit", recording.unit, "text", 'write "m", for instance')
    shape = np.shape(as_array(recording.time, "time", "s"))
    for name in ("time", *names):
        unit = {"time": "s", "azimuth": "rad"}.get(name, recording.unit)
        values = as_array(getattr(recording, name), name, unit).copy()
        if values.ndim != 1 or values.shape != shape:
            raise InvalidInput.of(
                "columns_shape", what=name, seen=str(values.shape), times=str(shape)
            )
        if not np.isfinite(values).all():
            where = int(np.flatnonzero(~np.isfinite(values))[0])
            seen = float(values[where])
            raise InvalidInput.of("columns_finite", what=name, row=where, seen=seen)
        values.flags.writeable = False
        object.__setattr__(recording, name, values)
    time = recording.time
    steps = np.diff(time)
    if (steps <= 0).any():
        where = int(np.argmax(steps <= 0))
        before, after = (float(time[where + k]) for k in (0, 1))
        raise InvalidInput.of("columns_ascending", before=(before, "s"), after=(after, "s"))
