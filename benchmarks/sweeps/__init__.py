"""Sweeps beside the bare ensembles: processor time, memory, workers, the start, and large ones."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from report import Ratio, Section, Table, duration

import kugelpendel as kp
from kugelpendel.spelling import spell_bytes
from kugelpendel.sweeps import Uniform, chunk_for, kept_store
from kugelpendel.sweeps._chunk import do_chunk
from kugelpendel.sweeps._cluster import local_workers
from kugelpendel.sweeps._quantities import measure as read

ROUNDS = 5
DAY = 86400.0
PIECE = 1 << 17
MILLION, HUNDRED_MILLION = 10**6, 10**8

GROUND = {"pendulum": {"length": 67.0}, "site": {"latitude": 0.85}}
CLAMP = {"suspension": {"anisotropy": Uniform(1e-7, 1e-5), "axis": Uniform(0.0, 3.0)}}
SWING = {"launch": {"kind": "ellipse", "a": Uniform(1.0, 5.0), "b": 0.0}}


def exact(count: int, keep: tuple[str, ...] = ("all",)) -> kp.Sweep:
    """Random ellipses up to 0.95 l, of which frequency and precession are read."""
    launch = {"kind": "apsides", "a": Uniform(0.01, 0.95), "b": Uniform(-0.01, 0.01)}
    given = {"pendulum": {"length": 1.0, "gravity": 1.0}, "launch": launch}
    return kp.Sweep(given, "sample", "exact", ("frequency", "precession"), count=count, keep=keep)


def averaged(count: int, **options: object) -> kp.Sweep:
    """A day of the Panthéon's pendulum in random clamps."""
    given = {**GROUND, **CLAMP, **SWING}
    return kp.Sweep(given, "sample", "averaged", ("azimuth",), (DAY,), count, **options)


def real(count: int) -> kp.Sweep:
    """A hundred swings of it by the full equations."""
    given = {**GROUND, **CLAMP, **SWING}
    return kp.Sweep(given, "sample", "real", ("azimuth",), (1642.0,), count)


def bare_exact(draw: np.random.Generator, count: int) -> None:
    for _ in range(0, count, PIECE):
        size = min(PIECE, count)
        a, b = draw.uniform(0.01, 0.95, size), draw.uniform(-0.01, 0.01, size)
        motion = kp.ExactMotion(kp.Pendulum(1.0, 1.0), kp.Launch.apsides(a, b))
        _ = motion.frequency, motion.precession


def bare_forced(draw: np.random.Generator, count: int, kind: type, until: float) -> None:
    clamp = kp.Suspension(draw.uniform(1e-7, 1e-5, count), draw.uniform(0.0, 3.0, count))
    launch = kp.Launch.ellipse(draw.uniform(1.0, 5.0, count), 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        motion = kind(kp.Pendulum(67.0), launch, site=kp.Site(0.85), suspension=clamp)
        read(motion, ("azimuth",), np.array([until]))


def measure() -> Section:
    cost, ratios = {}, []
    bare: dict[str, Callable[[np.random.Generator, int], None]] = {
        "exact": bare_exact,
        "averaged": lambda draw, count: bare_forced(draw, count, kp.EnvelopeMotion, DAY),
        "real": lambda draw, count: bare_forced(draw, count, kp.RealMotion, 1642.0),
    }
    names = {
        "exact": "frequency and precession",
        "averaged": "a day, averaged",
        "real": "100 swings, full equations",
    }
    for kind, make in {"exact": exact, "averaged": averaged, "real": real}.items():
        ours, theirs, ratio, cases = processor_time(make, bare[kind])
        cost[kind] = ours / cases
        work = f"a default chunk of {cases} cases stored: {names[kind]}"
        ratios.append(Ratio(work, "the bare ensemble", ours, theirs, ratio, 1.10, unit="CPU s"))
    few, many = (peak_memory(count) for count in (MILLION, HUNDRED_MILLION))
    work = "peak memory of 1e8 exact cases, moments and quantiles kept"
    ratios.append(Ratio(work, "that of 1e6", many, few, many / few, 1.3, unit="MB"))
    one, two = (workers(count) for count in (1, 2))
    work = "averaged days with two workers"
    ratios.append(Ratio(work, "one worker", two, one, one / two, 1.7, at_least=True))
    started = start()
    work = "from the shell to the first chunk stored, without Dask"
    ratios.append(Ratio(work, "a second", started, 1.0, started, 1.0))
    passed = scheduler()
    return Section("Sweeps", ratios, (billion(cost, passed),), notes(passed))


def processor_time(
    make: Callable[[int], kp.Sweep], bare: Callable[[np.random.Generator, int], None]
) -> tuple[float, float, float, int]:
    """Medians of both, and of their ratio, in s of processor time; and the cases of a chunk."""
    chunk = chunk_for(make(1 << 24))
    draw = np.random.default_rng(1)
    with folder() as path, kept_store(path, make(chunk), lambda: chunk) as store:
        rounds = []
        for _ in range(-1, ROUNDS):
            marks = [time.process_time()]
            do_chunk(str(store.path), 0)
            marks.append(time.process_time())
            bare(draw, chunk)
            marks.append(time.process_time())
            rounds.append(np.diff(marks))
    ours, theirs = np.array(rounds[1:]).T
    return (
        float(np.median(ours)),
        float(np.median(theirs)),
        statistics.median(ours / theirs),
        chunk,
    )


@contextmanager
def folder() -> Iterator[Path]:
    """Lend a folder that goes again."""
    with tempfile.TemporaryDirectory() as path:
        yield Path(path)


# Not ru_maxrss: Linux hands that of the process that started this one on to it.
_PEAK = """
import re, sys
from pathlib import Path
sys.path[:0] = [{here!r}]
import sweeps, kugelpendel as kp
kp.sweep(sweeps.exact({count}, ("moments", "quantiles")), {out!r})
print(re.search(r"VmHWM:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])
"""


def peak_memory(count: int) -> float:
    """MB of a process of its own that does so many exact cases."""
    with folder() as path:
        here = str(Path(__file__).parents[1])
        script = _PEAK.format(here=here, count=count, out=str(path))
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, check=True)
        return int(done.stdout) / 1e3


