"""Ctrl-C ends every command and every call that lasts at once."""

import os
import re
import select
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import IO

import pytest

from kugelpendel.cli import main

JOB = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = "10 cm"
b = "3 cm"
{forces}
[output]
duration = "{duration}"
step = "{step}"
"""
DRAG = '[drag]\nhalf_life = "1 h"'
DESIGN = """
[pendulum]
length = "1 m"
[swing]
a = "5 cm"
[site]
latitude = "50 deg"
[drag]
linear = "1e-4 1/s"
[suspension]
anisotropy = "1e-6 rad/s"
damping_anisotropy = "1e-6 1/s"
[drive]
push = "1e-5 m/s"
phase = 0.4
"""

SWEEP = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = { uniform = ["1 cm", "10 cm"] }
b = "1 mm"
[site]
latitude = "45 deg"
[sweep]
design = "sample"
count = 1000000
motion = "real"
quantities = ["azimuth", "averaging_error"]
times = ["1 h"]
"""

GERMAN = "derive German"
COMMANDS = {
    "run": (["run"], JOB.format(forces="", duration="250 h", step="10 ms")),
    "run real": (["run"], JOB.format(forces=DRAG, duration="1e6 h", step="100 s")),
    "compare": (["compare"], JOB.format(forces="", duration="40000 s", step="1 s")),
    "design": (["design"], DESIGN),
    "synth": (["synth", "--rate", "300"], JOB.format(forces=DRAG, duration="40 h", step="1 s")),
    "sweep": (["sweep"], SWEEP),
    "derive": (["derive", "--format", "html"], None),
    "derive check": (["derive", "--check"], None),
    GERMAN: (["derive", "--format", "html", "--lang", "de"], None),
}

SETTING = """
import numpy as np
import kugelpendel as kp
l, many = kp.Pendulum(1.0), np.linspace(0.1, 0.2, {n})
ground = dict(site=kp.Site(0.8), suspension=kp.Suspension(1e-5, 0.3))
"""
TINY = (
    "kp.EnvelopeMotion(kp.Pendulum(1e-6), kp.Launch.ellipse({a}, 3e-8), site=kp.Site(0.04),"
    " suspension=kp.Suspension(30.0)).settled()"
)
"""A day of the Earth is long for so short a pendulum."""

CALLS = {
    "envelope": "kp.EnvelopeMotion(l, kp.Launch.ellipse(0.1, 0.03), drag=kp.Drag(1e-9),"
    " suspension=kp.Suspension(1e-3)).azimuth(1e9)",
    "envelopes": "kp.EnvelopeMotion(l, kp.Launch.ellipse(many[:1000], 0.03), drag=kp.Drag(1e-9),"
    " suspension=kp.Suspension(1e-3)).azimuth(1e8)",
    "settled": TINY.format(a="1e-7"),
    "settled ones": TINY.format(a="1e-6 * many"),
    "orbits": "kp.EnvelopeMotion(l, kp.Launch.ellipse(np.repeat(many, 100), 0.03), **ground)"
    ".clamp_orbits()",
    "course": "kp.EnvelopeMotion(l, kp.Launch.ellipse(0.1, 0.03), **ground).course(1e9)",
    "courses": "kp.EnvelopeMotion(l, kp.Launch.ellipse(many, 0.03), **ground).course(1e9)",
    "pace": "kp.EnvelopeMotion(l, kp.Launch.ellipse(0.1, 0.03), **ground).pace(0.0, 1e9)",
    "paces": "kp.EnvelopeMotion(l, kp.Launch.ellipse(many, 0.03), **ground).pace(0.0, 1e9)",
    "real course": "kp.RealMotion(l, kp.Launch.ellipse(0.1, 0.03), **ground)"
    ".course(np.array([0.0, 1e8]))",
    "real courses": "kp.RealMotion(l, kp.Launch.ellipse(many, 0.03), **ground)"
    ".course(np.linspace(0.0, 1e5, 60000))",
    "plane": "kp.PlaneMotion(l, kp.Launch.ellipse(0.1, 0.03)).position(1e8)",
    "cubic": "kp.CubicMotion(l, kp.Launch.ellipse(0.1, 0.03)).position(1e8)",
    "real": "kp.RealMotion(l, kp.Launch.ellipse(0.1, 0.03), drag=kp.Drag(1e-9)).position(1e8)",
    "reals": "kp.RealMotion(l, kp.Launch.ellipse(many[:100], 0.03)).position(1e7)",
    "sample": "kp.ExactMotion(l, kp.Launch.ellipse(0.1, 0.03)).sample(0.0, 0.1, 10**8)",
    "exacts": "kp.ExactMotion(l, kp.Launch.ellipse(many, 0.03)).position(np.arange(10.0))",
    "events": "kp.ExactMotion(l, kp.Launch.ellipse(0.1, 0.03)).events('radius', 0, 1e12, 0.5)",
    "series events": "kp.SeriesMotion(l, kp.Launch.ellipse(0.1, 0.03), 4).events('outer', 0, 1e9)",
    "map": "kp.validity_map(4000)",
    "ellipse": "kp.ellipse(kp.ExactMotion(l, kp.Launch.ellipse(0.1, 0.03)), np.arange(1e7))",
}

