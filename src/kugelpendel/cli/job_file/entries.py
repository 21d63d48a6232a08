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
    from kugelpendel.errors import Door, FileLine, Language


class Mistake(InvalidInput):
    """Something wrong in a file.

    Parameters
    ----------
    said
        The sentence; empty for that of the cause, with the table in front of it.
    section, key
        Where it stands; empty for nowhere.
    cause
        What a parameter refuses.
    """

    def __init__(
        self,
        said: str = "",
        section: str = "",
        key: str = "",
        *,
        cause: InvalidInput | None = None,
        place: tuple[str | FileLine, ...] = (),
    ) -> None:
        super().__init__(said, place=place)
        self.section = section
        self.key = key
        self.cause = cause

    def sentence(self, language: Language = "en", door: Door = "file") -> str:
        """What was wrong, the value seen, and the way out in a file."""
        if self.cause is None:
            return super().sentence(language, door)
        said = self.cause.sentence(language, door)
        table = f"[{self.section}] "
        place = InvalidInput(place=self.place).sentence(language)
        return f"{place}{said if table in said else table + said}"

    def at(self, place: str | FileLine) -> Mistake:
        """The same with its place in front of the sentence."""
        return Mistake(
            self.args[0], self.section, self.key, cause=self.cause, place=(place, *self.place)
        )


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
        owner = ""
        if self.section.ways:
            kind = self.word("kind")
            way = next(way for way in self.section.ways if way.word == kind)
            allowed, owner = ["kind", *way.keys], f' for kind = "{kind}"'
        for key in self.values:
            if key not in allowed:
                raise Mistake(
                    f"{self.where(key)} is not known{owner}{did_you_mean(key, allowed)}; "
                    f"allowed are {', '.join(allowed)}.",
                    self.section.name,
                    key,
                )
        options = [option for option in self.section.one_of if any(key in self for key in option)]
        if len(options) > 1:
            given = [key for option in options for key in option if key in self]
            every = ", ".join(" and ".join(option) for option in self.section.one_of)
            raise Mistake(
                f"[{self.section.name}] has both {' and '.join(given)}, which say the same thing; "
                f"give one of them: {every}.",
                self.section.name,
                given[-1],
            )

    def refuse(self, key: str, rest: str) -> NoReturn:
        """Refuse a value: "[table] key = value", and the rest of the sentence."""
        raise Mistake(
            f"{self.where(key)} = {show(self.values.get(key))}{rest}", self.section.name, key
        )

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
            self.refuse(key, f" is not a plain number; write {key} = {holds.example:g}.")
        return float(value)

    def vector(self, key: str) -> tuple[float, float, float]:
        """Three numbers in SI."""
        holds = self.section.key(key).holds
        assert isinstance(holds, Vector)
        value: object = self.values.get(key)
        if value is None:
            self._missing(key)
        if not isinstance(value, list) or len(cast("list[object]", value)) != 3:
            pasted = value_to_paste(self.section.key(key))
            self.refuse(key, f" does not have three components; write {key} = {pasted}.")
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
            raise Mistake(
                f"{self.where(key)} is missing; write one of {listed}.", self.section.name
            )
        if not isinstance(value, str) or value not in words:
            meant = did_you_mean(str(value), words)
            self.refuse(key, f" is not known{meant}; allowed are {listed}.")
        return value

    def truth(self, key: str) -> bool:
        """``true`` or ``false``."""
        value: object = self.values.get(key, self.section.key(key).default)
        if not isinstance(value, bool):
            self.refuse(key, ": write true or false.")
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
                raise Mistake(str(error), self.section.name, key) from error
            # Its values have names such as drag.linear, or those of the launch alone.
            names = (seen.name.rpartition(".")[2] for seen in error.values)
            key = next((name for name in names if name in self), "")
            raise Mistake("", self.section.name, key, cause=error) from error

    def _missing(self, key: str) -> NoReturn:
        pasted = value_to_paste(self.section.key(key))
        raise Mistake(f"{self.where(key)} is missing; write {key} = {pasted}.", self.section.name)


def did_you_mean(word: str, allowed: Iterable[str]) -> str:
    """A question that names the closest allowed word, or nothing."""
    close = get_close_matches(word.lower(), list(allowed), n=1, cutoff=0.6)
    return f" (did you mean {close[0]}?)" if close else ""


def take_apart(tables: Mapping[str, Any], schema: FileSchema) -> dict[str, Entries]:
    """Take a file apart into its tables, all of them checked; those that it has not are empty."""
    possible = [section.name for section in schema.sections]
    wanted = [section.name for section in schema.sections if section.needed]
    allowed, listed = (", ".join(f"[{name}]" for name in names) for names in (possible, wanted))
    for name, entries in tables.items():
        if name not in possible:
            shown = f"[{name}]" if isinstance(entries, dict) else f"{name} = {show(entries)}"
            raise Mistake(
                f"{shown} is not known{did_you_mean(name, possible)}; a job has the tables "
                f"{allowed}, and every key stands in one of them.",
                name,
            )
        if not isinstance(entries, dict):
            raise Mistake(f"{name} = {show(entries)} should be a table: write [{name}].", name)
    for name in wanted:
        if name not in tables:
            raise Mistake(f"the table [{name}] is missing; a job has {listed}.")
    found = {
        section.name: Entries(section, cast("dict[str, Any]", tables.get(section.name, {})))
        for section in schema.sections
    }
    for name in tables:
        found[name].check()
    return found
