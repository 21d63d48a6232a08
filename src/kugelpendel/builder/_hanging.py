"""What the wire has to bear, how far it stretches, and what warmth does to the period."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kugelpendel.builder._answer import HOOKE, NELSON, OLSSON, Answer, Check
from kugelpendel.builder._case import Case

_SAMPLES = 2000
_DAY = 86400.0  # s


def hanging(case: Case) -> Iterator[Answer]:
    """Tension, and with a wire stress, stretch and the change of the period with temperature."""
    least, most = _tension(case, 0.0), _tension(case, case.swing / 4)
    checks = _checks(case, least, most) if case.checked else (None, None)
    mass = float(case.pendulum.mass)
    law, source = "m (v² + gz)/l", f"{OLSSON}(5a)"
    note = f"for {mass:g} kg, the wire's own weight not in it"
    yield Answer("wire", "Least tension", least, "N", law, source, note, checks[0])
    yield Answer("wire", "Largest tension", most, "N", law, source, note, checks[1])
    if case.wire is None:
        return
    area, young = float(case.wire.cross_section), float(case.wire.young)
    own = 0.0 if case.bob is None else float(case.bob.thread_mass) * case.gravity
    top = "with the wire's own weight, at the top" if own else "without the wire's own weight"
    yield Answer("wire", "Largest stress", (most + own) / area, "Pa", "F/(πd²/4)", HOOKE, top)
    rest = mass * case.gravity
    stretch = (rest + own / 2) * case.length / (area * young)
    yield Answer("wire", "Stretch at rest", stretch, "m", "(m + m_t/2) g l/(E πd²/4)", HOOKE)
    yield Answer("wire", "Stretch from turning point to bottom", (most - least) * case.length
                 / (area * young), "m", "ΔF l/(E πd²/4)", HOOKE)  # fmt: skip
    warm = float(case.wire.expansion)
    yield Answer("wire", "Lengthening by a kelvin", warm * case.length, "m", "α l", NELSON)
    yield Answer("wire", "Period by a kelvin", warm / 2, "1/K", "α/2", NELSON,
                 f"{_DAY * warm / 2:.3g} s in a day")  # fmt: skip


def _tension(case: Case, time: float) -> float:
    """Pull of the wire on the bob, N: least at the launch, largest at the closest approach."""
    speed = math.hypot(*case.ideal.velocity(time))
    height = float(case.ideal.position(time)[2])
    return float(case.pendulum.mass) * (speed**2 + case.gravity * height) / case.length


def _checks(case: Case, least: float, most: float) -> tuple[Check, Check]:
    motion = case.run(case.launch(case.b, turning=False))
    tension = motion.tension(np.linspace(0.0, case.swing, _SAMPLES + 1))
    how = f"RealMotion without Earth, air and suspension: {_SAMPLES} times in a swing"
    return Check(least, float(tension.min()), how), Check(most, float(tension.max()), how)
