"""What an uneven suspension does to the turning, and whether the plane goes round in it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from kugelpendel import _core
from kugelpendel.builder import _measured
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import MOST_SWINGS, Case
from kugelpendel.builder._turning import judged
from kugelpendel.observables import Orbit, Portrait
from kugelpendel.parameters import Drag, Suspension

_MOMENTS = 80
"""Turning points that a run reads in half a turn, where they are two swings apart."""

_FEWEST = 8
"""With fewer, a run would say too little."""

_NARROW = 0.95
"""Beyond this circularity the rate has peaks that are shorter than a run's readings are apart."""


def suspension(case: Case) -> Iterator[DesignAnswer]:
    """Critical anisotropies and amplitude, what this clamp does, and with all that acts."""
    if not case.earth:
        return
    checks = _anisotropy_checks(case)
    basis = checks.get("turning_by_anisotropy")
    critical = _core.critical_anisotropy(case.numbers, case.earth, case.a)
    found = answer("stalling_anisotropy", critical, None, "safe_below")
    yield replace(found, basis=basis)
    periods = 2 * math.pi * critical / case.omega**2
    yield answer("stalling_period_difference", periods)
    yield answer("stalling_damping", _core.critical_damping(case.earth), _stalled(case))
    settled = _settled(case)
    bare = ""
    if case.stiffness:
        largest = _core.critical_amplitude(case.numbers, case.earth, case.stiffness)
        remark = "safe_below_amplitude" if largest else "never_safe"
        yield replace(answer("critical_amplitude", largest, None, remark), basis=basis)
        orbit = portrait(case).orbit
        bare = orbit.verdict
        yield from _stiffness(orbit, checks)
    if case.damping:
        slowest, fastest, duration = _core.under_damping(case.earth, case.damping)
        bare = bare or ("stands" if slowest == 0 else "round")
        yield from _damping(case, slowest, fastest, duration)
    if settled is not None:
        yield from _with_all(case, settled, bare)


def portrait(case: Case) -> Portrait:
    """The map on which this swing is."""
    return Portrait(case.pendulum, case.a, case.b, case.azimuth, case.forces)


def steps(case: Case) -> int:
    """How many moments the runs will read."""
    if not case.earth:
        return 0
    durations = [portrait(case).orbit.period] if case.stiffness else []
    if case.damping:
        durations.append(_time(case, _core.under_damping(case.earth, case.damping)[2]))
    return sum(_moments(case, duration) for duration in durations)


def _moments(case: Case, duration: float) -> int:
    """Turning points that are read in a time; 0 where it is not run."""
    if not case.checked or duration > MOST_SWINGS * case.swing:
        return 0
    count = min(_MOMENTS, int(duration / (2 * case.swing)))
    return count if count >= _FEWEST else 0


def _time(case: Case, duration: float) -> float:
    """Of a half turn; one that comes to rest is followed for as long as the Earth's half turn."""
    return min(duration, 3 * math.pi / abs(case.earth)) if math.isfinite(duration) else (
        math.pi / abs(case.earth)
    )  # fmt: skip


def _stalled(case: Case) -> DesignCheck | None:
    """The critical damping anisotropy, with its axis where it turns against the Earth most."""
    if not case.checked:
        return None
    critical = 2 * case.earth
    axis = case.azimuth - math.pi / 4
    launch = case.launch(0.0, turning=True)
    motion = case.run(launch, site=True, suspension=Suspension(0.0, 0.0, critical, axis))
    rate = _measured.turning_rate(motion, case.swing)
    # What is left of the turning needs so much more of it.
    return DesignCheck(abs(critical), abs(critical - 2 * rate), how("damping"))


@dataclass(frozen=True)
class _Run:
    """Rates in rad/s, the largest |b| in m, over the time of one orbit or half turn."""

    mean: float
    slowest: float
    fastest: float
    widest: float


def _run(case: Case, alone: Suspension, duration: float) -> _Run | None:
    """Follow the full equations, with the Earth and the one cause, without a drive."""
    count = _moments(case, duration)
    if not count:
        return None
    # Uneven damping opens no ellipse, and one would turn by itself.
    b = case.b if alone.anisotropy else 0.0
    # As much drag as it takes that no direction gains energy; it leaves the turning as it is.
    drag = Drag(abs(float(alone.damping_anisotropy)) / 2)
    launch = case.launch(b, turning=True)
    motion = case.run(launch, site=True, drag=drag, suspension=alone, fine=False)
    moments = np.linspace(0.0, duration, count)
    course = _measured.Course.of(motion, case.swing, moments, case.worked)
    way = -math.copysign(1.0, case.earth)
    rates = np.sort(way * course.rates)
    mean = float((course.azimuths[-1] - course.azimuths[0]) / (course.times[-1] - course.times[0]))
    ends = (way * float(rates[0]), way * float(rates[-1]))
    return _Run(mean, *ends, float(course.inner.max()))


