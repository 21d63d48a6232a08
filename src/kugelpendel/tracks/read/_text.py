"""From bytes to text: the encodings that instruments, spreadsheets and phones write."""

from __future__ import annotations

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._note import Note

_MARKS = (
    (b"\xef\xbb\xbf", "utf-8-sig"),
    (b"\xff\xfe\x00\x00", "utf-32"),
    (b"\x00\x00\xfe\xff", "utf-32"),
    (b"\xff\xfe", "utf-16"),
    (b"\xfe\xff", "utf-16"),
)
"""Byte-order marks; those of UTF-32 come before that of UTF-16 with which one of them begins."""


def decode(content: bytes, file: str) -> tuple[str, list[Note]]:
    """The text of a file, and what was assumed about its encoding.

    The rule is short enough to be known by heart, and so better than a guess from statistics, which
    are poor in a file of digits: a byte-order mark; zeros in every other byte; UTF-8 where that is
    valid; else Windows' Latin-1.

    Raises
    ------
    InvalidInput
        The file has nothing in it, or is no text.
    """
    if not content.strip(b" \t\r\n\x00\xef\xbb\xbf\xff\xfe"):
        raise InvalidInput.of("track_empty", file=file)
    for mark, encoding in _MARKS:
        if content.startswith(mark):
            return _strictly(content, encoding, file), []
    start = content[:4096]
    even, odd = start[::2].count(0), start[1::2].count(0)
    if len(start) > 3 and max(even, odd) > 0.3 * len(start) / 2:
        encoding = "utf-16-le" if odd > even else "utf-16-be"
        return _strictly(content, encoding, file), [Note.of("encoding", encoding=encoding)]
    if b"\x00" in start:
        raise InvalidInput.of("track_no_text", file=file)
    try:
        return content.decode("utf-8"), []
    except UnicodeDecodeError:
        # Five bytes have no sign there; they are never part of a number.
        return content.decode("cp1252", errors="replace"), [
            Note.of("encoding", encoding="Windows-1252")
        ]


def _strictly(content: bytes, encoding: str, file: str) -> str:
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        raise InvalidInput.of("track_no_text", file=file) from error
