"""When the bob passes a radius, how long it stays within it, and where it is at a time."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ._answer import CLOSED_FORM, Answer, Check
from ._case import Case

_BISECTIONS = 60


def passage(case: Case) -> Iterator[Answer]:
    """Times count from the closest approach to the axis."""
    radius = case.a / 2 if case.radius is None else case.radius
    if radius > abs(case.b):
        time = time_at(case, radius)
        note = f"radius {radius:.6g} m, after the closest approach"
        yield _answer("Time to pass the radius", time, "s", "ρ(t) = radius, by bisection of the "
                      "closed form", note)  # fmt: skip
        yield _answer("Time within the radius", 2 * time, "s", "twice that",
                      "in every half swing")  # fmt: skip
        speed = math.hypot(*case.ideal.velocity(_inner_time(case) + time))
        yield _answer("Speed at the radius", speed, "m/s", "|v(t)|", note)
    when = case.swing / 8 if case.time is None else case.time
    value = radius_at(case, when)
    check = None
    if case.checked:
        motion = case.run(case.launch(case.b, turning=False))
        inner = motion.next_event("inner", after=0.0, within=case.swing)
        x, y, _ = motion.position(inner + when)
        how = "RealMotion without Earth, air and suspension, counted from its closest approach"
        check = Check(value, math.hypot(x, y), how)
    yield _answer("Radius at the time", value, "m", "ρ(t)", f"{when:.6g} s after the closest "
                  "approach", check)  # fmt: skip


def time_at(case: Case, radius: float) -> float:
    """From the closest approach outwards, s; |b| < radius < a."""
    low, high = 0.0, float(case.ideal.radial_period) / 2
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        if radius_at(case, middle) < radius:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def radius_at(case: Case, time: float) -> float:
    """At a time after the closest approach, m."""
    x, y, _ = case.ideal.position(_inner_time(case) + time)
    return math.hypot(x, y)


def _inner_time(case: Case) -> float:
    """Of the first closest approach: the launch is at an outer turning point."""
    return float(case.ideal.radial_period) / 2


def _answer(
    name: str, value: float, unit: str, formula: str, note: str, check: Check | None = None
) -> Answer:
    return Answer("passage", name, value, unit, formula, CLOSED_FORM, note, check)
