"""Dask's workers as an engine: the same function for each chunk, some ahead of each worker."""

from __future__ import annotations

import logging
import os
import queue
import time
import warnings
from collections.abc import Generator, Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path
from typing import Any

from kugelpendel.errors import KugelpendelError, require_extra
from kugelpendel.sweeps._chunk import Done, do_chunk
from kugelpendel.sweeps._store import SweepStore, unwritable

AHEAD = 64
"""Chunks in flight for each worker at most."""

_ANSWER = 5.0
"""s in which a scheduler has to answer."""

_GRACE = 20.0
"""s after which workers that are gone are not waited for any longer."""

_LOOK = 0.1
"""s between two looks whether something was interrupted or lost."""

_THREADS = "RAYON_NUM_THREADS"
_ALIKE = ("kugelpendel", "numpy", "scipy", "zarr", "dask", "distributed")
"""Packages whose versions have to be the same here and at the workers."""


@contextmanager
def local_workers(count: int) -> Generator[Any]:
    """Lend a client of so many workers of this machine, each of them one process and one thread."""
    require_extra("cluster", "--workers")
    _quiet()
    distributed: Any = import_module("distributed")
    one = dict.fromkeys((_THREADS, "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a port is taken, and the like
        cluster = distributed.LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            env=one,
            silence_logs=logging.CRITICAL,
            memory_limit=0,
        )
        client = distributed.Client(cluster, set_as_default=False)
    try:
        yield client
    except KeyboardInterrupt:
        # The process ends, and its workers with it; to close them first takes seconds.
        raise
    except BaseException:
        _close(client, cluster)
        raise
    _close(client, cluster)


@contextmanager
def workers_of(address: str) -> Generator[Any]:
    """Lend a client of a scheduler's workers.

    Raises KugelpendelError where none answers at the address.
    """
    require_extra("cluster", "--scheduler")
    _quiet()
    distributed: Any = import_module("distributed")
    try:
        with warnings.catch_warnings():
            # Versions that differ are refused, in a sentence.
            warnings.simplefilter("ignore")
            client = distributed.Client(address, timeout=_ANSWER, set_as_default=False)
    except (OSError, TimeoutError, ValueError, TypeError) as error:
        raise KugelpendelError.of(
            "sweep_no_scheduler", address=address, patience=(_ANSWER, "s")
        ) from error
    try:
        yield client
    except KeyboardInterrupt:
        raise
    except BaseException:
        _close(client)
        raise
    _close(client)


def done_by(client: Any, store: SweepStore, missing: list[int]) -> Iterator[Done]:
    """Have the chunks done by a client's workers, and yield each when it is done.

    Raises
    ------
    KugelpendelError
        The workers are of other versions, have several threads or do not see the store; the
        scheduler or all workers vanish; a chunk kills its workers; the disk is full.
    """
    try:
        count = _checked_workers(client, store)
    except OSError as error:  # of the connection: workers that die are left out
        raise KugelpendelError.of(
            "sweep_scheduler_lost", address=_address(client), folder=str(store.path.parent)
        ) from error
    arrived: queue.SimpleQueue[Any] = queue.SimpleQueue()
    waiting = iter(missing)
    flying: set[Any] = set()

    def submit() -> None:
        for chunk in waiting:
            key = f"kugelpendel-{store.sweep.digest[:12]}-{chunk}"
            future = client.submit(do_chunk, str(store.path), chunk, key=key, pure=False)
            flying.add(future)
            future.add_done_callback(arrived.put)
            return

    with _dropped(flying):
        for _ in range(AHEAD * count):
            submit()
        without = 0.0
        while flying:
            try:
                future = arrived.get(timeout=_LOOK)
            except queue.Empty:
                without = _without_workers(client, store, without)
                continue
            without = 0.0
            done = _result(future, client, store)
            flying.discard(future)
            future.release()
            submit()
            yield done


def _checked_workers(client: Any, store: SweepStore) -> int:
    """How many workers there are; raises KugelpendelError where they cannot do it."""
    address = _address(client)
    try:
        client.wait_for_workers(1, timeout=_ANSWER)
    except TimeoutError as error:
        raise KugelpendelError.of("sweep_no_workers", address=address) from error
    workers = _workers(client)
    for worker in workers.values():
        if worker["nthreads"] != 1:
            raise KugelpendelError.of(
                "sweep_threads", address=address, count=float(worker["nthreads"])
            )
    versions = client.get_versions(packages=[*_ALIKE])
    ours: dict[str, Any] = versions["client"]["packages"]
    for worker in versions["workers"].values():
        for name in _ALIKE:
            theirs = worker["packages"].get(name)
            if theirs != ours.get(name):
                raise KugelpendelError.of(
                    "sweep_versions", package=name, ours=str(ours.get(name)), theirs=str(theirs)
                )
    digest = store.sweep.digest
    # A worker that dies while it is asked is replaced, or its chunks go to the others.
    if not all(client.run(prepared, str(store.path), digest, on_error="ignore").values()):
        raise KugelpendelError.of("sweep_not_shared", folder=str(store.path.parent))
    return len(workers)


def prepared(path: str, digest: str) -> bool:
    """Make the process of a worker ready for one thread, and say whether it sees the store."""
    os.environ.setdefault(_THREADS, "1")
    try:
        return SweepStore(Path(path)).sweep.digest == digest
    except KugelpendelError:
        return False


def _result(future: Any, client: Any, store: SweepStore) -> Done:
    """What a chunk has come to; raises KugelpendelError where it has failed."""
    under_way, without = ("finished", "pending", "lost"), 0.0
    while future.status in under_way:
        try:
            return future.result(timeout=_LOOK)
        except TimeoutError:  # it was with a worker that has died, and the chunk is done again
            without = _without_workers(client, store, without)
        except Exception:
            if future.status in under_way:  # else it is told below
                raise
    address, folder = _address(client), str(store.path.parent)
    if future.status != "error":  # "cancelled", though nobody has asked for it
        raise KugelpendelError.of("sweep_scheduler_lost", address=address, folder=folder)
    error = future.exception(timeout=_ANSWER)
    if isinstance(error, OSError):
        raise unwritable(store.path.parent, error)
    if type(error).__name__ == "KilledWorker":
        raise KugelpendelError.of("sweep_workers_killed", address=address, folder=folder)
    raise error


def _without_workers(client: Any, store: SweepStore, without: float) -> float:
    """Since when there have been no workers, or 0; raises KugelpendelError where that is long."""
    address, folder = _address(client), str(store.path.parent)
    if client.status not in ("running", "connecting"):
        raise KugelpendelError.of("sweep_scheduler_lost", address=address, folder=folder)
    if client.status == "running" and _workers(client):
        return 0.0
    now = time.monotonic()
    if without and now - without > _GRACE:
        kind = "sweep_workers_lost" if client.status == "running" else "sweep_scheduler_lost"
        raise KugelpendelError.of(kind, address=address, folder=folder)
    return without or now


def _workers(client: Any) -> dict[str, Any]:
    """What the scheduler knows of its workers, as of the last two seconds."""
    try:
        return client.scheduler_info(n_workers=-1)["workers"]
    except TypeError:  # versions before 2025.4 tell all of them
        return client.scheduler_info()["workers"]


def _address(client: Any) -> str:
    scheduler: Any = client.scheduler
    return str(scheduler.address) if scheduler is not None else "-"


@contextmanager
def _dropped(flying: set[Any]) -> Generator[None]:
    """Take back what is in flight when the block ends, without waiting for the scheduler."""
    try:
        yield
    finally:
        for future in flying:
            future.release()


def _close(*what: Any) -> None:
    """Close a client and its cluster, which may be gone."""
    for each in what:
        with suppress(Exception):
            each.close(timeout=2)


def _quiet() -> None:
    """Leave it to this package to say what is wrong."""
    # An interrupted process leaves semaphores, which are cleaned up, to a process that says so.
    os.environ.setdefault("PYTHONWARNINGS", "ignore::UserWarning:multiprocessing.resource_tracker")
    for name in ("distributed", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
