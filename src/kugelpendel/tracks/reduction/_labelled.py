"""Ellipses as a labelled data set, with their covariance."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from kugelpendel.parameters import Numbers
from kugelpendel.tracks._scipy import chi_square_limit
from kugelpendel.tracks.reduction._carrier import Array
from kugelpendel.tracks.reduction._spectrum import Noise
from kugelpendel.tracks.reduction._windows import AHEAD, BEHIND, CENTRE, Windows

PARAMETERS = ("a", "b", "azimuth", "frequency", "x0", "y0")

_NAMES = {
    "a": "semi-major axis",
    "b": "semi-minor axis, positive counter-clockwise",
    "azimuth": "azimuth of the major axis, counter-clockwise from x",
    "frequency": "angular frequency of the swing",
    "x0": "centre, x",
    "y0": "centre, y",
}

_UNITS = {"azimuth": "rad", "frequency": "rad/s"}


def covariance_of(windows: Windows, noise: Noise, azimuth: Array) -> Array:
    """Covariance of a, b, azimuth, frequency, x0 and y0 in each window, shape (windows, 6, 6).

    The circles are p = |A₊| and q = |A₋|, a = p + q, b = p − q, ψ half the sum of their
    directions; the noise has the level S₊ ahead, S₋ behind, and C where x and y are not alike.
    Slope and place of the centre, and slope and direction of the circles, are independent as the
    times are counted from their mean; so is the swing from the centre.
    """
    ahead, behind = windows.found[:, AHEAD], windows.found[:, BEHIND]
    p, q = np.abs(ahead), np.abs(behind)
    g = windows.inverse[:, AHEAD, AHEAD].real
    both, apart = 0.5 * (noise.ahead + noise.behind) * g, 0.5 * (noise.ahead - noise.behind) * g
    c = noise.uneven * np.exp(-2j * azimuth) * g
    out = np.zeros((len(p), 6, 6))
    out[:, 0, 0] = both + c.real
    out[:, 1, 1] = both - c.real
    out[:, 2, 2] = g * (noise.ahead / p**2 + noise.behind / q**2) / 8 - c.real / (4 * p * q)
    out[:, 0, 1] = apart
    out[:, 0, 2] = c.imag * (1 / p + 1 / q) / 4
    out[:, 1, 2] = c.imag * (1 / q - 1 / p) / 4
    slope = windows.inverse[:, AHEAD + 2, AHEAD + 2].real
    turned = (c / g).real * slope / (4 * p * q)
    phased = slope * (noise.ahead / p**2 + noise.behind / q**2) / 8 + turned
    out[:, 3, 3] = phased / windows.spread**2
    middle = windows.inverse[:, CENTRE, CENTRE].real
    out[:, 4, 4], out[:, 5, 5] = noise.x * middle, noise.y * middle
    out[:, 4, 5] = noise.cross * middle
    lower = np.tril_indices(6, -1)
    out[:, lower[0], lower[1]] = out[:, lower[1], lower[0]]
    return out


def column(ellipses: Any, name: str) -> Numbers:
    """A variable of a data set as plain numbers."""
    return np.asarray(ellipses[name].values, dtype=float)


def labelled(
    time: Array,
    values: Mapping[str, Array],
    covariance: Array,
    attrs: Mapping[str, Any],
    spread: Array,
    points: Array,
) -> Any:
    """The data set of `ellipses`.

    Parameters
    ----------
    time
        s.
    values
        By the names of `PARAMETERS`.
    covariance
        Shape (time, 6, 6).
    attrs
        What was seen on the way, "unit" among it.
    spread, points
        Standard deviation of the times of each window in s, and how many there are.
    """
    import xarray

    unit = str(attrs["unit"])
    variables: dict[str, Any] = {}
    for index, name in enumerate(PARAMETERS):
        units = _UNITS.get(name, unit)
        told = {"units": units, "long_name": _NAMES[name]}
        variables[name] = ("time", values[name], told)
        stderr = np.sqrt(covariance[:, index, index])
        told = {"units": units, "long_name": f"standard error of {name}"}
        variables[f"{name}_stderr"] = ("time", stderr, told)
    told = {"long_name": "covariance of the six, each in its own unit"}
    variables["covariance"] = (("time", "parameter", "parameter_"), covariance, told)
    variables["spread"] = ("time", spread, {"units": "s"})
    variables["points"] = ("time", points)
    seen = np.sum(values["b"] ** 2 / np.maximum(covariance[:, 1, 1], 1e-300))
    coordinates = {
        "time": ("time", time, {"units": "s"}),
        "parameter": list(PARAMETERS),
        "parameter_": list(PARAMETERS),
    }
    planar = int(float(seen) < chi_square_limit(len(time)))
    return xarray.Dataset(variables, coordinates, {**attrs, "planar": planar})
