"""The user asked to stop."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language


class Interrupted(KeyboardInterrupt):
    """An interruption that says in a sentence what is kept."""


def is_interruption(error: BaseException) -> bool:
    """Whether the user asked to stop, also where Python took that for something else.

    Before 3.12, whatever is raised while a class names its attributes (``__set_name__``), as it may
    be during an import, becomes the cause of a RuntimeError.
    """
    return isinstance(error, KeyboardInterrupt) or (
        isinstance(error, RuntimeError) and isinstance(error.__cause__, KeyboardInterrupt)
    )


NOTHING_LEFT: dict[Language, str] = {
    "en": "interrupted; no file is left half-written.",
    "de": "abgebrochen; keine Datei ist halb geschrieben.",
}
"""What is said of an interruption where nothing is kept."""
