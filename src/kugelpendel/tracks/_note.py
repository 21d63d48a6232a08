"""What was changed, dropped, assumed or merely seen on the way from a file to its track."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal, TypeAlias, final

from kugelpendel.errors import Language
from kugelpendel.spelling import general

Action: TypeAlias = Literal["changed", "dropped", "assumed", "seen"]

Value: TypeAlias = str | float | int


@final
@dataclass(frozen=True)
class Note:
    """One thing that a track's reader has to know, as data; `sentence` words it.

    Attributes
    ----------
    kind
        A word that stays from one version to the next, such as "doubled_rows".
    values
        The numbers and names that belong to it, in SI units where they have one.
    """

    kind: str
    values: Mapping[str, Value]

    @classmethod
    def of(cls, kind: str, **values: Value) -> Note:
        """A note of a kind with its values."""
        return cls(kind, values)

    @property
    def action(self) -> Action:
        """Whether something was changed, dropped or assumed, or is merely worth knowing."""
        return _read("en")[self.kind]["action"]

    def sentence(self, language: Language = "en") -> str:
        """The note as a sentence; names out of the file stand in it as they are."""
        texts = _read(language)[self.kind]
        text: str = texts["one" if "one" in texts and self.values.get("count") == 1 else "text"]
        said = {name: _said(value, language) for name, value in self.values.items()}
        return text.format_map(said)


def _said(value: Value, language: Language) -> str:
    return value if isinstance(value, str) else general(value, 6, language=language)


@cache
def _read(language: Language) -> dict[str, Any]:
    text = files("kugelpendel.tracks").joinpath("sentences", f"{language}.toml")
    return tomllib.loads(text.read_text(encoding="utf-8"))
