"""The averaged motion as a track's windows would see it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from kugelpendel import _core
from kugelpendel.parameters import Numbers
from kugelpendel.tracks._scipy import spline

SHAPE = ("a", "b", "azimuth")
ANISOTROPY = ("anisotropy_cos", "anisotropy_sin")
FORCES = ("rotation", "linear", "quadratic", *ANISOTROPY)
DAMPING = ("damping_anisotropy_cos", "damping_anisotropy_sin")
TILT = ("tilt_cos", "tilt_sin")
INTRINSIC = "intrinsic"

ALL = (*SHAPE, *FORCES, *DAMPING, *TILT, INTRINSIC)
"""Every parameter that a fit can have, in the order of the model's rows."""

_PLACE = {name: index for index, name in enumerate(ALL)}

_NODES, _SMOOTH = 200, 600.0
"""Times at which a long record is read: at least so many, and one in so many seconds."""

IDEAL = 0.375
"""κ of an ideal pendulum."""


@dataclass(frozen=True)
class Measured:
    """The ellipses that a model is fitted to.

    Attributes
    ----------
    time
        Of the windows, s, counted from t0.
    spread
        Standard deviation of the times within each window, s.
    values
        a, b in m and azimuth in rad, shape (windows, 3).
    whitening
        Lᵀ of C⁻¹ = L Lᵀ, shape (windows, 3, 3).
    frequency
        ω at t0, rad/s.
    gravity, length
        m/s² and m; the length may be None, and follows then from frequency and gravity.
    """

    time: Numbers
    spread: Numbers
    values: Numbers
    whitening: Numbers
    frequency: float
    gravity: float
    length: float | None
    nodes: Numbers = field(init=False)

    def __post_init__(self) -> None:
        both = np.stack([self.time - self.spread, self.time + self.spread])
        object.__setattr__(self, "nodes", both)

    def near(self, middle: int, count: int) -> Measured:
        """So many windows about one of them; all where there are no more."""
        some = slice(max(middle - count // 2, 0), middle + (count + 1) // 2)
        return replace(
            self, time=self.time[some], spread=self.spread[some], values=self.values[some],
            whitening=self.whitening[some],
        )  # fmt: skip

    def pendulum(self, rows: Numbers) -> tuple[Numbers, Numbers, Numbers]:
        """Length, gravity and ω0 (mean of the two axes) of every set of parameters.

        The frequency of a track is known far better than all else, so ω0 is no parameter: it is
        what makes the model swing with the measured ω at t0. With Θ' of docs/conventions.md,
        ω0 = ω + ω0(a² + b²)/16l² and what the suspension adds; three rounds suffice.
        """
        a, b, azimuth = _columns(rows, SHAPE)
        cos, sin = _columns(rows, ANISOTROPY)
        lost_cos, lost_sin = _columns(rows, DAMPING)
        share = cos * np.cos(2 * azimuth) + sin * np.sin(2 * azimuth)
        lost = lost_cos * np.sin(2 * azimuth) - lost_sin * np.cos(2 * azimuth)
        apart = np.maximum(a**2 - b**2, 1e-12 * a**2)
        added = 0.5 * (a**2 + b**2) / apart * share - a * b / apart * lost
        stiff = 0.5 * np.hypot(cos, sin)
        omega0 = np.full(len(rows), self.frequency)
        for _ in range(3):
            across = omega0 - stiff
            length = self.gravity / across**2 if self.length is None else self.length
            omega0 = self.frequency + omega0 * (a**2 + b**2) / (16 * length**2) - added
        across = omega0 - stiff
        if self.length is None:
            return self.gravity / across**2, np.full(len(rows), float(self.gravity)), omega0
        return np.full(len(rows), float(self.length)), self.length * across**2, omega0

    def predicted(self, rows: Numbers) -> Numbers:
        """a, b and azimuth of every window, for every set of parameters.

        Parameters
        ----------
        rows
            In the order of `ALL`, shape (sets, parameters).

        Returns
        -------
        Shape (sets, windows, 3); NaN for sets that no motion has. A window gives the mean of the
        two circles over its times: two nodes a standard deviation from the middle have it to second
        order. a and b are those of the fundamental, as tracks are fitted by one frequency.
        """
        length, gravity, _ = self.pendulum(rows)
        a, b, azimuth = _columns(rows, SHAPE)
        turn, linear, quadratic, *_ = _columns(rows, FORCES)
        azimuth = azimuth - np.pi * np.rint(azimuth / np.pi)  # a record may turn many times
        stiff, lossy, tilt = (
            cos + 1j * sin for cos, sin in (_columns(rows, q) for q in (ANISOTROPY, DAMPING, TILT))
        )
        (intrinsic,) = _columns(rows, (INTRINSIC,))
        columns = (
            length, gravity, a, b, azimuth, linear, quadratic, turn, np.abs(stiff),
            np.angle(stiff) / 2, np.abs(lossy), np.angle(lossy) / 2, intrinsic / IDEAL,
        )  # fmt: skip
        times, back = np.unique(self.nodes, return_inverse=True)
        columns = [np.ascontiguousarray(column) for column in columns]
        found = self._read(len(rows), columns, times)[:, back.reshape(self.nodes.shape)]
        a, b, azimuth = np.moveaxis(found, -1, 0)  # (sets, two nodes, windows)
        direction = np.exp(1j * azimuth)
        ahead, behind = 0.5 * (a + b) * direction, 0.5 * (a - b) * direction
        # A camera that looks askew: z + η z̄, η half the difference of the scales along its axis.
        eta = 0.5 * tilt[:, None, None]
        seen = ahead + eta * behind.conj(), behind + eta * ahead.conj()
        ahead, behind = (circle.mean(axis=1) for circle in seen)
        p, q = np.abs(ahead), np.abs(behind)
        return np.stack([p + q, p - q, 0.5 * np.angle(ahead * behind)], axis=-1)

    def _read(self, count: int, columns: list[Numbers], times: Numbers) -> Numbers:
        """Radii and azimuths at ascending times, shape (count, times, 3).

        Of a long record they are read at some hundreds of times, and a cubic spline goes through
        them: in ten minutes an ellipse changes little, and its error is the fourth power of that.
        """
        whole = float(times[-1] - times[0])
        grid: Numbers = np.linspace(
            float(times[0]), float(times[-1]), max(_NODES, int(whole / _SMOOTH))
        )
        if len(times) < 2 * len(grid):
            return _core.averaged_fundamentals(count, columns, times).reshape(count, len(times), 3)
        read = _core.averaged_fundamentals(count, columns, grid).reshape(count, len(grid), 3)
        found = np.full((count, len(times), 3), np.nan)
        good = np.isfinite(read).all(axis=(1, 2))
        if good.any():
            found[good] = spline(grid, read[good], times)
        return found

    def differences(self, predicted: Numbers) -> Numbers:
        """Measured less model, the azimuth modulo half a turn."""
        apart = self.values - predicted
        apart[..., 2] -= np.pi * np.rint(apart[..., 2] / np.pi)
        return apart

    def whitened(self, apart: Numbers) -> Numbers:
        """Differences in units of their errors and independent, flat: shape (…, 3·windows)."""
        white = (self.whitening @ apart[..., None])[..., 0]
        return white.reshape((*apart.shape[:-2], -1))

    def row(self, given: dict[str, float]) -> Numbers:
        """A set of parameters; what is not given is 0, and κ 3/8."""
        row = np.zeros(len(ALL))
        row[_PLACE[INTRINSIC]] = IDEAL
        for name, value in given.items():
            row[_PLACE[name]] = value
        return row

    def steps(self) -> Numbers:
        """Steps of the derivatives, far above rounding and far below what bends: as `ALL`."""
        size, omega = float(np.median(self.values[:, 0])), self.frequency
        whole = max(float(np.ptp(self.time)), 1.0)
        shape = (1e-5 * size, 1e-5 * size, 1e-5)
        rate = 1e-4 / whole
        forces = (rate, rate, 4 * rate / (omega * size), rate, rate)
        return np.array([*shape, *forces, rate, rate, 1e-5, 1e-5, 1e-5])


def _columns(rows: Numbers, names: Sequence[str]) -> list[Numbers]:
    """The parameters of these names, of every set."""
    return [rows[..., _PLACE[name]] for name in names]
