"""The schema in words: an example of a file, the list for the help, the tables of the docs."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from kugelpendel.cli.job_file.kinds import Kind
from kugelpendel.cli.job_file.schema import Choice, Key, Number, Section, Several, Truth, Vector

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from kugelpendel.cli.job_file.schema import FileSchema

_COLUMN = 23
"""Of the remarks in an example."""

_NAME = 12
"""Columns of the names in the list for the help."""


def example(schema: FileSchema) -> str:
    """Write the example of a file, with what may stand in place of a line beside it."""
    parts: list[str] = []
    for name, entries in schema.example.items():
        section = schema.section(name)
        lines = [f"[{name}]"]
        for key, value in entries.items():
            line, remark = f"{key} = {value}", _others(section, section.key(key), entries)
            lines.append(f"{line:<{_COLUMN - 2}}  # or {remark}" if remark else line)
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)


def listing(schema: FileSchema, width: int) -> str:
    """List the tables and their keys for the help, in so many columns."""
    lines: list[str] = []
    for needed in (True, False):
        sections = [section for section in schema.sections if section.needed is needed]
        if sections and not needed:
            lines.append("\nand where they are wanted:\n")
        for section in sections:
            start = f"  {section.name:<{_NAME}}"
            ways = [f'kind = "{way.word}", {", ".join(way.keys)}' for way in section.ways]
            for line in ways or [", ".join(_listed(section))]:
                lines += textwrap.wrap(
                    line, width, initial_indent=start, subsequent_indent=" " * len(start)
                )
                start = " " * len(start)
    return "\n".join(lines)


def markdown(sections: Iterable[Section], classes: Mapping[str, str] | None = None) -> str:
    """Write the table of the docs.

    Parameters
    ----------
    sections
        Those that it describes.
    classes
        Names of the Python classes that stand beside those of the tables.
    """
    lines = ["| table | key | such as | what |", "|---|---|---|---|"]
    for section in sections:
        name = f"`[{section.name}]`"
        if classes and section.name in classes:
            name += f", `{classes[section.name]}`"
        for cells in _rows(section):
            lines.append(f"| {' | '.join((name, *cells))} |".replace("|  |", "| |"))
            name = ""
    return "\n".join(lines) + "\n"


def value_to_paste(key: Key) -> str:
    """Show what may stand right of the equals sign."""
    if key.example:
        return key.example
    match key.holds:
        case Kind() as kind:
            return f'"{kind.example}"'
        case Vector(kind):
            return f'["{kind.example}", 0, 0]'
        case Choice(choices):
            return f'"{choices[0]}"'
        case Number(number):
            return f"{number:g}"
        case Truth():
            return "true"
        case Several(holds):
            return f'["{holds.example}"]' if isinstance(holds, Kind) else f'["{holds}"]'


def _rows(section: Section) -> Iterable[tuple[str, str, str]]:
    """Key, example and meaning."""
    of_a_way = {name for way in section.ways for name in way.keys}
    for key in section.keys:
        if key.name not in of_a_way:
            yield f"`{key.name}`", _code(value_to_paste(key)), _meaning(section, key)
    for way in section.ways:
        keys = ", ".join(f"`{name}`" for name in way.keys)
        yield f'`"{way.word}"`', "", f"{keys}: {way.text}"


def _meaning(section: Section, key: Key) -> str:
    text = key.text.replace("|", "\\|")
    first = section.one_of[0][0] if section.one_of else ""
    if any(key.name == option[0] for option in section.one_of[1:]):
        text = f"in place of `{first}`: {text}"
    if isinstance(key.holds, Choice) and not section.ways:
        *most, last = (f'`"{word}"`' for word in key.holds.choices)
        text += f": {', '.join(most)} or {last}"
    unless = _unless(key)
    return "; ".join(part for part in (text, f"{unless} unless given" if unless else "") if part)


def _unless(key: Key) -> str:
    """What is taken where the line is missing."""
    if key.unless or key.default is None:
        return key.unless
    if isinstance(key.default, bool):
        return f"`{str(key.default).lower()}`"
    return f'`"{key.default}"`' if isinstance(key.default, str) else f"{key.default:g}"


def _others(section: Section, key: Key, shown: Mapping[str, str]) -> str:
    """What may stand in place of a line of the example."""
    if isinstance(key.holds, Choice):
        return ", ".join(word for word in key.holds.choices if f'"{word}"' != shown[key.name])
    if not any(key.name in option for option in section.one_of):
        return ""
    rest = [" and ".join(option) for option in section.one_of if key.name not in option]
    return ", ".join(rest)


def _listed(section: Section) -> list[str]:
    """Keys, alternatives joined by "or"."""
    options = {option[0]: option for option in section.one_of}
    joined = " or ".join(" and ".join(option) for option in section.one_of)
    hidden = {name for option in section.one_of for name in option}
    first = section.one_of[0][0] if section.one_of else ""
    return [
        joined if key.name == first else key.name
        for key in section.keys
        if key.name not in hidden or (key.name in options and key.name == first)
    ]


def _code(text: str) -> str:
    return f"`{text}`"
