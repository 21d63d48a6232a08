"""The exact motion of a case: state at its times, frequency, precession, radial period."""

from dataclasses import dataclass

from flint import arb

from references import fixed
from references.launch import Case, Start, start
from references.orbit import BITS, Orbit, Path
from references.taylor import Law, State, normalised

SMALL = 1e-7
NEAR_TOP = 1e-12


@dataclass(frozen=True)
class Result:
    """Numbers of one motion: states in lengths and length·ω0 (fixed point), the rest in SI units.

    None stands for what has no meaning.
    """

    start: Start
    bits: int
    states: list[State]
    frequency: arb | None
    precession: arb | None
    radial_period: arb | None


def solve(
    case: Case,
    inputs: list[arb] | None = None,
    motion: str | None = None,
    bits: int = BITS,
    law: Law = normalised,
) -> Result:
    """Integrate a case, or the same launch with other inputs, which may make another motion of it.

    Two kinds get 128 bits more: small motions (on a circle of 1e-9 lengths the height varies by
    1e-34 lengths, and the turning points have to be found in that), and those that come to a near
    stop at the top.
    """
    begin = start(case.kind, inputs or [arb(v) for v in case.inputs])
    motion = motion or case.motion
    energy = begin.energy / (begin.gravity * begin.length)
    if energy < SMALL or abs(energy - 2) < NEAR_TOP:
        bits += 128
    rate = begin.angular_frequency
    when = [fixed.from_arb(arb(t) * rate, bits) for t in case.times]
    if motion in ("general", "plane"):
        orbit = Orbit(begin, motion == "plane", bits, law)
        states = [orbit.state(t) for t in when]
        period = fixed.to_arb(orbit.period, bits) / rate
        return Result(begin, bits, states, orbit.frequency * rate, orbit.precession * rate, period)
    path = Path(begin.scaled(bits), bits, law)
    if motion == "cone":
        cosine = begin.position[2] / begin.length
        turn = rate / cosine.sqrt() * (1 if begin.angular_momentum > 0 else -1)
        frequency = rate * ((1 + 3 * cosine**2) / cosine).sqrt() / 2
        precession = turn - frequency * (1 if turn > 0 else -1)
        states = [path.state(t) for t in when]
        return Result(begin, bits, states, frequency, precession, arb.pi() / frequency)
    states = [path.state(t) for t in when]
    if motion == "rest":
        return Result(begin, bits, states, rate, arb(0), arb.pi() / rate)
    if motion == "separatrix":
        return Result(begin, bits, states, arb(0), arb(0), arb("inf"))
    return Result(begin, bits, states, None, None, None)
