"""The command: from a file to a store and answers, interrupted or not, and what it refuses."""

# What is refused stands in rows, whatever their length.
# ruff: noqa: E501

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file.schema_text import example
from kugelpendel.cli.job_file.sweep_schema import SWEEP_FILE
from kugelpendel.cli.sweep.sweep_file import read_sweep_file
from kugelpendel.sweeps import Listed, Spaced, SweepStore, Uniform

SWEEP = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = { from = "5 cm", to = "50 cm", count = 4 }
b = ["1 cm", "2 cm", "3 cm"]
[sweep]
motion = "exact"
quantities = ["precession", "period"]
"""
LONG = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = { uniform = ["1 cm", "10 cm"] }
b = 0
[site]
latitude = "45 deg"
[suspension]
anisotropy = { uniform = ["1e-7 rad/s", "1e-5 rad/s"] }
[sweep]
design = "sample"
count = 600
motion = "averaged"
quantities = ["azimuth"]
times = ["10 min"]
chunk = 4
"""


@pytest.fixture
def file(tmp_path: Path) -> Callable[..., Path]:
    """Write a file with some lines replaced."""

    def file(text: str = SWEEP, **changes: str) -> Path:
        for key, value in changes.items():
            text, count = re.subn(rf"^{key} = .*$", f"{key} = {value}", text, flags=re.MULTILINE)
            assert count == 1, key
        path = tmp_path / "sweep.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return file


def test_the_whole(call: Any, file: Any) -> None:
    outcome = call("sweep", file())
    assert outcome.code == 0, outcome.err
    names = {path.name for path in Path("out/sweep").iterdir()}
    assert {"sweep.zarr", "results.json", "precession.png", "period.png"} <= names
    assert not [name for name in names if name.startswith(".sweep")]
    sweep, found = kp.sweeps.read("out/sweep")
    assert sweep.shape == (4, 3)
    motion = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.5, 0.02))
    assert found.precession.sel({"launch.a": 0.5, "launch.b": 0.02}).item() == motion.precession
    assert "12" in outcome.out
    again = call("sweep", file(), "--json")
    assert again.code == 0
    assert again.results["cases"] == 12
    assert again.results["status"] == {"not yet": 0, "good": 12, "refused": 0, "ended early": 0}
    periods = next(row for row in again.results["results"] if row["quantity"] == "period")
    assert periods["most"] == pytest.approx(found.period.values.max(), rel=1e-15)
    assert again.results == json.loads(Path("out/sweep/results.json").read_text("utf-8"))


def test_a_file_says_what_python_says(file: Any, tmp_path: Path) -> None:
    asked = read_sweep_file(file(LONG)).sweep
    given = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "ellipse", "a": Uniform(0.01, 0.1), "b": 0.0},
        "site": {"latitude": np.pi / 4},
        "suspension": {"anisotropy": Uniform(1e-7, 1e-5)},
    }
    assert asked == kp.Sweep(given, "sample", "averaged", ("azimuth",), (600.0,), 600)
    assert asked.chunk == 4
    path = tmp_path / "state.toml"
    path.write_text(
        '[pendulum]\nlength = "1 m"\n[launch]\nkind = "state"\n'
        'position = [0, 0, "1 m"]\nvelocity = [["1 m/s", "2 m/s"], {from = 0, to = 1, count = 3}, 0]\n'
        '[sweep]\nmotion = "exact"\nquantities = "azimuth"\n'
        'times = { from = "1 s", to = "3 s", count = 3 }\n',
        encoding="utf-8",
    )
    state = read_sweep_file(path).sweep
    assert dict(state.varied) == {
        "launch.vx": Listed((1.0, 2.0)), "launch.vy": Spaced(0.0, 1.0, 3),
    }  # fmt: skip
    assert list(state.times) == [1.0, 2.0, 3.0]


def test_the_example_of_the_help_can_be_read(tmp_path: Path) -> None:
    path = tmp_path / "example.toml"
    path.write_text(example(SWEEP_FILE), encoding="utf-8")
    assert read_sweep_file(path).sweep.shape == (40, 40, 2)


def test_reductions_have_an_answer(call: Any, file: Any) -> None:
    text = SWEEP + 'keep = ["moments", "quantiles"]\n'
    outcome = call("sweep", file(text), "--json")
    assert outcome.code == 0, outcome.err
    (period,) = [row for row in outcome.results["results"] if row["quantity"] == "period"]
    assert period["count"] == 12
    assert period["mean"] == pytest.approx(2.03, abs=0.02)
    assert call("sweep", file(text)).code == 0


