"""From the file of a recorded track to its numbers: processor time and memory."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from report import Ratio, Section

import kugelpendel as kp

ROUNDS = 5
MOTION = kp.RealMotion(
    kp.Pendulum(1.955, 9.805),
    kp.Launch.ellipse(0.28, 0.001, 0.9),
    site=kp.Site(0.764),
    drag=kp.Drag(2e-5, 8e-4),
    suspension=kp.Suspension(6e-5, 0.4),
)
"""As long, as often and as noisy as the recording of Florence: 1457 s at 8.645 points a second."""

MILLION = """
import sys, time
from pathlib import Path
import kugelpendel as kp
start = time.process_time()
track = kp.tracks.read(sys.argv[1])
read = time.process_time() - start
fit = kp.tracks.fit(track, gravity=9.805)
whole = time.process_time() - start
# Not ru_maxrss: Linux hands that of the process that started this one on to it.
status = Path("/proc/self/status").read_text().split()
print(read, whole, float(status[status.index("VmHWM:") + 1]) / 1024)
"""
PANDAS = """
import sys, time
import pandas
start = time.process_time()
pandas.read_csv(sys.argv[1])
print(time.process_time() - start)
"""


def written(folder: Path, duration: float, rate: float) -> Path:
    """A file of a synthetic track."""
    track = kp.tracks.synthesise(MOTION, duration, rate, noise=5e-4, jitter=0.2, outliers=0.02)
    path = folder / f"{len(track)}.csv"
    table = np.stack([track.time, track.x, track.y], axis=1)
    np.savetxt(path, table, delimiter=",", header="t (s),x (m),y (m)", comments="", fmt="%.6f")
    return path


def taken(work: object) -> float:
    """The least processor time of several rounds, s."""
    times = []
    for _ in range(ROUNDS):
        start = time.process_time()
        work()  # type: ignore[operator]
        times.append(time.process_time() - start)
    return min(times)


def said(program: str, path: Path) -> list[float]:
    """The numbers that a program prints in a process of its own."""
    command = [sys.executable, "-c", program, str(path)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


def measure() -> Section:
    with tempfile.TemporaryDirectory() as name:
        small = written(Path(name), 1457.0, 8.645)
        ellipses = kp.tracks.ellipses(kp.tracks.read(small))
        whole = taken(lambda: kp.tracks.fit(kp.tracks.read(small), gravity=9.805))
        reduced = taken(lambda: kp.tracks.ellipses(kp.tracks.read(small)))
        one = taken(lambda: kp.tracks.fit(ellipses, gravity=9.805, models=("narrow",)))
        large = written(Path(name), 33_333.0, 30.0)
        alone = said(MILLION, large), said(PANDAS, large)
    (read, seconds, megabytes), (pandas,) = alone
    ratios = [
        Ratio("12 600 points, from the file to all models", "1 s", whole, 1.0, whole, 1.0),
        Ratio("the same, from the file to ellipses", "1 s", reduced, 1.0, reduced),
        Ratio("the fit of one model", "0.1 s", one, 0.1, one / 0.1, 1.0),
        Ratio("a million points, to all models", "15 s", seconds, 15.0, seconds / 15.0, 1.0),
        Ratio("the same, memory at the most", "600 MB", megabytes, 600.0, megabytes / 600.0, 1.0,
              unit="MB"),
        Ratio("a million points, reading alone", "pandas.read_csv", read, pandas, read / pandas),
    ]  # fmt: skip
    notes = [
        f"Processor time, the least of {ROUNDS} rounds, of a million points of one. Memory is that "
        "of a process of its own, the interpreter and its libraries included.",
        "pandas is told nothing and checks nothing: it finds neither the separator, the decimal "
        "mark nor the units, drops no row and sorts none.",
    ]
    return Section("Recorded tracks", ratios, (), notes)
