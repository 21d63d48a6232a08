"""What a file has in one of its tables, checked against the schema."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, NoReturn, cast

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.kinds import Kind
from kugelpendel.cli.job_file.quantity import read_quantity, show
from kugelpendel.cli.job_file.schema import Choice, Number, Vector
from kugelpendel.cli.job_file.schema_text import value_to_paste

if TYPE_CHECKING:
    from collections.abc import Generator, Iterable, Mapping

    from kugelpendel.cli.job_file.schema import FileSchema, Section
    from kugelpendel.errors import Door, Language


class Mistake(InvalidInput):
    """Something wrong in a file, said to who writes it unless asked otherwise.

    Attributes
    ----------
    section, key
        Where it stands; empty for nowhere.
    """

    section = ""
    key = ""

    @classmethod
    def placed(cls, what: InvalidInput, section: str, key: str = "") -> Mistake:
        """What is wrong, with its place in the file."""
        mistake = cls(*what.args, kind=what.kind, values=what.values, place=what.place)
        mistake.section, mistake.key = section, key
        return mistake

    @classmethod
    def in_table(cls, what: InvalidInput, section: str, key: str = "") -> Mistake:
        """The same, with the table in front of a sentence that does not name it."""
        table = f"[{section}] "
        return cls.placed(what if table in str(what) else what.at(table), section, key)

    def sentence(self, language: Language = "en", door: Door = "file") -> str:
        """What was wrong, the value seen, and the way out in a file."""
        return super().sentence(language, door)


@dataclass(frozen=True)
class Entries:
    """The entries of one table; one that the file has not is empty."""

    section: Section
    values: Mapping[str, Any]

    def __contains__(self, key: str) -> bool:
        return key in self.values

    def where(self, key: str) -> str:
        """The place of a key, for a sentence."""
        return f"[{self.section.name}] {key}"

    def check(self) -> None:
        """Refuse keys that do not belong here, and those that say the same thing twice."""
        allowed = [key.name for key in self.section.keys]
        of = ""
        if self.section.ways:
            kind = self.word("kind")
            way = next(way for way in self.section.ways if way.word == kind)
            allowed, of = ["kind", *way.keys], kind
        for key in self.values:
            if key not in allowed:
                meant = closest(key, allowed)
                self.refuse("file_key", key, of=of, meant=meant, allowed=", ".join(allowed))
        options = [option for option in self.section.one_of if any(key in self for key in option)]
        if len(options) > 1:
            given = [key for option in options for key in option if key in self]
            self.refuse(
                "file_twice",
                given[-1],
                table=self.section.name,
                given=", ".join(given),
                options=", ".join(" + ".join(option) for option in self.section.one_of),
            )

    def refuse(self, kind: str, key: str, **values: str) -> NoReturn:
        """Refuse a key or its value, which the sentence of the kind has as ``where`` and ``seen``.

        Raises
        ------
        Mistake
            In any case.
        """
        seen = show(self.values.get(key))
        what = InvalidInput.of(kind, where=self.where(key), seen=seen, key=key, **values)
        raise Mistake.placed(what, self.section.name, key)

    def number(self, key: str, default: float | None = None) -> float:
        """A number in SI: that of the file, or the default given here, or that of the schema."""
        value = self.given(key)
        if value is None:
            value = default if default is not None else self.section.key(key).default
        return cast("float", self._missing(key) if value is None else value)

    def given(self, key: str) -> float | None:
        """A number in SI, or None where the file has none."""
        if key not in self:
            return None
        holds = self.section.key(key).holds
        if isinstance(holds, Kind):
            with self.at(key):
                return read_quantity(self.values[key], holds, self.where(key))
        assert isinstance(holds, Number)
        value = self.values[key]
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            self.refuse("file_plain", key, example=f"{holds.example:g}")
        return float(value)

    def vector(self, key: str) -> tuple[float, float, float]:
        """Three numbers in SI."""
        holds = self.section.key(key).holds
        assert isinstance(holds, Vector)
        value: object = self.values.get(key)
        if value is None:
            self._missing(key)
        if not isinstance(value, list) or len(cast("list[object]", value)) != 3:
            self.refuse("file_components", key, example=value_to_paste(self.section.key(key)))
        with self.at(key):
            x, y, z = (
                read_quantity(component, holds.kind, f"{self.where(key)}[{axis}]")
                for axis, component in zip("xyz", cast("list[object]", value), strict=True)
            )
        return x, y, z

    def word(self, key: str) -> str:
        """One of a few words."""
        declared = self.section.key(key)
        assert isinstance(declared.holds, Choice)
        words = declared.holds.choices
        value: object = self.values.get(key, declared.default)
        listed = ", ".join(f'"{word}"' for word in words)
        if value is None:
            self.refuse("file_word_missing", key, allowed=listed)
        if not isinstance(value, str) or value not in words:
            self.refuse("file_word", key, meant=closest(str(value), words), allowed=listed)
        return value

    def truth(self, key: str) -> bool:
        """``true`` or ``false``."""
        value: object = self.values.get(key, self.section.key(key).default)
        if not isinstance(value, bool):
            self.refuse("file_truth", key)
        return value

    @contextmanager
    def at(self, key: str = "") -> Generator[None]:
        """Name the table in what a parameter refuses, and note where the mistake stands."""
        try:
            yield
        except Mistake:
            raise
        except InvalidInput as error:
            if key:
                raise Mistake.placed(error, self.section.name, key) from error
            # Its values have names such as drag.linear, or those of the launch alone.
            names = (seen.name.rpartition(".")[2] for seen in error.values)
            key = next((name for name in names if name in self), "")
            raise Mistake.in_table(error, self.section.name, key) from error

    def _missing(self, key: str) -> NoReturn:
        self.refuse("file_key_missing", key, example=value_to_paste(self.section.key(key)))


def closest(word: str, allowed: Iterable[str]) -> str:
    """The allowed word that may have been meant, or nothing."""
    close = get_close_matches(word.lower(), list(allowed), n=1, cutoff=0.6)
    return close[0] if close else ""


def take_apart(tables: Mapping[str, Any], schema: FileSchema) -> dict[str, Entries]:
    """Take a file apart into its tables, all of them checked; those that it has not are empty."""
    possible = [section.name for section in schema.sections]
    wanted = [section.name for section in schema.sections if section.needed]
    allowed, needed = (", ".join(f"[{name}]" for name in names) for names in (possible, wanted))
    for name, entries in tables.items():
        if name not in possible:
            shown = f"[{name}]" if isinstance(entries, dict) else f"{name} = {show(entries)}"
            meant = closest(name, possible)
            what = InvalidInput.of("file_table", seen=shown, meant=meant, allowed=allowed)
            raise Mistake.placed(what, name)
        if not isinstance(entries, dict):
            what = InvalidInput.of("file_no_table", table=name, seen=show(entries))
            raise Mistake.placed(what, name)
    for name in wanted:
        if name not in tables:
            raise InvalidInput.of("file_table_missing", table=name, needed=needed)
    found = {
        section.name: Entries(section, cast("dict[str, Any]", tables.get(section.name, {})))
        for section in schema.sections
    }
    for name in tables:
        found[name].check()
    return found
