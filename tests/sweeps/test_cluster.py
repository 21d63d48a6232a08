"""Dask's workers do the same, to the last bit, and what they lose is a sentence and resumable."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import pytest
from tests.sweeps.made import averaged, exact

import kugelpendel as kp
from kugelpendel.errors import KugelpendelError
from kugelpendel.sweeps import SweepStore, _cluster, kept_store
from kugelpendel.sweeps._cluster import local_workers, workers_of

Same = Callable[[Path, Path], None]

STARTS = 120.0
"""s in which a worker has started, and one that has died is missed, however busy the machine is."""


@pytest.fixture(scope="module")
def client() -> Generator[Any]:
    """Two workers."""
    with local_workers(2) as client:
        yield client


def pids(client: Any) -> list[int]:
    return sorted(client.run(os.getpid).values())


@pytest.mark.parametrize(
    "sweep",
    [averaged(), averaged(keep=("moments", "histograms"), chunk=64), exact(3000, chunk=256)],
    ids=["all", "reduced", "exact"],
)
def test_the_same_bits(client: Any, sweep: kp.Sweep, tmp_path: Path, same: Same) -> None:
    here = kp.sweep(sweep, tmp_path / "here")
    there = kp.sweep(sweep, tmp_path / "there", client)
    assert there.identical(here)
    same(tmp_path / "here", tmp_path / "there")


def test_a_worker_has_one_thread_of_the_core(client: Any) -> None:
    for number in client.run(lambda: os.environ["RAYON_NUM_THREADS"]).values():
        assert number == "1"
    assert {worker["nthreads"] for worker in _cluster._workers(client).values()} == {1}


def test_killed_workers_are_replaced(client: Any, tmp_path: Path, same: Same) -> None:
    sweep = averaged()
    kp.sweep(sweep, tmp_path / "here")
    killed: list[int] = []

    def kill(done: int, size: int, bad: int) -> None:
        if done in (0, 40, 120) and (alive := _living(client)):
            os.kill(alive[0], signal.SIGKILL)
            killed.append(alive[0])

    kp.sweep(sweep, tmp_path / "there", client, progress=kill)
    assert killed
    same(tmp_path / "here", tmp_path / "there")


def test_a_worker_that_dies_when_it_is_asked(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, same: Same
) -> None:
    kp.sweep(averaged(), tmp_path / "here")
    monkeypatch.setattr(_cluster, "prepared", _dies_once)
    kp.sweep(averaged(), tmp_path / "there", client)
    (tmp_path / "there" / "dead").unlink()
    same(tmp_path / "here", tmp_path / "there")


def _dies_once(path: str, digest: str) -> bool:
    try:
        (Path(path).parent / "dead").touch(exist_ok=False)
    except FileExistsError:
        return True
    os.kill(os.getpid(), signal.SIGKILL)
    return False


def _living(client: Any) -> list[int]:
    """Processes of the workers, without asking those that may have died."""
    return [nanny.pid for nanny in client.cluster.workers.values() if nanny.pid is not None]


def test_nothing_is_asked_of_more_workers_than_there_is(client: Any, tmp_path: Path) -> None:
    assert kp.sweep(averaged(chunk=256), tmp_path, client).status.attrs["counts"][1] == 240


def test_an_error_of_a_chunk_comes_back(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_cluster, "do_chunk", _breaks)
    with pytest.raises(KugelpendelError, match=r"takes no more: No space left on device\. What"):
        kp.sweep(averaged(), tmp_path, client)


def _breaks(path: str, chunk: int) -> None:
    raise OSError(28, os.strerror(28))


def test_a_connection_that_breaks_is_no_full_disk(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object, **__: object) -> None:
        raise ConnectionResetError("Stream is closed")

    monkeypatch.setattr(type(client), "get_versions", broken)
    with pytest.raises(KugelpendelError, match=r"^The Dask scheduler at .* has vanished\."):
        kp.sweep(averaged(), tmp_path, client)


def test_other_versions_are_refused(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = client.get_versions(packages=[*_cluster._ALIKE])
    next(iter(told["workers"].values()))["packages"]["kugelpendel"] = "0.0.1"
    monkeypatch.setattr(type(client), "get_versions", lambda *_, **__: told)
    with pytest.raises(KugelpendelError) as raised:
        kp.sweep(averaged(), tmp_path, client)
    assert str(raised.value) == (
        "The workers have kugelpendel 0.0.1, and this process has 0.1.0, whose bits may differ; "
        "install the same version on both sides."
    )


def test_a_folder_that_workers_do_not_see(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_cluster, "prepared", _sees_nothing)
    with pytest.raises(KugelpendelError, match=r"^The workers do not see .*; take a folder that"):
        kp.sweep(averaged(), tmp_path, client)


def _sees_nothing(path: str, digest: str) -> bool:
    return False


def test_a_scheduler_that_does_not_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_cluster, "_ANSWER", 0.5)
    for address in ("tcp://127.0.0.1:1", "nonsense"):
        with pytest.raises(KugelpendelError) as raised, workers_of(address):
            pass
        assert str(raised.value).startswith(
            f"No Dask scheduler answers at {address} within 0.5 s; start one with"
        )


def started(*arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_scheduler" if arguments[0] == "scheduler"
         else "distributed.cli.dask_worker", *arguments[1:]],
        stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
    )  # fmt: skip


@pytest.fixture
def scheduler() -> Generator[tuple[subprocess.Popen[str], str]]:
    """A scheduler of its own process, and its address."""
    process = started("scheduler", "--port", "0", "--no-dashboard", "--host", "127.0.0.1")
    assert process.stderr is not None
    address = ""
    for line in process.stderr:
        if "Scheduler at:" in line:
            address = line.split()[-1]
            break
    reader = threading.Thread(target=process.stderr.read, daemon=True)
    reader.start()
    try:
        yield process, address
    finally:
        process.kill()
        process.wait()
        reader.join()
        process.stderr.close()


def test_a_scheduler_without_workers_then_with_one_of_two_threads_then_gone(
    scheduler: tuple[subprocess.Popen[str], str],
    tmp_path: Path,
    same: Same,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    process, address = scheduler
    monkeypatch.setattr(_cluster, "_GRACE", 2.0)
    kp.sweep(averaged(), tmp_path / "here")
    workers: list[subprocess.Popen[str]] = []
    try:
        with workers_of(address) as client:
            monkeypatch.setattr(_cluster, "_ANSWER", 0.5)
            with pytest.raises(KugelpendelError, match=r"has no workers; start some with `dask w"):
                kp.sweep(averaged(), tmp_path / "there", client)
            monkeypatch.setattr(_cluster, "_ANSWER", STARTS)
            workers.append(_worker(address, "2"))
            with pytest.raises(KugelpendelError, match=r"has 2 threads, and a sweep takes worker"):
                kp.sweep(averaged(), tmp_path / "there", client)
            _end(workers)
            _wait(lambda: not _cluster._workers(client))
            workers.append(_worker(address, "1"))

            def vanish(done: int, size: int, bad: int) -> None:
                if done:
                    process.kill()
                    process.wait()

            with pytest.raises(KugelpendelError) as raised:
                kp.sweep(averaged(), tmp_path / "there", client, progress=vanish)
    finally:
        _end(workers)
    assert str(raised.value) == (
        f"The Dask scheduler at {address} has vanished. What is done is kept in "
        f"{tmp_path / 'there'}: start it again, and the same call goes on."
    )
    assert SweepStore(tmp_path / "there" / "sweep.zarr").done().any()
    kp.sweep(averaged(), tmp_path / "there")
    same(tmp_path / "here", tmp_path / "there")


@pytest.fixture
def last_worker(
    scheduler: tuple[subprocess.Popen[str], str], monkeypatch: pytest.MonkeyPatch
) -> Generator[tuple[str, Callable[[], None]]]:
    """The address of a scheduler with one worker, and what ends that worker."""
    _, address = scheduler
    monkeypatch.setattr(_cluster, "_GRACE", 1.0)
    monkeypatch.setattr(_cluster, "_ANSWER", STARTS)
    workers = [_worker(address, "1")]
    yield address, lambda: _end(workers)
    _end(workers)


def test_all_workers_gone(last_worker: tuple[str, Callable[[], None]], tmp_path: Path) -> None:
    address, end = last_worker

    def progress(done: int, size: int, bad: int) -> None:
        if done:
            end()

    with workers_of(address) as client, pytest.raises(KugelpendelError) as raised:
        kp.sweep(averaged(), tmp_path, client, progress=progress)
    assert str(raised.value).startswith(f"All workers of the scheduler at {address} have vanished")


def test_a_result_that_was_with_the_last_worker(
    last_worker: tuple[str, Callable[[], None]], tmp_path: Path
) -> None:
    address, end = last_worker
    with workers_of(address) as client, kept_store(tmp_path, averaged(), lambda: 2) as store:
        future = client.submit(_cluster.do_chunk, str(store.path), 0, pure=False)
        _wait(lambda: future.status == "finished")
        end()
        with pytest.raises(KugelpendelError, match="have vanished"):
            _cluster._result(future, client, store)


def _worker(address: str, threads: str) -> subprocess.Popen[str]:
    process = started("worker", address, "--nthreads", threads, "--no-nanny", "--no-dashboard")
    threading.Thread(target=process.communicate, daemon=True).start()
    return process


def _end(workers: list[subprocess.Popen[str]]) -> None:
    while workers:
        worker = workers.pop()
        worker.kill()
        worker.wait()


def _wait(until: Callable[[], bool]) -> None:
    deadline = time.monotonic() + STARTS
    while not until():
        assert time.monotonic() < deadline
        time.sleep(0.05)
