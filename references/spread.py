"""How far a motion moves when its binary64 inputs move by half a unit in the last place.

That is the error no binary64 program can be blamed for. Every input moves by a fraction 2**-70 of
itself, one at a time; differences are taken in 224-bit arithmetic, so they are derivatives to many
more digits than the two that matter. Inputs that are exactly 0 do not move.
"""

from dataclasses import dataclass
from math import ulp

from flint import arb

from references import fixed
from references.launch import Case
from references.motion import Result, solve
from references.taylor import conserved

NUDGE = arb(2) ** -70
BITS = 224


@dataclass(frozen=True)
class Spread:
    """Σ over inputs of |derivative|·half ulp.

    Of position / length at each time; of frequency and precession relative, None without meaning.
    """

    position: list[float]
    frequency: float | None
    precession: float | None


def spread(case: Case) -> Spread:
    """Spread of a case."""
    exact = [arb(v) for v in case.inputs]
    base = solve(case, bits=BITS, law=conserved)
    position = [0.0] * len(case.times)
    frequency = precession = 0.0
    for i, value in enumerate(case.inputs):
        if value == 0.0:
            continue
        share = 0.5 * ulp(value) / abs(value)
        inputs = [v * (1 + NUDGE) if j == i else v for j, v in enumerate(exact)]
        moved = solve(case, inputs, _motion(case, i), BITS, conserved)
        for n in range(len(case.times)):
            position[n] += share * _distance(base, moved, n)
        frequency += share * _relative(base.radial_period, moved.radial_period)
        precession += share * _relative(base.precession, moved.precession)
    has_period = base.radial_period is not None and base.radial_period.is_finite()
    turns = base.precession is not None and base.precession != 0
    return Spread(position, frequency if has_period else None, precession if turns else None)


def _motion(case: Case, moved: int) -> str:
    """What a case becomes when one input (0 length, 1 gravity, 2… state) moves a little."""
    if case.motion == "cone":
        return "general"
    if case.motion != "plane" or moved < 2 or case.kind == "angles":
        return case.motion
    half = len(case.state) // 2
    plan = (case.state[0], case.state[half]), (case.state[1], case.state[half + 1])
    at_pole = case.state[0] == 0.0 and case.state[1] == 0.0
    along_axis = plan[0] == (0.0, 0.0) or plan[1] == (0.0, 0.0)
    return "plane" if at_pole or along_axis else "general"


def _distance(base: Result, moved: Result, n: int) -> float:
    """|Δ position| / (length · nudge) at time n."""
    pairs = zip(base.states[n][:3], moved.states[n][:3], strict=True)
    ratio = moved.start.length / base.start.length
    squares = (
        (fixed.to_arb(a, base.bits) - fixed.to_arb(b, moved.bits) * ratio) ** 2 for a, b in pairs
    )
    return float((sum(squares, arb(0)) ** arb(0.5)) / NUDGE)


def _relative(base: arb | None, moved: arb | None) -> float:
    if base is None or moved is None or base == 0 or not base.is_finite():
        return 0.0
    return float(abs(moved / base - 1) / NUDGE)
