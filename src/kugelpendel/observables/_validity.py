"""How good the formulas for small ellipses are: their errors against the exact motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core, series
from kugelpendel.motion import ExactMotion
from kugelpendel.parameters import (
    InvalidInput,
    Launch,
    Numbers,
    Pendulum,
    Scalars,
    as_array,
    as_numbers,
    column,
    one_number,
)

ORDERS = (2, 4, 6, 8, 10, 12)
"""Orders of the series that are judged."""

LEVELS = (1e-4, 1e-3, 1e-2, 1e-1)
"""Relative errors that reports and figures name: 0.01 %, 0.1 %, 1 %, 10 %."""

_MOST = 4000
"""Points along one side of a map: 16 million motions, whose errors take 2 GB."""

_TOGETHER = 1 << 17
"""Motions of a map that are solved together."""


class SeriesErrors(NamedTuple):
    """Relative errors of the series of one order, signed: approximate over exact, less 1."""

    precession: Scalars
    frequency: Scalars


@dataclass(frozen=True)
class Validity:
    """Relative errors, signed: approximate over exact, less 1.

    Attributes
    ----------
    formula_25
        Of the precession by Olsson's (25); 0.003 is 0.3 %.
    formula_26
        Of the frequency by (26).
    series
        Of precession and frequency by the series, by its order: 2, 4, … 12. That of order 2 is
        (25), and (26) but for its square root.
    """

    formula_25: Scalars
    formula_26: Scalars
    series: Mapping[int, SeriesErrors]


@dataclass(frozen=True)
class ValidityMap:
    """Errors for all ellipses below the support: axis 0 runs along b/a, axis 1 along a/l.

    Attributes
    ----------
    a_over_l, b_over_a
        (n,) arrays; b/a begins with 0, the limit of narrow ellipses, and ends with 1, the cone.
    errors
        With arrays of shape (n, n).
    """

    a_over_l: Numbers
    b_over_a: Numbers
    errors: Validity

    def reach(self, error: Scalars, level: float) -> float:
        """Up to which a/l no ellipse of any width has a larger error than `level`.

        `error` is one of those in `errors`. Between two sizes of the map it counts as a power of
        a/l. 0 where the smallest ellipses of the map exceed the level, infinite where none does.
        Raises InvalidInput for an error of another shape, and a level that is no number.
        """
        errors = as_array(error, "The error", "")
        if errors.shape != (len(self.b_over_a), len(self.a_over_l)):
            raise InvalidInput(
                f"The error must be one of the map's, such as map.errors.formula_25, but its shape "
                f"is {errors.shape}."
            )
        worst = np.abs(errors).max(axis=0)
        return _core.reach(self.a_over_l, worst, one_number(level, "The level", ""))


def validity(a: ArrayLike, b: ArrayLike, length: ArrayLike) -> Validity:
    """How far the formulas for small ellipses are off, for one pendulum or many.

    Parameters
    ----------
    a, b
        m, exact turning radii, |b| ≤ a < length; they broadcast. The sign of b does not matter.
        For b = 0, where nothing precesses, the errors are the limits b → 0.
    length
        m, of the pendulum. Gravity does not matter.

    Returns
    -------
    Relative errors, floats or arrays in the common shape; 0 where a is below 1e-9 l.

    Raises
    ------
    InvalidInput
        For a single ellipse that is not finite or does not fit below the support. In arrays a bad
        case gives NaN.

    Notes
    -----
    The exact rates have a relative error of 4e-16, so that much of these is noise. They are no
    bound for the error of a position, which grows with the time: see `compare`.
    """
    pendulum = Pendulum(length)
    given = as_numbers(a, "The turning radius a", "m"), as_numbers(b, "The turning radius b", "m")
    shape = np.broadcast_shapes(*(np.shape(value) for value in (*given, pendulum.length)))
    columns = [column(value, shape) for value in (*given, pendulum.length)]
    radii = _core.judged_radii(prod(shape), columns).reshape((*shape, 3))
    outer, inner, wide = np.moveaxis(radii, -1, 0)
    # A sentence is about the launch as it was given.
    exact = ExactMotion(pendulum, Launch.apsides(outer, inner))
    rates = ExactMotion(pendulum, Launch.apsides(outer, wide)) if np.any(wide != inner) else exact
    found = np.moveaxis(rates.ellipse_rates(outer, wide), -1, 0)
    precession, frequency, alpha, beta, formula_25, formula_26, tiny = found
    bad = np.isnan(np.asarray(exact.frequency))
    rest = np.asarray(pendulum.angular_frequency)

    def error(relative: Numbers) -> Scalars:
        good = np.where(bad, np.nan, np.where(tiny == 1, 0.0, relative))
        return float(good) if exact.shape == () else good

    def by_series(approximate: Scalars, truth: Numbers) -> Scalars:
        with np.errstate(invalid="ignore", divide="ignore"):
            return error(np.asarray(rest * approximate) / truth - 1)

    return Validity(
        formula_25=error(formula_25),
        formula_26=error(formula_26),
        series={
            order: SeriesErrors(
                by_series(series.precession(order)(alpha, beta), precession),
                by_series(series.frequency(order)(alpha, beta), frequency),
            )
            for order in ORDERS
        },
    )


def validity_map(n: int = 400, largest: float = 0.99) -> ValidityMap:
    """The errors of `validity` for n × n ellipses, of every width and up to a = largest · l.

    Raises
    ------
    InvalidInput
        For n below 2 or above 4000, and largest not between 0 and 1.
    """
    if not (isinstance(n, int) and 2 <= n <= _MOST):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(f"A map needs a whole number of points, 2 … {_MOST}, but n is {n}.")
    most = one_number(largest, "The map's largest a/l", "")
    if not 0 < most < 1:
        raise InvalidInput(
            f"The map's largest a/l must lie between 0 and 1, but it is {most}: at 1 the bob is "
            f"at the height of its support."
        )
    a = np.arange(1, n + 1, dtype=np.float64) * (most / n)
    ratio = np.linspace(0, 1, n)
    # A few rows at a time, so that it can be interrupted and needs little memory.
    groups = np.array_split(ratio[:, None], max(1, n * n // _TOGETHER))
    return ValidityMap(a, ratio, _joined([validity(a, rows * a, 1.0) for rows in groups]))


def _joined(parts: list[Validity]) -> Validity:
    """Errors of many rows of ellipses, from those of groups of rows."""
    of_orders = [[part.series[order] for part in parts] for order in ORDERS]
    return Validity(
        formula_25=np.concatenate([part.formula_25 for part in parts]),
        formula_26=np.concatenate([part.formula_26 for part in parts]),
        series={
            order: SeriesErrors(*(np.concatenate(rates) for rates in zip(*found, strict=True)))
            for order, found in zip(ORDERS, of_orders, strict=True)
        },
    )
