"""When the bob passes a radius, how long it stays within it, and where it is at a time."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel.builder._answer import CLOSED_FORM, Answer, Check
from kugelpendel.builder._case import Case
from kugelpendel.motion import RealMotion

_BISECTIONS = 60


def passage(case: Case) -> Iterator[Answer]:
    """Times count from the closest approach to the axis."""
    radius = case.a / 2 if case.radius is None else case.radius
    motion = case.run(case.launch(case.b, turning=False)) if case.checked else None
    if radius > abs(case.b):
        time = time_at(case, radius)
        note = f"radius {radius:.6g} m, after the closest approach"
        check = None
        if motion is not None:
            there, speed = _radius_and_rate(motion, case, time)
            # One step of Newton's method from the place where the motion is then.
            check = Check(time, time - (there - radius) / speed, _HOW)
        formula = "ρ(t) = radius, by bisection of the closed form"
        yield _answer("Time to pass the radius", time, "s", formula, note, check)
        yield _answer("Time within the radius", 2 * time, "s", "twice that", "in every half swing")
        speed = math.hypot(*case.ideal.velocity(_inner_time(case) + time))
        yield _answer("Speed at the radius", speed, "m/s", "|v(t)|", note)
    when = case.swing / 8 if case.time is None else case.time
    value = radius_at(case, when)
    check = None if motion is None else Check(value, _radius_and_rate(motion, case, when)[0], _HOW)
    note = f"{when:.6g} s after the closest approach"
    yield _answer("Radius at the time", value, "m", "ρ(t)", note, check)


_HOW = "RealMotion without Earth, air and suspension, counted from its closest approach"


def _radius_and_rate(motion: RealMotion, case: Case, time: float) -> tuple[float, float]:
    """Radius, m, and its rate, m/s, at a time after the motion's own closest approach."""
    at = motion.next_event("inner", within=case.swing) + time
    x, y, _ = motion.position(at)
    vx, vy, _ = motion.velocity(at)
    radius = math.hypot(x, y)
    return radius, (x * vx + y * vy) / radius


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
