"""How the plane of the swing turns: with the Earth, and by itself where it is an ellipse."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from kugelpendel import _core, olsson
from kugelpendel.builder import _measured
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import Case
from kugelpendel.motion import CAUSES
from kugelpendel.parameters import Launch

_DAY = 86400.0  # s
_SWINGS = 10  # over which the checks take a mean
_ROUNDING = 1e-14  # of a rate beside those of which it is made


def foucault(case: Case) -> Iterator[DesignAnswer]:
    """What the Earth does to any pendulum there."""
    if case.forces.site is None:
        return
    rate = -case.earth
    check = None
    if case.checked:
        start = case.pushed(case.a, -case.ground(case.a))
        check = judged(case, rate, _rate(case, start), how("no_ellipse"))
    yield answer("foucault_rate", rate, check)
    yield answer("foucault_turn", 2 * math.pi / abs(rate) if rate else math.inf)
    yield answer("foucault_day", rate * _DAY)


def intrinsic(case: Case) -> Iterator[DesignAnswer]:
    """What the ellipse does by itself, and how narrow it has to be."""
    yield answer("intrinsic_first", _first(case, case.b))
    exact = float(case.exact.precession)
    check = None
    if case.checked and case.b:
        measured = _rate(case, case.launch(case.b, turning=False), site=False)
        check = DesignCheck(exact, measured, how("bare"))
    yield answer("intrinsic_exact", exact, check)
    if case.earth:
        yield answer("intrinsic_ratio", exact / case.earth)
        yield from _widest(case)


def _first(case: Case, b: float) -> float:
    """By Olsson's (25), rad/s."""
    return float(olsson.precession(case.a, b, case.length, float(case.effective.gravity)))


def _widest(case: Case) -> Iterator[DesignAnswer]:
    allowed = case.share * abs(case.earth)
    largest = allowed / _first(case, 1.0)  # (25) goes with b
    percent = 100 * case.share
    remark, check = "", None
    if largest > case.a / 2:
        remark = "wide"
    elif case.checked:
        measured = _rate(case, case.launch(largest, turning=False), site=False)
        # In metres, as the answer.
        check = DesignCheck(largest, largest * allowed / measured, how("share", percent=percent))
    yield answer("largest_b", largest, check, remark, percent=percent)
    speed = largest * case.omega
    for key, sideways in (("speed_least", -speed), ("speed_most", speed)):
        yield answer(key, sideways - case.ground(case.a), percent=percent)


def release(case: Case) -> Iterator[DesignAnswer]:
    """Let go at rest against the floor, as with a burnt thread."""
    if not case.earth:
        return
    b = case.ground(case.a) / case.omega
    check = None
    if case.checked:
        motion = case.run(case.pushed(case.a, 0.0), site=True)
        x, y, _ = motion.position(motion.next_event("inner", within=case.swing))
        # Distances have no sign, but the ellipse has the Earth's sense.
        radius = math.copysign(math.hypot(x, y), case.earth)
        check = DesignCheck(b, radius, how("first_approach"))
    yield answer("release_b", b, check)
    rate = _first(case, b) - case.earth
    check = None
    if case.checked:
        check = judged(case, rate, _rate(case, case.pushed(case.a, 0.0)), how("release"))
    yield answer("release_rate", rate, check)
    yield answer("release_speed", -case.ground(case.a))


def total(case: Case) -> Iterator[DesignAnswer]:
    """All causes at once, at the start."""
    parts = budget(case)
    for cause, rate in parts.items():
        yield answer(f"share_{cause}", rate)
    value = sum(parts.values())
    check = None
    if case.checked:
        launch = case.launch(case.b, turning=True)
        motion = case.run(launch, site=True, drag=True, suspension=True)
        # Short, for the causes change with a, b and the azimuth.
        measured = _measured.turning_rate(motion, case.swing, 3)
        check = judged(case, value, measured, how("start"))
    yield answer("rate_at_start", value, check)


def budget(case: Case) -> dict[str, float]:
    """What each cause but a drive adds to the rate at the start, rad/s."""
    without = replace(case.forces, drive=None)
    shares, _ = _core.budget_at_start(*case.averaged(case.b, without))
    parts: dict[str, float] = dict(zip(CAUSES, shares, strict=True))
    del parts["drive"]
    clamp = case.forces.suspension
    if clamp is None:
        del parts["anisotropy"], parts["damping"]
        return parts
    # Of a straight swing each share of the clamp is the rest of a subtraction.
    full = max(abs(case.earth), abs(float(clamp.anisotropy)), abs(float(clamp.damping_anisotropy)))
    return {cause: 0.0 if abs(rate) < _ROUNDING * full else rate for cause, rate in parts.items()}


def judged(case: Case, expected: float, measured: float, said: str) -> DesignCheck:
    """A rate beside the Earth's, where that is the larger."""
    if abs(case.earth) > abs(measured):
        return DesignCheck(expected, measured, said, abs(case.earth), "Ω_z")
    return DesignCheck(expected, measured, said)


def _rate(case: Case, launch: Launch, *, site: bool = True) -> float:
    return _measured.turning_rate(case.run(launch, site=site), case.swing, _SWINGS)
