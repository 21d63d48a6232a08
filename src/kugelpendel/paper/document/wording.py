"""The wording of the derivation in one language, read from ``sentences/``."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, cast

from kugelpendel.errors import InvalidInput
from kugelpendel.paper.derivation.statements import LANGUAGES, resolved, sentences
from kugelpendel.paper.document.example import values

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.errors import Language
    from kugelpendel.paper.derivation.model import Misprint

_NAME = re.compile(r"<([a-z0-9-]+)>")


@dataclass(frozen=True)
class Words:
    """Texts of the document; `kugelpendel.paper.document.prose` reads what is not words in them.

    Attributes
    ----------
    language
        "de" or "en".
    tables
        The file's tables, with formulas in the places of their names.
    """

    language: Language
    tables: Mapping[str, Any]

    def ui(self, key: str, *values: object) -> str:
        """Give a short text of the document's frame, with values in its gaps."""
        text: str = self.tables["ui"][key]
        return text.format(*values) if values else text

    def title(self) -> str:
        """Give the document's title."""
        return str(self.tables["title"])

    def subtitle(self) -> str:
        """Give what stands under the title."""
        return str(self.tables["subtitle"])

    def paragraphs(self, name: str) -> tuple[str, ...]:
        """Give the introduction, the conventions, the closing or the example."""
        return tuple(self._filled(one) for one in self.tables[name])

    def number(self, label: str) -> str:
        """Say what a display means for the pendulum of the example; "" where nothing is said."""
        return self._filled(self.tables["number"].get(label, ""))

    def picture(self, key: str) -> Mapping[str, str]:
        """Give title, caption and description of a picture, and the words in it."""
        entry: dict[str, str] = self.tables["picture"][key]
        return {name: self._filled(text) for name, text in entry.items()}

    def section(self, number: int) -> tuple[str, str]:
        """Give title and lead of one of the paper's sections."""
        entry = self.tables["section"][str(number)]
        return entry["title"], entry["lead"]

    def kind(self, kind: str) -> str:
        """Name a kind of step."""
        return str(self.tables["kind"][kind])

    def formula(self, label: str) -> str:
        """Say something about a formula or a display; "" where nothing is said."""
        return str(self.tables["formula"].get(label, ""))

    def condition(self, key: str) -> str:
        """Say a condition in words."""
        return str(self.tables["condition"][key])

    def consequence(self, name: str) -> str:
        """Say what happens where a condition fails, or why it holds."""
        table = "holds" if self.is_met(name) else "consequence"
        return str(self.tables[table][name])

    def is_met(self, name: str) -> bool:
        """Tell whether a condition turns out to hold by itself."""
        return name in self.tables["holds"]

    def fate(self, name: str) -> str:
        """Give what stands before the consequence."""
        return self.ui("holds" if self.is_met(name) else "fails")

    def neglected(self, kind: str) -> str:
        """Give what stands before the terms that a kind of step neglects."""
        return self.ui("terms_with" if kind == "average" else "order")

    def printed(self, one: Misprint) -> str:
        """Give what the paper prints, as a sentence: a formula between dollars, or German words."""
        return quoted(one.printed)

    def right(self, one: Misprint) -> str:
        """Give what should stand there, in this language."""
        return str(self.tables["right"].get(one.key) or quoted(one.right))

    def misprint(self, key: str) -> str:
        """Say what is wrong, and how one knows."""
        return str(self.tables["misprint"][key])

    def _filled(self, text: str) -> str:
        """Put the numbers of the example in the places of their names."""
        return _NAME.sub(lambda found: values(self.language)[found[1]], text)


def quoted(text: str) -> str:
    """Put LaTeX between dollars, leave words as they are, and write a dash for nothing."""
    if "\\" in text or "^" in text or text == "=":
        return f"${text}$"
    return text or "–"


@cache
def words(language: str) -> Words:
    """Read the wording of a language, one of `LANGUAGES`, with its statements put in.

    Raises
    ------
    InvalidInput
        There is no text in that language.
    """
    for known in LANGUAGES:
        if known == language:
            return Words(known, {key: _resolved(one) for key, one in sentences(known).items()})
    choice = " or ".join(repr(known) for known in LANGUAGES)
    raise InvalidInput(f"There is no text in the language {language!r}; choose {choice}.")


def _resolved(entry: Any) -> Any:
    match entry:
        case str():
            return resolved(entry)
        case list():
            return [_resolved(one) for one in cast("list[Any]", entry)]
        case _:
            return {key: _resolved(one) for key, one in cast("dict[str, Any]", entry).items()}
