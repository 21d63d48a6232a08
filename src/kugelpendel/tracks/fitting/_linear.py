"""Weighted linear least squares."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from kugelpendel.parameters import Numbers
from kugelpendel.tracks.fitting._search import inverse


@dataclass(frozen=True)
class LinearFit:
    """What the least squares of a linear model give.

    Attributes
    ----------
    found
        The coefficients.
    covariance
        Of them, as the errors have it; infinite where they cannot be told apart.
    rest
        Residuals in units of their errors.
    """

    found: Numbers
    covariance: Numbers
    rest: Numbers

    @property
    def chi_square(self) -> float:
        """The sum of the squares of the residuals."""
        return float(self.rest @ self.rest)

    @property
    def degrees(self) -> int:
        """How many values there are more than coefficients; at least 1."""
        return max(len(self.rest) - len(self.found), 1)

    @property
    def ratio(self) -> float:
        """χ²/ndof where it is above 1, and else 1."""
        return max(self.chi_square / self.degrees, 1.0)


def linear(columns: Sequence[Numbers], values: Numbers, error: Numbers) -> LinearFit:
    """The sum of columns, each times a coefficient, that comes nearest to values with errors."""
    design = np.stack(columns, axis=1) / error[:, None]
    size = np.linalg.norm(design, axis=0) + 1e-300
    solve: Any = np.linalg.lstsq
    found = np.asarray(solve(design / size, values / error, rcond=None)[0], dtype=float) / size
    return LinearFit(found, inverse(design), values / error - design @ found)
