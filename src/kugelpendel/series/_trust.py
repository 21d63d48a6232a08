"""How wrong a truncated series is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters import InvalidInput, Numbers, Scalars, as_numbers
from kugelpendel.series._functions import all_harmonics, frequency, precession
from kugelpendel.series._orders import checked_order
from kugelpendel.series._polynomial import Polynomial
from kugelpendel.series._table import polynomial

WARNED = 0.01
"""A relative error of frequency or precession above this makes a warning."""


@dataclass(frozen=True, eq=False)
class Trust:
    """The expected error of the series, from the terms that it leaves out.

    Of these the first two orders are evaluated and the others replaced by a geometric series. Up to
    radii of 0.99 and to order 12, frequency and precession turn out at most 4 % more wrong than
    expected; at radii below 0.3 at least 0.65 times as wrong, above 0.9 down to a tenth
    (tests/series/test_trust.py). An estimate, not a bound.

    Attributes
    ----------
    alpha, beta
        Turning radii over l, both below 1 in magnitude.
    order
        Of the series.
    """

    alpha: Scalars
    beta: Scalars
    order: int

    @cached_property
    def frequency(self) -> Scalars:
        """Of ω, relative."""
        series = self._beyond("frequency")
        return self._number(self._left_out(series, self.order) / series(self.alpha, self.beta))

    @cached_property
    def precession(self) -> Scalars:
        """Of Ω, relative to itself, and to its limit where the motion is plane."""
        series = self._beyond("precession")
        terms = tuple((i - 1, j - 1, value) for i, j, value in series.terms)
        over_product = Polynomial(terms, series.variables)
        error = self._left_out(over_product, self.order - 2)
        return self._number(error / over_product(self.alpha, self.beta))

    @cached_property
    def drift(self) -> Scalars:
        """Of the phases, rad per unit of ω0 t: the position is wrong by about this times a ω0 t."""
        rates = (
            series(self.order)(self.alpha, self.beta) * error
            for series, error in ((frequency, self.frequency), (precession, self.precession))
        )
        return self._number(sum(np.abs(rate) for rate in rates))

    @cached_property
    def position(self) -> Scalars:
        """Of the harmonics: of the position over l, besides the drift."""
        found = all_harmonics(self.order + 4, "radii")
        plan = sum(self._left_out(series, self.order + 1) for series in found.plan.values())
        height = sum(self._left_out(series, self.order + 2) for series in found.height.values())
        return self._number(np.hypot(plan, height))

    @property
    def worst(self) -> float:
        """The largest relative error of frequency and precession; NaN are left out."""
        errors = np.concatenate([np.ravel(self.frequency), np.ravel(self.precession)])
        return float(np.max(errors, initial=0.0, where=~np.isnan(errors)))

    @property
    def warning(self) -> str | None:
        """A sentence where an error is above 1 %, or None."""
        if self.worst <= WARNED:
            return None
        radius = max(_largest(np.abs(value)) for value in (self.alpha, self.beta))
        return (
            f"The series of order {self.order} is wrong by up to {100 * self.worst:.2g} % at a "
            f"turning radius of {radius:.4g} l; use a higher order, or ExactMotion."
        )

    def __str__(self) -> str:
        return (
            f"Series of order {self.order}: expected errors of the frequency "
            f"{_largest(self.frequency):.1e}, of the precession {_largest(self.precession):.1e} "
            f"(relative), of the harmonics {_largest(self.position):.1e} l."
        )

    def _beyond(self, name: str) -> Polynomial:
        return polynomial(self.order + 4, "radii", name, self.order + 4)

    def _left_out(self, series: Polynomial, degree: int) -> Numbers:
        """The terms beyond a degree: |first| + |second| (1 + x + x² + …), x = max(α, β)²."""
        first = series.homogeneous(degree + 2)(self.alpha, self.beta)
        second = series.homogeneous(degree + 4)(self.alpha, self.beta)
        square = np.square(np.maximum(np.abs(self.alpha), np.abs(self.beta)))
        return np.asarray(np.abs(first) + np.abs(second) / (1 - square))

    @staticmethod
    def _number(value: ArrayLike) -> Scalars:
        return as_numbers(value, "the error", "1")


def trusted(alpha: ArrayLike, beta: ArrayLike, order: int) -> Trust:
    """The expected error of the series in the turning radii at an order.

    Parameters
    ----------
    alpha, beta
        Turning radii over l, below 1 in magnitude; their order and signs do not matter.
    order
        As in `frequency`.

    Returns
    -------
    Trust
        With `frequency`, `precession`, `position`, `drift`, a `warning` (None where the errors are
        below 1 %), and a sentence as its `str`. In arrays, NaN where the series do not converge.

    Raises
    ------
    InvalidInput
        A single radius of 1 or more, where the series do not converge; a bad order.
    """
    radii = as_numbers(alpha, "The turning radius α", "1"), as_numbers(beta, "β", "1")
    for name, value in zip("αβ", radii, strict=True):
        if isinstance(value, float) and not abs(value) < 1:
            raise InvalidInput(
                f"The series converge while both turning radii are below the length, but "
                f"{name} = {value}; use ExactMotion, which is right at every amplitude."
            )
    first, second = (_inside(value) for value in radii)
    return Trust(first, second, checked_order(order))


def _inside(value: Scalars) -> Scalars:
    return as_numbers(np.where(np.abs(value) < 1, value, np.nan), "the turning radius", "1")


def _largest(value: Scalars) -> float:
    return float(np.nanmax(value))
