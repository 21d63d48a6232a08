"""Long and large tracks are announced, and those that no disk holds are refused."""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file.sample_times import Grid
from kugelpendel.cli.run import real
from kugelpendel.cli.track import track, trial

MOTION = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1))


class Usage(NamedTuple):
    free: int


@pytest.mark.parametrize("track_format", track.FILES)
def test_size_is_foretold(tmp_path: Path, track_format: str) -> None:
    grid = Grid(20_000.0, 0.1, 200_001)
    foretold = trial.cost(tmp_path, MOTION, grid, track.WRITERS[track_format])
    assert list(tmp_path.iterdir()) == []
    path = tmp_path / track.FILES[track_format]
    track.write_track(path, MOTION, grid, track_format, lambda _: None)
    assert foretold.size == pytest.approx(path.stat().st_size, rel=0.03)
    assert foretold.seconds > 0


def test_a_track_beyond_the_disk_is_refused(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(track, "WORTH_A_TRIAL", 50)
    monkeypatch.setattr(trial.shutil, "disk_usage", lambda _: Usage(5000))
    outcome = call("run", write())
    assert outcome.code == 2
    assert re.search(
        r"the track of 101 samples would take about 1\d kB, and the disk has 5 kB free; choose "
        r"samples = [23]\d or fewer, a binary format, or another disk with --out\.",
        outcome.err,
    )
    assert list(Path.cwd().iterdir()) == []


@pytest.mark.parametrize("track_format", ["csv", "netcdf", "parquet"])
def test_a_real_track_beyond_the_disk_is_refused_on_the_way(
    call, write, monkeypatch: pytest.MonkeyPatch, track_format: str
) -> None:
    monkeypatch.setattr(real, "WORTH_A_TRIAL", 50)
    monkeypatch.setattr(real, "ROWS", 50)
    monkeypatch.setattr(trial.shutil, "disk_usage", lambda _: Usage(500))
    outcome = call("run", write(drag={"half_life": "1 h"}), "--format", track_format)
    assert outcome.code == 2
    assert "the track of 101 samples would take about" in outcome.err
    assert list(Path.cwd().iterdir()) == []


def test_a_large_real_track_is_announced(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real, "WORTH_A_TRIAL", 50)
    monkeypatch.setattr(real, "ROWS", 50)
    monkeypatch.setattr(real, "LARGE", 1000.0)
    outcome = call("run", write(drag={"half_life": "1 h"}))
    assert outcome.code == 0
    assert re.search(r"the track takes about 1\d kB\.", outcome.err)


@pytest.mark.parametrize(("name", "value"), [("WORTH_SAYING", 0.0), ("LARGE", 1000.0)])
def test_a_long_or_large_track_is_announced(
    call, write, monkeypatch: pytest.MonkeyPatch, name: str, value: float
) -> None:
    monkeypatch.setattr(track, "WORTH_A_TRIAL", 50)
    assert call("run", write()).err == ""
    monkeypatch.setattr(trial, name, value)
    outcome = call("run", write())
    assert outcome.code == 0
    assert re.fullmatch(
        r"kugelpendel: this takes about \S+ (µs|ms|s) and writes about 1\d kB; Ctrl-C leaves "
        r"everything as it was\.\n",
        outcome.err,
    )
    assert len(np.loadtxt("out/job/track.csv", delimiter=",", skiprows=1)) == 101
