"""A polynomial in two amplitudes, with exact coefficients."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from numpy.typing import ArrayLike

from kugelpendel.parameters import Scalars, as_numbers

_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_GREEK = {"α": r"\alpha", "β": r"\beta"}


@dataclass(frozen=True)
class Polynomial:
    """Σ coefficient · firstⁱ · secondʲ; dimensionless, as its variables are.

    Attributes
    ----------
    terms
        (i, j, coefficient), by total degree and then by j; none is zero. The sum i + j is even in
        all of them, or odd in all of them.
    variables
        Names of the two: α, β for the turning radii, a, b for the first harmonics, over l.

    Called with numbers or arrays, it gives its value in their common shape. It has one for every
    amplitude, within the convergence of the series or not: how wrong it is says `trusted`.
    """

    terms: tuple[tuple[int, int, Fraction], ...]
    variables: tuple[str, str]

    @classmethod
    def of(
        cls, coefficients: Mapping[tuple[int, int], Fraction], variables: tuple[str, str]
    ) -> Polynomial:
        """From the coefficients by exponents."""
        order = sorted(coefficients, key=lambda powers: (sum(powers), powers[1]))
        return cls(tuple((i, j, coefficients[i, j]) for i, j in order), variables)

    @property
    def coefficients(self) -> dict[tuple[int, int], Fraction]:
        """Exact, by the two exponents."""
        return {(i, j): coefficient for i, j, coefficient in self.terms}

    @property
    def degree(self) -> int:
        """The largest i + j; 0 where there are no terms."""
        return max((i + j for i, j, _ in self.terms), default=0)

    def truncated(self, degree: int) -> Polynomial:
        """The terms up to a total degree."""
        return Polynomial(
            tuple(term for term in self.terms if term[0] + term[1] <= degree), self.variables
        )

    def homogeneous(self, degree: int) -> Polynomial:
        """The terms of one total degree."""
        return Polynomial(
            tuple(term for term in self.terms if term[0] + term[1] == degree), self.variables
        )

    def __call__(self, first: ArrayLike, second: ArrayLike) -> Scalars:
        x = as_numbers(first, self.variables[0], "units of the length")
        y = as_numbers(second, self.variables[1], "units of the length")
        square = y * y
        value: Scalars = 0.0 * (x + y)
        above = self._rows[0][0] if self._rows else 0
        for i, j, row in self._rows:
            inner: Scalars = row[0]
            for coefficient in row[1:]:
                inner = inner * square + coefficient
            value = value * x ** (above - i) + (inner * y if j else inner)
            above = i
        return as_numbers(value * x**above, "the value", "units of the length")

    @cached_property
    def _rows(self) -> list[tuple[int, int, list[float]]]:
        """By i from the highest: i, whether j is odd, coefficients from the highest j in twos."""
        rows: dict[int, dict[int, float]] = {}
        for i, j, coefficient in self.terms:
            rows.setdefault(i, {})[j] = float(coefficient)
        return [
            (i, max(row) % 2, [row.get(j, 0.0) for j in range(max(row), -1, -2)])
            for i, row in sorted(rows.items(), reverse=True)
        ]

    def __str__(self) -> str:
        def power(name: str, exponent: int) -> str:
            raised = str(exponent).translate(_RAISED) if exponent > 1 else ""
            return f"{name}{raised}" if exponent else ""

        return self._joined(str, power, " ")

    @property
    def latex(self) -> str:
        """For a formula in LaTeX, without dollar signs."""

        def number(value: Fraction) -> str:
            if value.denominator == 1:
                return str(value)
            return rf"\frac{{{value.numerator}}}{{{value.denominator}}}"

        def power(name: str, exponent: int) -> str:
            raised = f"^{{{exponent}}}" if exponent > 1 else ""
            return f"{_GREEK.get(name, name)}{raised}" if exponent else ""

        return self._joined(number, power, r"\,")

    def _joined(
        self, number: Callable[[Fraction], str], power: Callable[[str, int], str], times: str
    ) -> str:
        text = ""
        for i, j, coefficient in self.terms:
            factors = [power(name, n) for name, n in zip(self.variables, (i, j), strict=True) if n]
            if abs(coefficient) != 1 or not factors:
                factors.insert(0, number(abs(coefficient)))
            sign = "-" if coefficient < 0 else "+"
            text += f" {sign} {times.join(factors)}"
        text = text.removeprefix(" + ") or "0"
        return text.replace(" - ", "-", 1) if text.startswith(" - ") else text
