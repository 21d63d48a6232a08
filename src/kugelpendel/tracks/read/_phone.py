"""From the acceleration that a swinging phone measures to its position."""

# SciPy has no types.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false
# pyright: reportUnknownMemberType=false, reportAttributeAccessIssue=false
from __future__ import annotations

import math

import numpy as np

from kugelpendel.tracks.read._cells import Numbers


def swing_frequency(time: Numbers, values: Numbers) -> float:
    """The angular frequency of a swing, rad/s: where least squares finds most of it.

    Parameters
    ----------
    time
        s, ascending; shape (n,).
    values
        Two columns, x and y; shape (n, 2).
    """
    centred = values - values.mean(axis=0)
    count = len(time)
    grid = np.linspace(time[0], time[-1], count)
    even = [np.interp(grid, time, centred[:, index]) for index in range(2)]
    size = 1 << math.ceil(math.log2(8 * count))
    spectra = [np.fft.rfft(one * np.hanning(count), size) for one in even]
    power = np.abs(spectra[0]) ** 2 + np.abs(spectra[1]) ** 2
    step = 2 * math.pi / (size * (grid[1] - grid[0]))
    peak = step * int(np.argmax(power[1:]) + 1)
    from scipy.optimize import minimize_scalar

    found = minimize_scalar(
        lambda omega: _unexplained(omega, time, centred),
        bounds=(max(peak - 4 * step, 0.1 * step), peak + 4 * step),
        method="bounded",
        options={"xatol": 1e-7 * peak},
    )
    return float(found.x)


def _unexplained(omega: float, time: Numbers, values: Numbers) -> float:
    """What remains beside a swing that decays or grows linearly, and a constant."""
    shifted = 2 * (time - time.mean()) / np.ptp(time)
    cos, sin = np.cos(omega * time), np.sin(omega * time)
    basis = np.column_stack((np.ones_like(time), cos, sin, shifted * cos, shifted * sin))
    return float(((values - basis @ np.linalg.lstsq(basis, values, rcond=None)[0]) ** 2).sum())
