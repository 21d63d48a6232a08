"""What a motion was given: a part of it, and a short way to show it."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from kugelpendel.parameters import Numbers

_WIDTH = 200
"""Characters of the longest repr."""


def selected(value: Any, shape: tuple[int, ...], key: Any) -> Any:
    """What belongs to the motions at an index of an ensemble of that shape.

    Parameters
    ----------
    value
        An argument of the motion's constructor: arrays, alone or in what was given together, have
        a row for each case; what has no shape belongs to all.
    shape
        Of the ensemble.
    key
        Index, slice or mask, as NumPy takes them.
    """
    if isinstance(value, np.ndarray):
        numbers = cast("Numbers", value)
        part = np.broadcast_to(numbers, shape)[key]
        return float(part) if part.ndim == 0 else part
    if isinstance(value, tuple):
        parts = cast("tuple[Any, ...]", value)
        return tuple(selected(part, shape, key) for part in parts)
    if getattr(value, "shape", ()) == ():
        return value
    make, arguments = value.__reduce__()[:2]
    return make(*selected(arguments, shape, key))


def short(name: str, arguments: dict[str, Any]) -> str:
    """A call that says what was given, in one line of at most 200 characters."""
    # Pendulum and launch come first and need no name.
    parts = [
        repr(value) if key in ("pendulum", "launch") else f"{key}={value!r}"
        for key, value in arguments.items()
    ]
    for index, (key, value) in reversed(list(enumerate(arguments.items()))):
        if len(_call(name, parts)) <= _WIDTH:
            break
        if not hasattr(value, "shape"):
            continue
        label = "" if key in ("pendulum", "launch") else f"{key}="
        parts[index] = f"{label}{type(value).__name__}(…)"
    return _call(name, parts)


def _call(name: str, parts: list[str]) -> str:
    return " ".join(f"{name}({', '.join(parts)})".split())
