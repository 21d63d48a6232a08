"""A folder that gets all its files at once or none, and single files likewise."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput
from kugelpendel.cli.output import manifest
from kugelpendel.cli.output.stage import Stage, Unfinished, complete, sweep

if TYPE_CHECKING:
    from collections.abc import Collection, Generator, Sequence


@contextmanager
def staged(
    folder: Path, replaces: Sequence[str], writes: Collection[str] | None = None
) -> Generator[Path]:
    """Lend a temporary folder whose files move into the given one when the block ends well.

    When the block fails or is interrupted, the temporary folder goes and the given one is as it
    was.

    Parameters
    ----------
    folder
        Where the files go; made, with its parents, when it is not there.
    replaces
        Names that an earlier run may have left: those of them that it made, and that this run does
        not write, are removed, so that the folder never mixes two runs.
    writes
        Names that this run may write; all of those that it replaces unless given. A file that
        bears one of them and was not made by an earlier run is refused before any work is done.

    Raises
    ------
    InvalidInput
        The folder cannot be made or written, or holds a file of that name which is not a run's own.
    """
    try:
        parent = _existing(folder)
        sweep(folder)
        _refuse_foreign(folder, replaces if writes is None else writes)
        stage = Stage(parent)
    except OSError as error:
        raise InvalidInput.of("out_unwritable", folder=str(folder), said=_said(error)) from error
    try:
        yield stage.new
        _refuse_foreign(folder, [path.name for path in stage.new.iterdir()])
        _publish(stage, folder, replaces)
    except Unfinished as error:
        raise InvalidInput.of(
            "out_unfinished",
            folder=str(folder),
            said=_said(error.cause),
            old=str(stage.old),
            new=str(stage.new),
        ) from error
    except OSError as error:
        raise InvalidInput.of("out_failed", folder=str(folder), said=_said(error)) from error
    finally:
        stage.close()


@contextmanager
def one_file(path: Path, *, makes_parents: bool = False) -> Generator[Path]:
    """Lend the name of a file that takes the place of the given one when the block ends well.

    A file that is there is replaced, since the user named it.

    Parameters
    ----------
    path
        The file.
    makes_parents
        Whether folders above it are made that are not there.

    Raises
    ------
    InvalidInput
        The file cannot be written; what was there before is as it was.
    """
    try:
        if path.is_dir():
            raise InvalidInput.of("out_is_folder", file=str(path))
        if makes_parents:
            _existing(path.parent)
            path.parent.mkdir(parents=True, exist_ok=True)
        sweep(path.parent)
        stage = Stage(path.parent)
        try:
            yield stage.new / path.name
            (stage.new / path.name).replace(path)
        finally:
            stage.close()
    except OSError as error:
        said = error.strerror or str(error)
        raise InvalidInput.of("out_file_unwritable", file=str(path), said=said) from error


def write_file(path: Path, text: str) -> None:
    """Write a text file, in place of one that may be there.

    Raises
    ------
    InvalidInput
        The file cannot be written; what was there before is as it was.
    """
    with one_file(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def _existing(folder: Path) -> Path:
    """The folder itself, or the closest one above it that exists.

    Raises InvalidInput where a file is in the way.
    """
    for candidate in (folder, *folder.absolute().parents):
        if candidate.is_dir():
            return candidate
        if candidate.exists() or candidate.is_symlink():
            raise InvalidInput.of("out_below_file", folder=str(folder), file=str(candidate))
    return Path.cwd()


def _refuse_foreign(folder: Path, names: Collection[str]) -> None:
    """Refuse to replace what no run has made."""
    made = manifest.read(folder)
    foreign: list[str] = []
    for name in names:
        path = folder / name
        if path.is_dir():
            raise InvalidInput.of("out_folder_in_the_way", folder=str(folder), file=str(path))
        if (path.exists() or path.is_symlink()) and not manifest.is_made(path, made):
            foreign.append(name)
    if foreign:
        raise InvalidInput.of("out_foreign", folder=str(folder), names=", ".join(sorted(foreign)))


def _publish(stage: Stage, folder: Path, replaces: Sequence[str]) -> None:
    """Put the new files in their places, and take away those of an earlier run that are left."""
    new = [path.name for path in stage.new.iterdir()]
    made = manifest.read(folder)
    surplus = [
        name for name in replaces if name not in new and manifest.is_made(folder / name, made)
    ]
    kept = {
        name: print_
        for name, print_ in made.items()
        if name not in replaces and (folder / name).exists()
    }
    manifest.write(stage.new, {**kept, **{name: manifest.of(stage.new / name) for name in new}})
    if not folder.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        stage.new.rename(folder)
        return
    for name in (*new, *surplus, manifest.NAME):
        if (folder / name).exists():
            stage.keep(folder / name)
    complete(stage, folder)


def _said(error: OSError) -> str:
    """What the system says, and of which file."""
    said = error.strerror or str(error)
    name = Path(str(error.filename2 or error.filename)).name if error.filename else ""
    return f"{name}: {said}" if name and not name.startswith(".kugelpendel-") else said
