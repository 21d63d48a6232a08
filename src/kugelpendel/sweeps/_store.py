"""The Zarr store of a sweep: what is done stays done, whatever ends the process that does it.

A chunk writes its values, then its status codes and their counts, then its done mark. Zarr writes a
file beside its place and renames it, so that each of them is there whole or not at all; what counts
as done is only what has its mark. Nothing is written by xarray, whose writes into regions are not
safe for several writers.
"""

from __future__ import annotations

import errno
import json
import os
import secrets
import shutil
from collections.abc import Callable, Generator, Mapping
from contextlib import ExitStack, contextmanager
from functools import cached_property, lru_cache
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import InvalidInput, KugelpendelError, require_extra
from kugelpendel.parameters import Numbers
from kugelpendel.sweeps._lock import locked
from kugelpendel.sweeps._reductions import BINS, FIELDS
from kugelpendel.sweeps.cases import Sweep, bytes_kept, where

NAME = "sweep.zarr"
"""The store, in the folder of a sweep."""

STATUS = ("not yet", "good", "refused", "ended early")
"""The status of a case by its code."""

NOT_YET, GOOD, REFUSED, ENDED = range(4)

_PARTIAL = ".partial"
_FORMAT = 1
_PACKAGES = ("kugelpendel", "numpy", "scipy")
"""Whose versions the bits of the results may depend on."""


