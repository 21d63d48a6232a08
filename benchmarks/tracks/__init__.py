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
import resource, sys, time
import kugelpendel as kp
start = time.process_time()
fit = kp.tracks.fit(kp.tracks.read(sys.argv[1]), gravity=9.805)
print(time.process_time() - start, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
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


def measure() -> Section:
    with tempfile.TemporaryDirectory() as name:
        small = written(Path(name), 1457.0, 8.645)
        ellipses = kp.tracks.ellipses(kp.tracks.read(small))
        whole = taken(lambda: kp.tracks.fit(kp.tracks.read(small), gravity=9.805))
        reduced = taken(lambda: kp.tracks.ellipses(kp.tracks.read(small)))
        one = taken(lambda: kp.tracks.fit(ellipses, gravity=9.805, models=("narrow",)))
        large = written(Path(name), 33_333.0, 30.0)
        command = [sys.executable, "-c", MILLION, str(large)]
        said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    seconds, megabytes = (float(word) for word in said.split())
    ratios = [
        Ratio("12 600 points, from the file to all models", "1 s", whole, 1.0, whole, 1.0),
        Ratio("the same, from the file to ellipses", "1 s", reduced, 1.0, reduced),
        Ratio("the fit of one model", "0.1 s", one, 0.1, one / 0.1, 1.0),
        Ratio("a million points, to all models", "15 s", seconds, 15.0, seconds / 15.0, 1.0),
    ]  # fmt: skip
    notes = [
        f"Processor time, the least of {ROUNDS} rounds, of a million points of one. These take "
        f"{megabytes:.0f} MB at the most, the interpreter and its libraries included; 600 MB are "
        "allowed.",
    ]
    return Section("Recorded tracks", ratios, (), notes)
