"""The user asked to stop."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language


class Interrupted(KeyboardInterrupt):
    """An interruption that says in a sentence what is kept."""


NOTHING_LEFT: dict[Language, str] = {
    "en": "interrupted; no file is left half-written.",
    "de": "abgebrochen; keine Datei ist halb geschrieben.",
}
"""What is said of an interruption where nothing is kept."""
