"""The text of a job file, and a sentence for everything that can be wrong with a file as such."""

from __future__ import annotations

import re
import sys
import tomllib
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kugelpendel import InvalidInput, KugelpendelError
from kugelpendel.cli.job_file.entries import Mistake
from kugelpendel.cli.job_file.schema_text import example
from kugelpendel.errors import FileLine

if TYPE_CHECKING:
    from collections.abc import Generator

    from kugelpendel.cli.job_file.schema import FileSchema
    from kugelpendel.errors import Door, Language

STANDARD_INPUT = Path("-")
"""What is named to read the file from there."""

_LARGEST = 1 << 20  # bytes; a job has a few hundred


@dataclass(frozen=True)
class JobDocument:
    """A TOML file that was read.

    Attributes
    ----------
    path
        Its name; ``stdin`` for standard input.
    text, tables
        What it says.
    """

    path: Path
    text: str
    tables: dict[str, Any]

    @contextmanager
    def named(self) -> Generator[None]:
        """Name the file, and where it can be known the line, in what is refused."""
        try:
            yield
        except KugelpendelError as error:
            line = self._line(error)
            raise error.at(FileLine(str(self.path), line) if line else f"{self.path}: ") from error

    def _line(self, error: KugelpendelError) -> int | None:
        """Where the mistake stands: that of the table and key, or of the value that was seen."""
        if isinstance(error, Mistake):
            return line_of(self.text, error.section, error.key)
        for seen in error.values:
            section, _, key = seen.name.rpartition(".")
            if key in self.tables.get(section, ()):
                return line_of(self.text, section, key)
        return None


def read_document(path: Path, schema: FileSchema) -> JobDocument:
    """Read a TOML file; that on standard input where the path is ``-``.

    Parameters
    ----------
    path
        The file.
    schema
        What it may say, for the example that is shown for an empty file.

    Raises
    ------
    InvalidInput
        Missing, a folder, unreadable, too large, not UTF-8, empty, or not TOML.
    """
    content, name = _from_stdin() if path == STANDARD_INPUT else (_content(path), path)
    text = _decoded(content, name)
    try:
        tables = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise _explained(error, name, text) from error
    if not tables:
        raise _Empty.followed_by(example(schema), name)
    return JobDocument(name, text, tables)


def line_of(text: str, section: str, key: str) -> int | None:
    """Find the line of a key, or that of its table where the key is not there; None for neither.

    TOML's own reader keeps no places. A line that looks like the one sought is it if what stands
    above it is TOML by itself, which it is not in the middle of a string of several lines.
    """
    if not section:
        return None
    name, quoted = re.escape(section), rf"[\"']?{re.escape(section)}[\"']?"
    header = re.compile(rf"\s*\[+\s*{quoted}\s*\]")
    inline = re.compile(rf"\s*{quoted}\s*[=.]")
    entry = re.compile(rf"\s*(?:{name}\s*\.\s*)?[\"']?{re.escape(key)}[\"']?\s*=")
    lines = text.split("\n")
    found, inside = None, False
    for number, line in enumerate(lines, start=1):
        is_header = re.match(r"\s*\[", line) is not None
        starts = header.match(line) is not None
        fits = starts or inline.match(line) is not None
        sought = bool(key) and entry.match(line) is not None and (inside or "." in line)
        if (fits or sought) and _is_toml("\n".join(lines[: number - 1])):
            found = number if sought or found is None else found
            if sought:
                return number
        if is_header:
            inside = starts
    return found


def _is_toml(text: str) -> bool:
    try:
        tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError):
        return False
    return True


def _explained(error: Exception, file: Path, text: str) -> InvalidInput:
    """What the reader of TOML says, or what is meant where one can tell."""
    place = re.search(r"at line (\d+)", str(error))
    if place is not None:
        line = text.split("\n")[int(place[1]) - 1].strip()
        comma = re.fullmatch(r"([\w\"'.-]+)\s*=\s*([+-]?\d+,\d[^#]*?)\s*(?:#.*)?", line)
        if comma is not None:
            mistake = InvalidInput.of(
                "file_comma",
                seen=line,
                key=comma[1],
                number=comma[2],
                point=comma[2].replace(",", "."),
            )
            return mistake.at(FileLine(str(file), int(place[1])))
    return InvalidInput.of("file_no_toml", file=str(file), said=str(error))


class _Empty(InvalidInput):
    """A file with nothing in it, whose sentence is followed by an example."""

    example = ""

    @classmethod
    def followed_by(cls, example: str, file: Path) -> _Empty:
        """That of a file, with the example."""
        empty = cls.of("file_empty", file=str(file))
        empty.example = example
        return empty

    def sentence(self, language: Language = "en", door: Door = "file") -> str:
        """That it is empty, and what it may look like."""
        return f"{super().sentence(language, door)}\n\n{self.example}"


def _from_stdin() -> tuple[bytes, Path]:
    if sys.stdin is None or sys.stdin.closed:
        raise InvalidInput.of("file_stdin_closed")
    try:
        return sys.stdin.buffer.read(_LARGEST + 1), Path("stdin")
    except OSError as error:
        said = error.strerror or str(error)
        raise InvalidInput.of("file_stdin_unread", said=said) from error


def _content(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(_LARGEST + 1)
    except FileNotFoundError as error:
        beside = _neighbours(path)
        raise InvalidInput.of("file_missing", file=str(path), beside=beside) from error
    except IsADirectoryError as error:
        raise InvalidInput.of("file_is_folder", file=str(path)) from error
    except (OSError, ValueError) as error:  # a name with a zero in it is a ValueError
        said = getattr(error, "strerror", None) or str(error)
        raise InvalidInput.of("file_unread", file=str(path), said=said) from error


def _decoded(content: bytes, name: Path) -> str:
    if len(content) > _LARGEST:
        raise InvalidInput.of("file_large", file=str(name), most=_LARGEST // 1024)
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        byte = f"{content[error.start]:02x}"
        raise InvalidInput.of(
            "file_encoding", file=str(name), byte=byte, position=error.start
        ) from error


def _neighbours(path: Path) -> str:
    try:
        found = sorted(file.name for file in path.parent.glob("*.toml"))
    except OSError:
        found = []
    return ", ".join(found[:6]) + (", …" if len(found) > 6 else "")
