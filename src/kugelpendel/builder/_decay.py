"""How the swing dies away, and what is lost in it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel.builder import _measured
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import MOST_SWINGS, Case


def decay(case: Case) -> Iterator[DesignAnswer]:
    """Quality, decay times, the amplitude after a time, and what is lost."""
    if not case.decay:
        return
    if case.linear:
        yield answer("quality_linear", case.omega / (2 * case.linear))
        yield answer("decay_time", 1 / case.linear)
    yield answer("quality_now", case.omega / (2 * case.decay))
    yield answer("half_time", case.fading.until(case.a, case.a / 2))
    yield answer("e_time", case.fading.until(case.a, case.a / math.e))
    left = case.fading.after(case.a, case.after)
    yield answer("amplitude_after", left, _after(case, left), time=case.after)
    yield answer("energy_lost", 4 * math.pi * case.decay / case.omega)
    mass = float(case.pendulum.mass)
    yield answer("power_lost", mass * (case.omega * case.a) ** 2 * case.decay, mass=mass)


def _after(case: Case, expected: float) -> DesignCheck | None:
    """At the time that is asked, or none where that is too many swings to run."""
    if not case.checked or case.after > MOST_SWINGS * case.swing:
        return None
    motion = case.run(case.launch(0.0, turning=False), drag=True, fine=False)
    return DesignCheck(expected, _measured.amplitude(motion, case.after, case.swing), how("drag"))
