"""All spellings of one motion give one track, and say what was done to them."""

from pathlib import Path

import numpy as np
import pytest
from tests.tracks.read.spellings import COUNT, RATE, Spelling, motion, spellings

import kugelpendel as kp

ALL = list(spellings())


def test_there_are_many() -> None:
    assert len(ALL) >= 60
    assert len({one.name for one in ALL}) == len(ALL)


@pytest.mark.parametrize("one", ALL, ids=lambda one: one.name)
def test_every_spelling_gives_the_same_track(one: Spelling, tmp_path: Path) -> None:
    file = tmp_path / "track.dat"
    file.write_bytes(one.content)
    track = kp.tracks.read(file, **one.options)
    assert isinstance(track, kp.tracks.Track)
    _, x, y = motion()
    at = np.rint((track.time - track.time[0]) * RATE).astype(int)
    if one.missing and track.time[0] > 0.5 / RATE:
        at += round(track.time[0] * RATE)
    assert np.abs(np.diff(track.time) * RATE - np.diff(at)).max() < 0.01
    assert len(track) == COUNT - one.missing
    for seen, true in ((track.x, x), (track.y, y)):
        off = seen * one.size - true[at]
        assert np.abs(off - np.median(off)).max() < max(one.within, 2e-5)
    kinds = [note.kind for note in track.notes]
    assert [kind for kind in one.notes if kind not in kinds] == []
    for note in track.notes:
        assert note.sentence("de") != note.sentence("en")
        assert "{" not in note.sentence("de") + note.sentence("en")
