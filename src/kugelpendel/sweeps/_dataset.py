"""What a store holds, as an xarray data set that reads only what is looked at."""

from __future__ import annotations

from collections.abc import Callable
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import require_extra
from kugelpendel.parameters import Numbers
from kugelpendel.sweeps._quantities import QUANTITIES
from kugelpendel.sweeps._reductions import combined, edges, quantiles
from kugelpendel.sweeps._store import NAME, STATUS, SweepStore, numbers
from kugelpendel.sweeps.cases import Sweep

if TYPE_CHECKING:
    import xarray as xr

SHARES = (0.01, 0.025, 0.05, 0.25, 0.5, 0.75, 0.95, 0.975, 0.99)
"""The quantiles of reductions: the median, and the ends of 50, 90, 95 and 98 % in the middle."""

_NAMED = 10
"""Bad cases that are named by their index."""

_AT_ONCE = 1 << 19
"""Cells that are read at once where bins are added up."""


def read(folder: str | Path) -> tuple[Sweep, xr.Dataset]:
    """Read what a sweep has come to, finished or not.

    Parameters
    ----------
    folder
        That of the sweep, which holds ``sweep.zarr``.

    Returns
    -------
    Sweep
        What was asked.
    Dataset
        As from `kugelpendel.sweep`; NaN, and the status 0, for what is not done yet.

    Raises
    ------
    InvalidInput
        There is no sweep in that folder.
    """
    require_extra("sweep", "kugelpendel.sweeps", "scipy", "xarray", "zarr")
    store = SweepStore(Path(folder) / NAME)
    return store.sweep, dataset_of(store)


def dataset_of(store: SweepStore) -> xr.Dataset:
    """The data set of a store: the cases, or what they were reduced to.

    The cases of a grid have a dimension for each number that varies, with its values; those of
    other designs the one dimension "case", along which what varies stands as coordinates that are
    made from the index where they are read.
    """
    import xarray as xr

    sweep = store.sweep
    attributes = {
        "title": f"A sweep of {sweep.size} spherical pendulums",
        "sweep": sweep.as_json(),
        "digest": sweep.digest,
        "design": sweep.design,
        "motion": sweep.motion,
    }
    dims, coordinates = _coordinates(sweep)
    status = _lazy(store.array("status"), sweep, dims, (), _codes(store))
    variables: dict[str, Any] = {"status": status}
    for name in sweep.quantities:
        quantity = QUANTITIES[name]
        tail = ("time",) if quantity.per_time else ()
        noted = {"units": quantity.unit, "long_name": quantity.text}
        if sweep.keeps_all:
            variables[name] = _lazy(store.array(name), sweep, dims, tail, noted)
        else:
            variables |= _reduced(store, name, tail, noted)
    if any(QUANTITIES[name].per_time for name in sweep.quantities):
        coordinates["time"] = xr.Variable("time", np.asarray(sweep.times), {"units": "s"})
    if not sweep.keeps_all and "quantiles" in sweep.keep:
        coordinates["quantile"] = xr.Variable("quantile", np.asarray(SHARES))
    return xr.Dataset(variables, coordinates, attributes)


def _codes(store: SweepStore) -> dict[str, Any]:
    """What the codes of the status mean, how many cases have each, and the first bad ones."""
    return {
        "flag_values": list(range(len(STATUS))),
        "flag_meanings": ", ".join(STATUS),
        "counts": store.counts().tolist(),
        "first_bad": store.bad(_NAMED).tolist(),
    }


def _coordinates(sweep: Sweep) -> tuple[tuple[str, ...], dict[str, Any]]:
    """The dimensions of the cases, and what varies along them."""
    import xarray as xr

    noted = {
        name: {"units": sweep.unit(name), "long_name": name.replace(".", " ").replace("_", " ")}
        for name in sweep.names
    }
    if sweep.design == "grid":
        axes = {
            name: xr.Variable(name, law.at(np.arange(law.levels or 0)), noted[name])
            for name, law in sweep.varied.items()
        }
        return sweep.names, dict(axes)
    made = {
        name: xr.Variable("case", _lazily(_varying(sweep, name), (sweep.size,)), noted[name])
        for name in sweep.names
    }
    return ("case",), dict(made)


def _varying(sweep: Sweep, name: str) -> Callable[[tuple[Any, ...]], NDArray[Any]]:
    """What one of the numbers is for the cases of a key."""

    def get(key: tuple[Any, ...]) -> NDArray[Any]:
        index = _indices(key[0], sweep.size)
        return sweep.values_at(np.atleast_1d(index))[name].reshape(np.shape(index))

    return get


