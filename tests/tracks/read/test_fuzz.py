"""Spoilt files give a track or a sentence, never anything else."""

import random
from pathlib import Path

import numpy as np
import pytest
from tests.tracks.read.spellings import spellings

import kugelpendel as kp

FILES = [one for one in spellings() if len(one.content) < 30_000]
PIECES = [
    b";",
    b",",
    b"\t",
    b"\n",
    b"\r",
    b'"',
    b"\x00",
    b"\xff\xfe",
    b"-",
    b"1e999",
    b"nan",
    b":",
    b"<",
    b"&",
    b"#",
    b"mass B",
    b"9" * 400,
]


def spoilt(content: bytes, luck: random.Random) -> bytes:
    """A file after one to five accidents."""
    for _ in range(luck.randint(1, 5)):
        at, length = luck.randrange(len(content) + 1), luck.choice([1, 3, 40, 2000])
        match luck.randrange(4):
            case 0:
                content = content[:at] + content[at + length :]
            case 1:
                content = content[:at] + luck.choice(PIECES) + content[at:]
            case 2:
                content = (
                    content[:at]
                    + content[luck.randrange(len(content) + 1) :][:length]
                    + content[at:]
                )
            case _:
                content = content[:at] + luck.randbytes(min(length, 40)) + content[at + length :]
    return content


@pytest.mark.parametrize("seed", range(5))
def test_a_track_or_a_sentence(seed: int, tmp_path: Path) -> None:
    luck = random.Random(seed)
    file = tmp_path / "track.csv"
    for _ in range(25):
        one = luck.choice(FILES)
        file.write_bytes(spoilt(one.content, luck))
        track = refused = None
        try:
            track = kp.tracks.read(file, **one.options)
        except kp.InvalidInput as error:
            refused = error
        if refused is not None:
            assert refused.kind.startswith("track_")
            assert str(refused).endswith(".")
            continue
        assert track is not None
        assert (np.diff(track.time) > 0).all()
        assert len(track) >= 10
        for note in track.notes:
            assert note.sentence("de")
            assert note.sentence("en")
