"""When to push, how hard, and what a push at the wrong time or of the wrong size does."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from kugelpendel import _core
from kugelpendel.builder import _measured
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import Case
from kugelpendel.errors import KugelpendelError
from kugelpendel.parameters import Drag, Drive, Forces

_SWINGS = 10  # over which the runs take a mean

_OFFSET = math.radians(15)
"""How much too early and too late; half of the phase itself where that is less."""

_NARROW = 0.05
"""b/a of the ellipse that is run where none is given."""


@dataclass(frozen=True)
class Push:
    """A radial push of a size in m/s, at a phase in rad after the closest approach."""

    size: float
    phase: float


def drive(case: Case) -> Iterator[DesignAnswer]:
    """The best push, and what becomes of others, by running them."""
    if not case.decay:
        return
    phase = case.fading.best_phase(case.numbers, case.a)
    best = Push(case.fading.holding(case.a, phase), phase)
    late = math.pi / 2 - phase
    pull = case.fading.holding(case.a, late)
    yield answer("best_phase", phase)
    yield answer("best_time", phase / case.omega)
    yield answer("best_radius", case.a * math.sin(phase))
    yield answer("best_push", best.size)
    yield answer("best_pull_radius", case.a * math.sin(late))
    yield answer("best_pull", pull)
    off = min(_OFFSET, phase / 2, late / 2)
    tried = {
        "best_push": best,
        "best_pull": Push(-pull, math.pi - late),
        "early": replace(best, phase=phase - off),
        "late": replace(best, phase=phase + off),
        "weak": replace(best, size=best.size / 2),
        "strong": replace(best, size=2 * best.size),
    }
    if case.forces.drive is not None:
        tried["given"] = Push(float(case.forces.drive.push), _phase(case, case.forces.drive))
    for key, push in tried.items():
        yield from _tried(case, key, push)


def _phase(case: Case, drive: Drive) -> float:
    """Of a drive that is given by its radius, as the bob passes it on the way out."""
    if drive.radius is None:
        return 0.0 if drive.phase is None else float(drive.phase)
    return math.asin(min(float(drive.radius) / case.a, 1.0))


def _tried(case: Case, key: str, push: Push) -> Iterator[DesignAnswer]:
    """Turning of the ellipse and amplitude under a push, beside what running it gives."""
    b = case.b or _NARROW * case.a
    # A plane swing loses as much by linear drag alone, and linear drag leaves b/a as it is.
    drag = Drag(case.decay)
    forces = Forces(drag=drag, bob=case.forces.bob, drive=Drive(push.size, phase=push.phase))
    shares, (grows, _) = _core.budget_at_start(*case.averaged(b, forces))
    _, intrinsic, _, _, pushed = shares
    facts = {
        "phase": math.degrees(push.phase), "push": 1e3 * push.size, "b": b,
        "intrinsic": math.degrees(intrinsic) * 3600,
    }  # fmt: skip
    rate, growth = intrinsic + pushed, grows / case.a
    turning, growing = _checks(case, forces, b, (rate, growth, intrinsic))
    yield answer(f"turning_{key}", rate, turning, **facts)
    yield answer(f"growth_{key}", growth, growing)
    end = case.fading.final_amplitude(push.size, push.phase)
    remark = "takes" if end == 0 else "pumps" if end >= case.length else ""
    yield answer(f"amplitude_{key}", end, None, remark)


def _checks(
    case: Case, forces: Forces, b: float, rates: tuple[float, float, float]
) -> tuple[DesignCheck, DesignCheck] | tuple[None, None]:
    """Of turning and growth; none for a push that RealMotion refuses, as it pumps without end."""
    if not case.checked:
        return None, None
    try:
        motion = case.run(
            case.launch(b, turning=False), drag=forces.drag or False, drive=forces.drive
        )
        times, points = _measured.outer_points(
            motion, 0.25 * case.swing, (_SWINGS + 0.75) * case.swing
        )
    except KugelpendelError:
        return None, None
    span = float(times[-1] - times[0])
    first, last = (math.hypot(*points[k]) for k in (0, -1))
    turned = float(_measured.turned(points)[-1]) / span
    grown = math.log(last / first) / span
    rate, growth, intrinsic = rates
    return (
        DesignCheck(rate, turned, how("push"), intrinsic, "Ω(a, b)"),
        DesignCheck(growth, grown, how("push"), case.decay, "γ + ka"),
    )