def workers(count: int) -> float:
    """s in which so many workers do the same averaged days, once they are there."""
    chunk = chunk_for(averaged(1 << 20))
    spec = averaged(24 * chunk, chunk=chunk)
    with local_workers(count) as client, folder() as path:
        kp.sweep(averaged(4, chunk=1), path / "warm", client)
        start = time.perf_counter()
        kp.sweep(spec, path / "timed", client)
        return time.perf_counter() - start


_FILE = """
[pendulum]
length = "1 m"
[launch]
kind = "ellipse"
a = { from = "1 cm", to = "10 cm", count = 4 }
b = 0
[sweep]
motion = "exact"
quantities = ["precession"]
chunk = 1
"""


def start() -> float:
    """s from the start of the command to the done mark of its first chunk: the median of five."""
    taken = []
    for _ in range(ROUNDS):
        with folder() as path:
            (path / "start.toml").write_text(_FILE, encoding="utf-8")
            mark = path / "out" / "sweep.zarr" / "done" / "c" / "0"
            command = ["sweep", str(path / "start.toml"), "--out", str(path / "out")]
            began = time.perf_counter()
            process = subprocess.Popen(
                [sys.executable, "-m", "kugelpendel", *command], stdout=subprocess.DEVNULL
            )
            while not mark.exists() and process.poll() is None:
                time.sleep(1e-3)
            taken.append(time.perf_counter() - began)
            process.wait()
    return statistics.median(taken)


def scheduler() -> float:
    """Chunks a second that a scheduler passes on, measured with chunks that do nothing."""
    with local_workers(2) as client:
        client.gather(client.map(os.path.basename, [str(k) for k in range(50)], pure=False))
        start = time.perf_counter()
        many = client.map(os.path.basename, [f"{k}" for k in range(4000)], pure=False)
        client.gather(many)
        return 4000 / (time.perf_counter() - start)


def billion(cost: dict[str, float], passed: float) -> Table:
    """What 1e9 cases take on paper, by the figures above."""
    rows = []
    for kind, name, quantities in (
        ("exact", "frequency and precession", 2),
        ("averaged", "azimuth after a day, averaged", 1),
        ("real", "azimuth after 100 swings, full equations", 1),
    ):
        seconds = cost[kind] * 1e9
        chunk = chunk_for({"exact": exact, "averaged": averaged, "real": real}[kind](1 << 24))
        rows.append(
            (
                name,
                f"{seconds / 3600:.3g} h",
                spell_bytes(8e9 * quantities),
                f"{-(-(10**9) // chunk)} of {duration(cost[kind] * chunk)}",
                f"{passed * cost[kind] * chunk:.2g}",
            )
        )
    head = ("1e9 cases", "one core", "all values", "chunks", "workers that a scheduler serves")
    return Table("What a billion takes on paper, from these figures:", head, rows)


def notes(passed: float) -> list[str]:
    return [
        "Processor time of one thread, Zarr and all; the bare ensemble draws the same numbers with "
        "NumPy and reads the same quantities. Results vary with the load of the machine.",
        f"A scheduler passes on {passed:.0f} chunks a second on this machine, where it shares the "
        "cores with its workers; with chunks of a second that many workers are its limit.",
        "Reductions take 13 kB for each chunk and quantity at most, whatever the count of cases.",
    ]
