"""A folder that one living process at a time writes to."""

from __future__ import annotations

import os
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from kugelpendel.errors import InvalidInput
from kugelpendel.locks import hold

_LOCK = ".sweep.lock"


@contextmanager
def locked(folder: Path) -> Generator[None]:
    """Hold the folder of a sweep. Raises InvalidInput where a living process does."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / _LOCK
    while True:
        lock = os.open(path, os.O_CREAT | os.O_RDWR)
        if not hold(lock):
            os.close(lock)
            raise InvalidInput.of("sweep_locked", folder=str(folder))
        try:
            if path.stat().st_ino == os.fstat(lock).st_ino:
                break
        except FileNotFoundError:  # whoever held it has ended just now
            pass
        os.close(lock)
    try:
        yield
    finally:
        path.unlink(missing_ok=True)
        os.close(lock)
