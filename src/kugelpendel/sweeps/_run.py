"""`kugelpendel.sweep`: all cases of a sweep, here or on other machines, into a store."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from kugelpendel.parameters import require_type, wrong_type
from kugelpendel.sweeps._chunk import Done, chunk_for, do_chunk
from kugelpendel.sweeps._store import GOOD, REFUSED, SweepStore, kept_store, writing
from kugelpendel.sweeps.cases import Sweep

if TYPE_CHECKING:
    import xarray as xr

Progressed: TypeAlias = Callable[[int, int, int], object]
"""Told after each chunk: the cases that are done, of how many, and the bad ones among them."""


def sweep(
    spec: Sweep,
    out: str | Path,
    client: Any = None,
    *,
    progress: Progressed | None = None,
) -> xr.Dataset:
    """Do a sweep, or what is missing of it, and give what it has come to.

    Parameters
    ----------
    spec
        What varies, and what is read.
    out
        The folder, made where it is not there; the store in it is ``sweep.zarr``.
    client
        A ``distributed.Client``, whose workers then do the chunks, one core each; they have to see
        the folder under the same name. Without one, this process does them with all its threads.
    progress
        Called after each chunk with the cases that are done, all cases, and the bad ones.

    Returns
    -------
    Dataset
        Read from the store where it is looked at. A grid has a dimension for each number that
        varies; other designs have the dimension "case", and what varies as coordinates along it.
        Beside the quantities there is ``status``: 1 for good, 2 for refused, 3 for ended early, 0
        for not yet. With reductions kept, ``azimuth_mean`` and the like in place of ``azimuth``.

    Raises
    ------
    InvalidInput
        The folder holds another sweep, or one that another process is doing; or there is no room.
    KugelpendelError
        The disk is full, or no worker is left; what is done is kept, and the same call goes on.
    MissingExtra
        Without Zarr and xarray, which the extra [sweep] brings.

    Notes
    -----
    Interrupted or killed at any moment, the same call goes on, and the result is the same to the
    last bit as that of an uninterrupted one, by whichever engine, on processors of one kind.
    """
    require_type("The sweep", spec, Sweep)
    path = _folder(out)
    if client is not None and not hasattr(client, "submit"):
        raise wrong_type("client", client, "distributed.Client", "leave it out")
    if progress is not None and not callable(progress):
        way_out = "write progress=lambda done, cases, bad: …"
        raise wrong_type("progress", progress, "function of three numbers", way_out)
    from kugelpendel.sweeps._dataset import dataset_of

    with kept_store(path, spec, lambda: chunk_for(spec)) as store:
        for _ in progressed(store, client, progress):
            pass
    return dataset_of(store)


def _folder(out: object) -> Path:
    """The folder as a path from the root, which workers elsewhere need."""
    if isinstance(out, (str, Path)) and str(out):
        return Path(out).absolute()
    raise wrong_type("out", out, "name of a folder", 'write out="out/sweep"')


def progressed(
    store: SweepStore, client: Any = None, progress: Progressed | None = None
) -> Iterator[Done]:
    """Do the chunks that a store lacks, and yield each that is done.

    Raises KugelpendelError as `sweep` does.
    """
    missing = np.flatnonzero(~store.done()).tolist()
    if not missing:
        return
    counts = store.counts()
    done, bad = int(counts[GOOD:].sum()), int(counts[REFUSED:].sum())
    if progress is not None:
        progress(done, store.sweep.size, bad)
    path = str(store.path)
    for chunk in _here(path, missing, store) if client is None else _there(client, store, missing):
        done, bad = done + chunk.cases, bad + chunk.bad
        if progress is not None:
            progress(done, store.sweep.size, bad)
        yield chunk


def _here(path: str, missing: Iterable[int], store: SweepStore) -> Iterator[Done]:
    for chunk in missing:
        with writing(store.path.parent):
            done = do_chunk(path, chunk)
        yield done


def _there(client: Any, store: SweepStore, missing: list[int]) -> Iterator[Done]:
    from kugelpendel.sweeps._cluster import done_by

    return done_by(client, store, missing)
