"""The same motion to 40 digits and more, by another road: Taylor series and Carlson's integrals.

Inputs are binary64 numbers taken exactly. Carlson's integrals carry rigorous error bounds
(python-flint); the Taylor series must meet them at the next turning point to 40 digits.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from flint import acb, arb, arb_poly, arb_series, ctx

BITS = 400  # the precession of an ellipse of 1e-8 l loses 107 bits to the subtraction of π
ORDER = 64
ctx.prec = BITS
ctx.cap = ORDER
STEP = arb("0.4")  # in 1/ω0; truncation below 1e-45 for the paths used here


def rf(x: arb, y: arb, z: arb) -> arb:
    return acb.elliptic_rf(acb(x), acb(y), acb(z)).real


def rj(x: arb, y: arb, z: arb, p: arb) -> arb:
    return acb.elliptic_rj(acb(x), acb(y), acb(z), acb(p)).real


@dataclass(frozen=True)
class Apsides:
    """Period and precession from the heights of the turning points and λ > 0."""

    high: arb
    low: arb
    momentum: arb

    @classmethod
    def radii(cls, a: float, b: float, length: float) -> Apsides:
        """Exact horizontal turning radii a ≥ b > 0 on the lower half."""
        outer, inner = (arb(r) / arb(length) for r in (a, b))
        high = outer**2 / (1 + (1 - outer**2).sqrt())
        low = inner**2 / (1 + (1 - inner**2).sqrt())
        top = 2 + high * low / (2 - high - low)
        return cls(high, low, (2 * high * low * top).sqrt())

    @classmethod
    def ellipse(cls, a: float, b: float, length: float) -> Apsides:
        """The paper's launch: displaced by a, pushed sideways with b·ω0, b > 0."""
        aside, push = (arb(r) / arb(length) for r in (a, b))
        start = aside**2 / (1 + (1 - aside**2).sqrt())
        total, product = 2 + push**2 / 2, push**2 * (2 - start) / 2
        top = (total + (total**2 - 4 * product).sqrt()) / 2
        other = product / top
        high, low = (start, other) if start > other else (other, start)
        return cls(high, low, aside * push)

    @cached_property
    def _half(self) -> tuple[arb, arb]:
        top = self.momentum**2 / (2 * self.high * self.low)
        w = ((top - self.low) / 2).sqrt()
        m1 = (top - self.high) / (top - self.low)
        n1 = (self.low - self.high) / self.low
        n2 = (self.high - self.low) / (2 - self.low)
        one, zero = arb(1), arb(0)
        K = rf(zero, m1, one)
        third1 = (K + n1 / 3 * rj(zero, m1, one, 1 - n1)) / self.low
        third2 = (K + n2 / 3 * rj(zero, m1, one, 1 - n2)) / (2 - self.low)
        return 2 * K / w, self.momentum / w * (third1 + third2)

    @property
    def period(self) -> arb:
        """Time from one outer turning point to the next, in 1/ω0."""
        return self._half[0]

    @property
    def angle(self) -> arb:
        """Azimuth from one outer turning point to the next, rad."""
        return self._half[1]

    @property
    def frequency(self) -> arb:
        return arb.pi() / self.period

    @property
    def precession(self) -> arb:
        return (self.angle - arb.pi()) / self.period


class Ellipse:
    """Positions at any time after the paper's launch (a, 0), (0, b ω0), a the outer radius.

    One passage between outer turning points is integrated by Taylor series; the others are that
    one, turned.
    """

    def __init__(self, a: float, b: float, length: float, gravity: float) -> None:
        self.length = arb(length)
        self.rate = (arb(gravity) / self.length).sqrt()
        self.apsides = Apsides.ellipse(a, b, length)
        aside, push = arb(a) / self.length, arb(b) / self.length
        place = [aside, arb(0), (1 - aside**2).sqrt()]
        speed = [arb(0), push, arb(0)]
        self.pieces = []
        for _ in range(int(float((self.apsides.period / STEP).mid())) + 1):
            r, v = series(place, speed)
            self.pieces.append(r)
            place, speed = ([q(STEP) for q in part] for part in (r, v))
        self._close(arb(a))

    def _close(self, a: arb) -> None:
        rest = self.apsides.period - (len(self.pieces) - 1) * STEP
        x, y = (q(rest) * self.length for q in self.pieces[-1][:2])
        angle = self.apsides.angle
        if not max(abs(x - a * angle.cos()), abs(y - a * angle.sin())) < arb("1e-40"):
            raise ArithmeticError(f"Taylor series and Carlson's integrals differ at T_s: {x}, {y}")

    def position(self, time: float | arb) -> tuple[arb, arb, arb]:
        """Metres, z down, at a time in seconds, taken exactly."""
        phase = arb(time) * self.rate
        turns = int(float((phase / self.apsides.period).mid()))
        rest = phase - turns * self.apsides.period
        if rest < 0:
            turns, rest = turns - 1, rest + self.apsides.period
        piece = int(float((rest / STEP).mid()))
        x, y, z = (q(rest - piece * STEP) for q in self.pieces[piece])
        turned = turns * self.apsides.angle
        c, s = turned.cos(), turned.sin()
        return (c * x - s * y) * self.length, (s * x + c * y) * self.length, z * self.length


def series(place: list[arb], speed: list[arb]) -> tuple[list[arb_poly], list[arb_poly]]:
    """Taylor series of r'' = e_z - Λ r, Λ = (v·v + z)/(r·r), by Picard iteration."""
    start, rate = ([arb_series([q]) for q in part] for part in (place, speed))
    r, v = start, rate
    for _ in range(ORDER):
        pull = (sum(q * q for q in v) + r[2]) / sum(q * q for q in r)
        force = [-pull * q for q in r]
        force[2] += 1
        v = [q0 + f.integral() for q0, f in zip(rate, force, strict=True)]
        r = [q0 + q.integral() for q0, q in zip(start, v, strict=True)]
    return [arb_poly(q.coeffs()) for q in r], [arb_poly(q.coeffs()) for q in v]
