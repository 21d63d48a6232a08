"""The main job for a real pendulum: what is printed, what is written, and what is kept."""

import json
import math
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import _core
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.run.real import real_motion

REAL: dict[str, dict[str, Any]] = {
    "pendulum": {"length": "20 m", "mass": None},
    "launch": {"kind": "ellipse", "a": "80 cm", "b": 0},
    "site": {"latitude": "52 deg"},
    "drag": {"half_life": "1 h"},
    "suspension": {"anisotropy": "1e-5 rad/s", "axis": "30 deg"},
    "bob": {"radius": "10 cm", "density": "7860 kg/m^3"},
    "output": {"duration": "10 min", "step": "1 s", "figure": False},
}


def motion() -> kp.RealMotion:
    """That of the job."""
    site = kp.Site(math.radians(52))
    bob = kp.Bob(0.1, 7860.0)
    return kp.RealMotion(
        kp.Pendulum(20.0, float(site.gravity), float(bob.mass)),
        kp.Launch.ellipse(0.8, 0.0),
        site=site,
        drag=kp.Drag.from_half_life(3600.0),
        suspension=kp.Suspension(1e-5, math.radians(30)),
        bob=bob,
    )


@pytest.mark.parametrize("track_format", ["csv", "netcdf", "parquet"])
def test_track_is_that_of_the_full_equations(call, write, track_format: str) -> None:
    assert call("run", write(**REAL), "--format", track_format).code == 0
    times = np.arange(601.0)
    columns = (motion().position(times), motion().velocity(times), motion().tension(times))
    found = _read(track_format)
    assert_allclose(found, np.column_stack([times, *columns]), rtol=0, atol=0)


def _read(track_format: str) -> np.ndarray:
    if track_format == "csv":
        return np.loadtxt("out/job/track.csv", delimiter=",", skiprows=1)
    if track_format == "parquet":
        from pyarrow import parquet

        table = parquet.read_table("out/job/track.parquet")
        return np.column_stack([column.to_numpy() for column in table.columns])
    import xarray as xr

    with xr.open_dataset("out/job/track.nc", engine="h5netcdf") as track:
        return np.column_stack([track.time, *track.position.T, *track.velocity.T, track.tension])


def test_results(call, write) -> None:
    results = call("run", write(**REAL), "--json").results
    assert results == json.loads(Path("out/job/results.json").read_text(encoding="utf-8"))
    ideal = -7.292115e-5 * math.sin(math.radians(52))
    plane = results["plane"]
    assert plane["ideal_rad_per_s"] == pytest.approx(ideal, rel=1e-12)
    assert plane["ideal_turn_s"] == pytest.approx(2 * math.pi / -ideal, rel=1e-12)
    outer = motion().events("outer", 0.0, 600.0)
    x, y, _ = motion().position(outer).T
    turned = np.unwrap(np.arctan2(y, x), period=math.pi)
    rate = (turned[-1] - turned[0]) / (outer[-1] - outer[0])
    # The azimuth of the ellipse and that of the turning point differ by some b·(γ, Ω)/(a·ω0).
    assert plane["mean_rad_per_s"] == pytest.approx(rate, rel=1e-3)
    assert results["periods"]["first_swing_s"] == pytest.approx(outer[2] - outer[0], rel=1e-9)
    assert results["periods"]["small_swings_s"] == pytest.approx(
        2 * math.pi / motion().angular_frequency, rel=1e-14
    )
    swing = results["swing"]
    assert swing["last_a_m"] == pytest.approx(
        0.8 * 0.5 ** (plane["last_turning_point_s"] / 3600), rel=1e-4
    )
    assert 0 < swing["largest_b_m"] < 0.01
    least, most = results["tension"]["least_N"], results["tension"]["most_N"]
    weight = float(motion().pendulum.mass * motion().pendulum.gravity)
    assert least == pytest.approx(weight * math.sqrt(1 - 0.04**2), rel=1e-6)
    assert most == pytest.approx(weight * (3 - 2 * math.sqrt(1 - 0.04**2)), rel=1e-4)
    assert results["output"]["samples"] == 601
    assert results["output"]["interrupted"] is False


