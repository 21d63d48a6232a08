"""Whatever ends the process, what is done stays done and nothing else counts as done."""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.sweeps.made import averaged, contents, exact

import kugelpendel as kp
from kugelpendel.sweeps import Listed, Spaced, SweepStore, _store
from kugelpendel.sweeps._store import kept_store

KILLS = 20


def store_of(folder: Path) -> SweepStore:
    return SweepStore(folder / "sweep.zarr")


def do(sweep: kp.Sweep, folder: Path) -> Any:
    return kp.sweep(sweep, folder)


@pytest.mark.parametrize("keep", [("all",), ("moments", "quantiles")])
def test_killed_at_any_moment(
    keep: Any, tmp_path: Path, same: Callable[[Path, Path], None]
) -> None:
    sweep = averaged(keep=keep, chunk=64 if keep != ("all",) else 8)
    whole, killed = tmp_path / "whole", tmp_path / "killed"
    started = time.monotonic()
    do(sweep, whole)
    taken = time.monotonic() - started
    draw = random.Random(len(keep))
    kills = finished = 0
    while kills < KILLS:
        with warnings.catch_warnings():
            # Python 3.12 and later warn of threads, which the child does not use.
            warnings.simplefilter("ignore", DeprecationWarning)
            child = os.fork()
        if child == 0:  # as new as a process of its own, but for the imports
            try:
                do(sweep, killed)
            finally:
                os._exit(0)
        time.sleep(draw.uniform(0.0, taken))
        os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        if not os.WIFSIGNALED(status):
            finished += 1
            assert finished < 60
            shutil.rmtree(killed)  # and once more from the beginning
            continue
        kills += 1
        if (killed / "sweep.zarr").exists():
            done = store_of(killed).done()
            status_codes = np.asarray(store_of(killed).array("status")[:])
            size = store_of(killed).chunk_size
            for chunk in np.flatnonzero(done):
                assert (status_codes[chunk * size : (chunk + 1) * size] > 0).all()
    do(sweep, killed)
    same(whole, killed)


def test_the_mask_says_what_is_missing(tmp_path: Path, same: Callable[[Path, Path], None]) -> None:
    """Marks of any chunks may be gone, in any order; a counter would not notice."""
    do(averaged(), tmp_path / "a")
    do(averaged(), tmp_path / "b")
    marks = tmp_path / "b" / "sweep.zarr" / "done" / "c"
    for chunk in (0, 11, 29):
        (marks / str(chunk)).unlink()
        for name in ("azimuth", "status"):
            shutil.rmtree(
                tmp_path / "b" / "sweep.zarr" / name / "c" / str(chunk), ignore_errors=True
            )
            (tmp_path / "b" / "sweep.zarr" / name / "c" / str(chunk)).unlink(missing_ok=True)
    assert store_of(tmp_path / "b").done().sum() == 27
    seen: list[tuple[int, int, int]] = []
    kp.sweep(averaged(), tmp_path / "b", progress=lambda *told: seen.append(told))
    assert seen == [(216, 240, 0), (224, 240, 0), (232, 240, 0), (240, 240, 0)]
    same(tmp_path / "a", tmp_path / "b")


def test_partial_files_are_cleaned(tmp_path: Path, same: Callable[[Path, Path], None]) -> None:
    do(averaged(), tmp_path / "a")
    do(averaged(), tmp_path / "b")
    left = tmp_path / "b" / "sweep.zarr" / "azimuth" / "c" / f"3.{'0' * 32}.partial"
    left.write_bytes(b"half")
    hidden = tmp_path / "b" / ".sweep.zarr-0123456789ab"
    hidden.mkdir()
    do(averaged(), tmp_path / "b")
    assert not left.exists()
    assert not hidden.exists()
    same(tmp_path / "a", tmp_path / "b")


def test_a_finished_sweep_is_not_done_again(tmp_path: Path) -> None:
    do(averaged(), tmp_path)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*") if path.is_file()}
    found = do(averaged(), tmp_path)
    assert {
        path: path.stat().st_mtime_ns for path in tmp_path.rglob("*") if path.is_file()
    } == before
    assert found.status.attrs["counts"] == [0, 240, 0, 0]


