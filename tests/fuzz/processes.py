"""The same in real processes: odd terminals, closed outputs, and kills at any moment."""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from tests.fuzz.in_process import files, verdict

COMMAND = [sys.executable, "-m", "kugelpendel"]
ENCODINGS = ("utf-8", "cp1252", "ascii", "latin-1", "utf-16")

JOB = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = "10 cm"
b = "3 cm"
[drag]
half_life = "1 h"
[output]
duration = "{duration}"
step = "10 ms"
figure = false
"""


def process_fault(command: str, data: bytes, encoding: str) -> str | None:
    """What is wrong with how a process dealt with a file, or None."""
    folder = Path(tempfile.mkdtemp(prefix="fuzz-"))
    try:
        file, out = folder / "job.toml", folder / "out"
        file.write_bytes(data)
        more = ["--formulas"] if command == "design" else []
        process = subprocess.Popen(
            [*COMMAND, command, file, "--out", out, "--json", *more],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            env=os.environ | {"PYTHONIOENCODING": encoding},
        )  # fmt: skip
        try:
            printed, said = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            try:
                _, said = process.communicate(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                return "Ctrl-C was not obeyed within ten seconds"
            return None if said.strip() else "nothing said for a minute"
        shown, told = (text.decode(encoding, errors="replace") for text in (printed, said))
        return verdict(process.returncode, shown, told, out)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def kill_faults(count: int, seed: int, tick: Callable[[], None]) -> list[str]:
    """Kill a job at any moment: the old files or the new are whole, the next run cleans."""
    chance = random.Random(seed)
    found: list[str] = []
    folder = Path(tempfile.mkdtemp(prefix="fuzz-"))
    try:
        for job, duration in (("old", "10 s"), ("new", "400 s")):
            (folder / f"{job}.toml").write_text(JOB.format(duration=duration))
        out = folder / "out"
        call = [*COMMAND, "run", folder / "old.toml", "--out", out]
        subprocess.run(call, check=True, capture_output=True)
        start = time.perf_counter()
        subprocess.run([*COMMAND, "run", folder / "new.toml", "--out", out], check=True,
                       capture_output=True)  # fmt: skip
        whole = time.perf_counter() - start
        for _ in range(count):
            subprocess.run(call, check=True, capture_output=True)
            process = subprocess.Popen(
                [*COMMAND, "run", folder / "new.toml", "--out", out],
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            )  # fmt: skip
            # Most of them late, where files move into their place.
            time.sleep(whole * chance.choice((chance.random(), chance.uniform(0.6, 1.1))))
            process.kill()
            process.wait()
            if wrong := _not_whole(out):
                found.append(wrong)
            subprocess.run(call, check=True, capture_output=True)
            if left := [path.name for path in folder.rglob(".kugelpendel-*")]:
                found.append(f"the next run left {left}")
            tick()
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return found


def _not_whole(out: Path) -> str | None:
    try:
        samples = json.loads((out / "results.json").read_text())["output"]["samples"]
        rows = (out / "track.csv").read_text().splitlines()
    except (OSError, ValueError, KeyError) as error:
        return f"neither the old set nor the new one: {error!r}"
    data = [row for row in rows if row and row[0] in "-0123456789"]
    return None if len(data) == samples else f"{len(data)} rows beside {samples} samples"


def process_faults(count: int, seed: int, tick: Callable[[], None]) -> list[tuple[str, bytes, str]]:
    """Every file that a process dealt with wrongly, and how."""
    chance = random.Random(seed)
    found: list[tuple[str, bytes, str]] = []
    for command, data in files(count, seed):
        if (wrong := process_fault(command, data, chance.choice(ENCODINGS))) is not None:
            found.append((command, data, wrong))
        tick()
    return found
