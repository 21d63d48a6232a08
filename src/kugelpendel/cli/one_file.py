"""A file that is there complete, or not at all."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    from pathlib import Path


def write_file(path: Path, text: str) -> None:
    """Write a text file, in place of one that may be there.

    Raises
    ------
    InvalidInput
        The file cannot be written; what was there before is as it was.
    """
    try:
        if path.is_dir():
            raise IsADirectoryError(21, "it is a folder")
        temporary = path.with_name(f".{path.name}-{secrets.token_hex(6)}")
        try:
            temporary.write_text(text, encoding="utf-8", newline="\n")
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        raise InvalidInput(
            f"{path} cannot be written: {error.strerror or error}; choose another file with --out."
        ) from error
