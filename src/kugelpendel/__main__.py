"""``kugelpendel``, or ``python -m kugelpendel``: the command as a process of its own."""

from __future__ import annotations

import os
import sys
from typing import NoReturn

_INTERRUPTED = 130


def run() -> NoReturn:
    """Run the command line and leave with its exit code."""
    try:
        from kugelpendel.cli import main

        code = main()
    except (KeyboardInterrupt, RuntimeError) as error:
        # Before there was a command that could have said it. That of an import may be the cause of
        # a RuntimeError: cli/terminal/interrupted.py, which may not be there yet, says why.
        if isinstance(error, RuntimeError) and not isinstance(error.__cause__, KeyboardInterrupt):
            raise
        print("kugelpendel: interrupted; no file is left half-written.", file=sys.stderr)
        code = _INTERRUPTED
    if code == _INTERRUPTED:
        # Everything is said and put away; to unload what was imported takes up to half a second.
        os._exit(code)
    sys.exit(code)


if __name__ == "__main__":
    run()
