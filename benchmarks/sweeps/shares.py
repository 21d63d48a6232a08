"""Where the time of ensembles goes, by the core's files: ``python -m sweeps.shares`` in benchmarks.

The core is built once more with line tables, `perf` takes samples of one thread, and addr2line
says to which file each belongs: the first one, from the innermost call outwards, that is not among
the numbers which all of them reckon with.
"""

from __future__ import annotations

import collections
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from report import grid

ROOT = Path(__file__).parents[2]
SOURCES = "crates/kugelpendel/src/"
SECONDS = 4.0
LEAST = 0.02
"""Smaller shares are put together."""

# The core with line tables takes the place of the installed one; the ensembles are those of sweeps.
_WORK = """
import importlib.util, json, sys, time, warnings
spec = importlib.util.spec_from_file_location("kugelpendel._core", {core!r})
sys.modules["kugelpendel._core"] = core = importlib.util.module_from_spec(spec)
spec.loader.exec_module(core)
sys.path[:0] = [{here!r}]
import numpy as np
import sweeps
draw, runs = np.random.default_rng(1), 0
warnings.simplefilter("ignore")
began = time.perf_counter()
while (taken := time.perf_counter() - began) < {seconds}:
    {work}
    runs += 1
print(json.dumps(taken / runs))
"""

WORKS = {
    "ω and Ω of random launches": ("sweeps.bare_exact(draw, 1 << 17)", 1 << 17),
    "a day, averaged, in random clamps": (
        "sweeps.bare_forced(draw, 4096, sweeps.kp.EnvelopeMotion, sweeps.DAY)",
        4096,
    ),
    "100 swings, full equations": (
        "sweeps.bare_forced(draw, 512, sweeps.kp.RealMotion, 1642.0)",
        512,
    ),
}


def main() -> int:
    for tool in ("perf", "addr2line", "readelf"):
        if shutil.which(tool) is None:
            print(f"{tool} is needed and is not on the PATH", file=sys.stderr)
            return 2
    core = build()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "_core.abi3.so"
        shutil.copy(core, copy)
        for name, (work, cases) in WORKS.items():
            seconds, shares = sampled(copy, work, Path(folder) / "perf.data")
            caption = f"{name}, {seconds / cases * 1e6:.3g} µs a case on one thread:"
            print(caption, table(shares), sep="\n\n", end="\n\n", flush=True)
    return 0


def build() -> Path:
    """The core as it is released, with line tables."""
    environment = {**os.environ, "CARGO_PROFILE_RELEASE_DEBUG": "line-tables-only"}
    command = ["cargo", "build", "--release", "--locked", "--package", "kugelpendel-python"]
    subprocess.run([*command, "--quiet"], cwd=ROOT, env=environment, check=True)
    return ROOT / "target" / "release" / "lib_core.so"


def sampled(core: Path, work: str, data: Path) -> tuple[float, collections.Counter[str]]:
    """Seconds of one run, and the samples of each source file or library."""
    here = str(Path(__file__).parents[1])
    script = _WORK.format(core=str(core), here=here, seconds=SECONDS, work=work)
    record = ["perf", "record", "--quiet", "--output", str(data), sys.executable, "-c", script]
    seconds = json.loads(told_by(*record, RAYON_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1"))
    fields = ["--show-mmap-events", "--fields", "ip,sym,dso,event"]
    events = told_by("perf", "script", "--input", str(data), *fields)
    inside: collections.Counter[int] = collections.Counter()
    shares: collections.Counter[str] = collections.Counter()
    shift = 0
    for line in events.splitlines():
        if "MMAP2" in line:
            found = re.search(r"\[0x([0-9a-f]+)\(.*@ (?:0x)?([0-9a-f]+) .*r-xp (.*)", line)
            if found and found[3] == str(core):
                shift = address_of(core, int(found[2], 16)) - int(found[1], 16)
        elif found := re.search(r"\s([0-9a-f]+) (.*) \((.*)\)$", line):
            if found[3] == str(core):
                inside[int(found[1], 16) + shift] += 1
            elif library := of_library(found[3]):
                shares[library] += 1
    for address, file in files(core, inside).items():
        shares[file] += inside[address]
    return seconds, shares


def of_library(library: str) -> str | None:
    """What the core calls in the C library; the rest is Python's."""
    if "libm.so" in library:
        return "sines, logarithms and the like of the C library"
    if "libc.so" in library:
        return "memory: copied, filled, handed out"
    return None


def address_of(core: Path, offset: int) -> int:
    """Where a place of the file's code lies when it is loaded at zero."""
    segments = told_by("readelf", "--program-headers", "--wide", str(core))
    code = re.search(r"LOAD\s+0x(\w+) 0x(\w+) .* R E ", segments)
    if code is None:
        raise SystemExit(f"readelf finds no code in {core}")
    start, address = (int(number, 16) for number in code.groups())
    return address + offset - start


def files(core: Path, addresses: collections.Counter[int]) -> dict[int, str]:
    """The source file that each address is put down to."""
    command = ["addr2line", "--exe", str(core), "--inlines", "--addresses"]
    told = told_by(*command, *map(hex, addresses))
    found: dict[int, str] = {}
    for block in re.split(r"^(?=0x)", told, flags=re.MULTILINE)[1:]:
        address, *lines = block.splitlines()
        names = [line.split(SOURCES)[1].split(":")[0] for line in lines if SOURCES in line]
        own = [name for name in names if not name.startswith("numbers/")]
        found[int(address, 16)] = (own or names or ["Python's side of the core"])[0]
    return found


def table(shares: collections.Counter[str]) -> str:
    """The large shares, the largest first, and the rest together."""
    total = sum(shares.values())
    large = {file: count for file, count in shares.most_common() if count > LEAST * total}
    rows = {**large, "all others": total - sum(large.values())}
    cells = [(file, f"{count / total:.0%}") for file, count in rows.items()]
    return grid(("file, or what", "share"), cells)


def told_by(*command: str, **environment: str) -> str:
    """What a command prints; it raises CalledProcessError where it fails."""
    around = {**os.environ, **environment}
    done = subprocess.run(command, env=around, capture_output=True, text=True, check=True)
    return done.stdout


if __name__ == "__main__":
    sys.exit(main())
