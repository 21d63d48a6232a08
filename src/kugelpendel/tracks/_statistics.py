"""Quantiles that SciPy has, with types that it does not have."""

from __future__ import annotations

from typing import Any


def student(degrees: float) -> float:
    """Student's t at 97.5 %: half the width of a 95 % interval in standard errors."""
    return float(_special().stdtrit(max(degrees, 1), 0.975))


def chi_square_limit(degrees: int) -> float:
    """The χ² that is passed by chance in one case of twenty."""
    return float(_special().chdtri(max(degrees, 1), 0.05))


def chi_square_tail(chi_square: float, degrees: int) -> float:
    """The probability of a χ² as large as this by chance."""
    return float(_special().chdtrc(max(degrees, 1), chi_square))


def _special() -> Any:
    import scipy.special  # pyright: ignore[reportMissingTypeStubs]

    return scipy.special
