"""The period of the swing, with every correction by itself."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from kugelpendel.builder import _measured
from kugelpendel.builder._answer import AVERAGED, CLOSED_FORM, NELSON, Answer, Check
from kugelpendel.builder._case import Case
from kugelpendel.motion import ExactMotion
from kugelpendel.parameters import Launch

_STANDARD = 9.80665  # m/s², of the tables


def period(case: Case) -> Iterator[Answer]:
    """Small swings, each correction relative to them, and all together."""

    def answer(name: str, value: float, formula: str, source: str, note: str = "") -> Answer:
        return Answer("period", name, value, "1", formula, source, note)

    point = 2 * math.pi / float(case.pendulum.angular_frequency)
    yield Answer("period", "Period of small swings", point, "s", "T0 = 2π √(l/g)", NELSON)
    theta = math.asin(case.a / case.length)
    series = theta**2 / 16 + 11 * theta**4 / 3072
    yield answer("Amplitude, by the series", series, "θ0²/16 + 11 θ0⁴/3072, sin θ0 = a/l", NELSON)
    plane = ExactMotion(case.effective, Launch.apsides(case.a, 0.0))
    small = 2 * math.pi / case.omega
    amplitude = 2 * float(plane.radial_period) / small - 1
    yield answer("Amplitude, exact", amplitude, "2K(m)/π − 1, m = sin²(θ0/2)", CLOSED_FORM)
    width = 2 * (float(case.ideal.radial_period) - float(plane.radial_period)) / small
    first = case.b**2 / (16 * case.length**2)
    note = f"b²/16l² = {first:.3g} by (26)"
    yield answer("Width of the ellipse", width, "T(a, b)/T0 − T(a, 0)/T0", CLOSED_FORM, note)
    corrections = [*_bob(case), *_surroundings(case)]
    for name, value, formula, source, note in corrections:
        yield answer(name, value, formula, source, note)
    total = case.swing * math.prod(1 + value for _, value, *_ in _surroundings(case))
    check = _check(case, total) if case.checked else None
    yield Answer("period", "Period of the swing", total, "s", "T0 with all of these",
                 f"{NELSON}; {CLOSED_FORM}", check=check)  # fmt: skip
    yield from _of_the_site(case, answer)


_Correction = tuple[str, float, str, str, str]
"""Name, relative change of the period, formula, source, note."""


def _bob(case: Case) -> Iterator[_Correction]:
    """Those of a ball in air on a thread, each as if it were alone."""
    if case.bob is None:
        return
    bob = case.bob
    ratio = float(bob.radius) / case.length
    thread = float(bob.thread_mass) / float(bob.mass)
    air = float(bob.air_density) / float(bob.density)
    size = math.sqrt(1 + 0.4 * ratio**2) - 1
    yield "Bob's radius", size, "√(1 + (2/5)(r/l)²) − 1 ≈ (1/5)(r/l)²", NELSON, ""
    mass = math.sqrt((1 + thread / 3) / (1 + thread / 2)) - 1
    yield "Thread's mass", mass, "√((1 + μ/3)/(1 + μ/2)) − 1 ≈ −μ/12, μ = m_t/m", NELSON, ""
    lift = 1 / math.sqrt(1 - air) - 1
    yield "Buoyancy", lift, "1/√(1 − β) − 1 ≈ β/2, β = ρ_air/ρ_bob", NELSON, ""
    moved = math.sqrt(1 + air / 2) - 1
    yield "Air that moves along", moved, "√(1 + β/2) − 1 ≈ β/4", NELSON, "half the displaced air"


def _surroundings(case: Case) -> Iterator[_Correction]:
    """Those of drag, Earth and suspension."""
    if case.linear:
        value = 1 / math.sqrt(1 - (case.linear / case.omega) ** 2) - 1
        yield "Linear drag", value, "1/√(1 − (γ/ω0)²) − 1 ≈ 1/8Q²", NELSON, ""
    if case.earth:
        value = 1 / math.sqrt(1 + (case.earth / case.omega) ** 2) - 1
        formula = "1/√(1 + (Ω_z/ω0)²) − 1"
        yield "Turning of the Earth", value, formula, AVERAGED, ""
    if case.suspension is not None and float(case.suspension.anisotropy):
        delta, axis = float(case.suspension.anisotropy), float(case.suspension.axis)
        value = -delta / case.omega * math.cos(case.azimuth - axis) ** 2
        formula = "−(δ/ω0) cos²(ψ − χ)"
        yield "Suspension", value, formula, AVERAGED, "at the start"


def _check(case: Case, expected: float) -> Check:
    motion = case.run(
        case.launch(case.b, turning=True), site=True, drag=True, suspension=True
    )  # fmt: skip
    how = (
        "RealMotion with all that is given but the drive: the first swings, between turning points"
    )
    return Check(expected, _measured.period(motion, case.swing), how)


def _of_the_site(case: Case, answer: Callable[..., Answer]) -> Iterator[Answer]:
    against = math.sqrt(_STANDARD / case.gravity) - 1
    formula = "√(9.80665 m/s²/g) − 1"
    note = "in T0 already"
    yield answer("Gravity, against the standard", against, formula, NELSON, note)
    if case.site is not None and not case.site.gravity_given:
        normal = float(case.site.gravity)
        yield answer(
            "Gravity, against that of the site", math.sqrt(normal / case.gravity) - 1,
            "√(g_site/g) − 1", "WGS84 normal gravity: NIMA TR8350.2, eq. (4-1), (4-3)",
            f"normal gravity there is {normal:.6g} m/s²",
        )  # fmt: skip
