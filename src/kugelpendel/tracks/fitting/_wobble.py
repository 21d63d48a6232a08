"""How evenly the plane turns, without a model of why."""

from __future__ import annotations

from typing import Any

import numpy as np

from kugelpendel.parameters import Numbers
from kugelpendel.tracks._scipy import running_integral
from kugelpendel.tracks.fitting._intervals import correlations
from kugelpendel.tracks.fitting._linear import linear
from kugelpendel.tracks.fitting._results import Wobble
from kugelpendel.tracks.reduction import column

_LEAST = 12
"""Windows that a mean rate with its correlation needs."""


def wobble(ellipses: Any) -> Wobble | None:
    """The mean rate with an honest error, and what of its changes goes with 2ψ and 4ψ.

    The azimuth is fitted with a straight line, κ∫ab dt, and the integrals of cos 2ψ, sin 2ψ,
    cos 4ψ, sin 4ψ over time, with a, b and ψ as they were measured. The rate is the slope of the
    straight line alone.

    Parameters
    ----------
    ellipses
        As `fit` got them. None for fewer than twelve windows.
    """
    time, azimuth = column(ellipses, "time"), column(ellipses, "azimuth")
    error = column(ellipses, "azimuth_stderr")
    if len(time) < _LEAST:
        return None
    apart = time - time.mean()
    line = [np.ones_like(time), apart]
    fitted = linear(line, azimuth, error)
    slope, rest = float(fitted.found[1]), fitted.rest
    weights = apart / error**2
    naive = _slope_error(rest, apart, error)
    turned = float(np.ptp(azimuth))
    shares, sizes = [float("nan")] * 2, [float("nan")] * 2
    if turned > np.pi:
        bent = column(ellipses, "a") * column(ellipses, "b")
        columns = [*line, running_integral(time, bent / max(float(np.abs(bent).max()), 1e-300))]
        whole = linear(columns, azimuth, error).chi_square
        for k, order in enumerate((2, 4)):
            waves = np.cos(order * azimuth), np.sin(order * azimuth)
            columns += [running_integral(time, wave) for wave in waves]
            fitted = linear(columns, azimuth, error)
            shares[k] = 1.0 - fitted.chi_square / whole
        rest, found = fitted.rest, fitted.found
        sizes = [float(np.hypot(*found[3:5])), float(np.hypot(*found[5:7]))]
    correlated = _slope_error(rest, apart, error) * _correlation(rest, weights)
    return Wobble(slope, max(correlated, naive), naive, turned, *shares, *sizes)


def _slope_error(rest: Numbers, apart: Numbers, error: Numbers) -> float:
    """Standard error of the slope if the residuals were independent, by their own size."""
    spread = float(np.sqrt(rest @ rest / (len(rest) - 2)))
    return spread / float(np.sqrt(np.sum((apart / error) ** 2)))


def _correlation(rest: Numbers, weights: Numbers) -> float:
    """By what the correlation of the residuals multiplies the error of a slope.

    The variance of Σ wᵢrᵢ is Σₖ ρₖ Σᵢ wᵢwᵢ₊ₖ: a ramp is alike to itself over a third of its length
    only, so slow residuals count less than in a mean.
    """
    rho = correlations(rest)
    size = 2 * len(weights)
    alike = np.fft.irfft(np.abs(np.fft.rfft(weights, size)) ** 2, size)[: len(rho)]
    return float(np.sqrt(max(1.0 + 2.0 * np.sum(rho[1:] * alike[1:]) / alike[0], 1.0)))
