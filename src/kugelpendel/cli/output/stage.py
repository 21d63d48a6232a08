"""The folder of a run, and the move of its files into their places.

A stage has the folders ``new`` and ``old``, a lock that tells whether its run lives, and during the
move ``move.json``, which says which of the two sets is to be put in place. Both sets are whole as
long as that file is there: a file is put in its place by linking it under another name and renaming
that over what is there. A run that finds a stage whose own run is dead completes the move first.

Two files cannot be renamed at once, so for the length of a few renamings the folder may show files
of both sets. Exchanging whole folders would avoid that where the system can; but it would pull the
folder away under those who stand in it, and carry along what else the user keeps there.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
from contextlib import suppress
from filecmp import cmp
from typing import TYPE_CHECKING, Literal

from kugelpendel.cli.output import manifest
from kugelpendel.locks import hold

if TYPE_CHECKING:
    from pathlib import Path

_NAME = re.compile(r"\.kugelpendel-[0-9a-f]{12}")
_LOCK, _JOURNAL, _MOVING = "lock", "move.json", "moving"

_Set = Literal["new", "old"]


class Unfinished(Exception):
    """A move that failed and could not be undone either; its stage stays."""

    def __init__(self, cause: OSError) -> None:
        super().__init__(str(cause))
        self.cause = cause


class Stage:
    """A folder of one run, which other runs leave alone as long as it lives.

    Parameters
    ----------
    parent
        Where it lies.
    """

    def __init__(self, parent: Path) -> None:
        while True:
            self.folder = parent / f".kugelpendel-{secrets.token_hex(6)}"
            self.folder.mkdir()
            try:
                self._lock = os.open(self.folder / _LOCK, os.O_CREAT | os.O_RDWR)
            except FileNotFoundError:  # another run took the empty folder for a dead one's
                continue
            if hold(self._lock) and (self.folder / _LOCK).exists():
                break
            os.close(self._lock)
        self.new, self.old = self.folder / "new", self.folder / "old"
        self.new.mkdir()
        self.old.mkdir()

    def keep(self, path: Path) -> None:
        """Keep what will be replaced."""
        _link(path, self.old / path.name)

    def close(self) -> None:
        """Remove the stage, unless it is needed to complete the move."""
        os.close(self._lock)
        if not (self.folder / _JOURNAL).exists():
            shutil.rmtree(self.folder, ignore_errors=True)


def complete(stage: Stage, folder: Path) -> None:
    """Put the new set in place of the old one; where that fails, put the old one back.

    Raises
    ------
    OSError
        The new set could not be put in place; the old one is.
    Unfinished
        Neither could; the stage stays, and the next run tries again.
    """
    _decide(stage.folder, "new", folder)
    try:
        _settle(stage.folder)
    except BaseException as error:
        try:
            _decide(stage.folder, "old", folder)
            _settle(stage.folder)
        except OSError as second:
            raise Unfinished(error if isinstance(error, OSError) else second) from error
        _forget(stage.folder)
        raise
    _forget(stage.folder)


def sweep(folder: Path) -> None:
    """Complete what dead runs have left half-done in a folder or above it, and remove their stages.

    Raises
    ------
    OSError
        Files of the folder itself cannot be put in their places.
    """
    for place in (folder, *folder.parents):
        for stage in sorted(place.glob(".kugelpendel-*")):
            if _NAME.fullmatch(stage.name) and stage.is_dir() and not stage.is_symlink():
                _remove_dead(stage, folder)


def _remove_dead(stage: Path, folder: Path) -> None:
    try:
        lock = os.open(stage / _LOCK, os.O_RDWR)
    except FileNotFoundError:  # it was being made, or removed
        shutil.rmtree(stage, ignore_errors=True)
        return
    except OSError:  # it belongs to somebody else
        return
    try:
        if not hold(lock):
            return
        if (stage / _JOURNAL).exists():
            _settle(stage)
            (stage / _JOURNAL).unlink()
    except OSError:
        if stage.parent == folder:
            raise
        return
    finally:
        os.close(lock)
    shutil.rmtree(stage, ignore_errors=True)


def _decide(stage: Path, which: _Set, folder: Path) -> None:
    """Note, at once or not at all, which set is to be put in place, and where."""
    where = os.path.relpath(folder, stage)
    (stage / "note").write_text(json.dumps({"put": which, "folder": where}), encoding="utf-8")
    (stage / "note").replace(stage / _JOURNAL)


def _forget(stage: Path) -> None:
    """End the move. Where that fails, the next run does once more what is done already."""
    with suppress(OSError):
        (stage / _JOURNAL).unlink()


def _settle(stage: Path) -> None:
    """Put the set that was decided on in place, and then take away what only the other one has."""
    journal = json.loads((stage / _JOURNAL).read_text(encoding="utf-8"))
    which: _Set = journal["put"]
    other: _Set = "old" if which == "new" else "new"
    folder = stage / journal["folder"]
    names = sorted(path.name for path in (stage / which).iterdir())
    # The manifest comes last: until then the fingerprints tell that the folder is in between.
    for name in sorted(names, key=lambda name: name == manifest.NAME):
        source, place = stage / which / name, folder / name
        if place.exists() and place.samefile(source):
            continue  # of two links to one file, a renaming would remove none
        if which == "old" and place.is_file() and cmp(source, place, shallow=False):
            continue  # it was never replaced, and maybe cannot be
        _link(source, stage / _MOVING)
        (stage / _MOVING).replace(place)
    for path in (stage / other).iterdir():
        if path.name not in names:
            (folder / path.name).unlink(missing_ok=True)


def _link(source: Path, target: Path) -> None:
    """Give a file a second name; where the file system or its owner has none, make a copy."""
    target.unlink(missing_ok=True)
    try:
        target.hardlink_to(source)
    except OSError:
        shutil.copy2(source, target)
