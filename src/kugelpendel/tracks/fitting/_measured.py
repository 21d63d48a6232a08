"""The azimuth alone, with the size and the shape of the ellipse as they were measured.

Recorded decays are often no γ + c; then a model of a(t) is wrong, and what it gets wrong goes into
the rates of the plane. Here it need not be right: ψ' depends on a, b and ψ, and all are measured.
"""

from __future__ import annotations

import numpy as np

from kugelpendel.motion import EnvelopeMotion, ExactMotion
from kugelpendel.parameters import Launch, Numbers, Pendulum, Suspension
from kugelpendel.tracks._scipy import running_integral
from kugelpendel.tracks.fitting._intervals import NOTHING, Judge
from kugelpendel.tracks.fitting._linear import linear
from kugelpendel.tracks.fitting._model import IDEAL, SHAPE, Measured
from kugelpendel.tracks.fitting._results import FittedModel
from kugelpendel.tracks.fitting._search import correlation

_UNEVEN = 1e-6
"""δ/ω0 at which its share of the rate is read off: small, as the share is linear in it."""


def azimuth_alone(
    name: str, measured: Measured, judge: Judge, with_anisotropy: bool
) -> FittedModel:
    """ψ = ψ0 − Ω_z t + κ∫ω0 ab/l² dt, and where asked for what δ makes, by linear least squares.

    Parameters
    ----------
    name
        The model's.
    measured
        What is fitted.
    judge
        For intervals. Those of this model have √(χ²/ndof) multiplied in where it is above 1: it
        is an empirical one, and its χ² says how far it is from the truth.
    with_anisotropy
        Whether δ cos 2χ and δ sin 2χ are free as well.
    """
    rates = _rates(measured, with_anisotropy)
    time = measured.time
    columns = {"azimuth": np.ones_like(time), "rotation": -time} | {
        each: _integrated(time, rate) for each, rate in rates.items()
    }
    error = np.sqrt(np.linalg.inv(measured.whitening.swapaxes(1, 2) @ measured.whitening)[:, 2, 2])
    azimuth = measured.values[:, 2]
    line = linear(list(columns.values()), azimuth, error)
    widened = judge.widened(line.rest[None], line.chi_square, line.degrees)
    factor = max(widened, float(np.sqrt(line.ratio)))
    t = judge.quantile(line.degrees)
    stderr = factor * np.sqrt(np.diag(line.covariance))
    parameters = {
        each: judge.estimated(each, float(value), float(error_), t)
        for each, value, error_ in zip(columns, line.found, stderr, strict=True)
    }
    nothing = np.full(len(time), NOTHING)
    return FittedModel(
        name, parameters, correlation(line.covariance), line.chi_square, line.degrees,
        not np.isfinite(line.found).all(), judge.time, nothing, nothing,
        azimuth - line.rest * error, nothing, nothing, line.rest * error,
    )  # fmt: skip


def _rates(measured: Measured, with_anisotropy: bool) -> dict[str, Numbers]:
    """Rate of the plane in each window per unit of κ, of δ cos 2χ and δ sin 2χ, by the core."""
    a, b, azimuth = measured.values.T
    middle = int(np.argmin(np.abs(measured.time)))
    centre = {name: float(measured.values[middle, k]) for k, name in enumerate(SHAPE)}
    lengths, gravities, omega0 = measured.pendulum(measured.row(centre)[None])
    pendulum = Pendulum(float(lengths[0]), float(gravities[0]))
    b = np.clip(b, -0.999 * a, 0.999 * a)
    turned: Numbers = azimuth - np.pi * np.rint(azimuth / np.pi)
    launch = Launch.apsides(a, b, turned)
    rates: dict[str, Numbers] = {
        "intrinsic": np.asarray(ExactMotion(pendulum, launch).precession) / IDEAL
    }
    if with_anisotropy:
        delta = _UNEVEN * float(omega0[0])
        for each, axis in (("anisotropy_cos", 0.0), ("anisotropy_sin", np.pi / 4)):
            motion = EnvelopeMotion(pendulum, launch, suspension=Suspension(delta, axis))
            rates[each] = np.asarray(motion.rates(0.0).anisotropy) / delta
    return rates


def _integrated(time: Numbers, rate: Numbers) -> Numbers:
    """∫ rate dt from t = 0 by trapezoids."""
    whole = running_integral(time, rate)
    return whole - np.interp(0.0, time, whole)
