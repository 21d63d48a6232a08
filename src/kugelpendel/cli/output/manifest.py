"""Which files of a folder were made by a run: names and fingerprints in ``.kugelpendel.json``."""

from __future__ import annotations

import hashlib
import json
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

NAME = ".kugelpendel.json"

_READ = 1 << 20
"""Bytes at the start and at the end of a file that go into its fingerprint: a track may have
gigabytes, and whoever changes it changes its length, its start or its end."""

_ABOUT = "kugelpendel: the files that a run has made here and may replace; size and BLAKE2b"


def read(folder: Path) -> dict[str, str]:
    """Read the fingerprint of each file that a run has made; none where nothing can be read."""
    try:
        tables = json.loads((folder / NAME).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    files: Any = cast("dict[str, Any]", tables).get("files") if isinstance(tables, dict) else None
    if not isinstance(files, dict):
        return {}
    return {name: str(value) for name, value in cast("dict[str, Any]", files).items()}


def write(folder: Path, files: Mapping[str, str]) -> None:
    """Write the fingerprints of the files."""
    text = json.dumps({"about": _ABOUT, "files": dict(sorted(files.items()))}, indent=2)
    (folder / NAME).write_text(text + "\n", encoding="utf-8")


def of(path: Path) -> str:
    """Take the fingerprint of a file."""
    digest = hashlib.blake2b(digest_size=16)
    with path.open("rb") as file:
        size = file.seek(0, 2)
        file.seek(0)
        digest.update(file.read(_READ))
        file.seek(max(size - _READ, 0))
        digest.update(file.read(_READ))
    return f"{size} {digest.hexdigest()}"


def is_made(path: Path, files: Mapping[str, str]) -> bool:
    """Say whether a run has made a file as it is now; a link or a missing file was not."""
    known = files.get(path.name)
    if known is None or path.is_symlink() or not path.is_file():
        return False
    try:
        return of(path) == known
    except OSError:
        return False
