"""Write the references of (13): ``python -m references.equations.cubic``, from the root.

With a number N it prints the first N of the launches instead.

r̈ = −(1 − ρ²/2 + ṙ²) r in the plan view, integrated by Taylor series in fixed point; see
`references.taylor`, of which only the law is another. The launches are random, with a fixed seed,
and below 60° from the vertical by the exact motion's energy. Lengths in l, times in 1/ω0.
"""

import json
import math
import random
import sys
from pathlib import Path

from references import fixed
from references.taylor import STEP_BITS, Series, State, dot, march, square

PATH = Path("tests/reference/cubic.json")
SEED = 13
LAUNCHES = 200
SWINGS = (1, 10, 50, 100)
LOWEST = 0.5  # cosine of the largest angle from the vertical
BITS = 96


def cubic(series: Series, energy: int, scale: int, order: int, bits: int) -> None:
    """Extend the series to ``order`` by Λ = 1 − ρ²/2 + ṙ²; ``energy`` is not used, z stays 0."""
    plan = series[:2]
    rates: tuple[list[int], list[int]] = ([], [])
    pull: list[int] = []
    unit = scale * scale
    for k in range(order - 1):
        for rate, x in zip(rates, plan, strict=True):
            rate.append((k + 1) * x[k + 1])
        radius_squared = sum(square(x, k) for x in plan) >> bits
        weight = ((1 << bits) if k == 0 else 0) - (radius_squared >> 1)
        speed_squared = sum(square(rate, k) for rate in rates) >> bits
        pull.append((weight * unit >> (2 * STEP_BITS)) + speed_squared)
        for x in plan:
            x.append((-dot(pull, x, k) // ((k + 1) * (k + 2))) >> bits)
        series[2].append(0)


def launches() -> list[list[float]]:
    """x, y, vx, vy."""
    numbers = random.Random(SEED)
    found: list[list[float]] = []
    while len(found) < LAUNCHES:
        x, y, vx, vy = (numbers.uniform(-1, 1) for _ in range(4))
        if x * x + y * y >= 1:
            continue
        depth = math.sqrt(1 - x * x - y * y)
        sinking = (x * vx + y * vy) / depth
        if depth - (vx * vx + vy * vy + sinking * sinking) / 2 >= LOWEST:
            found.append([x, y, vx, vy])
    return found


def states(launch: list[float], times: list[float]) -> list[State]:
    """The states at ascending times."""
    x, y, vx, vy = (round(value * 2.0**60) << (BITS - 60) for value in launch)
    found: list[State] = []
    when = [round(time * 2.0**40) << (BITS - 40) for time in times]
    for segment in march((x, y, 0, vx, vy, 0), BITS, cubic):
        while len(found) < len(when) and when[len(found)] <= segment.end:
            found.append(segment.state(when[len(found)]))
        if len(found) == len(when):
            return found
    raise AssertionError("a march has no end")


def text(count: int) -> str:
    """The file: one launch a line, with x and y at each time."""
    times = [float(round(2 * math.pi * swings)) for swings in SWINGS]
    lines: list[str] = []
    for launch in launches()[:count]:
        exact = [round(value * 2.0**60) / 2.0**60 for value in launch]
        places = [
            [fixed.decimal(fixed.to_arb(value, BITS)) for value in state[:2]]
            for state in states(exact, times)
        ]
        lines.append(json.dumps({"launch": exact, "places": places}))
    return f'{{\n "times": {times},\n "cases": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n"


if __name__ == "__main__":
    if asked := sys.argv[1:]:
        print(text(int(asked[0])), end="")
    else:
        PATH.write_text(text(LAUNCHES), encoding="utf-8")
