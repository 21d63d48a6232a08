"""One table of a job file: which keys it may have, and what they say."""

from __future__ import annotations

from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, cast

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.quantity import read_quantity, show

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from kugelpendel.cli.job_file.kinds import Kind


@dataclass(frozen=True)
class Table:
    """A table of the file, under its name."""

    name: str
    entries: Mapping[str, Any]

    def where(self, key: str) -> str:
        """The place of a key, for a sentence."""
        return f"[{self.name}] {key}"

    def allow(self, keys: Iterable[str], owner: str = "") -> None:
        """Refuse every key that is not among the given ones."""
        allowed = list(keys)
        for key in self.entries:
            if key not in allowed:
                raise InvalidInput(
                    f"{self.where(key)} is not known{owner}{did_you_mean(key, allowed)}; "
                    f"allowed are {', '.join(allowed)}."
                )

    def quantity(self, key: str, kind: Kind, default: float | None = None) -> float:
        """A number in the SI unit of its kind; without a default the key must be there."""
        if key not in self.entries:
            if default is None:
                raise InvalidInput(f'{self.where(key)} is missing; write {key} = "{kind.example}".')
            return default
        return read_quantity(self.entries[key], kind, self.where(key))

    def vector(self, key: str, kind: Kind) -> tuple[float, float, float]:
        """Three numbers in the SI unit of their kind."""
        value = self.entries.get(key)
        example = f'{key} = ["{kind.example}", 0, 0]'
        if value is None:
            raise InvalidInput(f"{self.where(key)} is missing; write {example}.")
        if not isinstance(value, list) or len(cast("list[object]", value)) != 3:
            raise InvalidInput(
                f"{self.where(key)} = {show(cast('object', value))} does not have three "
                f"components; write {example}."
            )
        x, y, z = (
            read_quantity(component, kind, f"{self.where(key)}[{axis}]")
            for axis, component in zip("xyz", cast("list[object]", value), strict=True)
        )
        return x, y, z

    def choice(self, key: str, allowed: Iterable[str], default: str | None = None) -> str:
        """One of a few words."""
        words = list(allowed)
        value = self.entries.get(key, default)
        listed = ", ".join(f'"{word}"' for word in words)
        if value is None:
            raise InvalidInput(f"{self.where(key)} is missing; write one of {listed}.")
        if not isinstance(value, str) or value not in words:
            raise InvalidInput(
                f"{self.where(key)} = {show(value)} is not known{did_you_mean(str(value), words)}; "
                f"allowed are {listed}."
            )
        return value

    def truth(self, key: str, default: bool) -> bool:
        """``true`` or ``false``."""
        value = self.entries.get(key, default)
        if not isinstance(value, bool):
            raise InvalidInput(f"{self.where(key)} = {show(value)}: write true or false.")
        return value


def did_you_mean(word: str, allowed: Iterable[str]) -> str:
    """A question that names the closest allowed word, or nothing."""
    close = get_close_matches(word.lower(), list(allowed), n=1, cutoff=0.6)
    return f" (did you mean {close[0]}?)" if close else ""


def split(
    tables: Mapping[str, Any], names: Iterable[str], optional: Iterable[str] = ()
) -> list[Table]:
    """Take a file apart: all the tables that it must have, and then those of the optional ones."""
    wanted = list(names)
    possible = [*wanted, *optional]
    listed = ", ".join(f"[{name}]" for name in wanted)
    allowed = ", ".join(f"[{name}]" for name in possible)
    for name, entries in tables.items():
        if name not in possible:
            shown = f"[{name}]" if isinstance(entries, dict) else f"{name} = {show(entries)}"
            raise InvalidInput(
                f"{shown} is not known{did_you_mean(name, possible)}; a job has the tables "
                f"{allowed}, and every key stands in one of them."
            )
        if not isinstance(entries, dict):
            raise InvalidInput(f"{name} = {show(entries)} should be a table: write [{name}].")
    for name in wanted:
        if name not in tables:
            raise InvalidInput(f"the table [{name}] is missing; a job has {listed}.")
    present = [name for name in possible if name in tables]
    return [Table(name, cast("dict[str, Any]", tables[name])) for name in present]
