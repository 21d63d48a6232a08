"""The main job from end to end: what is printed, what is written, and what is not."""

import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kugelpendel as kp

COLUMNS = ["time", "x", "y", "z", "vx", "vy", "vz", "tension"]
UNITS = ["s", "m", "m", "m", "m/s", "m/s", "m/s", "N"]


@pytest.fixture(scope="module")
def expected() -> np.ndarray:
    """The track of the usual job, column by column."""
    pendulum = kp.Pendulum(length=1.0, mass=2.0)
    motion = kp.ExactMotion(pendulum, kp.Launch.apsides(a=0.2, b=0.1))
    times = 0.1 * np.arange(101)
    position, velocity = motion.position(times), motion.velocity(times)
    return np.column_stack([times, position, velocity, motion.tension(times)])


def test_csv(call, write, expected: np.ndarray) -> None:
    assert call("run", write()).code == 0
    path = Path("out/job/track.csv")
    header = path.read_text().splitlines()[0].split(",")
    assert header == [f"{name} ({unit})" for name, unit in zip(COLUMNS, UNITS, strict=True)]
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    assert_allclose(table, expected, rtol=0, atol=0)


def test_parquet(call, write, expected: np.ndarray) -> None:
    from pyarrow import parquet

    assert call("run", write(output={"format": "parquet"})).code == 0
    table = parquet.read_table("out/job/track.parquet")
    assert table.column_names == COLUMNS
    units = [table.schema.field(name).metadata[b"units"].decode() for name in COLUMNS]
    assert units == UNITS
    columns = np.column_stack([table[name].to_numpy() for name in COLUMNS])
    assert_allclose(columns, expected, rtol=0, atol=0)


def test_netcdf(call, write, expected: np.ndarray) -> None:
    import xarray as xr

    assert call("run", write(output={"format": "netcdf"})).code == 0
    with xr.open_dataset("out/job/track.nc", engine="h5netcdf") as track:
        assert track.position.dims == ("time", "axis")
        assert [str(axis) for axis in track.axis.values.astype(str)] == ["x", "y", "z"]
        units = {name: track[name].attrs["units"] for name in ("position", "velocity", "tension")}
        assert units == {"position": "m", "velocity": "m/s", "tension": "N"}
        columns = [track.time, *track.position.T, *track.velocity.T, track.tension]
        assert_allclose(np.column_stack(columns), expected, rtol=0, atol=0)


def test_format_on_the_command_line_wins(call, write) -> None:
    call("run", write(), "--format", "parquet", "--out", "here")
    assert sorted(path.name for path in Path("here").glob("[!.]*")) == [
        "results.json",
        "track.parquet",
    ]


@pytest.mark.parametrize("track_format", ["csv", "netcdf", "parquet"])
def test_tracks_of_many_blocks_are_seamless(
    call, write, monkeypatch: pytest.MonkeyPatch, expected: np.ndarray, track_format: str
) -> None:
    from kugelpendel.cli.track import track

    names = {"csv": "track.csv", "netcdf": "track.nc", "parquet": "track.parquet"}
    call("run", write(), "--format", track_format, "--out", "one")
    monkeypatch.setattr(track, "BLOCK", 17)
    call("run", write(), "--format", track_format, "--out", "many")
    for folder in ("one", "many"):
        path = Path(folder, names[track_format])
        assert_allclose(_read(path), expected, rtol=0, atol=0)


def _read(path: Path) -> np.ndarray:
    if path.suffix == ".csv":
        return np.loadtxt(path, delimiter=",", skiprows=1)
    if path.suffix == ".nc":
        import xarray as xr

        with xr.open_dataset(path, engine="h5netcdf") as track:
            return np.column_stack(
                [track.time, *track.position.T, *track.velocity.T, track.tension]
            )
    from pyarrow import parquet

    table = parquet.read_table(path)
    return np.column_stack([table[name].to_numpy() for name in COLUMNS])


def test_samples_include_both_ends(call, write) -> None:
    call("run", write(output={"step": None, "samples": 11}))
    times = np.loadtxt("out/job/track.csv", delimiter=",", skiprows=1, usecols=0)
    assert_allclose(times, np.arange(11.0), rtol=1e-15)


def test_last_sample_survives_rounding(call, write) -> None:
    call("run", write(output={"duration": "0.3 s", "step": "0.1 s"}))
    assert len(Path("out/job/track.csv").read_text().splitlines()) == 1 + 4


def test_json_is_all_there_is_on_stdout(call, write) -> None:
    outcome = call("run", write(), "--json")
    assert outcome.code == 0
    assert outcome.err == ""
    assert outcome.results == json.loads(Path("out/job/results.json").read_text())


