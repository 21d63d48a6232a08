"""What an uneven suspension does to the turning, and when it stops it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..parameters import Suspension
from . import _measured
from ._answer import AVERAGED, Answer, Check
from ._case import Case

MOMENTS = 80
"""Turning points that a check reads in half a turn."""

_MOST_SWINGS = 40_000
"""A half turn of more swings is not run."""

_LAW = "ψ'² = ψ'0² + (3/16) ω0 δ (a/l)² (cos 2(ψ0−χ) − cos 2(ψ−χ))"


def anisotropy(case: Case) -> Iterator[Answer]:
    """Critical amplitude, critical anisotropies, and the slowest and fastest turning."""
    if not case.earth:
        return
    earth, l, omega = abs(case.earth), case.length, case.omega  # noqa: E741
    most = 8 * (l * earth) ** 2 / (3 * omega * case.a**2)
    yield _answer("Anisotropy that may stall this swing", most, "rad/s", "8 l² Ω_z²/(3 ω0 a²)",
                  "less than this is safe; of the angular frequencies")  # fmt: skip
    yield _answer("The same, of the periods", 2 * math.pi * most / omega**2, "s", "2π δ/ω0²")
    yield _answer("Damping anisotropy that stalls", 2 * earth, "1/s", "|Δγ| = 2 |Ω_z|",
                  "of the decay rates; at any amplitude")  # fmt: skip
    if case.suspension is None:
        return
    stiff, axis, damping, damping_axis = (float(value) for value in case.suspension.values)
    if stiff:
        critical = l * earth * math.sqrt(8 / (3 * omega * abs(stiff)))
        yield _answer("Critical amplitude", critical, "m", "l |Ω_z| √(8/(3 ω0 |δ|))",
                      "a smaller swing cannot stall by the anisotropy")  # fmt: skip
        yield from _extremes(case, "anisotropy", modulation(case, stiff, axis), _LAW,
                             Suspension(stiff, axis))  # fmt: skip
    if damping:
        pair = (max(earth - abs(damping) / 2, 0.0), earth + abs(damping) / 2)
        yield from _extremes(case, "damping", pair, "|Ω_z| ∓ |Δγ|/2",
                             Suspension(0.0, 0.0, damping, damping_axis))  # fmt: skip


def modulation(case: Case, stiff: float, axis: float) -> tuple[float, float]:
    """Slowest and fastest rate by which the swing turns the Earth's way, rad/s; 0 for a stall.

    From the first integral of the averaged equations for b ≪ a.
    """
    start = -case.earth + 3 / 8 * case.omega * case.a * case.b / case.length**2
    size = 3 / 16 * case.omega * stiff * (case.a / case.length) ** 2
    offset = start**2 + size * math.cos(2 * (case.azimuth - axis))
    slow, fast = offset - abs(size), offset + abs(size)
    return math.sqrt(max(slow, 0.0)), math.sqrt(max(fast, 0.0))


def courses(case: Case) -> int:
    """How many half turns `anisotropy` runs."""
    uneven = case.suspension
    if uneven is None or not case.checked or _half_turn(case) is None:
        return 0
    return bool(uneven.anisotropy) + bool(uneven.damping_anisotropy)


def _extremes(
    case: Case, cause: str, rates: tuple[float, float], law: str, alone: Suspension
) -> Iterator[Answer]:
    found = _run(case, alone) if case.checked else None
    stalls = rates[0] == 0
    for k, name in enumerate(("Slowest", "Fastest")):
        check = None
        if found is not None and not (stalls and k == 0):
            check = Check(rates[k], found.rates[k], _how(cause, found))
        note = "the Earth's way"
        if stalls and k == 0:
            note = "it stalls and may turn back"
            if found is not None:
                note += f": RealMotion has {found.rates[0]:+.3g} rad/s"
        yield _answer(f"{name} turning by the {cause}", rates[k], "rad/s", law, note, check)
    if cause == "anisotropy":
        gain = 3 / 8 * case.omega * case.a / case.length**2
        # A swing that turns back does so as fast as it turned before.
        back = -rates[1] if stalls else rates[0]
        opened = max(abs(abs(case.earth) - rate) for rate in (back, rates[1])) / gain
        check = None if found is None else Check(opened, found.widest, _how(cause, found))
        yield _answer("Ellipse that the anisotropy opens", opened, "m",
                      "largest |b| = |Ω_z − ψ'|·8l²/(3ω0 a)", "on either side", check)  # fmt: skip


@dataclass(frozen=True)
class _Course:
    """Slowest and fastest rate the Earth's way, rad/s; largest |b|, m; over what time, s."""

    rates: tuple[float, float]
    widest: float
    duration: float


def _how(cause: str, found: _Course) -> str:
    return f"RealMotion with the Earth and the {cause} alone, for {found.duration:.4g} s"


def _half_turn(case: Case) -> float | None:
    """How long the Earth takes for it, s; None where that is too many swings."""
    if not case.earth:
        return None
    duration = math.pi / abs(case.earth)
    return duration if duration < _MOST_SWINGS * case.swing else None


def _run(case: Case, alone: Suspension) -> _Course | None:
    duration = _half_turn(case)
    if duration is None:
        return None
    # The bob is let go so that it has the given ellipse; a drive is thought to hold a.
    motion = case.run(case.launch(case.b, turning=True), site=True, suspension=alone, fine=False)
    course = _measured.Course.of(
        motion, case.swing, np.linspace(0.0, duration, MOMENTS), case.worked
    )  # fmt: skip
    rates = -math.copysign(1.0, case.earth) * course.rates
    return _Course(
        (float(rates.min()), float(rates.max())), float(course.inner.max()), duration
    )  # fmt: skip


def _answer(
    name: str, value: float, unit: str, formula: str, note: str = "", check: Check | None = None
) -> Answer:
    return Answer("suspension", name, value, unit, formula, AVERAGED, note, check)