class SweepStore:
    """The store of one sweep, opened.

    Parameters
    ----------
    path
        The folder of the store itself.

    Raises
    ------
    InvalidInput
        There is no store of this package there.
    """

    def __init__(self, path: Path):
        self.path = path
        self._arrays: dict[str, Any] = {}
        try:
            noted = json.loads((path / "zarr.json").read_text(encoding="utf-8"))["attributes"]
            about = noted["kugelpendel"]
            self.sweep = Sweep.from_json(about["sweep"])
            self.chunk_size = int(about["chunk"])
            self.versions: dict[str, str] = about["versions"]
        except (OSError, ValueError, LookupError, TypeError) as error:
            raise InvalidInput.of("sweep_no_store", folder=str(path)) from error

    @cached_property
    def group(self) -> Any:
        """The Zarr group."""
        zarr = _zarr()
        return zarr.open_group(store=zarr.storage.LocalStore(self.path), mode="r+")

    def array(self, name: str) -> Any:
        """One of its arrays."""
        if name not in self._arrays:
            # Zarr would look through each chunk for a reason to leave it out.
            self._arrays[name] = self.group[name].with_config({"write_empty_chunks": True})
        return self._arrays[name]

    @property
    def chunks(self) -> int:
        """How many chunks there are; the last may be smaller than the others."""
        return -(-self.sweep.size // self.chunk_size)

    def bounds(self, chunk: int) -> tuple[int, int]:
        """The first case of a chunk, and the one after its last."""
        size = self.chunk_size
        return chunk * size, min((chunk + 1) * size, self.sweep.size)

    def done(self) -> NDArray[np.bool_]:
        """Which chunks are done: those that have their mark."""
        mask = np.zeros(self.chunks, dtype=bool)
        marks = self.path / "done" / "c"
        if marks.is_dir():
            with os.scandir(marks) as found:
                done = [int(mark.name) for mark in found if mark.name.isdigit()]
            mask[[k for k in done if k < len(mask)]] = True
        return mask

    def write(
        self,
        chunk: int,
        values: Mapping[str, Numbers],
        reduced: Mapping[str, NDArray[Any]],
        status: NDArray[np.uint8],
    ) -> None:
        """Write a chunk: values by case and reductions by their names, status, then the mark."""
        start, stop = self.bounds(chunk)
        for name, numbers in values.items():
            self.array(name)[start:stop] = numbers
        for name, numbers in reduced.items():
            self.array(name)[chunk : chunk + 1] = numbers[np.newaxis]
        self.array("status")[start:stop] = status
        counts = np.bincount(status, minlength=len(STATUS)).astype(np.int64)
        self.array("counts")[chunk : chunk + 1] = counts[np.newaxis]
        self.array("done")[chunk : chunk + 1] = np.ones(1, dtype=np.uint8)

    def counts(self) -> NDArray[np.int64]:
        """How many cases have each status."""
        found: NDArray[np.int64] = np.asarray(self.array("counts")[:])[self.done()]
        total = found.sum(axis=0)
        total[NOT_YET] = self.sweep.size - total.sum()
        return total

    def bad(self, most: int | None = None) -> NDArray[np.int64]:
        """The indices of bad cases, in order: the first so many, or all."""
        by_chunk = np.asarray(self.array("counts")[:])
        indices: list[NDArray[np.int64]] = []
        count = 0
        for chunk in np.flatnonzero(by_chunk[:, REFUSED:].sum(axis=1) > 0):
            start, stop = self.bounds(int(chunk))
            bad = np.flatnonzero(np.asarray(self.array("status")[start:stop]) >= REFUSED)
            indices.append(bad + start)
            count += bad.size
            if most is not None and count >= most:
                break
        return np.concatenate([np.empty(0, np.int64), *indices])[:most]

    def clean(self) -> None:
        """Remove what killed processes have left half-written."""
        for folder, _, files in os.walk(self.path):
            for file in files:
                if file.endswith(_PARTIAL):
                    (Path(folder) / file).unlink(missing_ok=True)


@contextmanager
def kept_store(folder: Path, sweep: Sweep, chunk: Callable[[], int]) -> Generator[SweepStore]:
    """Lend the store of a sweep in a folder, made or continued, that nobody else may write to.

    Parameters
    ----------
    folder
        Of the sweep; made where it is not there.
    sweep
        What it is to hold.
    chunk
        Says how many cases a chunk of a new store has.

    Raises
    ------
    InvalidInput
        A living process writes there; the store is of another sweep, or was begun with other
        versions; something else bears its name; or there is no room.
    KugelpendelError
        The disk is full or refuses; what is done is kept.
    """
    require_extra("sweep", "kugelpendel.sweep", "scipy", "xarray", "zarr")
    path = folder / NAME
    with ExitStack() as held:
        with writing(folder):
            held.enter_context(locked(folder))
            for left in folder.glob(f".{NAME}-*"):
                shutil.rmtree(left, ignore_errors=True)
            if path.exists():
                store = _continued(path, sweep)
            else:
                _refuse_without_room(folder, sweep)
                _create(path, sweep, chunk())
                store = SweepStore(path)
            store.clean()
        yield store
        with writing(folder):
            store.clean()


@contextmanager
def writing(folder: Path) -> Generator[None]:
    """Say in a sentence what the system says where nothing can be written.

    Raises KugelpendelError.
    """
    try:
        yield
    except OSError as error:
        raise unwritable(folder, error) from error


def unwritable(folder: Path, error: OSError) -> KugelpendelError:
    """What to raise where the folder of a sweep cannot be written."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
    kind = "sweep_disk_full" if full else "sweep_unwritable"
    said = error.strerror or str(error) or type(error).__name__
    return KugelpendelError.of(kind, folder=str(folder), said=said)


@lru_cache(maxsize=4)
def opened(path: str) -> SweepStore:
    """The store at a path, kept open by a worker between its chunks."""
    return SweepStore(Path(path))


def _continued(path: Path, sweep: Sweep) -> SweepStore:
    store = SweepStore(path)
    if store.sweep.digest != sweep.digest:
        folder, differs = str(path.parent), ", ".join(_differences(store.sweep, sweep))
        if not differs:
            raise InvalidInput.of("sweep_other_order", folder=folder)
        raise InvalidInput.of("sweep_other", folder=folder, differs=differs)
    now = _versions()
    for name, begun in store.versions.items():
        if now.get(name) != begun and not store.done().all():
            raise InvalidInput.of(
                "sweep_other_version",
                folder=str(path.parent),
                package=name,
                begun=begun,
                now=now.get(name, "-"),
            )
    return store


def _differences(stored: Sweep, asked: Sweep) -> list[str]:
    """In what two sweeps differ; nothing where only the order of what varies is another."""
    one, other = (json.loads(sweep.as_json()) for sweep in (stored, asked))
    differing = [key for key in one if key not in ("varied", "fixed") and one[key] != other[key]]
    one_given, other_given = (dict([*plain["varied"], *plain["fixed"]]) for plain in (one, other))
    names = [*one_given, *(name for name in other_given if name not in one_given)]
    changed = [where(name) for name in names if one_given.get(name) != other_given.get(name)]
    return [*changed, *differing]


def _refuse_without_room(folder: Path, sweep: Sweep) -> None:
    needed, free = bytes_kept(sweep), shutil.disk_usage(folder).free
    if needed > free:
        raise InvalidInput.of(
            "sweep_no_room",
            folder=str(folder),
            needed=(needed / 1e9, "GB"),
            free=(free / 1e9, "GB"),
            count=float(sweep.size),
        )


def _create(path: Path, sweep: Sweep, chunk: int) -> None:
    """Make an empty store; it gets its name when it is whole."""
    zarr = _zarr()
    hidden = path.with_name(f".{NAME}-{secrets.token_hex(6)}")
    try:
        about = {
            "format": _FORMAT, "sweep": sweep.as_json(), "digest": sweep.digest, "chunk": chunk,
        }  # fmt: skip
        group = zarr.create_group(
            store=zarr.storage.LocalStore(hidden),
            attributes={"kugelpendel": {**about, "versions": _versions()}},
        )
        _create_arrays(group, sweep, chunk)
        hidden.rename(path)
    finally:
        shutil.rmtree(hidden, ignore_errors=True)


def _create_arrays(group: Any, sweep: Sweep, chunk: int) -> None:
    from kugelpendel.sweeps._quantities import QUANTITIES

    chunks, cases = -(-sweep.size // chunk), sweep.size
    size = min(chunk, cases)
    make = group.create_array
    times = np.asarray(sweep.times, dtype=np.float64)
    for name in sweep.quantities:
        quantity = QUANTITIES[name]
        tail = (times.size,) if quantity.per_time else ()
        along = ("time",) if quantity.per_time else ()
        noted = {"units": quantity.unit, "long_name": quantity.text}
        if sweep.keeps_all:
            make(
                name, shape=(cases, *tail), chunks=(size, *tail), dtype="float64",
                fill_value=np.nan, dimension_names=("case", *along), attributes=noted,
                compressors=_numbers_codec(sweep),
            )  # fmt: skip
        for kind, count, dtype in reduced_arrays(sweep):
            make(
                f"{name}_{kind}", shape=(chunks, count, *tail), chunks=(1, count, *tail),
                dtype=dtype, fill_value=0, dimension_names=("chunk", kind, *along),
                attributes=noted,
            )  # fmt: skip
    make(
        "status", shape=(cases,), chunks=(size,), dtype="uint8", fill_value=NOT_YET,
        dimension_names=("case",), attributes={"codes": list(STATUS)},
    )  # fmt: skip
    make(
        "counts", shape=(chunks, len(STATUS)), chunks=(1, len(STATUS)), dtype="int64",
        fill_value=0, dimension_names=("chunk", "code"), compressors=None,
    )  # fmt: skip
    make(
        "done", shape=(chunks,), chunks=(1,), dtype="uint8", fill_value=0,
        dimension_names=("chunk",), compressors=None,
    )  # fmt: skip
    if times.size:
        make(
            "time", shape=times.shape, chunks=times.shape, dtype="float64", fill_value=np.nan,
            dimension_names=("time",), attributes={"units": "s"},
        )[:] = times  # fmt: skip


def reduced_arrays(sweep: Sweep) -> list[tuple[str, int, str]]:
    """Suffix, length and type of what is stored of each quantity in place of its values."""
    found: list[tuple[str, int, str]] = []
    if "moments" in sweep.keep:
        found.append(("moments", len(FIELDS), "float64"))
    if "quantiles" in sweep.keep or "histograms" in sweep.keep:
        found.append(("bins", BINS, "uint32"))
    return found


def _numbers_codec(sweep: Sweep) -> Any:
    """How values are packed: their bytes sorted by significance, then fast.

    Those of exact motions are not: it would save an eighth, and take a thirtieth of all the time.
    """
    if sweep.motion == "exact":
        return None
    codecs: Any = import_module("zarr.codecs")
    return codecs.BloscCodec(cname="lz4", clevel=1, shuffle="shuffle", typesize=8)


def _versions() -> dict[str, str]:
    found: dict[str, str] = {}
    for name in _PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "-"
    return found


def _zarr() -> Any:
    import_module("zarr.storage")
    return import_module("zarr")


def numbers(values: Any) -> Numbers:
    """What Zarr hands out, as numbers."""
    return np.asarray(values, dtype=np.float64)