def test_another_sweep_is_refused(tmp_path: Path) -> None:
    do(averaged(), tmp_path)
    before = contents(tmp_path)
    with pytest.raises(kp.InvalidInput) as raised:
        do(averaged(times=(600.0, 3601.0)), tmp_path)
    assert str(raised.value) == (
        f"{tmp_path} holds another sweep, which differs in times; choose another folder, or move "
        "that one away."
    )
    with pytest.raises(kp.InvalidInput, match=r"differs in \[launch\] a, \[suspension\] "):
        do(exact(10), tmp_path)
    for name, values in contents(tmp_path).items():
        assert np.array_equal(values, before[name], equal_nan=True)


def test_a_store_keeps_its_own_chunks(tmp_path: Path) -> None:
    do(averaged(), tmp_path)
    do(averaged(chunk=64), tmp_path)
    assert store_of(tmp_path).chunk_size == 8


def test_two_at_once_are_refused(tmp_path: Path, repository: Path) -> None:
    with kept_store(tmp_path, averaged(), lambda: 8):
        # A lock of this process would not stop itself: another one asks.
        asked = subprocess.run(
            [sys.executable, "-c", _ASKS, str(tmp_path)],
            capture_output=True, text=True, check=True, cwd=repository,
        )  # fmt: skip
    assert asked.stdout.strip() == (
        f"Another process is doing the sweep in {tmp_path}; wait for it, or choose another folder."
    )
    do(averaged(), tmp_path)


_ASKS = """
import sys
import kugelpendel as kp
from tests.sweeps.made import averaged
try:
    kp.sweep(averaged(), sys.argv[1])
except kp.InvalidInput as error:
    print(error)
"""


def test_a_full_disk_is_a_sentence_and_resumable(
    tmp_path: Path, repository: Path, same: Callable[[Path, Path], None]
) -> None:
    do(averaged(chunk=64), tmp_path / "whole")
    done = subprocess.run(
        [sys.executable, "-c", _FULL, str(tmp_path / "full")],
        capture_output=True, text=True, check=True, cwd=repository,
    )  # fmt: skip
    assert done.stdout.strip() == (
        f"{tmp_path}/full takes no more: File too large. What is done is kept: make room, and the "
        "same call goes on."
    ), done.stderr
    assert not store_of(tmp_path / "full").done().all()
    do(averaged(chunk=64), tmp_path / "full")
    same(tmp_path / "whole", tmp_path / "full")


_FULL = """
import resource, signal, sys
import kugelpendel as kp
from tests.sweeps.made import averaged
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
def limit(done, *others):
    if done:  # after the first chunk no file may have a hundred bytes
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, resource.RLIM_INFINITY))
try:
    kp.sweep(averaged(chunk=64), sys.argv[1], progress=limit)
except kp.KugelpendelError as error:
    print(error)
"""


def test_no_room_is_said_before_anything_is_made(tmp_path: Path) -> None:
    given = {
        "pendulum": {"length": Spaced(1.0, 2.0, 100_000)},
        "launch": {"kind": "ellipse", "a": Spaced(0.1, 0.2, 100_000), "b": Listed((0.0,))},
    }
    times = tuple(np.arange(1000.0))
    sweep = kp.Sweep(given, "grid", "exact", ("azimuth",), times)
    with pytest.raises(
        kp.InvalidInput, match=r"^The 1e\+10 cases of this sweep take up to 8e\+04 GB"
    ):
        do(sweep, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(kp.KugelpendelError, match=r"file/out cannot be written: Not a directory\."):
        do(averaged(), tmp_path / "file" / "out")


def test_what_is_no_store(tmp_path: Path) -> None:
    (tmp_path / "sweep.zarr").mkdir()
    for call in (lambda: do(averaged(), tmp_path), lambda: kp.sweeps.read(tmp_path)):
        with pytest.raises(kp.InvalidInput, match=r"there is no sweep of this package; "):
            call()


def test_other_versions_do_not_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    do(averaged(), tmp_path)
    monkeypatch.setattr(_store, "_versions", lambda: {"kugelpendel": "0.0.1"})
    do(averaged(), tmp_path)  # all is done
    (tmp_path / "sweep.zarr" / "done" / "c" / "4").unlink()
    with pytest.raises(
        kp.InvalidInput, match=r"was begun with kugelpendel 0\.1\.0, and this is 0\."
    ):
        do(averaged(), tmp_path)
