"""The swing that a track shows: its frequency, and the pieces between gaps."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import InvalidInput
from kugelpendel.tracks._scipy import fast_size

Array: TypeAlias = NDArray[Any]
"""Real numbers, counts or flags; the names say which."""

Complexes: TypeAlias = NDArray[np.complex128]

LEAST_SWINGS = 3.0
"""Swings that a piece needs, so that its slopes and its middle are told apart."""

LEAST_POINTS = 3.0
"""Points to a swing below which the swing may be an alias of a faster one."""

_PADDED = 4
"""The spectrum is padded to so many times the length: its peak is then within 1/8 of a cell, and
the phase drifts by less than a quarter turn over the whole track."""

_LONGEST = 120.0
"""m: no pendulum hangs as long as this, so a track that asks for it is sampled too slowly."""

_SHARPEST = 0.1
"""Share of the power within two cells of the peak in a track that shows a swing at all."""


@dataclass(frozen=True)
class Carrier:
    """The phase of the swing as a polynomial in time, φ(t), in rad.

    Attributes
    ----------
    coefficients
        Of the powers of (t − middle)/half, ascending.
    middle, half
        In s: the polynomial's argument runs from −1 to 1 over the track.
    """

    coefficients: Array
    middle: float
    half: float

    def phase(self, time: Array) -> Array:
        """The phase φ in rad at times in s."""
        scaled = (time - self.middle) / self.half
        return np.polynomial.polynomial.polyval(scaled, self.coefficients)

    def frequency(self, time: Array) -> Array:
        """The rate φ' of the phase in rad/s at times in s."""
        slopes = np.polynomial.polynomial.polyder(self.coefficients) / self.half
        return np.polynomial.polynomial.polyval((time - self.middle) / self.half, slopes)

    def corrected(self, time: Array, more: Array, weights: Array, degree: int) -> Carrier:
        """The same with a polynomial added that follows these phases in rad at these times."""
        degree = min(degree, len(time) - 1)
        scaled = (time - self.middle) / self.half
        added = polynomial(scaled, more, degree, weights)
        size = max(len(added), len(self.coefficients))
        padded = [np.pad(part, (0, size - len(part))) for part in (self.coefficients, added)]
        return Carrier(padded[0] + padded[1], self.middle, self.half)


def polynomial(x: Array, y: Array, degree: int, weights: Array | None = None) -> Array:
    """Coefficients of the least-squares polynomial, ascending; a column for each column of y."""
    fit: Any = np.polynomial.polynomial.polyfit  # its types say less than nothing
    return np.asarray(fit(x, y, degree, w=weights), dtype=float)


def first_guess(z: Complexes) -> Array:
    """Which points are taken at first: those that lie no further out than a swing may go."""
    distance = np.abs(z - np.median(z.real) - 1j * np.median(z.imag))
    return distance <= 1.6 * np.quantile(distance, 0.9)


def swing_frequency(time: Array, z: Complexes, kept: Array) -> float:
    """Angular frequency of the swing in rad/s: where the spectrum of the positions has its peak.

    Parameters
    ----------
    time
        s, ascending.
    z
        Positions x + iy.
    kept
        Which points count.

    Raises
    ------
    InvalidInput
        For positions that do not change, tracks without a swing, with fewer than three of them,
        and with fewer than three points to a swing.
    """
    time, z = time[kept], z[kept]
    if len(z) < 8 or not np.ptp(z.real) + np.ptp(z.imag) > 0:
        kind = "track_constant" if len(z) >= 8 else "track_few_points"
        raise InvalidInput.of(kind, points=float(len(z)))
    whole = float(time[-1] - time[0])
    step = usual_step(time)
    cells = round(whole / step) + 1
    if cells > 50 * len(z):
        raise InvalidInput.of("track_gaps", points=float(len(z)), duration=(whole, "s"))
    index = np.minimum(np.rint((time - time[0]) / step).astype(np.intp), cells - 1)
    centred = z - z.mean()
    grid = np.bincount(index, centred.real, cells) + 1j * np.bincount(index, centred.imag, cells)
    size = fast_size(_PADDED * cells)
    transformed = np.fft.fft(grid, size)
    power = np.abs(transformed[: size // 2]) ** 2
    power[1:] += np.abs(transformed[-1 : size // 2 : -1][: size // 2 - 1]) ** 2
    power[0] = 0.0
    peak = int(np.argmax(power))
    near = slice(max(peak - 2 * _PADDED, 0), peak + 2 * _PADDED + 1)
    if power[near].sum() < _SHARPEST * power.sum():
        raise InvalidInput.of("track_no_swing", points=float(len(z)), duration=(whole, "s"))
    omega = 2 * np.pi * (peak + _parabola(power, peak)) / (size * step)
    swings = whole * omega / (2 * np.pi)
    if swings < 1 + 1 / _PADDED:
        raise InvalidInput.of("track_no_swing", points=float(len(z)), duration=(whole, "s"))
    if swings < LEAST_SWINGS:
        period = (2 * np.pi / omega, "s")
        raise InvalidInput.of("track_short", swings=swings, period=period, duration=(whole, "s"))
    _refuse_alias(omega, step, time, centred)
    return omega


def usual_step(time: Array) -> float:
    """The mean step in s where there is no gap."""
    steps = np.diff(time)
    return float(steps[steps < 5 * np.median(steps)].mean())


def pieces(time: Array, longest: float) -> list[tuple[int, int]]:
    """First index and the one behind the last of each piece without a gap longer than this, s."""
    breaks = np.flatnonzero(np.diff(time) > longest) + 1
    edges = [0, *breaks.tolist(), len(time)]
    return list(pairwise(edges))


def _parabola(power: Array, peak: int) -> float:
    """Where between two cells the peak lies, as a share of a cell."""
    if not 0 < peak < len(power) - 1:
        return 0.0
    before, at, after = np.log(np.maximum(power[peak - 1 : peak + 2], 1e-300))
    bend = before - 2 * at + after
    return float(0.5 * (before - after) / bend) if bend < 0 else 0.0


def _refuse_alias(omega: float, step: float, time: Array, z: Complexes) -> None:
    """Raise InvalidInput where the swing may be an alias of a faster one.

    Beside too few points to a swing, two things give it away: a length that no pendulum has, and
    times with jitter, which tell a frequency from its aliases.
    """
    points = 2 * np.pi / (omega * step)
    seen: dict[str, Any] = {"points": points, "period": (2 * np.pi / omega, "s")}
    if points < LEAST_POINTS or 9.81 / omega**2 > _LONGEST:
        raise InvalidInput.of("track_aliased", **seen)
    last = float(time[0]) + 8 * 2 * np.pi / omega
    end = int(np.searchsorted(time, last))
    time, z = time[:end] - time[0], z[:end]
    if len(time) < 12:
        return
    rest: dict[float, float] = {}
    sampling = 2 * np.pi / step
    for candidate in (omega, sampling - omega, sampling + omega):
        turn = np.exp(1j * candidate * time)
        basis = np.stack([turn, turn.conj(), np.ones_like(turn)], axis=1)
        found, *_ = np.linalg.lstsq(basis, z, rcond=None)
        rest[candidate] = float(np.sum(np.abs(z - basis @ found) ** 2))
    best = min(rest, key=rest.__getitem__)
    explained = rest[best] < 0.1 * float(np.sum(np.abs(z - z.mean()) ** 2))
    if best != omega and explained and rest[best] < 0.5 * rest[omega]:
        raise InvalidInput.of("track_aliased", **seen)
