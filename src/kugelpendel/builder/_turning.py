"""How the plane of the swing turns: with the Earth, and by itself where it is an ellipse."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel import olsson
from kugelpendel.builder import _measured
from kugelpendel.builder._answer import AVERAGED, CLOSED_FORM, FOUCAULT, OLSSON, Answer, Check
from kugelpendel.builder._case import Case
from kugelpendel.parameters import Launch

_DAY = 86400.0  # s
_GROUND = "aΩ_z − (2/3)(a²/l) Ω_h sin ψ0"
_SWINGS = 10  # over which the checks take a mean


def foucault(case: Case) -> Iterator[Answer]:
    """What the Earth does to any pendulum there."""
    if case.site is None:
        return
    rate = -case.earth
    check = None
    if case.checked:
        start = case.pushed(case.a, -case.ground(case.a))
        how = f"RealMotion with the Earth alone, pushed so that no ellipse opens: {_SWINGS} swings"
        check = Check(rate, _rate(case, start), how)
    yield Answer(
        "turning", "Foucault rate", rate, "rad/s", "−Ω_E sin(latitude), Ω_E = 7.292115e-5 rad/s",
        FOUCAULT, "against the stars: one turn of the Earth in 86164 s", check,
    )  # fmt: skip
    turn = 2 * math.pi / abs(rate) if rate else math.inf
    yield Answer("turning", "One turn by the Earth", turn, "s", "2π/|Ω_z|", FOUCAULT)
    yield Answer("turning", "Turned in 24 h", rate * _DAY, "rad", "−Ω_z · 86400 s", FOUCAULT)


def intrinsic(case: Case) -> Iterator[Answer]:
    """What the ellipse does by itself, and how narrow it has to be."""
    first = float(
        olsson.precession(case.a, case.b, case.length, float(case.effective.gravity))
    )  # fmt: skip
    yield Answer(
        "turning", "Intrinsic rate, formula (25)", first, "rad/s", "(3/8) ω0 ab/l²",
        f"{OLSSON}(25)", "the same as Puiseux's 3RV/8l², R = a, V = bω0",
    )  # fmt: skip
    exact = float(case.ideal.precession)
    check = None
    if case.checked and case.b:
        how = f"RealMotion without Earth, air and suspension: {_SWINGS} swings"
        check = Check(exact, _rate(case, case.launch(case.b, turning=False), site=False), how)
    yield Answer("turning", "Intrinsic rate, exact", exact, "rad/s", "(ΔΦ − π)/T for the turning "
                 "radii a and b", CLOSED_FORM, check=check)  # fmt: skip
    if case.earth:
        yield Answer("turning", "Intrinsic over Foucault rate", exact / case.earth, "1",
                     "Ω(a, b)/Ω_z", CLOSED_FORM)  # fmt: skip
        yield from _widest(case)


def _widest(case: Case) -> Iterator[Answer]:
    share = 8 / 3 * case.share * abs(case.earth) * case.length**2 / (case.omega * case.a)
    percent = f"{100 * case.share:g} %"
    note = ""
    check = None
    if share > case.a / 2:
        note = "wider than half of a: the formula holds for narrow ellipses, so take any b"
    elif case.checked:
        expected = case.share * abs(case.earth)
        measured = _rate(case, case.launch(share, turning=False), site=False)
        # In metres, as the answer: the rate is proportional to b.
        how = f"RealMotion without Earth: the b that turns with {percent} of the Foucault rate"
        check = Check(share, share * expected / measured, how)
    yield Answer(
        "turning", f"Largest b for {percent}", share, "m", "(8/3) x |Ω_z| l²/(ω0 a)",
        f"{OLSSON}(25)", note, check,
    )  # fmt: skip
    speed = share * case.omega
    source = f"{OLSSON}(16); {AVERAGED}"
    for name, b in (("least", -speed), ("most", speed)):
        yield Answer(
            "turning", f"Sideways speed for {percent}, {name}", b - case.ground(case.a), "m/s",
            f"{'−' if b < 0 else '+'}bω0 − {_GROUND}, with that b", source,
            "against the floor; counter-clockwise",
        )  # fmt: skip


def release(case: Case) -> Iterator[Answer]:
    """Let go at rest against the floor, as with a burnt thread."""
    if not case.earth:
        return
    b = case.ground(case.a) / case.omega
    check = None
    if case.checked:
        motion = case.run(case.pushed(case.a, 0.0), site=True)
        x, y, _ = motion.position(motion.next_event("inner", within=case.swing))
        # Distances have no sign, but the ellipse has the Earth's sense.
        radius = math.copysign(math.hypot(x, y), case.earth)
        check = Check(b, radius, "RealMotion with the Earth alone: first closest approach")
    yield Answer(
        "turning", "Ellipse of a release from rest", b, "m", f"b = ({_GROUND})/ω0", AVERAGED,
        "seen from a frame that does not turn, where the floor moves",
        check,
    )  # fmt: skip
    gain = 3 / 8 * case.a * case.ground(case.a) / case.length**2
    rate = gain - case.earth
    check = None
    if case.checked:
        how = f"RealMotion with the Earth alone, at rest at the start: {_SWINGS} swings"
        check = Check(rate, _rate(case, case.pushed(case.a, 0.0)), how)
    law = "−Ω_z (1 − 3a²/8l²) − (1/4)(a/l)³ Ω_h sin ψ0"
    note = "to first orders in a/l"
    yield Answer(
        "turning", "Rate after a release from rest", rate, "rad/s", law, AVERAGED, note, check
    )
    law, note = f"−({_GROUND})", "against the floor; counter-clockwise"
    speed = -case.ground(case.a)
    yield Answer("turning", "Sideways speed for no ellipse", speed, "m/s", law, AVERAGED, note)


def total(case: Case) -> Iterator[Answer]:
    """All causes at once, at the start."""
    parts = shares(case)
    for name, rate in parts.items():
        yield Answer("turning", f"Share of the {name}", rate, "rad/s", _SHARES[name], _LAWS[name],
                     "at the start")  # fmt: skip
    value = sum(parts.values())
    check = None
    if case.checked:
        motion = case.run(case.launch(case.b, turning=True), site=True, drag=True, suspension=True)
        # Short, for the causes change with a, b and the azimuth.
        how = "RealMotion with all that is given but the drive: the first 3 swings"
        check = Check(value, _measured.turning_rate(motion, case.swing, 3), how)
    yield Answer("turning", "Rate at the start", value, "rad/s", "the sum of the shares", AVERAGED,
                 check=check)  # fmt: skip


_SHARES = {
    "Earth": "−Ω_z",
    "ellipse": "(ΔΦ − π)/T for the turning radii a and b",
    "anisotropy": "−δ ab/(a²−b²) cos 2(ψ−χ)",
    "damping": "(Δγ/2)(a²+b²)/(a²−b²) sin 2(ψ−χd)",
}

_LAWS = {
    "Earth": FOUCAULT,
    "ellipse": CLOSED_FORM,
    "anisotropy": AVERAGED,
    "damping": AVERAGED,
}


def shares(case: Case) -> dict[str, float]:
    """What each cause adds to the rate at the start, rad/s."""
    parts = {"Earth": -case.earth, "ellipse": float(case.ideal.precession)}
    if case.suspension is not None:
        a, b = case.a, case.b
        delta, axis, damping, damping_axis = (float(v) for v in case.suspension.values)
        round_ = a**2 - b**2
        parts["anisotropy"] = -delta * a * b / round_ * math.cos(2 * (case.azimuth - axis))
        turn = math.sin(2 * (case.azimuth - damping_axis))
        parts["damping"] = damping / 2 * (a**2 + b**2) / round_ * turn
    return parts


def _rate(case: Case, launch: Launch, *, site: bool = True) -> float:
    return _measured.turning_rate(case.run(launch, site=site), case.swing, _SWINGS)
