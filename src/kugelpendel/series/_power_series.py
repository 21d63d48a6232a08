"""Power series in two variables with exact dyadic coefficients, made of whole numbers.

Every coefficient of this theory is a whole number over a power of two, and 16^d is enough at total
degree d. A series is kept by total degree: the part of degree d, times 16^d, is a polynomial with
whole coefficients in the second variable alone, and is stored as its value at a power of two so
large that the coefficients can be read off again as digits. So two parts are multiplied by one
multiplication of Python integers.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

_SCALE = 4  # bits per degree


@dataclass(frozen=True)
class PowerSeries:
    """A series up to and including total degree len(parts) − 1.

    Attributes
    ----------
    parts
        The part of each total degree at (1, 2^slot), times 16^degree.
    slot
        Bits for one digit, the same for all series of a calculation.

    The result of two is as long as the shorter one.
    """

    parts: tuple[int, ...]
    slot: int

    @classmethod
    def variables(cls, degree: int) -> tuple[PowerSeries, PowerSeries]:
        """The two variables themselves."""
        # Twice the bits that a coefficient below 1 needs, and some, for what is met on the way.
        slot = 2 * _SCALE * degree + 64
        rest = (0,) * (degree - 1)
        first = 1 << _SCALE
        return cls((0, first, *rest), slot), cls((0, first << slot, *rest), slot)

    def to(self, degree: int) -> PowerSeries:
        """Cut, or continued with zeros."""
        rest = (0,) * (degree + 1 - len(self.parts))
        return PowerSeries((*self.parts[: degree + 1], *rest), self.slot)

    def constant(self, value: int) -> PowerSeries:
        """A whole number, as a series like this one."""
        return PowerSeries((value, *(0,) * (len(self.parts) - 1)), self.slot)

    def __add__(self, other: PowerSeries | int) -> PowerSeries:
        if isinstance(other, int):
            return PowerSeries((self.parts[0] + other, *self.parts[1:]), self.slot)
        pairs = zip(self.parts, other.parts, strict=False)
        return PowerSeries(tuple(x + y for x, y in pairs), self.slot)

    __radd__ = __add__

    def __neg__(self) -> PowerSeries:
        return -1 * self

    def __sub__(self, other: PowerSeries | int) -> PowerSeries:
        return self + (-other)

    def __rsub__(self, other: int) -> PowerSeries:
        return -self + other

    def __mul__(self, other: PowerSeries | int) -> PowerSeries:
        if isinstance(other, int):
            return PowerSeries(tuple(other * x for x in self.parts), self.slot)
        result = [0] * min(len(self.parts), len(other.parts))
        theirs = [(j, y) for j, y in enumerate(other.parts) if y]
        for i, x in enumerate(self.parts):
            if x:
                for j, y in theirs:
                    if i + j >= len(result):
                        break
                    result[i + j] += x * y
        return PowerSeries(tuple(result), self.slot)

    __rmul__ = __mul__

    def __truediv__(self, divisor: int) -> PowerSeries:
        """By a whole number, and only where nothing remains."""
        return PowerSeries(tuple(_exactly(x, divisor) for x in self.parts), self.slot)

    def power(self, twice: int) -> PowerSeries:
        """To the power twice/2, of a series that begins with 1: f g' = (twice/2) g f', degree by
        degree.
        """
        if self.parts[0] != 1:
            raise ArithmeticError(f"the series must begin with 1, but begins with {self.parts[0]}")
        result = [1]
        for n in range(1, len(self.parts)):
            total = sum(
                (twice * k - 2 * (n - k)) * self.parts[k] * result[n - k]
                for k in range(1, n + 1)
                if self.parts[k] and result[n - k]
            )
            result.append(_exactly(total, 2 * n))
        return PowerSeries(tuple(result), self.slot)

    def inverse(self) -> PowerSeries:
        """1/f, of a series that begins with 1."""
        return self.power(-2)

    def coefficients(self) -> dict[tuple[int, int], Fraction]:
        """The coefficients that are not zero, by the exponents of the two variables."""
        half = 1 << (self.slot - 1)
        found: dict[tuple[int, int], Fraction] = {}
        for degree, part in enumerate(self.parts):
            for second in range(degree + 1):
                digit = ((part + half) & (2 * half - 1)) - half
                part = (part - digit) >> self.slot
                if abs(digit) >> (self.slot - 8):
                    raise ArithmeticError(f"the digits of degree {degree} run into one another")
                if digit:
                    found[degree - second, second] = Fraction(digit, 1 << (_SCALE * degree))
            if part:
                raise ArithmeticError(f"degree {degree} has a digit too many")
        return found


def _exactly(value: int, divisor: int) -> int:
    quotient, remainder = divmod(value, divisor)
    if remainder:
        raise ArithmeticError(f"a coefficient is not a whole number over 16^degree: ÷ {divisor}")
    return quotient
