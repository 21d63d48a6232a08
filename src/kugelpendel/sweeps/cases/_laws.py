"""How a number varies: a list, a range, a normal or a uniform distribution."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers

MOST_LISTED = 1_000_000
"""Values of a list, which are part of what is stored and sent to workers."""


class Law(Protocol):
    """How one number varies, in SI."""

    word: ClassVar[str]
    """What the law is called where it is stored."""

    @property
    def levels(self) -> int | None:
        """How many values it takes on a grid; None where it has no levels."""
        ...

    def check(self, name: str) -> None:
        """Raise InvalidInput, which names the number, for a law that makes no sense."""
        ...

    def at(self, level: NDArray[np.int64]) -> Numbers:
        """The values of levels from 0 on."""
        ...

    def drawn(self, chance: Numbers) -> Numbers:
        """The values at probabilities between 0 and 1: the inverse of its distribution."""
        ...

    def plain(self) -> list[Any]:
        """Its numbers, as they are stored."""
        ...


@dataclass(frozen=True)
class Listed:
    """One of several values: each of them on a grid, each as likely in a sample.

    Parameters
    ----------
    values
        In SI; one that makes no pendulum is a bad case.
    """

    values: tuple[float, ...]

    word: ClassVar[str] = "list"

    @property
    def levels(self) -> int:
        """How many values there are."""
        return len(self.values)

    def check(self, name: str) -> None:
        """Raise InvalidInput for an empty list, one too long, and what is not finite."""
        if not self.values:
            raise InvalidInput.of("sweep_empty", name=name)
        if len(self.values) > MOST_LISTED:
            raise InvalidInput.of(
                "sweep_long_list", name=name, count=len(self.values), most=MOST_LISTED
            )
        _check_finite(name, *self.values)

    def at(self, level: NDArray[np.int64]) -> Numbers:
        """The values at these places of the list."""
        return np.asarray(self.values, dtype=np.float64)[level]

    def drawn(self, chance: Numbers) -> Numbers:
        """Each value for an equal share of the probabilities."""
        count = len(self.values)
        return self.at(np.minimum((chance * count).astype(np.int64), count - 1))

    def plain(self) -> list[Any]:
        """The values."""
        return list(self.values)


@dataclass(frozen=True)
class Spaced:
    """Values between two ends: at equal steps on a grid, any of them in a sample.

    Parameters
    ----------
    start, stop
        The ends, in SI, both of them values on a grid.
    count
        How many values on a grid; None for a sample, whose own count says how many.
    log
        Whether the steps, and the probability, are equal in the logarithm.
    """

    start: float
    stop: float
    count: int | None = None
    log: bool = False

    word: ClassVar[str] = "range"

    @property
    def levels(self) -> int | None:
        """How many values it takes on a grid."""
        return self.count

    def check(self, name: str) -> None:
        """Raise InvalidInput for a range that is empty or has no logarithm."""
        _check_finite(name, self.start, self.stop)
        if self.start == self.stop or (self.count is not None and self.count < 2):
            raise InvalidInput.of(
                "sweep_empty_range",
                name=name,
                start=self.start,
                stop=self.stop,
                count=1 if self.count is None else self.count,
            )
        if self.log and not (self.start > 0 and self.stop > 0):
            raise InvalidInput.of("sweep_logarithm", name=name, start=self.start, stop=self.stop)

    def at(self, level: NDArray[np.int64]) -> Numbers:
        """The values at these steps; the ends exactly."""
        last = (self.count or 2) - 1
        values = self._between(level / last)
        values[level == 0] = self.start
        values[level == last] = self.stop
        return values

    def drawn(self, chance: Numbers) -> Numbers:
        """The value below which this share of the range lies."""
        return self._between(chance)

    def plain(self) -> list[Any]:
        """Ends, count and whether it is logarithmic."""
        return [self.start, self.stop, self.count, self.log]

    def _between(self, share: Numbers) -> Numbers:
        if self.log:
            low, high = math.log(self.start), math.log(self.stop)
            return np.exp(low + (high - low) * share)
        return self.start + (self.stop - self.start) * share


@dataclass(frozen=True)
class Normal:
    """A normal distribution, for samples.

    Parameters
    ----------
    mean, deviation
        In SI; the standard deviation is positive.
    """

    mean: float
    deviation: float

    word: ClassVar[str] = "normal"

    @property
    def levels(self) -> None:
        """It has none."""
        return None

    def check(self, name: str) -> None:
        """Raise InvalidInput for a standard deviation that is not positive."""
        _check_finite(name, self.mean, self.deviation)
        if self.deviation <= 0:
            raise InvalidInput.of("sweep_deviation", name=name, deviation=self.deviation)

    def at(self, level: NDArray[np.int64]) -> Numbers:
        """There are no levels."""
        raise TypeError("a normal distribution has no levels")

    def drawn(self, chance: Numbers) -> Numbers:
        """The quantiles."""
        from scipy import special  # pyright: ignore[reportMissingTypeStubs]

        quantiles: Any = special.ndtri(chance)  # pyright: ignore[reportUnknownMemberType]
        return self.mean + self.deviation * np.asarray(quantiles, dtype=np.float64)

    def plain(self) -> list[Any]:
        """Mean and standard deviation."""
        return [self.mean, self.deviation]


@dataclass(frozen=True)
class Uniform:
    """A uniform distribution, for samples.

    Parameters
    ----------
    least, most
        Its ends, in SI.
    """

    least: float
    most: float

    word: ClassVar[str] = "uniform"

    @property
    def levels(self) -> None:
        """It has none."""
        return None

    def check(self, name: str) -> None:
        """Raise InvalidInput unless the ends differ and ascend."""
        _check_finite(name, self.least, self.most)
        if not self.least < self.most:
            raise InvalidInput.of(
                "sweep_empty_range", name=name, start=self.least, stop=self.most, count=2
            )

    def at(self, level: NDArray[np.int64]) -> Numbers:
        """There are no levels."""
        raise TypeError("a uniform distribution has no levels")

    def drawn(self, chance: Numbers) -> Numbers:
        """The quantiles."""
        return self.least + (self.most - self.least) * chance

    def plain(self) -> list[Any]:
        """The ends."""
        return [self.least, self.most]


LAWS = (Listed, Spaced, Normal, Uniform)
"""All that there are."""


def stored_law(word: str, numbers: list[Any]) -> Law:
    """The law that is stored under a word with these numbers."""
    make = next(law for law in LAWS if law.word == word)
    return Listed(tuple(numbers)) if make is Listed else make(*numbers)


def _check_finite(name: str, *values: float) -> None:
    for value in values:
        if not math.isfinite(value):
            raise InvalidInput.of("sweep_not_finite", name=name, number=value)
