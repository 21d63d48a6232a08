"""The sentences, in the language and for the door that are asked for."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kugelpendel.errors._seen import Door, Language, Seen

_EXACT = ("pendulum", "")
"""Parts whose values are shown to the last digit, as the exact motion takes them so.

What acts on a real pendulum is shown to six digits.
"""

_BREAK = re.compile(r"\s*\n\s*")


class _Number(float):
    """A number that is written in full where nothing else is asked for."""

    def __format__(self, spec: str) -> str:
        return format(float(self), spec) if spec else _in_full(self)


def sentence(kind: str, values: Sequence[Seen], language: Language, door: Door) -> str:
    """The sentence of a kind with its values filled in.

    Parameters
    ----------
    kind
        Of the core or of the Python side.
    values
        Under their names; the first of them is also there as name, value and unit, and with the
        spoken name and the way out of its quantity.
    language, door
        Which of the four sentences.
    """
    tables = read(language)
    entry = tables["kinds"][kind]
    filled: dict[str, Any] = {}
    for seen in reversed(values):
        value = seen.value
        value = _spoken(seen.name, value, tables) if isinstance(value, str) else _Number(value)
        filled[seen.name.replace(".", "_")] = value
    if values:
        first = values[0]
        shown = filled[first.name.replace(".", "_")]
        filled = {"name": first.name, "value": shown, "unit": first.unit, **filled}
        filled |= _quantity(tables, first, door)
    return entry.get(door, entry["python"]).format_map(filled)


def _spoken(name: str, text: str, tables: dict[str, Any]) -> str:
    """What is said for a text, in one line: by its name an aside, a word, or a quantity."""
    text = _BREAK.sub(" ", text)
    if name in tables["asides"]:
        return tables["asides"][name].format(text) if text else ""
    if name in tables["words"]:
        return tables["words"][name][text]
    if name != "what":
        return text
    if text in tables["quantities"]:
        return tables["quantities"][text]["name"]
    part, _, component = text.partition(".")
    return tables["launch"].format(name=component) if part == "launch" and component else text


def _quantity(tables: dict[str, Any], seen: Seen, door: Door) -> dict[str, str]:
    """Spoken name, value with its unit and way out; what has no entry keeps the core's name."""
    entry = tables["quantities"].get(seen.name, {"name": seen.name, "python": tables["unnamed"]})
    if isinstance(seen.value, str):
        return {}
    part = seen.name.rpartition(".")[0]
    shown = _in_full(seen.value) if part in _EXACT else f"{seen.value:.6g}"
    return {
        "spoken": entry["name"],
        "shown": f"{shown} {seen.unit}".rstrip(),
        "way_out": entry.get(door, entry["python"]),
    }


@cache
def read(language: Language) -> dict[str, Any]:
    """The tables of one language."""
    text = files("kugelpendel.errors").joinpath("sentences", f"{language}.toml")
    return tomllib.loads(text.read_text(encoding="utf-8"))


def _in_full(value: float) -> str:
    """All digits, without an exponent where that is readable."""
    if value != value:
        return "NaN"
    text = repr(float(value)).removesuffix(".0")
    if "e" in text and 1e-9 <= abs(value) < 1e16:
        digits = len(text.partition("e")[0].lstrip("-").replace(".", ""))
        exponent = int(text.partition("e")[2])
        text = f"{value:.{max(0, digits - 1 - exponent)}f}"
    return text
