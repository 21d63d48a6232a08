"""One integrated radial period, and what follows from it by symmetry.

The height of an ideal pendulum is periodic, and so is its motion up to a turn about the vertical:
with T the time from one highest point to the next, x + iy at t + T is x + iy at t times one
constant of modulus 1. T, that constant, and the motion over one T are integrated; later times
follow from them. ``verify.py`` integrates straight through instead.
"""

from bisect import bisect_left

from flint import acb, arb

from references import fixed
from references.launch import Start
from references.taylor import STEP_BITS, Law, Segment, State, march, normalised

SUBSTEPS = 16
BITS = 256


class Path:
    """A motion integrated straight through as far as asked for (times in 1/ω0, fixed point).

    With ``keep=False`` the steps already passed are forgotten, and times must be asked for in
    rising order.
    """

    def __init__(
        self, start: State, bits: int = BITS, law: Law = normalised, keep: bool = True
    ) -> None:
        self._keep = keep
        self._segments: list[Segment] = []
        self._march = march(start, bits, law)

    @property
    def end(self) -> int:
        return self._segments[-1].end if self._segments else 0

    def advance(self) -> Segment:
        """Integrate one step more."""
        if not self._keep:
            self._segments.clear()
        self._segments.append(next(self._march))
        return self._segments[-1]

    def state(self, time: int) -> State:
        while not self._segments or self.end < time:
            self.advance()
        at = bisect_left(self._segments, time, key=lambda segment: segment.end)
        return self._segments[at].state(time)


class Orbit:
    """Radial period and apsidal turn where the height oscillates, and the state at any time.

    Parameters
    ----------
    start
        Exact launch; energy other than that of the separatrix, height not constant.
    plane
        Whether the angular momentum is exactly 0: the turn per period is then exactly π (libration)
        or 2π (rotation).
    """

    def __init__(self, start: Start, plane: bool, bits: int = BITS, law: Law = normalised) -> None:
        self.bits = bits
        self.path = Path(start.scaled(bits), bits, law)
        first, second = self._highest_points()
        self.period = second - first
        if plane:
            rotation = bool(start.energy > 2 * start.gravity * start.length)
            self.turn = arb.pi() * (2 if rotation else 1)
            self.precession = arb(0)
            self.frequency = self.turn / fixed.to_arb(self.period, bits)
        else:
            early = first + self.period // 4
            before, after = self._plan(early), self._plan(early + self.period)
            excess = (-after * before.conjugate()).arg()
            self.turn = arb.pi() + excess
            self.precession = excess / fixed.to_arb(self.period, bits)
            self.frequency = arb.pi() / fixed.to_arb(self.period, bits)

    def state(self, time: int) -> State:
        turns, rest = divmod(time, self.period)
        x, y, z, u, v, w = self.path.state(rest)
        if turns == 0:
            return (x, y, z, u, v, w)
        angle = self.turn * turns
        c, s = fixed.from_arb(angle.cos(), self.bits), fixed.from_arb(angle.sin(), self.bits)
        x, y = (x * c - y * s) >> self.bits, (x * s + y * c) >> self.bits
        u, v = (u * c - v * s) >> self.bits, (u * s + v * c) >> self.bits
        return (x, y, z, u, v, w)

    def _plan(self, time: int) -> acb:
        x, y, *_ = self.path.state(time)
        return acb(fixed.to_arb(x, self.bits), fixed.to_arb(y, self.bits))

    def _highest_points(self) -> tuple[int, int]:
        """Times of two successive highest points (z least: dz/dt turns from − to +)."""
        found: list[int] = []
        sign, left = 0, 0
        while len(found) < 2:
            segment = self.path.advance()
            for step in range(1, SUBSTEPS + 1):
                time = segment.start + (segment.end - segment.start) * step // SUBSTEPS
                rate = segment.rate(2, segment.fraction(time))
                new = (rate > 0) - (rate < 0)
                if new == 0:
                    continue
                if sign < 0 < new:
                    found.append(_root(segment, max(left, segment.start), time))
                sign, left = new, time
        return found[0], found[1]


def _root(segment: Segment, left: int, right: int) -> int:
    """Zero of dz/dt, negative at the left time and positive at the right one; bracketed Newton."""
    low, high = segment.fraction(left), segment.fraction(right)
    tau = (low + high) // 2
    for _ in range(200):
        rate = segment.rate(2, tau)
        if rate < 0:
            low = tau
        else:
            high = tau
        step = (rate << segment.bits) // _slope(segment, tau)
        new = tau - step
        if not low <= new <= high:
            new = (low + high) // 2
        if abs(new - tau) <= 1:
            break
        tau = new
    return segment.start + (tau * segment.scale >> STEP_BITS)


def _slope(segment: Segment, tau: int) -> int:
    total = 0
    z = segment.series[2]
    for k in range(len(z) - 1, 1, -1):
        total = (total * tau >> segment.bits) + k * (k - 1) * z[k]
    return total or 1
