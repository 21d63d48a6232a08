"""Intervals, and the judgement whether a number is one."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from kugelpendel import _core
from kugelpendel.parameters import Numbers
from kugelpendel.tracks._scipy import chi_square_tail, student
from kugelpendel.tracks.fitting._model import DAMPING, INTRINSIC, Measured
from kugelpendel.tracks.fitting._results import Estimate, FittedModel, Reason
from kugelpendel.tracks.fitting._search import Found, correlation
from kugelpendel.tracks.reduction import column, polynomial

UNITS = {
    "azimuth": "rad",
    "rotation": "rad/s",
    "linear": "1/s",
    "anisotropy_cos": "rad/s",
    "anisotropy_sin": "rad/s",
    "damping_anisotropy_cos": "1/s",
    "damping_anisotropy_sin": "1/s",
}

NOTHING = float("nan")

_UNEVEN = 0.1
"""Share of ω0 beyond which no suspension is uneven, and the averages do not hold."""

_SURPRISE = 1e-3
"""A χ² that is less probable than this is a misfit."""


class Judge:
    """Makes estimates of minima, in the units of the track.

    Parameters
    ----------
    measured
        What was fitted.
    scale
        Metres per unit of the track.
    ellipses
        As `fit` got them.
    scaled
        Whether the track is in metres.
    """

    def __init__(self, measured: Measured, scale: float, ellipses: Any, scaled: bool):
        self._measured, self._scale, self._scaled = measured, scale, scaled
        self.unit = str(ellipses.attrs["unit"])
        self._is_table = ellipses.attrs["origin"] == "table"
        self._cells = int(ellipses.attrs.get("cells", 0))
        self.time = column(ellipses, "time")

    def quantile(self, degrees: int) -> float:
        """Student's t at 97.5 %: the noise is known from the cells of its spectrum."""
        return student(max(2 * self._cells if self._cells else degrees, 2))

    def widened(self, residuals: Numbers, chi_square: float, degrees: int) -> float:
        """By what errors are multiplied: 1 where the residuals are no larger than the noise.

        √(χ²/ndof) where they are, as then the model or the noise is not what it should be; of a
        table always, and with the correlation of the residuals, as its errors are from its scatter.

        Parameters
        ----------
        residuals
            In units of their errors, in the order of time; shape (…, windows).
        chi_square, degrees
            Of the fit.
        """
        ratio = max(chi_square / max(degrees, 1), 1.0)
        if self._is_table:
            return float(np.sqrt(ratio * max(correlation_time(row) for row in residuals)))
        return float(np.sqrt(ratio)) if is_misfit(chi_square, degrees) else 1.0

    def estimate(
        self, value: float, stderr: float, t: float, unit: str, span: tuple[float, float]
    ) -> Estimate:
        """A number with its interval, or none where that does not close inside its range."""
        low, high = value - t * stderr, value + t * stderr
        reason: Reason = ""
        if not np.isfinite(stderr) or 2 * t * stderr >= span[1] - span[0]:
            reason = "wide"
        elif high < span[0] or low > span[1]:
            reason = "outside"
        return undetermined(unit, reason) if reason else Estimate(value, stderr, low, high, unit)

    def estimated(self, name: str, value: float, stderr: float, t: float) -> Estimate:
        """As `estimate`, of a parameter in metres, by its name."""
        unit, scale = self._unit(name), 1.0
        if name in ("a", "b"):
            scale = 1 / self._scale
        elif name == "quadratic":
            scale = self._scale
        if name == INTRINSIC and not self._scaled:
            return undetermined(unit, "scale")
        return self.estimate(value * scale, stderr * scale, t, unit, self._range(name))

    def model(self, name: str, found: Found, stated: tuple[str, ...]) -> FittedModel:
        """The result of one search.

        Parameters
        ----------
        name
            The model's.
        found
            The minimum.
        stated
            Nuisances of a stated size.
        """
        measured = self._measured
        predicted = measured.predicted(found.row[None])[0]
        apart = measured.differences(predicted)
        white = measured.whitened(apart).reshape(-1, 3).T
        factor = self.widened(white, found.chi_square, found.degrees)
        t = self.quantile(found.degrees)
        parameters = {
            each: self._one(found, each, factor, t, each in stated) for each in found.names
        }
        parameters |= self._derived(found, factor, t)
        scale = self._scale
        azimuth = measured.values[:, 2] - apart[:, 2]
        return FittedModel(
            name, parameters, correlation(found.covariance), found.chi_square,
            found.degrees, found.failed, self.time, predicted[:, 0] / scale,
            predicted[:, 1] / scale, azimuth, apart[:, 0] / scale, apart[:, 1] / scale, apart[:, 2],
        )  # fmt: skip

    def _one(self, found: Found, name: str, factor: float, t: float, stated: bool) -> Estimate:
        if found.failed:
            return undetermined(self._unit(name), "failed")
        value, stderr = found.value(name), factor * found.stderr(name)
        if stated:
            everything = -np.inf, np.inf
            one = self.estimate(value, stderr, t, self._unit(name), everything)
            return replace(one, verdict="nuisance")
        return self.estimated(name, value, stderr, t)

    def _unit(self, name: str) -> str:
        if name in ("a", "b"):
            return self.unit
        return f"1/{self.unit}" if name == "quadratic" else UNITS.get(name, "")

    def _range(self, name: str) -> tuple[float, float]:
        """Within which a parameter is physical."""
        if name == "rotation":
            return -_core.ROTATION, _core.ROTATION
        if name == INTRINSIC:
            return 0.0, 1.0
        if name in ("linear", "quadratic"):
            return 0.0, np.inf
        if name in DAMPING:
            a = np.log(self._measured.values[:, 0])
            decay = abs(float(polynomial(self._measured.time, a, 1)[1]))
            return -2 * decay, 2 * decay
        if name in ("anisotropy_cos", "anisotropy_sin"):
            return -_UNEVEN * self._measured.frequency, _UNEVEN * self._measured.frequency
        return -np.inf, np.inf

    def _derived(self, found: Found, factor: float, t: float) -> dict[str, Estimate]:
        """Latitude, and the suspension's |δ| and χ."""
        out: dict[str, Estimate] = {}
        if "rotation" in found.names and not found.failed:
            out["latitude"] = self._latitude(found, factor, t)
        if "anisotropy_cos" in found.names:
            out |= self._anisotropy(found, factor, t)
        return out

    def _latitude(self, found: Found, factor: float, t: float) -> Estimate:
        value, stderr = found.value("rotation"), factor * found.stderr("rotation")
        rotation = self.estimate(value, stderr, t, "rad/s", self._range("rotation"))
        if rotation.verdict != "determined":
            return undetermined("rad", rotation.reason)
        limits = np.clip([value, rotation.low, rotation.high], -_core.ROTATION, _core.ROTATION)
        angle, low, high = np.arcsin(limits / _core.ROTATION)
        return Estimate(float(angle), float(high - low) / (2 * t), float(low), float(high), "rad")

    def _anisotropy(self, found: Found, factor: float, t: float) -> dict[str, Estimate]:
        """|δ| by its profile's upper limit where it is not told from 0: it cannot be negative."""
        if found.failed:
            return {
                "anisotropy": undetermined("rad/s", "failed"),
                "axis": undetermined("rad", "failed"),
            }
        k = found.names.index("anisotropy_cos")
        cos, sin = found.value("anisotropy_cos"), found.value("anisotropy_sin")
        block = factor**2 * found.covariance[k : k + 2, k : k + 2]
        size = float(np.hypot(cos, sin))
        along = np.array([cos, sin]) / (size or 1.0)
        across = np.array([-along[1], along[0]])
        stderr, turned = (float(np.sqrt(way @ block @ way)) for way in (along, across))
        if not np.isfinite(block).all():
            return {
                "anisotropy": undetermined("rad/s", "wide"),
                "axis": undetermined("rad", "wide"),
            }
        largest = float(np.sqrt(np.linalg.eigvalsh(block)[-1]))
        if size < 2 * largest:
            upper = size + t * largest
            modulus = Estimate(NOTHING, NOTHING, 0.0, upper, "rad/s", "not determined", "modulus")
            return {"anisotropy": modulus, "axis": undetermined("rad", "modulus")}
        axis, error = float(np.arctan2(sin, cos)) / 2, turned / (2 * size)
        return {
            "anisotropy": Estimate(size, stderr, size - t * stderr, size + t * stderr, "rad/s"),
            "axis": Estimate(axis, error, axis - t * error, axis + t * error, "rad"),
        }


