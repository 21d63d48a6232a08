"""``kugelpendel synth``: a track like a camera's, the same one for the same seed."""

from pathlib import Path

import numpy as np
import pytest

import kugelpendel as kp

JOB = Path(__file__).parents[3] / "examples" / "tracks" / "classroom.toml"
SHORT = (JOB, "--duration", "1 min", "--rate", "20")


def test_a_track_that_can_be_read(call) -> None:
    outcome = call("synth", *SHORT, "--noise", "0.5 mm", "--gap", "20 s,5 s", "--out", "a.csv")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith("In a.csv: ")
    track = kp.tracks.read("a.csv")
    assert track.unit == "m"
    assert 1080 < len(track) < 1120
    assert float(np.diff(track.time).max()) == pytest.approx(5.0, abs=0.1)


def test_a_seed_decides(call) -> None:
    for name, seed in (("a.csv", "3"), ("b.csv", "3"), ("c.csv", "4")):
        assert call("synth", *SHORT, "--noise", "1 mm", "--seed", seed, "--out", name).code == 0
    first, again, other = (Path(f"{name}.csv").read_text() for name in "abc")
    assert first == again
    assert first != other


def test_standard_output_is_the_file(call) -> None:
    assert call("synth", *SHORT, "--out", "a.csv").code == 0
    assert call("synth", *SHORT, "--out", "-").out == Path("a.csv").read_text()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--gap", "20 s"], "--gap is '20 s'; write its start and its length"),
        (["--colour", "pink"], "--colour is 'pink'; write one of white, slow, t3"),
        (["--seed", "-1"], "--seed"),
        (["--seed", "1.5"], "--seed is '1.5'; write a whole number from 0 on."),
        (["--rate", "0"], "--rate"),
        (["--duration", "1 kg"], "--duration"),
    ],
)
def test_refused(call, arguments: list[str], said: str) -> None:
    outcome = call("synth", *SHORT, *arguments, "--out", "a.csv")
    assert outcome.code == 2
    assert said in " ".join(outcome.err.split())
    assert list(Path().iterdir()) == []
