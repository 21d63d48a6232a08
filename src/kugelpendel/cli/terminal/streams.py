"""Standard output and standard error as they are: closed, full, or in an old encoding."""

from __future__ import annotations

import codecs
import contextlib
import io
import json
import os
import re
import sys
from typing import TYPE_CHECKING, Any, TextIO, cast

from kugelpendel.errors import KugelpendelError

if TYPE_CHECKING:
    from collections.abc import Generator

_PLAIN = {
    "−": "-",
    "–": "-",
    "…": "...",
    "→": "->",
    "─": "-",
    "°": " deg",
    "′": "'",
    "″": '"',
    "√": "sqrt ",
    "×": "x",
    "·": "*",
    "≪": "<<",
    "≤": "<=",
    "≥": ">=",
    "≈": "~",
    "²": "^2",
    "³": "^3",
    "⁴": "^4",
    "₀": "0",
    "µ": "u",
    "π": "pi",
    "ω": "omega",
    "Ω": "Omega",
    "δ": "delta",
    "Δ": "Delta",
    "γ": "gamma",
    "θ": "theta",
    "φ": "phi",
    "ψ": "psi",
    "χ": "chi",
}
"""What is written where the encoding of a stream lacks a sign; "?" for the rest."""

_CLOSED = (
    "standard output is closed, so nothing can be said; leave it open, or send it to a file with >."
)
"""This is said before the options are read, and so in English."""


class Unwritable(Exception):
    """Standard output takes no text.

    Parameters
    ----------
    what
        The error to say.
    """

    def __init__(self, what: KugelpendelError) -> None:
        super().__init__(what)
        self.what = what


class _Guarded:
    """Standard output whose failures are told from those of files."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        with _told():
            return self._stream.write(text)

    def flush(self) -> None:
        with _told():
            self._stream.flush()


@contextlib.contextmanager
def guarded() -> Generator[None]:
    """Make both streams write any text in the encoding that they have, or say why they cannot.

    Raises
    ------
    Unwritable
        Standard output is closed, or the device is full. The reader of a pipe that is gone is no
        error: such as `head`, it has had enough, and all files are written by now.
    """
    stdout = sys.stdout
    if stdout is None or stdout.closed:
        raise Unwritable(KugelpendelError(_CLOSED))
    for stream in (stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and not _is_unicode(stream.encoding):
            stream.reconfigure(errors=_HANDLER)
    sys.stdout = cast("TextIO", _Guarded(stdout))
    try:
        yield
        _flush()
    except SystemExit:  # after --help, which has to be written too
        _flush()
        raise
    finally:
        sys.stdout = stdout


def _flush() -> None:
    with contextlib.suppress(BrokenPipeError):
        sys.stdout.flush()


@contextlib.contextmanager
def _told() -> Generator[None]:
    try:
        yield
    except BrokenPipeError:
        _give_up()
        raise
    except OSError as error:
        _give_up()
        said = error.strerror or str(error)
        raise Unwritable(KugelpendelError.of("out_stream", said=said)) from error


def complain(sentence: str) -> None:
    """Say a sentence on standard error, where there is one."""
    if sys.stderr is not None:
        # Without a place to say it, the exit code is all that is left.
        with contextlib.suppress(OSError):
            print(f"kugelpendel: {sentence}", file=sys.stderr, flush=True)


def write_json(text: str) -> None:
    """Write JSON to standard output; what its encoding may lack is escaped as JSON escapes it."""
    if not _is_unicode(sys.stdout.encoding):
        text = re.sub(r"[^\x00-\x7f]", lambda match: json.dumps(match[0])[1:-1], text)
    sys.stdout.write(text)


def write_bytes(content: bytes) -> None:
    """Write a file to standard output, whatever the encoding of text there is."""
    sys.stdout.flush()
    with _told():
        sys.stdout.buffer.write(content)


def _is_unicode(encoding: str | None) -> bool:
    return encoding is None or codecs.lookup(encoding).name.startswith("utf")


def _give_up() -> None:
    """Let nothing that is still held be written at the end of the program, and fail there again."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _replaced(error: UnicodeError) -> tuple[str, int]:
    assert isinstance(error, UnicodeEncodeError)
    text = error.object[error.start : error.end]
    return "".join(_PLAIN.get(sign, "?") for sign in text), error.end


_HANDLER = "kugelpendel"
codecs.register_error(_HANDLER, _replaced)