def _anisotropy_checks(case: Case) -> dict[str, DesignCheck]:
    """By key, from one run once round the orbit; none where it is not run."""
    if not case.stiffness or case.forces.suspension is None:
        return {}
    orbit = portrait(case).orbit
    alone = Suspension(case.forces.suspension.anisotropy, case.forces.suspension.axis)
    found = _run(case, alone, orbit.period)
    if found is None:
        return {}
    said = how("anisotropy_run", time=orbit.period)
    checks = {"turning_by_anisotropy": judged(case, orbit.rate, found.mean, said)}
    if max(-orbit.limits[0], orbit.limits[1]) < _NARROW:
        checks["slowest_by_anisotropy"] = judged(case, orbit.slowest, found.slowest, said)
        checks["fastest_by_anisotropy"] = judged(case, orbit.fastest, found.fastest, said)
        checks["widest_by_anisotropy"] = DesignCheck(orbit.widest, found.widest, said)
    return checks


def _stiffness(orbit: Orbit, checks: dict[str, DesignCheck]) -> Iterator[DesignAnswer]:
    west, east = _folded(orbit.azimuths)
    key, remark = "turning_by_anisotropy", orbit.verdict.replace(" ", "_")
    facts = {"hours": orbit.period / 3600, "west": west, "east": east}
    yield answer(key, orbit.rate, checks.get(key), remark, **facts)
    values = {
        "slowest_by_anisotropy": orbit.slowest,
        "fastest_by_anisotropy": orbit.fastest,
        "widest_by_anisotropy": orbit.widest,
    }
    backwards = orbit.slowest * orbit.fastest < 0
    for key, value in values.items():
        remark = "turns_back" if backwards and key.startswith("slowest") else ""
        yield answer(key, value, checks.get(key), remark)


def _damping(case: Case, slowest: float, fastest: float, duration: float) -> Iterator[DesignAnswer]:
    assert case.forces.suspension is not None
    _, _, damping, axis = case.forces.suspension.values
    time = _time(case, duration)
    found = _run(case, Suspension(0.0, 0.0, damping, axis), time)
    slow = fast = None
    if found is not None:
        said = how("damping_run", time=time)
        slow = judged(case, slowest, found.slowest, said)
        fast = judged(case, fastest, found.fastest, said)
    yield answer("slowest_by_damping", slowest, slow, "stalls" if slowest == 0 else "")
    yield answer("fastest_by_damping", fastest, fast)


_Settled: TypeAlias = tuple[str, float, float, float, list[float], float, float, bool]


def _settled(case: Case) -> _Settled | None:
    """What the averaged motion comes to; None where nothing acts that the portrait leaves out.

    None as well where it ends before, or has not settled within a month.
    """
    uneven = case.stiffness or case.damping
    if not uneven or (case.forces.drive is None and not case.decay):
        return None
    return _core.settled(*case.averaged(case.b, case.forces))


def _with_all(case: Case, settled: _Settled, bare: str) -> Iterator[DesignAnswer]:
    """What it does with drag and drive as well, and whether the clamp alone would do the same."""
    verdict, start, stop, turned, (left, right), _, _, dies = settled
    what = "dying" if dies else f"settled_{verdict.replace(' ', '_')}"
    stalls = "stalls" if dies and verdict != "round" else ""
    changed = "same" if (verdict == "round") == (bare == "round") else "changed"
    west, east = _folded((left, right))
    yield answer(
        "settled_rate", turned / (stop - start), None, what, stalls, changed,
        "settled_after" if start else "",
        hours=(stop - start) / 3600, degrees=math.degrees(turned), west=west, east=east,
        alone=-math.degrees(case.earth * (stop - start)), after=start / 3600,
    )  # fmt: skip


def _folded(azimuths: tuple[float, float]) -> tuple[float, float]:
    """Of an axis, in degrees, their middle from −90 to 90; 0 where they are infinite."""
    left, right = azimuths
    if not math.isfinite(right - left):
        return 0.0, 0.0
    turns = math.pi * round((left + right) / 2 / math.pi)
    return math.degrees(left - turns), math.degrees(right - turns)