def is_misfit(chi_square: float, degrees: int) -> bool:
    """Whether a χ² as large as this has a probability below one in a thousand."""
    return not chi_square_tail(chi_square, degrees) > _SURPRISE


def undetermined(unit: str, reason: Reason) -> Estimate:
    """An estimate without a number."""
    return Estimate(NOTHING, NOTHING, NOTHING, NOTHING, unit, "not determined", reason)


def correlation_time(values: Numbers) -> float:
    """By how much the variance of a mean is larger than of independent values: 1 + 2Σρ."""
    return float(max(1.0 + 2.0 * np.sum(correlations(values)[1:]), 1.0))


def correlations(values: Numbers) -> Numbers:
    """ρ of the lags from 0 on, as far as they stand out of the noise.

    They end before the first pair of lags whose correlations add to less than 0 (Geyer,
    Statistical Science 7, 473 (1992), initial positive sequence).
    """
    values = values - values.mean()
    power = float(values @ values)
    if power == 0 or len(values) < 4:
        return np.ones(1)
    size = 2 * len(values)
    rho = np.fft.irfft(np.abs(np.fft.rfft(values, size)) ** 2, size)[: len(values)] / power
    pairs = rho[1:-1:2] + rho[2::2][: len(rho[1:-1:2])]
    ends = np.flatnonzero(pairs < 0)
    return rho[: 1 + 2 * int(ends[0])] if len(ends) else rho
