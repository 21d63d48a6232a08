"""Taylor series of the pendulum in fixed point, one step at a time.

Unit of length: the pendulum's length. Unit of time: 1/ω0 = √(length/gravity). z points down. Two
ways to write the same motion are kept, so that one can check the other:

``normalised``  r'' = e_z − Λ r with Λ = (v² + z)/(r·r); does not drift off the sphere.
``conserved``   the same with v² from the energy and r·r = 1: Λ = E + 3 z, E = v² − 2 z at launch.

Neither knows anything of elliptic functions.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import floor
from operator import mul

Series = tuple[list[int], list[int], list[int]]
State = tuple[int, int, int, int, int, int]
Law = Callable[[Series, int, int, int, int], None]

STEP_BITS = 10
LONGEST_STEP = 3 << STEP_BITS


def dot(a: list[int], b: list[int], k: int) -> int:
    """The k-th coefficient of a product of two series."""
    return sum(map(mul, a[: k + 1], b[k::-1]))


def square(a: list[int], k: int) -> int:
    """The k-th coefficient of the square of a series."""
    half = (k + 1) // 2
    total = 2 * sum(map(mul, a[:half], a[k : k - half : -1]))
    return total + a[k // 2] ** 2 if k % 2 == 0 else total


def normalised(series: Series, energy: int, scale: int, order: int, bits: int) -> None:
    """Extend the series to ``order`` by Λ = (v² + z)/(r·r); ``energy`` is not used."""
    z = series[2]
    rates: Series = ([], [], [])
    pull: list[int] = []
    radius: list[int] = []
    for k in range(order - 1):
        for rate, x in zip(rates, series, strict=True):
            rate.append((k + 1) * x[k + 1])
        weight = (z[k] * scale * scale) >> (2 * STEP_BITS)
        source = (sum(square(rate, k) for rate in rates) >> bits) + weight
        radius.append(sum(square(x, k) for x in series) >> bits)
        known = sum(map(mul, pull, radius[k:0:-1])) >> bits
        pull.append(((source - known) << bits) // radius[0])
        _accelerate(series, pull, scale, k, bits)


def conserved(series: Series, energy: int, scale: int, order: int, bits: int) -> None:
    """Extend the series to ``order`` by Λ = E + 3 z."""
    z = series[2]
    pull: list[int] = []
    for k in range(order - 1):
        bare = 3 * z[k] + (energy if k == 0 else 0)
        pull.append((bare * scale * scale) >> (2 * STEP_BITS))
        _accelerate(series, pull, scale, k, bits)


def _accelerate(series: Series, pull: list[int], scale: int, k: int, bits: int) -> None:
    divisor = (k + 1) * (k + 2)
    for x in series:
        x.append((-dot(pull, x, k) // divisor) >> bits)
    if k == 0:
        series[2][2] += (scale * scale << bits) >> (2 * STEP_BITS + 1)


@dataclass(frozen=True, slots=True)
class Segment:
    """The motion over one step, as series in τ = (time − start)/scale, 0 ≤ τ ≤ 1."""

    series: Series
    start: int
    end: int
    scale: int
    bits: int

    def fraction(self, time: int) -> int:
        """τ of a time, fixed point."""
        return ((time - self.start) << STEP_BITS) // self.scale

    def rate(self, axis: int, tau: int) -> int:
        """d/dτ of one coordinate at τ."""
        total = 0
        coefficients = self.series[axis]
        for k in range(len(coefficients) - 1, 0, -1):
            total = (total * tau >> self.bits) + k * coefficients[k]
        return total

    def state(self, time: int) -> State:
        """x, y, z and their time derivatives."""
        tau = self.fraction(time)
        place = []
        for coefficients in self.series:
            total = 0
            for c in reversed(coefficients):
                total = (total * tau >> self.bits) + c
            place.append(total)
        speed = [(self.rate(axis, tau) << STEP_BITS) // self.scale for axis in range(3)]
        return (place[0], place[1], place[2], speed[0], speed[1], speed[2])


def march(state: State, bits: int, law: Law) -> Iterator[Segment]:
    """Segments of the motion from time 0 on, without end.

    The order grows with the precision, at the ratio that costs least for a product of quadratic
    cost. The step is chosen so that the last two terms stay below 2**(16 − bits); steps are
    multiples of 2**-10 of the series' own scale, so that the sum of the steps is exact.
    """
    energy = sum(v * v for v in state[3:]) // (1 << bits) - 2 * state[2]
    order = bits * 11 // 32
    time = 0
    scale = 1 << (STEP_BITS - 3)
    while True:
        x, y, z, u, v, w = state
        series: Series = (
            [x, u * scale >> STEP_BITS],
            [y, v * scale >> STEP_BITS],
            [z, w * scale >> STEP_BITS],
        )
        law(series, energy, scale, order, bits)
        tau = _reach(series, bits)
        if tau < 0.3:
            scale = max(1, floor(scale * tau * 1.3))
            continue
        length = scale * floor(tau * (1 << STEP_BITS)) << (bits - 2 * STEP_BITS)
        segment = Segment(series, time, time + length, scale, bits)
        yield segment
        time += length
        state = segment.state(time)
        scale = min(LONGEST_STEP, max(1, floor(scale * tau * 1.3)))


def _reach(series: Series, bits: int) -> float:
    """Largest τ ≤ 1 at which the last two terms of each series stay below 2**(16 − bits)."""
    reach = 1.0
    for coefficients in series:
        for k in (len(coefficients) - 2, len(coefficients) - 1):
            excess = coefficients[k].bit_length() - 16
            if excess > 0:
                reach = min(reach, 2.0 ** (-excess / k))
    return 0.97 * reach
