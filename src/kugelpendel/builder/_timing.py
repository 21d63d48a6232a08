"""When to push, how hard, and what a push at the wrong time or of the wrong size does."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from kugelpendel.builder import _measured
from kugelpendel.builder._answer import AVERAGED, SCHUMACHER, Answer, Check
from kugelpendel.builder._case import Case
from kugelpendel.errors import KugelpendelError
from kugelpendel.parameters import Drag, Drive

_SWINGS = 10  # over which the runs take a mean

_OFFSET = math.radians(15)
"""How much too early and too late; half of the phase itself where that is less."""

_NARROW = 0.05
"""b/a of the ellipse that is run where none is given."""


@dataclass(frozen=True)
class Push:
    """A radial push at a phase after the closest approach, and what it does on the average."""

    case: Case
    b: float
    size: float
    phase: float

    @property
    def radius(self) -> float:
        """Where the bob is pushed, m: √(a² sin²φ + b² cos²φ)."""
        return math.hypot(self.case.a * math.sin(self.phase), self.b * math.cos(self.phase))

    @property
    def growth(self) -> float:
        """Rate at which it alone would make the amplitude grow, a'/a, 1/s."""
        return self.size * math.sin(2 * self.phase) / (2 * math.pi * self.radius)

    @property
    def final_amplitude(self) -> float:
        """Where growth and drag balance, m; 0 where the push takes energy away."""
        case = self.case
        gain = self.size * math.cos(self.phase) / math.pi
        if gain <= 0:
            return 0.0
        if not case.square:
            return gain / case.linear
        root = math.sqrt(case.linear**2 + 4 * case.square * gain)
        return 2 * gain / (case.linear + root)

    @property
    def turning(self) -> float:
        """What it adds to the rate of the ellipse, rad/s.

        With the push that holds the amplitude, and b ≪ a sin φ: −2γ(b/a) cot 2φ.
        """
        a, b = self.case.a, self.b
        share = a * b / (a**2 - b**2) * math.cos(2 * self.phase)
        return -self.size / (math.pi * self.radius) * share


def best_push(case: Case, b: float) -> Push:
    """The one that holds the amplitude and cancels the intrinsic precession, for b ≪ a sin φ."""
    quality = case.omega / (2 * case.decay)
    phase = math.atan2(8 * case.length**2, 3 * quality * case.a**2) / 2
    return Push(case, b, holding(case, phase), phase)


def holding(case: Case, phase: float) -> float:
    """The push that holds the amplitude, m/s: πa(γ + ka)/cos φ."""
    return math.pi * case.a * case.decay / math.cos(phase)


def timing(case: Case) -> Iterator[Answer]:
    """The best push, and what becomes of others, by running them."""
    if not case.decay:
        return
    best = best_push(case, case.b or _NARROW * case.a)
    law = "tan 2φ = 8l²/(3Qa²), Q = ω0/2(γ + ka)"
    note = "after the closest approach; it cancels the intrinsic precession"
    source = f"{AVERAGED}; {SCHUMACHER}"
    yield Answer("drive", "Phase of the best push", best.phase, "rad", law, source, note)
    yield _answer("Time of the best push", best.phase / case.omega, "s", "φ/ω0",
                  "after the closest approach")  # fmt: skip
    yield _answer("Radius of the best push", case.a * math.sin(best.phase), "m", "a sin φ",
                  "on the way out")  # fmt: skip
    yield _answer("Size of the best push", best.size, "m/s", "p = πa(γ + ka)/cos φ",
                  "outwards in every half swing; it holds the amplitude")  # fmt: skip
    pull = math.pi / 2 - best.phase
    yield _answer("Radius of the best pull", case.a * math.sin(pull), "m", "a cos φ",
                  "on the way in, for a coil that pulls")  # fmt: skip
    yield _answer("Size of the best pull", holding(case, pull), "m/s", "p = πa(γ + ka)/sin φ",
                  "inwards in every half swing")  # fmt: skip
    off = min(_OFFSET, best.phase / 2, (math.pi / 2 - best.phase) / 2)
    yield from _tried("the best push", best)
    yield from _tried("the best pull", replace(best, size=-holding(case, pull),
                                               phase=math.pi - pull))  # fmt: skip
    for name, push in (
        ("a push too early", replace(best, phase=best.phase - off)),
        ("a push too late", replace(best, phase=best.phase + off)),
        ("a push too weak", replace(best, size=best.size / 2)),
        ("a push too strong", replace(best, size=2 * best.size)),
    ):
        yield from _tried(name, push)
    if case.drive is not None:
        size, phase = float(case.drive.push), _phase(case, case.drive)
        yield from _tried("the drive given", replace(best, size=size, phase=phase))


def _phase(case: Case, drive: Drive) -> float:
    """Of a drive that is given by its radius, as the bob passes it on the way out."""
    if drive.radius is None:
        return 0.0 if drive.phase is None else float(drive.phase)
    return math.asin(min(float(drive.radius) / case.a, 1.0))


def _tried(name: str, push: Push) -> Iterator[Answer]:
    """Turning of the ellipse and amplitude under a push, beside what running it gives."""
    case, b = push.case, push.b
    intrinsic = 3 / 8 * case.omega * case.a * b / case.length**2
    rate = intrinsic + push.turning
    growth = push.growth - case.decay
    where = f"{math.degrees(push.phase):.4g}°, {1e3 * push.size:.4g} mm/s, b = {b:.4g} m"
    turning, growing = _checks(push, rate, growth, intrinsic)
    note = f"φ = {where}; without a push {math.degrees(intrinsic) * 3600:.4g} °/h"
    formula = "(3/8) ω0 ab/l² − (p/πρ) ab/(a²−b²) cos 2φ"
    yield _answer(f"Turning under {name}", rate, "rad/s", formula, note, turning)
    formula = "p sin 2φ/(2πρ) − γ − ka, ρ² = a² sin²φ + b² cos²φ"
    yield _answer(f"Growth under {name}", growth, "1/s", formula, "of the amplitude", growing)
    end = push.final_amplitude
    note = "the push takes energy away" if end == 0 else ""
    if end >= case.length:
        note = "beyond the length: it pumps without end, and is not run"
    yield _answer(f"Amplitude under {name}", end, "m", "γa + ka² = p cos φ/π", note)


def _checks(
    push: Push, rate: float, growth: float, intrinsic: float
) -> tuple[Check, Check] | tuple[None, None]:
    """Of turning and growth; none for a push that RealMotion refuses, as it pumps without end."""
    case = push.case
    if not case.checked:
        return None, None
    # A plane swing loses as much by linear drag alone, and linear drag leaves b/a as it is.
    drive, drag = Drive(push.size, phase=push.phase), Drag(case.decay)
    try:
        motion = case.run(case.launch(push.b, turning=False), drag=drag, drive=drive)
        times, points = _measured.outer_points(
            motion, 0.25 * case.swing, (_SWINGS + 0.75) * case.swing
        )
    except KugelpendelError:
        return None, None
    how = f"RealMotion with the drag as linear and this push: {_SWINGS} swings"
    span = float(times[-1] - times[0])
    first, last = (math.hypot(*points[k]) for k in (0, -1))
    turned = float(_measured.turned(points)[-1]) / span
    grown = math.log(last / first) / span
    return Check(rate, turned, how, intrinsic), Check(growth, grown, how, case.decay)


def _answer(
    name: str, value: float, unit: str, formula: str, note: str = "", check: Check | None = None
) -> Answer:
    return Answer("drive", name, value, unit, formula, AVERAGED, note, check)
