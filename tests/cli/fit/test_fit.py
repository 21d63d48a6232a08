"""``kugelpendel fit``: from a file to a report that says what it assumes, or to a sentence."""

import json
import re
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic, sleep

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.fit.words import words

SWING = kp.Launch.apsides(0.15, 0.02, azimuth=0.4)
REAL = kp.RealMotion(
    kp.Pendulum(1.5), SWING, site=kp.Site(0.82), drag=kp.Drag(2e-4), suspension=kp.Suspension(2e-5)
)


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Five minutes of a pendulum, in millimetres with decimal commas and a name that is markup."""
    track = kp.tracks.synthesise(REAL, 300.0, 12.0, noise=5e-4, outliers=0.01, seed=7)
    rows = zip(track.time, 1e3 * track.x, 1e3 * track.y, strict=True)
    lines = ["t (s);x (mm);y (mm);<b>spare</b>"]
    lines += [f"{t:.4f};{x:.3f};{y:.3f};1".replace(".", ",") for t, x, y in rows]
    path = tmp_path_factory.mktemp("fit") / "a<b>&.csv"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def test_the_numbers(call, file: Path) -> None:
    outcome = call("fit", file, "--length", "1.5 m", "--latitude", "47 N", "--json", "--out", "o")
    assert outcome.code == 0
    found = outcome.results
    assert found["unit"] == "m"
    table = found["ellipses"]
    count = len(table["time"])
    for name in ("a", "b", "azimuth", "frequency", "x0", "y0"):
        assert len(table[name]) == len(table[f"{name}_stderr"]) == count
    seen = found["models"]["headline"]["parameters"]
    middle = kp.EnvelopeMotion(REAL.pendulum, REAL.launch, REAL.forces)
    a, b = middle.semi_axes(found["pendulum"]["reference_time_s"])
    for name, true in (("a", a), ("b", b)):
        one = seen[name]
        assert abs(one["value"] - true) < 5 * one["stderr"] + 1e-3 * abs(true)
    assert seen["rotation"]["low"] < kp.Site(0.82).vertical_rotation < seen["rotation"]["high"]
    kinds = {note["kind"] for note in found["notes"]}
    assert {"decimal_comma", "unit", "columns_ignored", "y_up_assumed", "outliers"} <= kinds
    assert json.loads(Path("o/fit.json").read_text("utf-8")) == found
    written = {path.name for path in Path("o").iterdir() if not path.name.startswith(".")}
    assert {"fit.json", "ellipses.nc", "report.html", "seen.png", "course.png"} <= written
    import xarray as xr

    with xr.open_dataset("o/ellipses.nc", engine="h5netcdf") as kept:
        assert np.allclose(kept.a.values, table["a"])


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_report(call, file: Path, language: str) -> None:
    outcome = call("fit", file, "--lang", language, "--out", "o")
    assert outcome.code == 0
    said = words(language)
    # Whether the model fits at all comes first.
    first = " ".join(outcome.out.split("\n\n")[0].split())
    start = said["fits"].partition("(")[0]
    assert first.startswith((start.strip(), said["misfit"].partition(":")[0]))
    assert said["section_notes"] in outcome.out
    page = Path("o/report.html").read_text("utf-8")
    assert f'<html lang="{language}">' in page
    # Names out of the file are text, and nothing is fetched from elsewhere.
    assert "&lt;b&gt;spare&lt;/b&gt;" in page
    assert "<b>spare" not in page
    assert "a&lt;b&gt;&amp;.csv" in page
    assert not re.findall(r'(?:src|href)="(?!data:image/png)', page)
    assert "<script" not in page
    # A unit stays on the line of its number.
    values = re.findall(r'<dd class="value">(.*?)</dd>', page)
    assert any(re.search(r"\d\u00a0(mm|cm|m|s)\b", value) for value in values)
    assert not any(re.search(r"\d (mm|cm|m|s|°/h)\b", value) for value in values)
    # Every number has a whole sentence.
    meanings = re.findall(r"<dd>(.*?)</dd>", page)
    assert len(meanings) > 8
    for meaning in meanings:
        assert re.match(r"[A-Z0-9]|ln ", meaning), meaning
        assert meaning.endswith("."), meaning


def test_both_languages_say_the_same_things() -> None:
    english, german = words("en"), words("de")
    assert list(english) == list(german)
    for key, text in english.items():
        places = set(re.findall(r"\{\w+\}", text))
        assert places == set(re.findall(r"\{\w+\}", german[key])), key


REFUSED = {
    "nothing asked": ([], "Which track?"),
    "no such file": (["nothing.csv"], "cannot be read"),
    "a column that is not there": (["FILE", "--columns", "t=t,x=u,y=v"], "has no column u"),
    "columns in no form": (["FILE", "--columns", "t;x;y"], "write it like"),
    "a scale without a unit": (["FILE", "--scale", "big"], "--scale"),
    "a length of nothing": (["FILE", "--length", "0 m"], "--length"),
    "a tilt of too much": (["FILE", "--tilt", "200 %"], "--tilt"),
    "swings of nothing": (["FILE", "--swings", "1"], "--swings"),
    "no such language": (["FILE", "--lang", "fr"], "'fr'"),
    "a plan of nothing": (["--plan"], "--rate"),
    "a plan of a file": (["FILE", "--plan"], "leave out"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused(call, file: Path, case: str) -> None:
    arguments, said = REFUSED[case]
    outcome = call("fit", *(file if one == "FILE" else one for one in arguments), "--out", "o")
    assert outcome.code == 2
    assert said in outcome.err
    assert outcome.err.startswith("kugelpendel: ")
    assert outcome.out == ""
    assert not Path("o").exists()


BAD = {
    "empty": "",
    "one column": "\n".join(f"{i}" for i in range(99)),
    "no times": "x;y\n" + "\n".join(f"{i};{i * i % 7}" for i in range(99)),
    "constant": "t;x;y\n" + "\n".join(f"{i / 30:.4f};3;4" for i in range(99)),
    "NaN everywhere": "t;x;y\n" + "\n".join(f"{i / 30:.4f};NaN;NaN" for i in range(99)),
    "too short": "t;x;y\n" + "\n".join(f"{i / 30:.4f};{i}.5;{2 * i}.5" for i in range(20)),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_tracks(call, tmp_path: Path, case: str) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(BAD[case])
    outcome = call("fit", path, "--out", "o")
    assert outcome.code == 2
    assert re.fullmatch(r"kugelpendel: .*\.\n", outcome.err)
    assert not Path("o").exists()


def test_interrupted_it_leaves_nothing(tmp_path: Path) -> None:
    time = np.arange(150_000) / 30
    table = np.stack([time, np.cos(2.6 * time), 0.1 * np.sin(2.6 * time)], axis=1)
    np.savetxt(tmp_path / "long.csv", table, delimiter=",", header="t,x,y", comments="", fmt="%.5f")
    command = [sys.executable, "-m", "kugelpendel", "fit", "long.csv", "--out", "o"]
    with subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        until = monotonic() + 60
        while not list(tmp_path.rglob(".kugelpendel-*")) and monotonic() < until:
            sleep(0.01)  # it is at work as soon as its stage is there
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert (out, err) == ("", "kugelpendel: interrupted; no file is left half-written.\n")
    assert [path.name for path in tmp_path.iterdir()] == ["long.csv"]


def test_too_short_for_a_model_but_not_for_an_ellipse(call, file: Path) -> None:
    path = Path("short.csv")
    path.write_text("\n".join(file.read_text("utf-8").splitlines()[:200]), encoding="utf-8")
    outcome = call("fit", path, "--json", "--out", "o")
    assert outcome.code == 0
    found = outcome.results
    assert "models" not in found
    assert "record for" in found["why_no_model"]
    assert found["ellipses"]["a"][0] == pytest.approx(0.15, rel=0.02)
    outcome = call("fit", path, "--lang", "de", "--out", "o")
    assert outcome.code == 0
    assert outcome.out.startswith("Nur die Ellipsen")


def test_a_phone_tells_no_precession(call) -> None:
    rate = 2 * np.pi / 2.8
    lines = ["Time (s),Linear Acceleration x (m/s^2),Linear Acceleration y (m/s^2)"]
    for time in np.arange(0, 180, 1 / 20):
        x = -1.4 * np.exp(-time / 900) * np.cos(rate * time)
        y = -0.1 * np.sin(rate * time)
        lines.append(f"{time:.3f},{x:.5f},{y:.5f}")
    Path("phone.csv").write_text("\n".join(lines))
    outcome = call("fit", "phone.csv", "--json", "--out", "o")
    assert outcome.code == 0
    found = outcome.results
    assert found["axes"] == "phone"
    assert set(found["models"]["headline"]["parameters"]) == {"a", "linear", "quadratic"}
    assert not {"wobble", "stiffening"} & set(found)
    assert "phone" in {note["kind"] for note in found["notes"]}
    page = Path("o/report.html").read_text("utf-8")
    assert "a precession cannot" in page
    assert "Ω_z" not in page
