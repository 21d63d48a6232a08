"""The period of the swing, with every correction by itself."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel.builder import _measured
from kugelpendel.builder._answer import DesignAnswer, DesignCheck, answer, how
from kugelpendel.builder._case import Case
from kugelpendel.motion import ExactMotion
from kugelpendel.parameters import Launch

_STANDARD = 9.80665  # m/s², of the tables


def period(case: Case) -> Iterator[DesignAnswer]:
    """Small swings, each correction relative to them, and all together."""
    yield answer("period_small", 2 * math.pi / float(case.pendulum.angular_frequency))
    theta = math.asin(case.a / case.length)
    yield answer("amplitude_series", theta**2 / 16 + 11 * theta**4 / 3072)
    plane = ExactMotion(case.effective, Launch.apsides(case.a, 0.0))
    small = 2 * math.pi / case.omega
    yield answer("amplitude_exact", 2 * float(plane.radial_period) / small - 1)
    width = 2 * (float(case.exact.radial_period) - float(plane.radial_period)) / small
    yield answer("ellipse_width", width, first=case.b**2 / (16 * case.length**2))
    around = dict(_surroundings(case))
    for key, value in (*_bob(case), *around.items()):
        yield answer(key, value)
    total = case.swing * math.prod(1 + value for value in around.values())
    check = None
    if case.checked:
        launch = case.launch(case.b, turning=True)
        motion = case.run(launch, site=True, drag=True, suspension=True)
        check = DesignCheck(total, _measured.period(motion, case.swing), how("everything"))
    yield answer("period", total, check)
    yield answer("gravity_standard", math.sqrt(_STANDARD / case.gravity) - 1)
    if case.forces.site is not None and not case.forces.site.gravity_given:
        normal = float(case.forces.site.gravity)
        yield answer("gravity_site", math.sqrt(normal / case.gravity) - 1, normal=normal)


def _bob(case: Case) -> Iterator[tuple[str, float]]:
    """Those of a ball in air on a thread, each as if it were alone; they are in T0 already."""
    if case.forces.bob is None:
        return
    bob = case.forces.bob
    ratio = float(bob.radius) / case.length
    thread = float(bob.thread_mass) / float(bob.mass)
    air = float(bob.air_density) / float(bob.density)
    yield "bob_radius", math.sqrt(1 + 0.4 * ratio**2) - 1
    yield "thread_mass", math.sqrt((1 + thread / 3) / (1 + thread / 2)) - 1
    yield "buoyancy", 1 / math.sqrt(1 - air) - 1
    yield "added_air", math.sqrt(1 + air / 2) - 1


def _surroundings(case: Case) -> Iterator[tuple[str, float]]:
    """Those of drag, Earth and suspension."""
    if case.linear:
        yield "drag_period", 1 / math.sqrt(1 - (case.linear / case.omega) ** 2) - 1
    if case.earth:
        yield "earth_period", 1 / math.sqrt(1 + (case.earth / case.omega) ** 2) - 1
    if case.forces.suspension is not None and float(case.forces.suspension.anisotropy):
        delta, axis = float(case.forces.suspension.anisotropy), float(case.forces.suspension.axis)
        yield "suspension_period", -delta / case.omega * math.cos(case.azimuth - axis) ** 2
