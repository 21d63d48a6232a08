"""Least squares of one model, with nuisances of a stated size."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kugelpendel.parameters import Numbers
from kugelpendel.tracks._scipy import least_squares
from kugelpendel.tracks.fitting._model import ALL, Measured

_MOST = 30
"""Evaluations of a model before a fit is said to have failed; 5 to 10 are usual."""

_CLOSE = 1e-3
"""A search ends where χ² of a model that fits falls by less than this: by 3 % of a standard error
that is, and by far less in truth, as the steps converge faster and faster."""


@dataclass(frozen=True)
class Found:
    """A minimum.

    Attributes
    ----------
    names
        Of the free parameters.
    row
        All parameters, in the order of `ALL`.
    covariance
        (JᵀJ)⁻¹ of the free ones; infinite where they cannot be told apart.
    chi_square, degrees
        Nuisances count as data.
    failed
        Whether no end was found.
    """

    names: tuple[str, ...]
    row: Numbers
    covariance: Numbers
    chi_square: float
    degrees: int
    failed: bool

    def value(self, name: str) -> float:
        """The parameter of this name, free or not."""
        return float(self.row[ALL.index(name)])

    def stderr(self, name: str) -> float:
        """Its standard error; 0 if it was not free."""
        if name not in self.names:
            return 0.0
        k = self.names.index(name)
        return float(np.sqrt(self.covariance[k, k]))


def search(
    measured: Measured, start: Numbers, names: Sequence[str], sizes: Mapping[str, float]
) -> Found:
    """The least-squares fit from a start.

    Parameters
    ----------
    measured
        The ellipses.
    start
        All parameters; those that are not free stay as they are.
    names
        The free ones.
    sizes
        Standard deviations about 0 of those that have a stated size.
    """
    free = np.array([ALL.index(name) for name in names])
    held = [k for k, name in enumerate(names) if name in sizes]
    widths = np.array([sizes[names[k]] for k in held])
    steps = measured.steps()[free]
    known: dict[bytes, tuple[Numbers, Numbers]] = {}

    def both(x: Numbers) -> tuple[Numbers, Numbers]:
        """Residuals and their derivatives, from one ensemble."""
        key = x.tobytes()
        if key not in known:
            rows = np.tile(start, (len(x) + 1, 1))
            rows[:, free] = x
            rows[1 + np.arange(len(x)), free] += steps
            white = measured.whitened(measured.differences(measured.predicted(rows)))
            slopes = ((white[1:] - white[0]) / steps[:, None]).T
            prior = np.zeros((len(held), len(x)))
            prior[np.arange(len(held)), held] = 1 / widths
            known.clear()
            known[key] = (
                np.concatenate([white[0], x[held] / widths]),
                np.concatenate([slopes, prior]),
            )
        return known[key]

    def residuals(x: Numbers) -> Numbers:
        return both(x)[0]

    def jacobian_of(x: Numbers) -> Numbers:
        return both(x)[1]

    guess = start[free]
    scale = np.maximum(steps * 1e3, 1e-12)
    try:
        x, ended = least_squares(
            residuals, jacobian_of, guess, scale, _MOST, _CLOSE / (3 * len(measured.time))
        )
    except (ValueError, np.linalg.LinAlgError):  # the start itself is no motion
        x, ended = guess, False
    rest, jacobian = both(x)
    row = start.copy()
    row[free] = x
    degrees = len(rest) - len(x)
    covariance = inverse(jacobian)
    return Found(
        tuple(names), row, covariance, float(rest @ rest), degrees,
        not ended or not np.isfinite(rest).all(),
    )  # fmt: skip


def correlation(covariance: Numbers) -> Numbers:
    """The correlations of a covariance; NaN where it is infinite."""
    size = np.sqrt(np.diag(covariance))
    known = np.isfinite(size) & (size > 0)
    out = np.full(covariance.shape, np.nan)
    some = np.ix_(known, known)
    out[some] = covariance[some] / np.outer(size[known], size[known])
    return out


def inverse(jacobian: Numbers) -> Numbers:
    """(JᵀJ)⁻¹, by scaled columns; infinite on the diagonal where it does not exist."""
    count = jacobian.shape[1]
    nothing = np.full((count, count), np.nan)
    np.fill_diagonal(nothing, np.inf)
    if not np.isfinite(jacobian).all():
        return nothing
    size = np.linalg.norm(jacobian, axis=0)
    if (size == 0).any():
        return nothing
    _, values, back = np.linalg.svd(jacobian / size, full_matrices=False)
    if values[-1] < 1e-10 * values[0]:
        return nothing
    root = back / values[:, None]
    return (root.T @ root) / np.outer(size, size)