DELAYS = (0.3, 1.2)
"""s after the start of the work; a call that is over sooner begins again."""

LATE = 4.0
"""s after which a sweep has begun with its cases, and not only to import what it needs."""

NOTICED = 0.2
"""s after which somebody notices that nothing has happened."""

ATTEMPTS = 6


@pytest.mark.parametrize("delay", DELAYS)
@pytest.mark.parametrize("name", CALLS)
def test_a_call_is_interrupted(name: str, delay: float) -> None:
    setting = SETTING.format(n=10**6 if name == "exacts" else 1000)
    code = f"{setting}print(flush=True)\nwhile True:\n    {CALLS[name]}"
    command = [sys.executable, "-c", code]
    assert "KeyboardInterrupt" in interrupted(command, delay, Path.cwd())


# What is interrupted before its arguments are read knows no language, so German is asked late only.
@pytest.mark.parametrize(
    ("name", "delay"),
    [
        *((name, delay) for name in COMMANDS for delay in DELAYS if name != GERMAN or delay > 1),
        ("sweep", LATE),
    ],
)
def test_a_command_is_interrupted(name: str, delay: float, tmp_path: Path) -> None:
    words, job = COMMANDS[name]
    if job is not None:
        (tmp_path / "job.toml").write_text(job)
        words = [*words, "job.toml"]
    code = (
        "import sys, kugelpendel.__main__ as door\nfrom kugelpendel.cli import main\n"
        f"sys.argv[1:] = {words!r}\nprint(flush=True)\ndoor.run()"
    )
    said = interrupted([sys.executable, "-c", code], delay, tmp_path)
    kept = (
        r"abgebrochen; keine Datei ist halb geschrieben"
        if "de" in words
        else r"interrupted(; no file is left half-written"
        r"| before the first sample; nothing is written| after .* in out/job-interrupted"
        r"|; [\d ]+ of 1 000 000 cases are done and kept in out/job\. The same command goes on: .*)"
    )
    assert re.search(f"^kugelpendel: {kept}", said, re.MULTILINE), said
    # A folder with what is done so far has its manifest, as every folder that a command fills.
    manifest = {".kugelpendel.json"} if "in out/job-interrupted" in said else set[str]()
    assert {path.name for path in tmp_path.rglob(".kugelpendel*")} == manifest


def interrupted(command: list[str], delay: float, folder: Path) -> str:
    """What a process says that is interrupted so long after its first line, within `NOTICED`.

    What else the machine does can hold up an answer; what the command does holds up every one.
    """
    answers = (interrupted_once(command, delay, folder) for _ in range(ATTEMPTS))
    lates = list[float]()
    for said, late in answers:
        lates.append(late)
        if late < NOTICED:
            return said
    raise AssertionError(f"said after {lates} s at best, {NOTICED} s asked: {command}")


def interrupted_once(command: list[str], delay: float, folder: Path) -> tuple[str, float]:
    """Interrupt a process so long after its first line: what it said, and s until it said it."""
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=folder, bufsize=0
    )
    assert process.stdout is not None
    assert process.stderr is not None
    try:
        process.stdout.readline()
        time.sleep(delay)
        before = os.read(process.stderr.fileno(), 65536) if waiting(process.stderr, 0) else b""
        process.send_signal(signal.SIGINT)
        sent = time.perf_counter()
        waiting(process.stderr, 30)
        late = time.perf_counter() - sent
        _, said = process.communicate(timeout=30)
    finally:
        process.kill()
        process.wait()
    return (before + said).decode(), late


def waiting(stream: IO[bytes], patience: float) -> bool:
    """Whether there is something to read within so many seconds."""
    return bool(select.select([stream], [], [], patience)[0])


def test_an_interruption_that_python_wraps_is_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def wrapped(*_: object) -> None:
        raise RuntimeError("Error calling __set_name__") from KeyboardInterrupt()

    def broken(*_: object) -> None:
        raise RuntimeError("something else") from ValueError()

    monkeypatch.setattr("kugelpendel.cli.compare.command.compare", wrapped)
    assert main(["compare", "job.toml"]) == 130
    assert capsys.readouterr().err == "kugelpendel: interrupted; no file is left half-written.\n"
    monkeypatch.setattr("kugelpendel.cli.compare.command.compare", broken)
    with pytest.raises(RuntimeError, match="something else"):
        main(["compare", "job.toml"])