def test_results_are_those_of_the_motion(call, write) -> None:
    results = call("run", write(), "--json").results
    pendulum = kp.Pendulum(length=1.0, mass=2.0)
    motion = kp.ExactMotion(pendulum, kp.Launch.apsides(a=0.2, b=0.1))
    assert results["pendulum"] == {"length_m": 1.0, "gravity_m_per_s2": 9.80665, "mass_kg": 2.0}
    assert results["launch"] == {"kind": "apsides", "a_m": 0.2, "b_m": 0.1, "azimuth_rad": 0.0}
    found = results["motion"]
    assert found["regime"] == "ellipse"
    assert found["frequency_rad_per_s"] == motion.frequency
    assert found["precession_rad_per_s"] == motion.precession
    assert found["radial_period_s"] == motion.radial_period
    assert found["swing_period_s"] == pytest.approx(2 * math.pi / motion.frequency, rel=1e-15)
    assert found["full_turn_s"] == pytest.approx(2 * math.pi / motion.precession, rel=1e-15)
    assert found["largest_angle_rad"] == pytest.approx(math.asin(0.2), rel=1e-14)
    formula = results["formula_25"]
    assert formula["precession_rad_per_s"] == pytest.approx(
        kp.olsson.precession(0.2, 0.1, 1.0, 9.80665), rel=1e-12
    )
    error = formula["precession_rad_per_s"] / motion.precession - 1
    assert formula["difference_percent"] == pytest.approx(100 * error, rel=1e-9)
    tension = results["tension"]
    assert [tension["least_N"], tension["most_N"]] == list(motion.tension_range)
    assert tension["goes_slack"] is False
    assert tension["first_slack_s"] is None
    assert results["output"] == {
        "duration_s": 10.0,
        "step_s": 0.1,
        "samples": 101,
        "files": ["track.csv"],
    }


def test_run_again_replaces_its_own_files_and_no_others(call, write) -> None:
    call("run", write(output={"figure": True}))
    Path("out/job/notes.txt").write_text("mine")
    call("run", write(output={"format": "netcdf"}))
    names = sorted(path.name for path in Path("out/job").glob("[!.]*"))
    assert names == ["notes.txt", "results.json", "track.nc"]


def test_folders_are_made_with_their_parents(call, write, tmp_path: Path) -> None:
    assert call("run", write(), "--out", tmp_path / "a" / "b" / "c").code == 0
    assert sorted(path.name for path in (tmp_path / "a/b/c").glob("[!.]*")) == [
        "results.json",
        "track.csv",
    ]
    assert not list(tmp_path.rglob(".kugelpendel-*"))


@pytest.mark.parametrize("there", [True, False])
def test_failure_in_the_middle_leaves_nothing(
    call, write, monkeypatch: pytest.MonkeyPatch, there: bool
) -> None:
    from kugelpendel.cli.track import track

    if there:
        call("run", write(), "--out", "target")
        before = {path.name: path.read_bytes() for path in Path("target").iterdir()}

    class FullDisk:
        def position(self, time: np.ndarray) -> np.ndarray:
            raise OSError(28, "No space left on device")

    original = track.write_track
    monkeypatch.setattr(
        "kugelpendel.cli.run.command.write_track",
        lambda path, motion, *rest: original(path, FullDisk(), *rest),  # pyright: ignore[reportArgumentType]
    )
    outcome = call("run", write(), "--out", "target")
    assert outcome.code == 2
    assert "No space left on device" in outcome.err
    assert [path.name for path in Path.cwd().iterdir()] == (["target"] if there else [])
    if there:
        assert {path.name: path.read_bytes() for path in Path("target").iterdir()} == before


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM])
def test_interruption_leaves_nothing(write, tmp_path: Path, stop: signal.Signals) -> None:
    path = write(output={"duration": "1000 h", "step": "0.05 s"})
    folder = tmp_path / "target"
    folder.mkdir()
    command = [sys.executable, "-m", "kugelpendel", "run", str(path), "--out", str(folder)]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        deadline = time.monotonic() + 60
        while not list(folder.glob(".kugelpendel-*/new/track.csv")):
            assert time.monotonic() < deadline
            assert process.poll() is None
            time.sleep(0.02)
        process.send_signal(stop)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err == "kugelpendel: interrupted; no file is left half-written.\n"
    assert list(folder.iterdir()) == []


def test_closed_pipe_is_no_error(write, tmp_path: Path) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [sys.executable, "-m", "kugelpendel", "run", write(), "--out", tmp_path / "o"],
        stdout=writing,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    os.close(writing)
    assert done.returncode == 0
    assert done.stderr == ""
    assert (tmp_path / "o" / "results.json").exists()
