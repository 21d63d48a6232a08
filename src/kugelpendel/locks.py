"""Locks on open files, which end with the process that holds them, however it ends."""

from __future__ import annotations

import sys

if sys.platform == "win32":

    def hold(lock: int) -> bool:
        """Lock an open file, unless a living process has done so."""
        import msvcrt

        try:
            msvcrt.locking(lock, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:

    def hold(lock: int) -> bool:
        """Lock an open file, unless a living process has done so."""
        import fcntl

        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return False
        return True