def test_shares_add_up_to_the_rate_that_is_measured(call, write) -> None:
    results = call("run", write(**REAL), "--json").results
    shares = results["shares"]
    causes = ("earth", "intrinsic", "anisotropy", "damping", "drive")
    for when in ("mean", "at_the_slowest", "at_the_fastest"):
        total = sum(shares[cause][f"{when}_rad_per_s"] for cause in causes)
        assert total == pytest.approx(shares["sum"][f"{when}_rad_per_s"], rel=1e-12)
    mean = results["plane"]["mean_rad_per_s"]
    assert shares["sum"]["mean_rad_per_s"] == pytest.approx(mean, rel=2e-3)
    assert shares["earth"]["mean_rad_per_s"] == pytest.approx(
        results["plane"]["ideal_rad_per_s"], rel=1e-12
    )
    assert abs(results["averaged_equations"]["full_less_averaged_azimuth_at_the_end_rad"]) < 1e-4


def test_report_names_forces_rates_and_causes(call, write) -> None:
    said = call("run", write(**REAL)).out
    for line in (
        r"^Site +52° N, g = 9\.8\d+ m/s² \(WGS84 normal gravity\)$",
        r"^Drag +linear, amplitude halves in 60\.00 min \(γ = 0\.0001925 1/s, Q = 18\d\d\)$",
        r"^Suspension +faster by 1\.4\d+e−05 along 30° than across \(δ = 1e−05 rad/s\)$",
        r"^Bob +ball of 10\.00 cm radius, 7860 kg/m³, 32\.92 kg$",
        r"^Small swings +8\.97\d+ s +period of a point",
        r"^  with this bob +8\.97\d+ s +\+0\.0",
        r"^Foucault's rate +−11\.853 °/h +−Ω_E sin\(latitude\), a turn in 30\.37 h$",
        r"^Rate of the plane +−1\d\.\d+ °/h +mean over 9\.\d+ min$",
        r"^Amplitude a +80\.00 cm → 71\.\d\d cm ",
        r"^Tension +\d+\.\d+ to \d+\.\d+ N +the thread never goes slack$",
        r"^ earth( +−11\.853){5}$",
        r"^ sum( +−1\d\.\d{3}){5}$",
        r"track\.csv \(601 samples\), results\.json$",
    ):
        assert re.search(line, said, re.MULTILINE), line


