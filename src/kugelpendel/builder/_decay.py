"""How the swing dies away, and what keeps it up."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel.builder import _measured
from kugelpendel.builder._answer import NELSON, Answer, Check
from kugelpendel.builder._case import Case

_MOST_SWINGS = 400
"""A check over a longer time would take more than a second."""


def amplitude_after(case: Case, time: float, start: float | None = None) -> float:
    """Of the plane swing under linear and quadratic drag, m.

    a' = −γa − ka²: a = a0 e^(−γt)/(1 + k a0 (1 − e^(−γt))/γ).
    """
    a = case.a if start is None else start
    falls = -math.expm1(-case.linear * time)
    spread = falls / case.linear if case.linear else time
    return a * (1 - falls) / (1 + case.square * a * spread)


def time_to(case: Case, amplitude: float) -> float:
    """Until the amplitude has fallen to another one, s; inf without drag.

    t = ln(1 + γ(1/a − 1/a0)/(γ/a0 + k))/γ, which is (1/a − 1/a0)/k without linear drag.
    """
    if not case.decay:
        return math.inf
    gain = (1 / amplitude - 1 / case.a) / (case.linear / case.a + case.square)
    return math.log1p(case.linear * gain) / case.linear if case.linear else gain


def decay(case: Case) -> Iterator[Answer]:
    """Quality, decay times, the amplitude after a time, and the push that holds it."""
    if not case.decay:
        return

    def answer(name: str, value: float, unit: str, formula: str, note: str = "") -> Answer:
        return Answer("decay", name, value, unit, formula, NELSON, note)

    if case.linear:
        quality = case.omega / (2 * case.linear)
        yield answer("Quality of the linear drag", quality, "1", "Q = ω0/2γ")
        yield answer("Decay time of the linear drag", 1 / case.linear, "s", "1/γ", "to 1/e")
    now = case.omega / (2 * case.decay)
    yield answer("Quality at this amplitude", now, "1", "Q = ω0/2(γ + ka), k = (4/3π) c ω0",
                 "linear and quadratic drag; narrow ellipses")  # fmt: skip
    both = "ln(1 + γ(1/a − 1/a0)/(γ/a0 + k))/γ"
    yield answer("Time to half the amplitude", time_to(case, case.a / 2), "s", both)
    yield answer("Time to 1/e of the amplitude", time_to(case, case.a / math.e), "s", both)
    yield Answer(
        "decay", "Amplitude after the time asked", amplitude_after(case, case.after), "m",
        "a0 e^(−γt)/(1 + k a0 (1 − e^(−γt))/γ)", NELSON, f"t = {case.after:g} s",
        _check(case) if case.checked else None,
    )  # fmt: skip
    yield answer("Energy lost in a swing", 4 * math.pi * case.decay / case.omega, "1",
                 "4π (γ + ka)/ω0 = 2π/Q", "as a share of the energy")  # fmt: skip
    mass = float(case.pendulum.mass)
    power = mass * (case.omega * case.a) ** 2 * case.decay
    yield answer("Power lost", power, "W", "m ω0² a² (γ + ka)", f"for {mass:g} kg")


def _check(case: Case) -> Check:
    longest = _MOST_SWINGS * case.swing
    motion = case.run(case.launch(0.0, turning=False), drag=True)
    time, radius = _measured.amplitude(motion, min(case.after, longest), case.swing)
    how = f"RealMotion with the drag alone, at the turning point after {time:.6g} s"
    return Check(amplitude_after(case, time), radius, how)
