"""Ellipses that somebody else has fitted: a table of them, with errors from their scatter."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.tracks._ellipse_table import EllipseTable
from kugelpendel.tracks.reduction._carrier import Array
from kugelpendel.tracks.reduction._labelled import labelled

_LEAST = 5
"""Rows that the scatter of neighbours needs."""


def tabulated(
    time: ArrayLike, a: ArrayLike, b: ArrayLike, azimuth: ArrayLike, *, unit: str = "m"
) -> Any:
    """A table of ready ellipses in the form that `ellipses` gives.

    Parameters
    ----------
    time
        s, ascending; shape (n,), at least five.
    a, b
        Semi-axes in `unit`, b positive where the ellipse is run through counter-clockwise.
    azimuth
        Of the major axis, rad, counter-clockwise; a whole number of half turns is of no account.
    unit
        Of a and b.

    Returns
    -------
    An `xarray.Dataset` as from `ellipses`: the azimuth unwrapped, standard errors from the scatter
    of each row about the line through its neighbours, by its median. This sees what changes from
    row to row only: slow errors have to be looked for in the residuals, and `fit` does so. What a
    table does not say is NaN.

    Raises
    ------
    InvalidInput
        For fewer than five rows, columns of other lengths, times that do not ascend, and numbers
        that are not finite.
    """
    require_extra("fit", "kugelpendel.tracks", "scipy", "xarray")
    # The table makes arrays of them.
    table = EllipseTable(*(cast("tuple[Array, Array, Array, Array]", (time, a, b, azimuth))), unit)
    count, times = len(table), table.time
    if count < _LEAST:
        raise InvalidInput.of("table_rows", rows=count, least=_LEAST)
    columns = {
        "a": table.a.copy(),
        "b": table.b.copy(),
        "azimuth": np.unwrap(table.azimuth, period=np.pi),
    }
    covariance = np.full((count, 6, 6), np.nan)
    for index, name in enumerate(columns):
        covariance[:, index, :3] = 0.0
        covariance[:, index, index] = _scatter(times, columns[name]) ** 2
    nothing = np.full(count, np.nan)
    values = {**columns, "frequency": nothing, "x0": nothing, "y0": nothing}
    attrs = {"unit": unit, "origin": "table", "points": count, "pieces": 1, "rejected": 0}
    zeros = np.zeros(count)
    return labelled(times.copy(), values, covariance, attrs, zeros, np.ones(count, dtype=int))


def _scatter(time: Array, values: Array) -> float:
    """Standard deviation of one value, from how far each lies off the line of its neighbours."""
    share = (time[1:-1] - time[:-2]) / (time[2:] - time[:-2])
    apart = values[1:-1] - (1 - share) * values[:-2] - share * values[2:]
    apart /= np.sqrt(1 + share**2 + (1 - share) ** 2)
    size = float(np.median(np.abs(apart))) * 1.4826
    return size or float(np.std(values)) * 1e-6 or 1e-12