REFUSED: dict[str, tuple[dict[str, str], str]] = {
    "empty list": ({"b": "[]"}, "line 7: The list of [launch] b is empty; "),
    "empty range": ({"a": '{ from = "1 cm", to = "1 cm", count = 4 }'}, "line 6: The range of [launch] a is empty: "),
    "no unit": ({"a": '{ from = "1 cm", to = "2", count = 4 }'}, 'line 6: [launch] a = "2" has no unit; '),
    "no count": ({"a": '{ from = "1 cm", to = "2 cm" }'}, "line 6: The range of [launch] a lacks a count: "),
    "distribution": ({"b": '{ normal = ["1 cm", "1 mm"] }'}, "line 7: [launch] b has a distribution, normal, which"),
    "many": ({"a": '{ from = "1 cm", to = "2 cm", count = 1000000000000 }'}, "line 8: [sweep] This sweep has 3e+12 cases, which take 333 h of one core or more, and 5.1e+04 GB; "),
    "motion": ({"motion": '"slow"'}, 'line 9: [sweep] motion = "slow" is not known; '),
    "quantity": ({"quantities": '["precesion"]'}, "[sweep] A sweep cannot read 'precesion'; "),
    "words": ({"quantities": "3"}, "line 10: [sweep] quantities = 3 is no list of words; "),
    "nothing": ({"a": "0.1", "b": "0"}, "[sweep] Nothing varies in this sweep; "),
    "length": ({"length": '"-1 m"'}, "line 3: [pendulum] The pendulum's length must be positive"),
    "kind": ({"kind": '"circle"'}, 'line 5: [launch] kind = "circle" is not known; '),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refused(call: Any, file: Any, name: str) -> None:
    changes, sentence = REFUSED[name]
    outcome = call("sweep", file(**changes), "--lang", "en")
    assert outcome.code == 2
    assert outcome.out == ""
    said = outcome.err.removeprefix(f"kugelpendel: {file(**changes)}")
    assert sentence in said
    assert not Path("out").exists()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--workers", "0"], "--workers is '0'; write a whole number from 1 to 4096, "),
        (["--workers", "two"], "--workers is 'two'; write a whole number"),
        (["--lang", "fr"], "There is no text in the language 'fr'; "),
        (["--out", "-"], "--out -: several files do not fit into standard output; "),
    ],
)
def test_odd_options(call: Any, file: Any, arguments: list[str], sentence: str) -> None:
    outcome = call("sweep", file(), *arguments)
    assert outcome.code == 2
    assert sentence in outcome.err
    assert not Path("out").exists()


def test_german(call: Any, file: Any) -> None:
    outcome = call("sweep", file(b="[]"), "--lang", "de")
    assert outcome.err.endswith(
        "Die Liste von [launch] b ist leer; geben Sie wenigstens einen Wert an.\n"
    )


def test_another_sweep_in_the_folder(call: Any, file: Any) -> None:
    assert call("sweep", file()).code == 0
    outcome = call("sweep", file(length='"2 m"'))
    assert outcome.code == 2
    assert (
        "out/sweep holds another sweep, which differs in [pendulum] length; choose" in outcome.err
    )


def test_the_same_sweep_in_another_order(call: Any, file: Any) -> None:
    text = SWEEP.replace('a = { from = "5 cm", to = "50 cm", count = 4 }\n', "")
    text = text.replace("[sweep]", 'a = { from = "5 cm", to = "50 cm", count = 4 }\n[sweep]')
    assert call("sweep", file()).code == 0
    outcome = call("sweep", file(text))
    assert outcome.code == 2
    assert "out/sweep holds this sweep with what varies in another order; choose" in outcome.err
    german = call("sweep", file(text), "--lang", "de")
    assert "aber was sich ändert, steht in anderer Reihenfolge. Nehmen Sie mit --out" in german.err


def test_a_scheduler_that_does_not_answer(call: Any, file: Any) -> None:
    outcome = call("sweep", file(), "--scheduler", "tcp://127.0.0.1:1")
    assert outcome.code == 2
    assert "No Dask scheduler answers at tcp://127.0.0.1:1 within 5 s" in outcome.err


def started(path: Path, out: Path, *options: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "kugelpendel", "sweep", str(path), "--out", str(out)]
    return subprocess.Popen(
        [*command, "--lang", "en", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True, start_new_session=True,
    )  # fmt: skip


def wait_for_chunks(out: Path, count: int, process: subprocess.Popen[str]) -> None:
    marks = out / "sweep.zarr" / "done" / "c"
    deadline = time.monotonic() + 60
    while not marks.is_dir() or len(list(marks.iterdir())) < count:
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.005)


@pytest.mark.parametrize("engine", [[], ["--workers", "2"]], ids=["here", "workers"])
def test_interrupted_and_killed_it_goes_on(file: Any, tmp_path: Path, engine: list[str]) -> None:
    path, out = file(LONG), tmp_path / "out"
    process = started(path, out, *engine)
    wait_for_chunks(out, 3, process)
    os.killpg(process.pid, signal.SIGINT)
    said, complaint = process.communicate(timeout=30)
    assert process.returncode == 130
    assert said == ""
    told = re.search(
        r"interrupted; (\d+) of 600 cases are done and kept in .*\. The same command goes on: "
        r"kugelpendel sweep .*sweep\.toml --out .*\n$",
        complaint,
    )
    assert told is not None, complaint
    assert "Traceback" not in complaint
    for chunks in (10, 25):
        process = started(path, out, *engine)
        wait_for_chunks(out, chunks, process)
        os.kill(process.pid, signal.SIGKILL)
        process.communicate(timeout=30)
    process = started(path, out, "--json")
    said, complaint = process.communicate(timeout=120)
    assert process.returncode == 0, complaint
    assert re.search(r"\d+ of 600 cases are done already; going on\.", complaint)
    assert json.loads(said)["status"]["good"] == 600
    whole = kp.sweep(read_sweep_file(path).sweep, tmp_path / "whole")
    assert kp.sweeps.read(out)[1].identical(whole)
    assert SweepStore(out / "sweep.zarr").done().all()
    assert not list(out.rglob("*.partial"))
