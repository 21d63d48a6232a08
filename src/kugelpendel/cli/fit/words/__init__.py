"""The words of the report on a track, in English and German."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files

from kugelpendel.errors import Language


@cache
def words(language: Language) -> dict[str, str]:
    """All texts of one language by their keys; some have places for numbers in braces."""
    text = files(__name__).joinpath(f"{language}.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)
