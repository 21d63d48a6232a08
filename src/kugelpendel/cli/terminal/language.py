"""The language in which a command writes."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from kugelpendel.errors import InvalidInput, Language

if TYPE_CHECKING:
    from collections.abc import Mapping

_LANGUAGES: tuple[Language, ...] = ("de", "en")


def known_language(language: str | None, environment: Mapping[str, str] = os.environ) -> Language:
    """Choose the language to write in: the one given, or that of the locale, or English.

    Raises
    ------
    InvalidInput
        There is no text in that language.
    """
    if language is None:
        variables = ("LC_ALL", "LC_MESSAGES", "LANG")
        locale = next((environment[name] for name in variables if environment.get(name)), "")
        return "de" if locale.lower().startswith("de") else "en"
    for known in _LANGUAGES:
        if known == language:
            return known
    raise InvalidInput(
        f"There is no text in the language {language!r}; choose "
        f"{' or '.join(f'--lang {known}' for known in _LANGUAGES)}."
    )
