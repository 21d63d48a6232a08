"""An output folder that gets all its files at once, or none."""

from __future__ import annotations

import secrets
import shutil
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence


@contextmanager
def staged(folder: Path, replaces: Sequence[str]) -> Generator[Path]:
    """Lend a temporary folder whose files move into the given one when the block ends well.

    When the block fails or is interrupted, the temporary folder goes and the given one is as it
    was. The temporary folder lies where a move is a renaming: in the given folder when that exists,
    otherwise beside the first part of it that has to be made.

    Parameters
    ----------
    folder : Path
        Where the files go; made, with its parents, when it is not there.
    replaces : sequence of str
        Names that an earlier run may have left: those that this run does not write are removed,
        so that the folder never mixes two runs. The last name is the one that is moved last.

    Raises
    ------
    InvalidInput
        The folder cannot be made or written.
    """
    try:
        for name in replaces:
            if (folder / name).is_dir():
                raise IsADirectoryError(21, f"{folder / name} is a folder")
        temporary = _existing(folder) / f".kugelpendel-{secrets.token_hex(6)}"
        temporary.mkdir()
    except OSError as error:
        raise InvalidInput(
            f"The output folder {folder} cannot be written: {error.strerror or error}; "
            "choose another one with --out."
        ) from error
    try:
        yield temporary
        _move(temporary, folder, replaces)
    except OSError as error:
        raise InvalidInput(
            f"Writing to {folder} failed: {error.strerror or error}; nothing is left half-written."
        ) from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _existing(folder: Path) -> Path:
    """The folder itself, or the closest one above it that exists."""
    for candidate in (folder, *folder.absolute().parents):
        if candidate.is_dir():
            return candidate
        if candidate.exists() or candidate.is_symlink():
            raise NotADirectoryError(20, f"{candidate} is a file")
    return Path.cwd()


def _move(temporary: Path, folder: Path, replaces: Sequence[str]) -> None:
    if not folder.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        temporary.rename(folder)
        return
    for name in reversed(replaces):
        (folder / name).unlink(missing_ok=True)
    for name in replaces:
        if (temporary / name).exists():
            (temporary / name).replace(folder / name)
