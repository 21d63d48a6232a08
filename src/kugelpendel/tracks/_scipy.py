"""What SciPy does for tracks, with the types that it does not have; imported when it is needed."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np

from kugelpendel.parameters import Numbers


def student(degrees: float) -> float:
    """Student's t at 97.5 %: half the width of a 95 % interval in standard errors."""
    return float(_part("special").stdtrit(max(degrees, 1), 0.975))


def chi_square_limit(degrees: int) -> float:
    """The χ² that is passed by chance in one case of twenty."""
    return float(_part("special").chdtri(max(degrees, 1), 0.05))


def chi_square_tail(chi_square: float, degrees: int) -> float:
    """The probability of a χ² as large as this by chance."""
    return float(_part("special").chdtrc(max(degrees, 1), chi_square))


def fast_size(least: int) -> int:
    """A size not below this one whose Fourier transform is fast."""
    return int(_part("fft").next_fast_len(least))


def first_order(new: Numbers, memory: float) -> Numbers:
    """A series of which each value is `memory` times the last, and what is new."""
    return np.asarray(_part("signal").lfilter([1.0], [1.0, -memory], new), dtype=float)


def running_integral(time: Numbers, rate: Numbers) -> Numbers:
    """∫ rate dt from the first time to each, by trapezoids."""
    summed = _part("integrate").cumulative_trapezoid(rate, time, initial=0.0)
    return np.asarray(summed, dtype=float)


def spline(grid: Numbers, values: Numbers, times: Numbers) -> Numbers:
    """Cubic interpolation along the second axis."""
    return np.asarray(_part("interpolate").CubicSpline(grid, values, axis=1)(times), dtype=float)


def least_squares(
    residuals: Callable[[Numbers], Numbers],
    jacobian: Callable[[Numbers], Numbers],
    start: Numbers,
    scale: Numbers,
    most: int,
    close: float,
) -> tuple[Numbers, bool]:
    """Where the sum of the squares is least, and whether an end was found.

    It ends where the sum falls by less than a share `close` of itself. Raises ValueError where the
    residuals at the start are not finite.
    """
    result: Any = _part("optimize").least_squares(
        residuals, start, jacobian, method="trf", x_scale=scale, max_nfev=most, xtol=1e-8,
        ftol=close, gtol=1e-8,
    )  # fmt: skip
    return np.asarray(result.x, dtype=float), bool(result.status > 0)


def _part(name: str) -> Any:
    return import_module(f"scipy.{name}")
