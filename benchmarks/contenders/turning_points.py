"""Period and precession out of a trajectory, as one would measure them."""

from __future__ import annotations

import math

import numpy as np

Path = tuple[np.ndarray, np.ndarray]  # position (m), velocity (m/s), z down
WINDOW = 10  # rows used to locate one turning point


def apsides(time: np.ndarray, path: Path) -> tuple[float, float]:
    """Period T_s (s) and precession (rad/s), from the outer turning points of a trajectory.

    There the horizontal radius stops growing: f = x vx + y vy falls through zero. Time and azimuth
    at f = 0 come from inverse interpolation in f, of degree WINDOW - 1.
    """
    (x, y, _), (vx, vy, _) = (part.T for part in path)
    f = x * vx + y * vy
    before = np.flatnonzero((f[:-1] > 0) & (f[1:] <= 0))
    half = WINDOW // 2
    before = before[(before >= half - 1) & (before + half < f.size)]
    last = (before.size - 1) // 2 * 2  # an even number of passages: whole turns and a small rest
    rows = before[[0, last], None] + np.arange(1 - half, half + 1)
    g = f[rows]
    apart = g[:, None, :] - g[:, :, None] + np.eye(WINDOW)
    weight = np.where(np.eye(WINDOW, dtype=bool), 1.0, g[:, None, :] / apart).prod(axis=-1)
    times = (weight * time[rows]).sum(-1)
    angles = (weight * np.unwrap(np.arctan2(y[rows], x[rows]))).sum(-1)
    elapsed, turned = times[1] - times[0], angles[1] - angles[0]
    rough = np.ptp(np.unwrap(np.arctan2(y, x))[rows[:, 0]])
    turned += 2 * math.pi * (round((rough - turned) / (2 * math.pi)) - last // 2)
    return float(elapsed / last), float(turned / elapsed)
