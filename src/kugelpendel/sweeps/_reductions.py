"""Moments and quantiles of results that are not kept: a few numbers for each chunk.

Those of two sets are combined into those of their union, always in the same order, so that they are
the same to the last bit whoever has done the chunks and when.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from kugelpendel.parameters import Numbers
from kugelpendel.sweeps.cases._cost import LEAF, bytes_each

if TYPE_CHECKING:
    from kugelpendel.sweeps.cases import Sweep

_Any = TypeVar("_Any", bound=np.generic)

FIELDS = ("count", "infinite", "mean", "m2", "m3", "m4", "least", "most")
"""What is kept for the moments: of the finite values their count, mean, sums of the second to
fourth powers of the distance from it, least and largest; and how many are infinite."""

_MANTISSA = 8
"""Bits of the mantissa that a bin goes by: its ends differ by 2⁻⁸ of themselves or less."""

_OCTAVES = 50
"""Bins reach from 2⁻⁵⁰ to 2⁵⁰ in size, some 1e-15 to 1e15 in SI."""

_SHIFT = 52 - _MANTISSA
_LOWEST = (1023 - _OCTAVES) << _MANTISSA
_SIZES = 2 * _OCTAVES << _MANTISSA
BINS = 2 * (_SIZES + 1) + 1
"""Sizes of either sign, beyond them, and what is nearer to zero in the middle."""

QUANTILE_ERROR = 2.0 ** -(_MANTISSA + 1)
"""Relative error of a quantile of the bins."""

MOST_SORTED = 1_000_000
"""Values that are sorted at once: some tenths of a second, in which Ctrl-C has to wait."""

_BINS_STORED = 4096
"""Bytes that the bins of a chunk take when compressed: a few hundred of them are not empty."""


def moments(values: Numbers) -> Numbers:
    """The fields of values: shape (fields, *tail) for values of shape (n, *tail); NaN is left out.

    Those of each 64 values are combined as `combined` does. So the fields of a set do not depend on
    the pieces in which it came, where each piece but the last has a power of two of values, 64 or
    more.
    """
    short = -len(values) % LEAF
    padded = np.concatenate([values, np.full((short, *values.shape[1:]), np.nan)])
    leaves = padded.reshape(-1, LEAF, *values.shape[1:])
    finite = np.isfinite(leaves)
    count = finite.sum(axis=1).astype(np.float64)
    filled = np.where(finite, leaves, 0.0)
    mean = filled.sum(axis=1) / np.maximum(count, 1.0)
    apart = np.where(finite, filled - mean[:, np.newaxis], 0.0)
    square = apart * apart
    fields = [
        count,
        np.isinf(leaves).sum(axis=1).astype(np.float64),
        mean,
        square.sum(axis=1),
        (square * apart).sum(axis=1),
        (square * square).sum(axis=1),
        np.where(finite, leaves, np.inf).min(axis=1, initial=np.inf),
        np.where(finite, leaves, -np.inf).max(axis=1, initial=-np.inf),
    ]
    return combined(np.stack(fields, axis=1))


def combined(parts: Numbers) -> Numbers:
    """The fields of the union of sets: (fields, *tail) for parts of shape (sets, fields, *tail).

    Neighbours are combined in pairs, and the pairs in pairs; one without a neighbour waits for the
    next round. Source: P. Pébay, Formulas for robust
    one-pass parallel computation of covariances and arbitrary-order statistical moments, Sandia
    Report SAND2008-6212 (2008), eq. (1.3) to (1.6) for two sets.
    """
    if len(parts) == 0:
        return moments(np.full((1, *parts.shape[2:]), np.nan))
    while len(parts) > 1:
        paired = len(parts) // 2 * 2
        pairs = _united(parts[0:paired:2], parts[1:paired:2])
        parts = np.concatenate([pairs, parts[paired:]])
    return parts[0]


def binned(values: Numbers) -> NDArray[np.uint32]:
    """How many values fall into each bin: (bins, *tail) for values of shape (n, *tail).

    A bin is a sign and the leading bits of a number, so that no rounding decides between two.
    """
    columns = values.reshape(len(values), -1)
    counts = np.empty((BINS, columns.shape[1]), dtype=np.uint32)
    for k in range(columns.shape[1]):
        column = columns[~np.isnan(columns[:, k]), k]
        size = (np.abs(column).view(np.int64) >> _SHIFT) - _LOWEST + 1
        place = np.asarray(np.clip(size, 0, _SIZES + 1), dtype=np.int64)
        signed = np.where(column < 0, -place, place) + _SIZES + 1
        counts[:, k] = np.bincount(signed, minlength=BINS)
    return counts.reshape(BINS, *values.shape[1:])


def edges(place: NDArray[np.int64]) -> tuple[Numbers, Numbers]:
    """The lower and the upper end of bins: those about zero and beyond all sizes too."""
    size = np.abs(place - _SIZES - 1)
    small, large = _size(size), _size(size + 1)
    negative = place < _SIZES + 1
    lower = np.where(negative, -large, np.where(size == 0, -large, small))
    return lower, np.where(negative, -small, large)


def quantiles(counts: NDArray[np.int64], shares: Numbers) -> Numbers:
    """The values below which shares of all lie: (shares, *tail) for counts of (bins, *tail).

    Right to 2⁻⁹ of themselves, 0.2 %; NaN where there are no values.
    """
    columns = counts.reshape(len(counts), -1)
    found = np.full((len(shares), columns.shape[1]), np.nan)
    lower, upper = edges(np.arange(len(counts)))
    with np.errstate(invalid="ignore"):
        middle = np.where(
            np.isinf(lower), lower, np.where(np.isinf(upper), upper, (lower + upper) / 2)
        )
    for k in range(columns.shape[1]):
        running = np.cumsum(columns[:, k])
        if running[-1]:
            rank = np.maximum(np.ceil(shares * running[-1]), 1)
            found[:, k] = middle[np.searchsorted(running, rank)]
    return found.reshape(len(shares), *counts.shape[1:])


def bytes_reduced(sweep: Sweep, chunks: int) -> int:
    """Bytes that the reductions of a sweep in so many chunks take, about."""
    each = (8 * len(FIELDS) if "moments" in sweep.keep else 0) + (
        _BINS_STORED if {"quantiles", "histograms"} & set(sweep.keep) else 0
    )
    return each * bytes_each(sweep) // 8 * chunks


def _size(size: NDArray[np.int64]) -> Numbers:
    """The lower end of a bin of sizes: 0 for the first, infinite beyond the last."""
    bits = (np.clip(size, 1, _SIZES + 1) - 1 + _LOWEST) << _SHIFT
    return np.where(size == 0, 0.0, np.where(size > _SIZES + 1, np.inf, bits.view(np.float64)))


def _united(one: Numbers, other: Numbers) -> Numbers:
    """The fields of the unions of pairs: shape (pairs, fields, *tail) each."""
    a: Any = one.swapaxes(0, 1)
    b: Any = other.swapaxes(0, 1)
    m: Any = a[0]
    n: Any = b[0]
    total = m + n
    whole = np.where(total > 0, total, 1.0)
    step = (b[2] - a[2]) / whole
    shared = m * n * step * (b[2] - a[2])
    m2 = a[3] + b[3] + shared
    m3 = a[4] + b[4] + shared * step * (m - n) + 3 * step * (m * b[3] - n * a[3])
    m4 = (
        a[5]
        + b[5]
        + shared * step * step * (m * m - m * n + n * n)
        + 6 * step * step * (m * m * b[3] + n * n * a[3])
        + 4 * step * (m * b[4] - n * a[4])
    )
    # An empty set has the mean 0, which must not count.
    mean = np.asarray(a[2] + n * step, dtype=np.float64)
    mean[n == 0] = a[2][n == 0]
    mean[m == 0] = b[2][m == 0]
    empty = (m == 0) | (n == 0)
    sums: list[Any] = [
        np.where(empty, a[k] + b[k], value) for k, value in ((3, m2), (4, m3), (5, m4))
    ]
    ends: list[Any] = [np.minimum(a[6], b[6]), np.maximum(a[7], b[7])]
    fields: list[Any] = [total, a[1] + b[1], mean, *sums, *ends]
    return np.stack(fields, axis=1)


def evenly(values: NDArray[_Any]) -> NDArray[_Any]:
    """As many of some values as are sorted at once, evenly spread where there are more."""
    return values[:: max(1, -(-values.size // MOST_SORTED))]
