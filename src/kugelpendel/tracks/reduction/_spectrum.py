"""The noise of a track at the frequency of its swing, from the spectrum of the residuals."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kugelpendel.tracks._scipy import fast_size
from kugelpendel.tracks.reduction._carrier import Array, Carrier, Complexes, usual_step
from kugelpendel.tracks.reduction._windows import CLIP, Windows, basis, scatter

BAND = (0.22, 0.6)
"""Distance from the line, as shares of ω0, between which the spectrum is taken: nearer the windows
take the noise with the swing, further the spectrum is another one."""

_STRAIGHT = 60
"""Below so many cells to a side the curvature of the spectrum is left at 0."""

_LOOKED = 120
"""Frequencies at which the share that the windows take is computed."""

_SLOW = (0.15, 0.4)
"""Shares of ω0 between which the noise of the centre is read off."""


@dataclass(frozen=True)
class Noise:
    """What the noise does to the swing; levels are variances of x + iy per point, in unit².

    Attributes
    ----------
    ahead, behind
        S₊ and S₋: the level that white noise would need, at +ω0 and at −ω0.
    uneven
        C: the mean of the square of the noise, not 0 where x is noisier than y; complex.
    x, y, cross
        Levels of the two coordinates and their covariance towards zero frequency.
    cells
        Cells of the spectrum behind S₊ and S₋ together.
    theta
        The line: ln S = α± + βx + γx², x = ln |ω/ω0|.
    frequency, power
        The spectrum, in rad/s and unit², corrected for what the windows take.
    """

    ahead: float
    behind: float
    uneven: complex
    x: float
    y: float
    cross: float
    cells: int
    theta: tuple[float, float, float, float]
    frequency: Array
    power: Array

    def line(self, omega: Array, omega0: float) -> Array:
        """The fitted spectrum at these frequencies in rad/s, unit²."""
        alpha = np.where(omega > 0, self.theta[0], self.theta[1])
        x = np.log(np.abs(omega / omega0))
        return np.exp(alpha + self.theta[2] * x + self.theta[3] * x**2)


def noise_of(
    time: Array, residuals: Complexes, kept: Array, windows: Windows, carrier: Carrier
) -> Noise:
    """The noise at the swing's frequency, of whatever colour it is.

    Parameters
    ----------
    time
        s, ascending.
    residuals
        Of the window fits, complex.
    kept
        Which points were used.
    windows
        The fits.
    carrier
        Their common phase.
    """
    omega0 = float(np.mean(carrier.frequency(windows.middle)))
    time, rest = time[kept], residuals[kept]
    step = usual_step(time)
    cells = round((time[-1] - time[0]) / step) + 1
    # Points that fall into one cell are added: overwriting would lose three per cent of the power.
    index = np.minimum(np.rint((time - time[0]) / step).astype(np.intp), cells - 1)
    grid = np.bincount(index, rest.real, cells) + 1j * np.bincount(index, rest.imag, cells)
    size = fast_size(cells)
    transformed = np.fft.fft(grid, size) / np.sqrt(len(rest))
    omega = 2 * np.pi * np.fft.fftfreq(size, step)
    wide = np.abs(omega) < (1 + BAND[1]) * omega0
    kept_share = 1.0 - taken(omega[wide], time, windows, carrier, omega0)
    power = np.abs(transformed[wide]) ** 2 / np.maximum(kept_share, 0.05)
    near = np.abs(np.abs(omega[wide]) - omega0) / omega0
    used = (near > BAND[0]) & (near < BAND[1])
    theta, count = _line(omega[wide][used] / omega0, power[used])
    edge = _edge(np.abs(residuals), scatter(residuals, kept))
    levels = np.exp(theta[:2]) / edge
    order = np.argsort(omega[wide])
    uneven = _uneven(transformed, omega, omega0) * np.sqrt(levels[0] * levels[1])
    slow = (np.abs(omega) > _SLOW[0] * omega0) & (np.abs(omega) < _SLOW[1] * omega0)
    share = 1.0 - np.interp(omega[slow], omega[wide][order], 1.0 - kept_share[order])
    x, y, cross = _centre(transformed, slow, share) / edge
    return Noise(
        float(levels[0]), float(levels[1]), complex(uneven), float(x), float(y), float(cross),
        count, tuple(theta.tolist()), omega[wide][order], power[order] / edge,
    )  # fmt: skip


def taken(omega: Array, time: Array, windows: Windows, carrier: Carrier, omega0: float) -> Array:
    """The share of white noise at a frequency that the fullest window takes as swing: L(ω)."""
    fullest = int(np.argmax(windows.points))
    middle, spread = windows.middle[fullest], windows.spread[fullest]
    first = int(np.searchsorted(time, float(middle)))
    half = int(windows.points[fullest]) // 2
    some = slice(max(first - half, 0), first + half)
    rows = basis(time[some], carrier, middle, spread)
    inverse = np.linalg.pinv(rows.conj().T @ rows, hermitian=True)
    grid = np.linspace(-(1 + BAND[1]), 1 + BAND[1], 2 * _LOOKED) * omega0
    waves = np.exp(1j * np.outer(time[some] - middle, grid))
    seen = rows.conj().T @ waves
    share: Array = np.sum(seen.conj() * (inverse @ seen), axis=0).real / len(rows)
    return np.interp(omega, grid, share)


def _line(omega: Array, power: Array) -> tuple[Array, int]:
    """Ln S = α± + βx + γx² by the exponential likelihood of the cells, and the count of cells.

    A flat mean would be wrong by a half where the spectrum slopes; the curvature is left out where
    there are too few cells to see it.
    """
    ahead, x = omega > 0, np.log(np.abs(omega))
    columns = [ahead.astype(float), (~ahead).astype(float), x]
    sides = max(int(ahead.sum()), 1), max(int((~ahead).sum()), 1)
    if min(sides) >= _STRAIGHT:
        columns.append(x**2)
    design = np.stack(columns, axis=1)
    scale = max(float(power.mean()), 1e-300)
    power = power / scale
    theta = np.zeros(design.shape[1])
    for side, index in ((ahead, 0), (~ahead, 1)):
        theta[index] = np.log(max(float(power[side].mean()), 1e-300)) if side.any() else 0.0
    for _ in range(40):
        step, *_ = np.linalg.lstsq(design, power * np.exp(-design @ theta) - 1.0, rcond=None)
        theta = theta + np.clip(step, -1.0, 1.0)
        if np.abs(step).max() < 1e-9:
            break
    theta = np.pad(theta, (0, 4 - len(theta)))
    theta[:2] += np.log(scale)
    return theta, sum(sides)


def _edge(size: Array, scale: float) -> float:
    """By how much a hard rejection at its edge makes the noise seem smaller than it acts.

    `size` is |r| of all points, 0 of those in no window. Points near the edge pull the fit, and
    leave it with a step beyond: S acts as S/(1 − β)². It matters for heavy tails only.
    """
    limit = CLIP * scale
    inside = np.count_nonzero((size < limit) & (size > 0))
    if inside == 0:
        return 1.0
    near = np.count_nonzero((size > 0.85 * limit) & (size < 1.15 * limit))
    return (1.0 - min(near / (0.6 * inside), 0.5)) ** 2


def _uneven(transformed: Complexes, omega: Array, omega0: float) -> complex:
    """How far the noise ahead and the noise behind go together: C/√(S₊S₋)."""
    near = np.abs(omega - omega0) / omega0
    ahead = np.flatnonzero((near > BAND[0]) & (near < BAND[1]))
    ahead = ahead[(ahead > 0) & (ahead < len(omega))]
    if len(ahead) == 0:
        return 0.0
    plus, minus = transformed[ahead], transformed[-ahead]
    size = np.sqrt(np.mean(np.abs(plus) ** 2) * np.mean(np.abs(minus) ** 2))
    return complex(np.mean(plus * minus) / size) if size > 0 else 0.0


def _centre(transformed: Complexes, slow: Array, share: Array) -> Array:
    """Levels of x and of y and their covariance, of one coordinate each, towards zero frequency."""
    index = np.flatnonzero(slow)
    if len(index) == 0:
        return np.zeros(3)
    x = 0.5 * (transformed[index] + transformed[-index].conj())
    y = -0.5j * (transformed[index] - transformed[-index].conj())
    parts = [np.abs(x) ** 2, np.abs(y) ** 2, (x * y.conj()).real]
    return np.array([float(np.mean(part / np.maximum(share, 0.05))) for part in parts])
