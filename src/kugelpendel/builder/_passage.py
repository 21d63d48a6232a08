"""When the bob passes a radius, how long it stays within it, and where it is at a time."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel import _core
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import Case
from kugelpendel.motion import RealMotion


def passage(case: Case) -> Iterator[DesignAnswer]:
    """Times count from the closest approach to the axis."""
    radius = case.a / 2 if case.radius is None else case.radius
    motion = case.run(case.launch(case.b, turning=False)) if case.checked else None
    time = _core.passage_time(case.numbers, (case.a, case.b), radius)
    if time is not None:
        check = None
        if motion is not None:
            there, speed = _radius_and_rate(motion, case, time)
            # One step of Newton's method from the place where the motion is then.
            check = DesignCheck(time, time - (there - radius) / speed, how("passage"))
        yield answer("passage_time", time, check, radius=radius)
        yield answer("time_within", 2 * time)
        speed = math.hypot(*case.exact.velocity(_inner_time(case) + time))
        yield answer("passage_speed", speed, radius=radius)
    when = case.swing / 8 if case.time is None else case.time
    x, y, _ = case.exact.position(_inner_time(case) + when)
    value = math.hypot(x, y)
    check = None
    if motion is not None:
        check = DesignCheck(value, _radius_and_rate(motion, case, when)[0], how("passage"))
    yield answer("radius_at", value, check, time=when)


def _radius_and_rate(motion: RealMotion, case: Case, time: float) -> tuple[float, float]:
    """Radius, m, and its rate, m/s, at a time after the motion's own closest approach."""
    at = motion.next_event("inner", within=case.swing) + time
    x, y, _ = motion.position(at)
    vx, vy, _ = motion.velocity(at)
    radius = math.hypot(x, y)
    return radius, float(x * vx + y * vy) / radius


def _inner_time(case: Case) -> float:
    """Of the first closest approach: the launch is at an outer turning point."""
    return float(case.exact.radial_period) / 2
