"""Times as they are asked for."""

from __future__ import annotations

import os
from functools import cache
from math import isfinite
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel import _core
from kugelpendel.parameters import (
    InvalidInput,
    Launch,
    Numbers,
    Pendulum,
    as_array,
    one_number,
)


def motion_shape(pendulum: Pendulum, launch: Launch) -> tuple[int, ...]:
    """The shape that a pendulum and a launch broadcast to.

    Raises InvalidInput where there is none.
    """
    try:
        return np.broadcast_shapes(pendulum.shape, launch.shape)
    except ValueError:
        raise InvalidInput(
            f"The pendulum's shape {pendulum.shape} and the launch's {launch.shape} do not fit "
            f"together; give one of them another axis."
        ) from None


def checked_times(t: ArrayLike, numbers_each: int) -> Numbers:
    """The times as an array; `numbers_each` is how many results one time will make."""
    times = as_array(t, "The times", "s")
    if _core.extent(times.ravel()) is None:
        wrong = times[~np.isfinite(times)]
        raise InvalidInput(
            f"Times must be finite, but {wrong.size} of {times.size} are not, the first of them "
            f"{wrong.flat[0]} s."
        )
    check_memory(times.size, numbers_each)
    return times


_LATEST = 1e100
"""s: beyond it a time in units of 1/ω0 need not be a number, and no integration gets there."""


def followed_times(t: ArrayLike, numbers_each: int) -> Numbers:
    """The same for a motion that is followed, not read off a closed form: no further than it goes.

    Raises InvalidInput.
    """
    times = checked_times(t, numbers_each)
    first, last = _core.extent(times.ravel()) or (0.0, 0.0)
    if max(-first, last) > _LATEST:
        wrong = times[np.abs(times) > _LATEST]
        raise InvalidInput(
            f"An integration goes no further than {_LATEST:g} s from the launch, but "
            f"{wrong.flat[0]} s is asked for; ExactMotion goes to any time."
        )
    return times


def one_time(value: ArrayLike, name: str) -> float:
    """A time after the launch, s.

    Raises InvalidInput for what is no number, for a time before the launch and for one to which no
    integration gets.
    """
    time = one_number(value, name, "s")
    if not 0 <= time <= _LATEST:
        raise InvalidInput(
            f"{name} must lie between 0 and {_LATEST:g} s after the launch, but it is {time} s."
        )
    return time


def checked_grid(start: float, step: float, count: int, numbers_each: int) -> int:
    """The count as an int, where the grid makes sense."""
    for name, given in (("start", start), ("step", step)):
        value = one_number(given, f"The grid's {name}", "s")
        if not isfinite(value):
            raise InvalidInput(f"The grid's {name} must be finite, but it is {value} s.")
    if step == 0:
        raise InvalidInput(
            "The grid's step must not be 0 s: every sample would be the same; use position(start)."
        )
    size = checked_count(count, 0, "The count of samples")
    check_memory(size, numbers_each)
    return size


def checked_count(count: int, least: int, name: str) -> int:
    """The count as an int, where it is a whole number of any type."""
    try:
        whole = not isinstance(count, str | bytes) and float(count).is_integer()
    except (TypeError, ValueError, OverflowError):
        whole = False
    if not whole or count < least:
        raise InvalidInput(f"{name} must be a whole number ≥ {least}, but it is {count!r}.")
    return int(count)


def check_out(out: object, shape: tuple[int, ...]) -> None:
    """Refuse what results cannot be written into without a copy."""
    if not isinstance(out, np.ndarray):
        raise InvalidInput(f"out must be an array to be filled, but it is {out!r}.")
    array = cast("NDArray[np.generic]", out)
    flags = array.flags
    if array.dtype != np.float64 or not (flags.c_contiguous and flags.aligned and flags.writeable):
        raise InvalidInput(
            f"out must be a C-contiguous, writeable array of float64, but its dtype is "
            f"{array.dtype} and its strides {array.strides}; make it with numpy.empty({shape})."
        )
    if array.shape != shape:
        raise InvalidInput(
            f"out must have the shape {shape}, but its shape is {array.shape}; make it with "
            f"numpy.empty({shape})."
        )


def check_memory(count: int, numbers_each: int) -> None:
    """Refuse before the machine starts to swap."""
    needed = 8 * count * numbers_each
    if needed > (available := _memory()):
        raise InvalidInput(
            f"{count:.6g} samples would take {needed / 1e9:.3g} GB of memory, and this machine has "
            f"{available / 1e9:.3g} GB; ask for fewer, or go piece by piece with start."
        )


@cache
def _memory() -> int:
    """Bytes of memory in this machine; where it does not tell, as much as can be addressed."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return 2**62
