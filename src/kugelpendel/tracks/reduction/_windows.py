"""A track cut into windows, and the swing of each window by least squares."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from kugelpendel.tracks.reduction._carrier import (
    LEAST_SWINGS,
    Array,
    Carrier,
    Complexes,
    pieces,
)

AHEAD, BEHIND, CENTRE = 0, 1, 4
"""Where the basis has the circle that goes ahead, the one that goes behind, and the centre; the
slopes of the circles are two further on, the centre's one."""

WIDTH = 10
"""Functions of the basis: the swing's two circles with their slopes, the centre with its own, and
two harmonics either way, for what the camera and the pendulum bend."""

_AT_ONCE = 1 << 16
"""Points whose basis is held at once: 10 MB."""

CLIP = 4.5
"""Residuals beyond so many of their standard deviations are outliers."""

_ROUNDS = 8
"""Rounds in which the outliers are found at the most."""

_SURE = 2.0
"""A window whose circle is known worse than by so many times the variance of an even window is
left out: its points leave the basis undetermined."""


@dataclass(frozen=True)
class Windows:
    """The swing of every window.

    Attributes
    ----------
    first, behind
        Index of the first point of each window and of the one behind its last.
    middle, spread
        Mean and standard deviation of the times in it, s.
    points
        How many of its points are kept.
    found
        Coefficients of the basis, complex, shape (windows, 10).
    inverse
        (BᴴB)⁻¹ of each, shape (windows, 10, 10).
    """

    first: Array
    behind: Array
    middle: Array
    spread: Array
    points: Array
    found: Complexes
    inverse: Complexes

    def __len__(self) -> int:
        return len(self.first)

    def chosen(self, which: Array) -> Windows:
        """Only those windows that are marked."""
        return Windows(*(value[which] for value in vars(self).values()))


def cut(time: Array, omega: float, swings: float) -> tuple[list[tuple[int, int]], int, int]:
    """Windows of about so many swings, none across a gap that is longer than a swing.

    Returns
    -------
    First index and the one behind the last of each window, the number of pieces between gaps, and
    how many points lie in pieces that are too short.
    """
    period = 2 * np.pi / omega
    windows: list[tuple[int, int]] = []
    count = left_out = 0
    for begin, end in pieces(time, period):
        lasts = time[end - 1] - time[begin]
        if lasts < LEAST_SWINGS * period * 0.999 or end - begin < 2 * WIDTH:
            left_out += end - begin
            continue
        count += 1
        parts = max(1, int(lasts / (swings * period) + 1e-9))
        bounds = time[begin] + lasts / parts * np.arange(1, parts)
        edges = [
            begin,
            *(begin + int(np.searchsorted(time[begin:end], float(bound))) for bound in bounds),
            end,
        ]
        windows += pairwise(edges)
    return windows, count, left_out


def basis(time: Array, carrier: Carrier, middle: Array, spread: Array) -> Complexes:
    """The functions of the basis at these times, shape (*time.shape, 10).

    Middle and spread, in s, broadcast against the times.
    """
    turn = np.exp(1j * carrier.phase(time))
    back, scaled = turn.conj(), (time - middle) / spread
    out = np.empty((*time.shape, WIDTH), dtype=complex)
    second = turn * turn
    columns = (turn, back, turn * scaled, back * scaled, 1.0, scaled, second, second.conj())
    for index, column in enumerate((*columns, second * turn, (second * turn).conj())):
        out[..., index] = column
    return out


def fitted(
    time: Array, z: Complexes, kept: Array, bounds: list[tuple[int, int]], carrier: Carrier
) -> tuple[Windows, Complexes]:
    """The swing of every window by complex least squares of the kept points.

    Returns
    -------
    The windows, and the residuals of all points, 0 where a point is in no window.
    """
    first, behind = np.array(bounds, dtype=np.intp).reshape(-1, 2).T
    count = len(first)
    middle, spread, points = np.zeros(count), np.ones(count), np.zeros(count, dtype=np.intp)
    found, inverse = np.zeros((count, WIDTH), complex), np.zeros((count, WIDTH, WIDTH), complex)
    residuals = np.zeros(len(time), complex)
    for some in _groups(first, behind):
        index = first[some, None] + np.arange(int((behind - first)[some].max()))
        inside = index < behind[some, None]
        index = np.minimum(index, len(time) - 1)
        weights = (inside & kept[index]).astype(float)
        times, place = time[index], z[index]
        points[some] = weights.sum(axis=1)
        total = np.maximum(points[some], 1)
        middle[some] = (weights * times).sum(axis=1) / total
        apart = times - middle[some, None]
        spread[some] = np.sqrt((weights * apart**2).sum(axis=1) / total) + 1e-300
        rows = basis(times, carrier, middle[some, None], spread[some, None])
        weighted = (rows * weights[..., None]).conj().swapaxes(1, 2)
        products = weighted @ rows
        # What has too few points is singular; a trace of the unit keeps it solvable, and `sure`
        # leaves it out.
        trace = 1e-13 * np.trace(products, axis1=1, axis2=2).real + 1e-300
        products += trace[:, None, None] * np.eye(WIDTH)
        inverse[some] = np.linalg.inv(products)
        found[some] = (inverse[some] @ (weighted @ place[..., None]))[..., 0]
        rest = place - (rows @ found[some][..., None])[..., 0]
        residuals[index[inside]] = rest[inside]
    return Windows(first, behind, middle, spread, points, found, inverse), residuals


def sure(windows: Windows) -> Array:
    """Which windows determine the two circles: enough points, well spread."""
    circles = windows.inverse[:, [AHEAD, BEHIND], [AHEAD, BEHIND]].real.max(axis=1)
    enough = windows.points >= WIDTH + 2
    return enough & (circles * windows.points <= _SURE)


def without_outliers(
    time: Array,
    z: Complexes,
    kept: Array,
    bounds: list[tuple[int, int]],
    carrier: Carrier,
    tell: Callable[[float], None],
) -> tuple[Windows, Complexes, Array]:
    """As `fitted`, with outliers left out until nothing changes.

    Returns
    -------
    The windows, the residuals of all points from the fit of those that are kept, and which are.
    """
    windows, residuals = fitted(time, z, kept, bounds, carrier)
    inside = np.zeros(len(time), dtype=bool)
    for begin, end in bounds:
        inside[begin:end] = True
    for done in range(_ROUNDS):
        now = inside & (np.abs(residuals) < CLIP * scatter(residuals, kept & inside))
        if np.array_equal(now, kept & inside):
            break
        kept = now
        windows, residuals = fitted(time, z, kept, bounds, carrier)
        tell((done + 1) / _ROUNDS)
    return windows, residuals, kept & inside


def scatter(residuals: Complexes, kept: Array) -> float:
    """Standard deviation of one coordinate of the residuals, by their median.

    The median of |r| is √(2 ln 2) of it where both coordinates have the same normal noise.
    """
    size = np.abs(residuals[kept])
    return float(np.median(size)) / 1.1774 if len(size) else 0.0


def _groups(first: Array, behind: Array) -> Iterator[slice]:
    """Windows in groups whose points fit into memory, also where their counts differ."""
    begin = 0
    while begin < len(first):
        end, longest = begin, 0
        while end < len(first):
            longest = max(longest, int(behind[end] - first[end]))
            if end > begin and longest * (end + 1 - begin) > _AT_ONCE:
                break
            end += 1
        yield slice(begin, end)
        begin = end
