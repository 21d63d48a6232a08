"""Spoilt files through the command line, in one process: an answer, a sentence, nothing else."""

import contextlib
import io
import json
import math
import os
import random
import shutil
import signal
import tempfile
import traceback
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from tests.fuzz.mutate import bases, mutated

from kugelpendel.cli import main

PATIENCE = 20.0
"""s of the processor: who has heard nothing of how long it takes has waited long enough."""

STANDSTILL = 15
"""Times as long on the clock, in which even the busiest machine gets something done."""

KEPT = "what was here before"


class TooLong(BaseException):
    """Raised into a call that lasts longer than `PATIENCE`."""


def files(count: int, seed: int) -> Iterator[tuple[str, bytes]]:
    """Commands and spoilt files, the same for the same seed."""
    chance = random.Random(seed)
    texts = {command: bases(command) for command in ("run", "design")}
    for _ in range(count):
        command = "run" if chance.random() < 0.8 else "design"
        yield command, mutated(chance.choice(texts[command]), chance)


def fault(command: str, data: bytes, *options: str) -> str | None:
    """What is wrong with how a file was dealt with, or None."""
    folder = Path(tempfile.mkdtemp(prefix="fuzz-"))
    try:
        return _fault(folder, command, data, options)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _fault(folder: Path, command: str, data: bytes, options: tuple[str, ...]) -> str | None:
    file, out = folder / "job.toml", folder / "out"
    file.write_bytes(data)
    more = ("--formulas",) if command == "design" else ()
    arguments = [command, os.fspath(file), "--out", os.fspath(out), "--json", *more, *options]
    printed, said = io.StringIO(), io.StringIO()
    try:
        with (
            contextlib.redirect_stdout(printed),
            contextlib.redirect_stderr(said),
            warnings.catch_warnings(),
            patience(PATIENCE),
        ):
            warnings.simplefilter("ignore")
            code = main(arguments)
    except TooLong:
        return (
            None if said.getvalue().strip() else f"no estimate within {PATIENCE:g} s of processor"
        )
    except SystemExit as leave:
        code = leave.code
    except BaseException:  # noqa: BLE001 — any of them is what is looked for
        return traceback.format_exc()
    return verdict(code, printed.getvalue(), said.getvalue(), out)


def verdict(code: Any, printed: str, said: str, out: Path) -> str | None:
    """What is wrong with an exit code, what was printed, and what lies in the output folder."""
    if "Traceback" in said or "Traceback" in printed:
        return f"a traceback was printed:\n{said}"
    left = sorted(path.name for path in out.iterdir()) if out.is_dir() else []
    hidden = [path.name for path in out.parent.glob(".kugelpendel*")]
    if hidden or any(name.startswith(".kugelpendel-") for name in left):
        return f"left behind: {hidden or left}"
    if code == 2:
        if not said.strip():
            return "exit code 2 without a sentence"
        return f"exit code 2, but files: {left}" if left else None
    if code != 0:
        return f"exit code {code}: {said}"
    try:
        results = json.loads(printed, parse_constant=_refuse)
    except ValueError as error:
        return f"what was printed is no JSON: {error}"
    if "results.json" not in left and "design.json" not in left:
        return f"exit code 0, but only {left}"
    return _nan(results)


def _refuse(name: str) -> float:
    raise ValueError(f"it holds {name}")


def _nan(value: Any, where: str = "") -> str | None:
    if isinstance(value, dict):
        found = (_nan(item, f"{where}.{key}") for key, item in value.items())
        return next((one for one in found if one), None)
    if isinstance(value, list):
        return next((one for item in value if (one := _nan(item, where))), None)
    bad = isinstance(value, float) and not math.isfinite(value)
    return f"{where} is {value}" if bad else None


@contextlib.contextmanager
def patience(seconds: float) -> Iterator[None]:
    """Raise `TooLong` into a block that takes more processor time, or stands still for long.

    Processor time does not count what else a busy machine does.
    """

    def wake(number: int, frame: object) -> None:
        raise TooLong

    clocks = {
        signal.ITIMER_PROF: (signal.SIGPROF, seconds),
        signal.ITIMER_REAL: (signal.SIGALRM, STANDSTILL * seconds),
    }
    before = {number: signal.signal(number, wake) for number, _ in clocks.values()}
    for clock, (_, limit) in clocks.items():
        signal.setitimer(clock, limit)
    try:
        yield
    finally:
        for clock in clocks:
            signal.setitimer(clock, 0)
        for number, handler in before.items():
            signal.signal(number, handler)


def all_faults(count: int, seed: int, tick: Callable[[], None]) -> list[tuple[str, bytes, str]]:
    """Every file that was dealt with wrongly, and how."""
    found: list[tuple[str, bytes, str]] = []
    for command, data in files(count, seed):
        if (wrong := fault(command, data)) is not None:
            found.append((command, data, wrong))
        tick()
    return found