@pytest.mark.parametrize("columns", [60, 80])
@pytest.mark.parametrize("real", [False, True])
def test_a_report_keeps_to_the_width(
    call, write, monkeypatch: pytest.MonkeyPatch, columns: int, real: bool
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    said, _, _files = call("run", write(**(REAL if real else {}))).out.rpartition("\n\n")
    assert max(map(len, said.splitlines())) <= columns
    assert "…" not in said


@pytest.mark.parametrize(
    ("name", "table", "words"),
    [
        ("site", {"latitude": "-30 deg", "gravity": "9.80665 m/s^2"}, ["30° S", "as given"]),
        ("drag", {"quadratic": "1e-3 1/m"}, ["quadratic, c = 0.001 1/m"]),
        ("suspension", {"damping_anisotropy": "1e-6 1/s"}, ["decay 1e−06 1/s faster along 0°"]),
        ("bob", {"radius": "1 cm", "density": 8000}, ["ball of 1.000 cm radius"]),
        ("drive", {"push": "-1 mm/s", "radius": "10 cm"}, ["1 mm/s inwards", "10 cm from"]),
        ("drive", {"push": "-1e-5 m/s", "phase": "5 deg"}, ["10 µm/s inwards, 5° of phase"]),
    ],
)  # fmt: skip
def test_each_table_alone_makes_a_real_job(call, write, name: str, table, words) -> None:
    outcome = call("run", write(**{name: table}))
    assert outcome.code == 0, outcome.err
    for word in words:
        assert word in outcome.out
    assert "plane" in json.loads(Path("out/job/results.json").read_text(encoding="utf-8"))


def test_without_the_earth_no_pace_is_named(call, write) -> None:
    said = call("run", write(drag={"linear": 1e-3})).out
    assert "Foucault" not in said
    assert not re.search("hurries|lags|stalls|alone would", said)


def test_forces_too_strong_to_average_are_told_with_their_error(call, write) -> None:
    tables = {**REAL, "suspension": {"anisotropy": "0.05 rad/s", "axis": "30 deg"}}
    outcome = call("run", write(**tables))
    assert outcome.code == 0
    results = json.loads(Path("out/job/results.json").read_text(encoding="utf-8"))
    caution = results["averaged_equations"]["caution"]
    assert re.search(r"anisotropy changes a swing by 0\.0\d+ of itself.*off by 0\.0", caution)
    assert "much for an averaged motion" in outcome.out.replace("\n", " ")


def test_blocks_are_seamless(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    from kugelpendel.cli.run import real

    first = call("run", write(**REAL), "--json").results
    whole = _read("csv")
    monkeypatch.setattr(real, "BLOCK", 7)
    second = call("run", write(**REAL), "--json").results
    assert_allclose(_read("csv"), whole, rtol=0, atol=0)
    # The azimuth is unwrapped block by block, which rounds differently.
    assert first["plane"].pop("stands_since_s") is second["plane"].pop("stands_since_s") is None
    assert first["plane"].pop("stands_at_rad") is second["plane"].pop("stands_at_rad") is None
    assert first["plane"] == pytest.approx(second["plane"], rel=1e-11)
    assert first["swing"] == pytest.approx(second["swing"], rel=1e-11)


SLACK: dict[str, dict[str, Any]] = {
    "launch": {"kind": "angles", "theta": "80 deg", "theta_rate": "150 deg/s"},
    "drag": {"linear": "1e-6 1/s"},
    "output": {"duration": "1 min", "step": "0.01 s"},
}


def test_track_ends_where_the_thread_goes_slack(call, write) -> None:
    outcome = call("run", write(**SLACK))
    assert outcome.code == 0, outcome.err
    results = json.loads(Path("out/job/results.json").read_text(encoding="utf-8"))
    end = results["tension"]["first_slack_s"]
    assert "the bob leaves the sphere, and the track ends." in outcome.out
    assert results["tension"]["goes_slack"] is True
    assert results["tension"]["least_N"] == 0
    times = np.loadtxt("out/job/track.csv", delimiter=",", skiprows=1, usecols=0)
    assert times[-1] <= end < times[-1] + 0.01
    assert results["output"]["samples"] == len(times)
    assert results["output"]["interrupted"] is False


def test_years_are_estimated_and_what_is_done_is_kept(write, tmp_path: Path) -> None:
    tables = {**REAL, "output": {"duration": "3 years", "step": "1 h", "figure": False}}
    folder = tmp_path / "target"
    command = [sys.executable, "-m", "kugelpendel", "run", str(write(**tables)), "--out", folder]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        line = process.stderr.readline()
        assert re.fullmatch(
            r"kugelpendel: this takes about \S+ (s|min|h|d); Ctrl-C keeps what is done\.\n", line
        )
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    kept = tmp_path / "target-interrupted"
    assert re.fullmatch(
        rf"kugelpendel: interrupted after .* of 3\.00 years; in {kept}: "
        r"track\.csv \([\d ]+ samples\), results\.json\.\n",
        err,
    )
    assert not folder.exists()
    results = json.loads((kept / "results.json").read_text(encoding="utf-8"))
    times = np.loadtxt(kept / "track.csv", delimiter=",", skiprows=1, usecols=0)
    assert_allclose(times, 3600.0 * np.arange(results["output"]["samples"]))
    assert results["output"]["interrupted"] is True
    assert results["output"]["followed_until_s"] >= times[-1]
    assert not list(tmp_path.glob(".kugelpendel-*"))


@pytest.mark.parametrize("moment", ["the figure", "the explanation"])
def test_interrupted_after_the_last_sample_the_whole_track_is_kept(
    call, write, monkeypatch: pytest.MonkeyPatch, moment: str
) -> None:
    # The track is done; the first Ctrl-C was forgotten then, and the figure drawn to its end.
    from kugelpendel.cli.run import real

    def interrupted(*given: Any) -> Any:
        signal.raise_signal(signal.SIGINT)
        return explained(*given)

    explained = real.explain
    owner, name = (real, "explain") if moment == "the explanation" else (real.plot, "day")
    monkeypatch.setattr(owner, name, interrupted)
    job = REAL | {"output": REAL["output"] | {"figure": True}}
    outcome = call("run", write(**job), "--out", "out/job")
    assert outcome.code == 130
    assert "interrupted after" in outcome.err
    assert [path.name for path in Path("out").iterdir()] == ["job-interrupted"]
    kept = Path("out/job-interrupted")
    assert {path.name for path in kept.glob("[!.]*")} == {"track.csv", "results.json"}
    results = json.loads((kept / "results.json").read_text(encoding="utf-8"))
    assert results["output"]["interrupted"] is True
    rows = np.loadtxt(kept / "track.csv", delimiter=",", skiprows=1)
    assert len(rows) == results["output"]["samples"] == 601


@pytest.mark.parametrize("track_format", ["csv", "netcdf", "parquet"])
def test_interrupted_tracks_are_whole(
    call, write, monkeypatch: pytest.MonkeyPatch, track_format: str
) -> None:
    from kugelpendel.cli.terminal import estimate

    class Hasty(estimate.StopRequest):
        """Stops after the first stretch."""

        asked = 0

        def __getattribute__(self, name: str) -> object:
            if name == "stop":
                type(self).asked += 1
                return type(self).asked > 1
            return super().__getattribute__(name)

    monkeypatch.setattr("kugelpendel.cli.run.real.StopRequest", Hasty)
    monkeypatch.setattr("kugelpendel.cli.run.real.BLOCK", 100)
    outcome = call("run", write(**REAL), "--format", track_format, "--out", "out/job")
    assert outcome.code == 130
    assert "interrupted after" in outcome.err
    assert [path.name for path in Path("out").iterdir()] == ["job-interrupted"]
    Path("out/job-interrupted").rename("out/job")
    table = _read(track_format)
    times = np.arange(len(table), dtype=np.float64)
    assert 50 < len(table) < 601
    assert_allclose(table[:, 0], times, rtol=0, atol=0)
    assert_allclose(table[:, 1:4], motion().position(times), rtol=0, atol=0)


def test_an_interrupted_job_goes_beside_its_folder() -> None:
    from kugelpendel.cli.run.real import _aside

    assert _aside(Path("out/job")) == Path("out/job-interrupted")
    assert _aside(Path()) == Path("interrupted")


def test_second_interruption_leaves_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    from kugelpendel.cli.terminal.estimate import StopRequest

    with StopRequest() as wish:
        time.sleep(0)
        signal.raise_signal(signal.SIGINT)
        assert wish.stop
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is not StopRequest._ask


@pytest.mark.parametrize("name", ["pantheon-day", "museum", "guelph", "short", "short-remedy"])
def test_a_job_is_one_pass(call, repository: Path, tmp_path: Path, name: str) -> None:
    """Track, tension, turning points and figure together take the steps of one integration."""
    text = (repository / "examples" / f"{name}.toml").read_text(encoding="utf-8")
    text = re.sub(r'^duration = ".*"$', 'duration = "1 h"', text, flags=re.MULTILINE)
    path = tmp_path / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    plain = real_motion(read_job(path))
    before = _core.steps_taken()
    plain.position(3600.0)
    once = _core.steps_taken() - before
    assert call("run", path).code == 0
    assert (Path("out") / name / "figure.png").exists()
    assert _core.steps_taken() - before - once <= 1.05 * once


CIRCLE: dict[str, dict[str, Any]] = {
    "pendulum": {"length": "10 m", "mass": None},
    "launch": {"kind": "apsides", "a": "50 cm", "b": "50 cm"},
    "site": {"latitude": "48 deg"},
    "output": {"duration": "20 min", "step": "1 s", "figure": False},
}


@pytest.mark.parametrize("sense", [1, -1])
def test_a_circle_has_revolutions_and_no_plane(call, write, sense: int) -> None:
    """Bravais' pendulum: the bob's two senses differ by twice what the Earth turns."""
    launch = {**CIRCLE["launch"], "b": f"{50 * sense} cm"}
    outcome = call("run", write(**{**CIRCLE, "launch": launch}), "--json")
    found = outcome.results["revolutions"]
    assert found["sense"] == ("counter-clockwise" if sense > 0 else "clockwise")
    earth = 7.292115e-5 * math.sin(math.radians(48))
    this, other = (
        2 * math.pi / found[f"{key}_s"] for key in ("period", "period_in_the_other_sense")
    )
    assert other - this == pytest.approx(2 * sense * earth, rel=1e-3)
    assert found["last_period_s"] == pytest.approx(found["period_s"], rel=1e-4)
    assert outcome.results["plane"]["mean_deg_per_h"] is None
    assert outcome.results["plane"]["stands_since_s"] is None
    said = call("run", write(**{**CIRCLE, "launch": launch})).out
    assert re.search(r"^One revolution +6\.3\d+ s +.*a circle has no plane$", said, re.MULTILINE)
    assert re.search(r"^  the other way +6\.3\d+ s +.*\d µs (longer|shorter)$", said, re.MULTILINE)
    assert not re.search("stall|stand|Rate of the plane", said)


def test_a_swing_is_no_circle(call, write) -> None:
    assert call("run", write(**REAL), "--json").results["revolutions"] is None


def test_a_plane_that_stands_is_told_before_any_mean(call, repository: Path) -> None:
    outcome = call("run", repository / "examples" / "short.toml")
    said = outcome.out
    assert re.search(
        r"^The plane stands +at −6\d\.\d° +since 2\.\d+ h, to the end$", said, re.MULTILINE
    )
    assert said.index("The plane stands") < said.index("Rate at the end") < said.index("mean over")
    plane = json.loads(Path("out/short/results.json").read_text(encoding="utf-8"))["plane"]
    assert 2.0 * 3600 < plane["stands_since_s"] < 3.0 * 3600
    assert math.degrees(plane["stands_at_rad"]) == pytest.approx(-63.8, abs=0.1)
    assert abs(plane["at_the_end_deg_per_h"]) < 0.01
    assert plane["mean_deg_per_h"] == pytest.approx(-10.63, abs=0.01)
    keys = list(plane)
    assert keys.index("stands_since_s") < keys.index("mean_rad_per_s")


def test_a_job_of_absurd_length_says_so_and_stops_at_once(write, tmp_path: Path) -> None:
    """A sideways push of 10⁹ m: before, the events of the first stretch took 14 minutes."""
    tables = {
        "pendulum": {"length": "83 cm", "mass": None},
        "launch": {"kind": "ellipse", "a": "3 cm", "b": "1e9 m"},
        "site": {"latitude": "43.53 deg"},
        "output": {"duration": "36 h", "step": "0.5 s", "figure": False},
    }
    command = [sys.executable, "-m", "kugelpendel", "run", str(write(**tables))]
    command += ["--out", str(tmp_path / "target")]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert "this takes about" in process.stderr.readline()
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=30)
        # A leg of work of at most 0.2 s, and the way out of the interpreter.
        assert time.monotonic() - sent < 3
    assert process.returncode == 130
    assert "interrupted" in err
    assert not (tmp_path / "target").exists()


def test_comparison_of_ideal_motions_refuses_forces(call, write) -> None:
    outcome = call("compare", write(**REAL))
    assert outcome.code == 2
    assert "[site], [drag], [suspension], [bob]" in outcome.err
    assert "kugelpendel run" in outcome.err
