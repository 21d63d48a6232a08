"""The text of a job file, and a sentence for everything that can be wrong with a file as such."""

from __future__ import annotations

import tomllib
from typing import TYPE_CHECKING, Any

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    from pathlib import Path

EXAMPLE = """\
[pendulum]
length = "67 m"
mass = "28 kg"

[launch]
kind = "ellipse"
a = "3 m"
b = "1 cm"

[output]
duration = "1 h"
step = "0.1 s"
"""
"""The shortest complete job, to paste."""

_LARGEST = 1 << 20  # bytes; a job has a few hundred


def read_file(path: Path) -> dict[str, Any]:
    """Read the tables of a TOML file.

    Raises
    ------
    InvalidInput
        Missing, a folder, unreadable, too large, not UTF-8, empty, or not TOML.
    """
    text = _text(path)
    try:
        tables = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InvalidInput(
            f"{path} is not valid TOML: {error}. A value is a number or stands in quotes: "
            'length = "67 m".'
        ) from error
    if not tables:
        raise InvalidInput(f"{path} is empty. A job looks like this:\n\n{EXAMPLE}")
    return tables


def _text(path: Path) -> str:
    try:
        if path.is_dir():
            raise InvalidInput(f"{path} is a folder; name a job file, such as {path}/job.toml.")
        with path.open("rb") as file:
            content = file.read(_LARGEST + 1)
    except FileNotFoundError as error:
        raise InvalidInput(f"{path} does not exist{_neighbours(path)}.") from error
    except OSError as error:
        raise InvalidInput(f"{path} cannot be read: {error.strerror or error}.") from error
    if len(content) > _LARGEST:
        raise InvalidInput(
            f"{path} is larger than {_LARGEST // 1024} KiB, and a job has a few hundred bytes; "
            "is this the right file?"
        )
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        raise InvalidInput(
            f"{path} is not UTF-8 text (byte 0x{content[error.start]:02x} at position "
            f"{error.start}); save it as UTF-8."
        ) from error


def _neighbours(path: Path) -> str:
    try:
        found = sorted(file.name for file in path.parent.glob("*.toml"))
    except OSError:
        found = []
    shown = ", ".join(found[:6]) + (", …" if len(found) > 6 else "")
    return f"; that folder has {shown}" if found else ""