def _lazy(
    array: Any, sweep: Sweep, dims: tuple[str, ...], tail: tuple[str, ...], noted: dict[str, Any]
) -> Any:
    """A variable in the shape of the cases, whose values are read where they are looked at."""
    import xarray as xr

    shape = sweep.shape
    widths = tuple(array.shape[1:])

    def get(key: tuple[Any, ...]) -> NDArray[Any]:
        cases, rest = key[: len(shape)], key[len(shape) :]
        at = [_indices(part, size) for part, size in zip(cases, shape, strict=True)]
        flat = np.zeros((), dtype=np.int64)
        for index, size in zip(at, shape, strict=True):
            flat = np.add.outer(flat * size, index)
        found = _rows(array, flat.ravel()).reshape((*flat.shape, *widths))
        return np.asarray(found[(..., *rest)]) if rest else found

    return xr.Variable((*dims, *tail), _lazily(get, (*shape, *widths), array.dtype), noted)


def _rows(array: Any, flat: NDArray[np.int64]) -> NDArray[Any]:
    """Rows of a stored array by their indices; neighbours are read together."""
    if flat.size == 0:
        return np.empty((0, *array.shape[1:]), dtype=array.dtype)
    first, last = int(flat.min()), int(flat.max()) + 1
    if last - first == flat.size and (flat.size == 1 or bool((np.diff(flat) == 1).all())):
        return np.asarray(array[first:last])
    if last - first <= 4 * flat.size:
        return np.asarray(array[first:last])[flat - first]
    # Each row once and in order, which is what Zarr is fast at.
    rows, back = np.unique(flat, return_inverse=True)
    whole = (slice(None),) * (array.ndim - 1)
    return np.asarray(array.oindex[(rows, *whole)])[back]


def _indices(key: Any, size: int) -> NDArray[np.int64]:
    """The indices that an int, a slice or an array of them means."""
    if isinstance(key, slice):
        return np.arange(*key.indices(size), dtype=np.int64)
    index = np.asarray(key, dtype=np.int64)
    return np.where(index < 0, index + size, index)


def _lazily(
    get: Callable[[tuple[Any, ...]], NDArray[Any]],
    shape: tuple[int, ...],
    dtype: Any = np.float64,
) -> Any:
    """An array that xarray asks for what is looked at, and for nothing else."""
    from xarray.backends import BackendArray
    from xarray.core import indexing

    class SweepArray(BackendArray):
        def __init__(self) -> None:
            self.shape = shape
            self.dtype = np.dtype(dtype)

        def __getitem__(self, key: Any) -> Any:
            outer = indexing.IndexingSupport.OUTER
            return indexing.explicit_indexing_adapter(key, self.shape, outer, get)

    return indexing.LazilyIndexedArray(SweepArray())


def _reduced(
    store: SweepStore, name: str, tail: tuple[str, ...], noted: dict[str, Any]
) -> dict[str, Any]:
    """The variables that a quantity was reduced to."""
    import xarray as xr

    sweep = store.sweep
    found: dict[str, Any] = {}
    plain = {key: value for key, value in noted.items() if key != "units"}
    if "moments" in sweep.keep:
        parts = numbers(store.array(f"{name}_moments")[:])[store.done()]
        for kind, value in _told(combined(parts)).items():
            has_unit = kind in ("mean", "std", "least", "most")
            found[f"{name}_{kind}"] = xr.Variable(tail, value, noted if has_unit else plain)
    if "quantiles" not in sweep.keep and "histograms" not in sweep.keep:
        return found
    counts = _summed(store.array(f"{name}_bins"), store.done())
    if "quantiles" in sweep.keep:
        values = quantiles(counts, np.asarray(SHARES))
        found[f"{name}_quantile"] = xr.Variable(("quantile", *tail), values, noted)
    if "histograms" in sweep.keep:
        filled = np.flatnonzero(counts.reshape(len(counts), -1).sum(axis=1))
        lower, upper = edges(filled)
        along = f"{name}_bin"
        found[f"{name}_histogram"] = xr.Variable((along, *tail), counts[filled], plain)
        found[f"{name}_lower"] = xr.Variable(along, lower, noted)
        found[f"{name}_upper"] = xr.Variable(along, upper, noted)
    return found


def _told(fields: Numbers) -> dict[str, Numbers]:
    """The moments that people ask for; those of less than two values are NaN."""
    count, infinite, mean, m2, m3, m4, least, most = fields
    with np.errstate(invalid="ignore", divide="ignore"):
        found = {
            "count": count,
            "infinite": infinite,
            "mean": np.where(count > 0, mean, np.nan),
            "std": np.sqrt(m2 / np.where(count > 1, count - 1, np.nan)),
            "skewness": np.sqrt(count) * m3 / m2**1.5,
            "kurtosis": count * m4 / m2**2 - 3,
            "least": np.where(count > 0, least, np.nan),
            "most": np.where(count > 0, most, np.nan),
        }
    return {name: np.asarray(value) for name, value in found.items()}


def _summed(array: Any, done: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The counts of all chunks that are done, added up some at a time."""
    total = np.zeros(array.shape[1:], dtype=np.int64)
    step = max(_AT_ONCE // prod(array.shape[1:]), 1)
    for start in range(0, array.shape[0], step):
        part = np.asarray(array[start : start + step])[done[start : start + step]]
        total += part.sum(axis=0, dtype=np.int64)
    return total
