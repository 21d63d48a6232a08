"""What the wire has to bear, how far it stretches, and what warmth does to the period."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import Case

_SAMPLES = 2000
_DAY = 86400.0  # s


def wire(case: Case) -> Iterator[DesignAnswer]:
    """Tension, and with a wire stress, stretch and the change of the period with temperature."""
    least, most = _tension(case, 0.0), _tension(case, case.swing / 4)
    checks = _checks(case, least, most) if case.checked else (None, None)
    mass = float(case.pendulum.mass)
    yield answer("tension_least", least, checks[0], mass=mass)
    yield answer("tension_largest", most, checks[1], mass=mass)
    if case.wire is None:
        return
    area, young = float(case.wire.cross_section), float(case.wire.young)
    own = 0.0 if case.forces.bob is None else float(case.forces.bob.thread_mass) * case.gravity
    yield answer("stress", (most + own) / area, None, "weight" if own else "no_weight")
    rest = mass * case.gravity
    yield answer("stretch_rest", (rest + own / 2) * case.length / (area * young))
    yield answer("stretch_swing", (most - least) * case.length / (area * young))
    warm = float(case.wire.expansion)
    yield answer("lengthening", warm * case.length)
    yield answer("period_kelvin", warm / 2, daily=_DAY * warm / 2)


def _tension(case: Case, time: float) -> float:
    """Pull of the wire on the bob, N: least at the launch, largest at the closest approach."""
    speed = math.hypot(*case.exact.velocity(time))
    height = float(case.exact.position(time)[2])
    return float(case.pendulum.mass) * (speed**2 + case.gravity * height) / case.length


def _checks(case: Case, least: float, most: float) -> tuple[DesignCheck, DesignCheck]:
    motion = case.run(case.launch(case.b, turning=False))
    tension = motion.tension(np.linspace(0.0, case.swing, _SAMPLES + 1))
    said = how("tension", samples=_SAMPLES)
    return DesignCheck(least, float(tension.min()), said), DesignCheck(
        most, float(tension.max()), said
    )
