"""Write the references of quadratic drag: ``python -m references.equations.drag``, from the root.

With a number N it prints the first N of the cases instead.

Pendulums whose uneven suspension takes b through zero again and again. At a turning point |v| then
falls to next to nothing, and its series is no longer than that: the third method that shows whose
error a difference is. Taylor series in fixed point; r'' = F − Λ r with F = e_z − c|v|v − 2δ(r·χ)χ
and Λ = (v² + F·r)/(r·r), lengths in l, times in 1/ω0, z down.
"""

import json
import random
import sys
from collections.abc import Iterator
from math import isqrt
from operator import mul
from pathlib import Path
from typing import TypedDict

from flint import arb

from references import fixed
from references.taylor import dot, square

PATH = Path("tests/reference/drag.json")
SEED = 11
CASES = 40
TIMES = (50.0, 200.0, 400.0)
BITS = 96
ORDER = 33
GRAIN = 60  # bits of what is given, so that it is the same number in binary64 and here
LONGEST = 0.7

Plan = tuple[list[int], list[int], list[int]]


def field(plan: Plan, drag: int, stiff: list[list[int]], scale: int) -> None:
    """Extend the series in τ = t/scale of x, y, z, of which two coefficients each are known."""
    rates: Plan = ([], [], [])
    speed: list[int] = []
    sideways: tuple[list[int], list[int]] = ([], [])
    radius: list[int] = []
    pull: list[int] = []
    unit = scale * scale >> BITS
    for k in range(ORDER - 1):
        for rate, x in zip(rates, plan, strict=True):
            rate.append((k + 1) * x[k + 1])
        squared = sum(square(rate, k) for rate in rates) >> BITS
        if k == 0:
            speed.append(isqrt(squared << BITS))
        else:
            known = sum(map(mul, speed[1:k], speed[k - 1 : 0 : -1])) >> BITS
            speed.append(((squared - known) << BITS) // (2 * speed[0]))
        for side, (along, across) in zip(sideways, stiff, strict=True):
            acts = along * plan[0][k] + across * plan[1][k] >> BITS
            side.append(-acts * unit >> BITS)
        source = squared + (plan[2][k] * unit >> BITS)
        source += sum(dot(side, x, k) for side, x in zip(sideways, plan, strict=False)) >> BITS
        radius.append(sum(square(x, k) for x in plan) >> BITS)
        known = sum(map(mul, pull, radius[k:0:-1])) >> BITS
        pull.append(((source - known) << BITS) // radius[0])
        for axis, (x, rate) in enumerate(zip(plan, rates, strict=True)):
            force = -dot(pull, x, k) - (drag * dot(speed, rate, k) >> BITS) >> BITS
            if axis < 2:
                force += sideways[axis][k]
            elif k == 0:
                force += unit
            x.append(force // ((k + 1) * (k + 2)))


def reach(plan: Plan) -> float:
    """Largest τ ≤ 1 at which the last two terms of each series stay below 2^(8 − BITS).

    With that a step sees the branch points of |v| beside the real axis, where c times the square
    of the least speed is above 3e-27.
    """
    found = 1.0
    for x in plan:
        for k in (ORDER - 1, ORDER):
            excess = x[k].bit_length() - 8
            if excess > 0:
                found = min(found, 2.0 ** (-excess / k))
    return found


def steps(state: list[int], drag: int, stiff: list[list[int]]) -> Iterator[tuple[int, int, Plan]]:
    """Start, scale and series of each step, from time 0 on without end; τ goes from 0 to 1."""
    time = 0
    scale = round(0.1 * 2**BITS)
    while True:
        place, velocity = state[:3], state[3:]
        plan: Plan = tuple(  # pyright: ignore[reportAssignmentType]
            [x, v * scale >> BITS] for x, v in zip(place, velocity, strict=True)
        )
        field(plan, drag, stiff, scale)
        tau = reach(plan)
        if tau < 1.0:
            scale = round(scale * tau * 0.9)
            continue
        yield time, scale, plan
        time += scale
        ended = at(plan, 1 << BITS)
        rates = [sum(k * c for k, c in enumerate(x)) for x in plan]
        state = [*ended, *((rate << BITS) // scale for rate in rates)]
        scale = min(round(scale * 1.5), round(LONGEST * 2**BITS))


def at(plan: Plan, tau: int) -> list[int]:
    """Position at τ."""
    place: list[int] = []
    for coefficients in plan:
        total = 0
        for c in reversed(coefficients):
            total = (total * tau >> BITS) + c
        place.append(total)
    return place


class Case(TypedDict):
    """What is given: x, y, vx, vy of the launch, c, δ and the azimuth of the stiff axis."""

    launch: list[float]
    quadratic: float
    anisotropy: float
    axis: float


def cases() -> list[Case]:
    """Launches with b next to zero."""
    numbers = random.Random(SEED)

    def grain(value: float) -> float:
        return round(value * 2.0**GRAIN) / 2.0**GRAIN

    found: list[Case] = []
    for _ in range(CASES):
        a = numbers.uniform(0.1, 0.6)
        across = a * 10 ** numbers.uniform(-5, -2) * numbers.choice((-1, 1))
        found.append(
            {
                "launch": [grain(a), 0.0, grain(0.01 * a), grain(across)],
                "quadratic": grain(10 ** numbers.uniform(-3.5, -1)),
                "anisotropy": grain(10 ** numbers.uniform(-2.3, -1.5)),
                "axis": grain(numbers.uniform(0.2, 1.3)),
            }
        )
    return found


def places(case: Case) -> list[list[str]]:
    """x, y, z at TIMES."""
    x, y, vx, vy = (round(value * 2.0**GRAIN) << (BITS - GRAIN) for value in case["launch"])
    one = 1 << BITS
    z = isqrt((one * one) - x * x - y * y)
    vz = -((x * vx + y * vy) // z)
    given = (case["quadratic"], case["anisotropy"])
    drag, delta = (round(value * 2.0**GRAIN) << (BITS - GRAIN) for value in given)
    angle = arb(case["axis"])
    cos, sin = fixed.from_arb(angle.cos(), BITS), fixed.from_arb(angle.sin(), BITS)
    stiff = [[2 * delta * (a * b >> BITS) >> BITS for b in (cos, sin)] for a in (cos, sin)]
    found: list[list[str]] = []
    when = [round(time) << BITS for time in TIMES]
    for start, scale, plan in steps([x, y, z, vx, vy, vz], drag, stiff):
        while when[len(found)] <= start + scale:
            tau = ((when[len(found)] - start) << BITS) // scale
            place = at(plan, tau)
            found.append([fixed.decimal(fixed.to_arb(value, BITS)) for value in place])
            if len(found) == len(when):
                return found
    raise AssertionError("the steps have no end")


def text(count: int) -> str:
    """The file: one case a line."""
    lines = [json.dumps({**case, "places": places(case)}) for case in cases()[:count]]
    return f'{{\n "times": {list(TIMES)},\n "cases": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n"


if __name__ == "__main__":
    if asked := sys.argv[1:]:
        print(text(int(asked[0])), end="")
    else:
        PATH.write_text(text(CASES), encoding="utf-8")
