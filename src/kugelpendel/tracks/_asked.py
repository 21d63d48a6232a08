"""What is asked of a track is of the right type, or there is a sentence."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kugelpendel.parameters import one_number, require_type, wrong_type
from kugelpendel.tracks._track import Track

_READ_ONE = "read one with kugelpendel.tracks.read(path)"


def require(is_right: bool, what: str, given: object, wanted: str, way_out: str) -> None:
    """Raise InvalidInput unless what was given is right.

    Parameters
    ----------
    what, wanted, way_out
        For the sentence: what was asked, the type that it has to be, and what to write.
    """
    if not is_right:
        raise wrong_type(what, given, wanted, way_out)


def require_track(given: Any) -> None:
    """Raise InvalidInput for what is no track."""
    require_type("The track", given, Track, way_out=_READ_ONE)


def require_text(what: str, given: Any) -> None:
    """Raise InvalidInput for what is no text."""
    require(isinstance(given, str), what, given, "text", "write it in quotes")


def require_listener(given: Callable[..., object] | None) -> None:
    """Raise InvalidInput for a progress that nothing can be told."""
    way_out = "give one that is told how far the work is, or None"
    require(given is None or callable(given), "The progress", given, "function", way_out)


def whole(what: str, given: Any, least: int, most: int) -> int:
    """A whole number within these bounds; raises InvalidInput for anything else."""
    number = one_number(given, what, "")
    way_out = f"write one from {least} to {most}"
    is_whole = number.is_integer() and least <= number <= most
    require(is_whole, what, given, "whole number", way_out)
    return int(number)
