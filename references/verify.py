"""Checks of a computed motion: another law and precision; straight through; elementary."""

from math import pi

from flint import arb

from references import fixed
from references.launch import Case
from references.motion import Result, solve
from references.orbit import BITS, Path
from references.taylor import State, conserved

AGREEMENT = 1e-26


def again(case: Case, result: Result) -> float:
    """Difference from a second computation: law ``conserved``, 64 bits more, order 22 higher."""
    other = solve(case, bits=320, law=conserved)
    worst = _states(result, other.states, other.bits, len(case.times))
    for ours, theirs in (
        (result.frequency, other.frequency),
        (result.precession, other.precession),
        (result.radial_period, other.radial_period),
    ):
        if ours is not None and theirs is not None and ours != 0 and ours.is_finite():
            worst = max(worst, float(abs(theirs / ours - 1)))
    return worst


def straight(case: Case, result: Result) -> tuple[float, float]:
    """Difference from integrating straight through, and how far (small-oscillation periods).

    Law ``conserved``, 256 bits: no drift off the sphere was seen in it, above the equator neither.
    """
    rate = result.start.angular_frequency
    limit = case.check * 2 * pi / float(rate)
    when = [t for t in case.times if t <= limit]
    path = Path(result.start.scaled(BITS), BITS, conserved, keep=False)
    states = [path.state(fixed.from_arb(arb(t) * rate, BITS)) for t in when]
    return _states(result, states, BITS, len(when)), when[-1] * float(rate) / (2 * pi)


def elementary(case: Case, result: Result) -> float:
    """Difference from the elementary solution of separatrix, cone, rest and upright; else 0."""
    if case.motion not in ("separatrix", "cone", "rest", "upright"):
        return 0.0
    x, y, z, u, v, w = (fixed.to_arb(n, result.bits) for n in result.start.scaled(result.bits))
    rate = result.start.angular_frequency
    worst = 0.0
    for t, state in zip(case.times, result.states, strict=True):
        time = arb(t) * rate
        if case.motion == "separatrix":
            # θ counted so that it grows: d sin(θ/2)/dt = cos²(θ/2), so sin(θ/2) = tanh(t + t0).
            speed = (u * u + v * v + w * w).sqrt()
            ahead = (u / (z * speed), v / (z * speed))
            half = ((x * ahead[0] + y * ahead[1]) / (2 * (1 + z)).sqrt()).atanh() + time
            sine = 2 * half.tanh() / half.cosh()
            place = (sine * ahead[0], sine * ahead[1], 1 - 2 * half.tanh() ** 2)
        elif case.motion == "cone":
            turn = (
                (u * u + v * v).sqrt()
                / (x * x + y * y).sqrt()
                * (1 if x * v - y * u > 0 else -1)
                * time
            )
            place = (x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), z)
        else:
            place = (x, y, z)
        for ours, exact in zip(state[:3], place, strict=True):
            worst = max(worst, float(abs(fixed.to_arb(ours, result.bits) - exact)))
    return worst


def _states(result: Result, others: list[State], bits: int, count: int) -> float:
    """Largest difference, relative to the largest size of the component over the case."""
    sizes = [_size(result, axes) for axes in ((0, 1), (0, 1), (2,), (3, 4), (3, 4), (5,))]
    worst = 0.0
    for ours, theirs in zip(result.states[:count], others, strict=True):
        for a, b, size in zip(ours, theirs, sizes, strict=True):
            difference = abs(fixed.to_arb(a, result.bits) - fixed.to_arb(b, bits))
            worst = max(worst, float(difference / size))
    return worst


def _size(result: Result, axes: tuple[int, ...]) -> arb:
    largest = max(abs(state[axis]) for state in result.states for axis in axes)
    return max(fixed.to_arb(largest, result.bits), arb(10) ** -40)
