"""What an uneven suspension does to the turning, and when it stops it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kugelpendel.builder import _half_turn, _measured
from kugelpendel.builder._answer import AVERAGED, Answer, Check
from kugelpendel.builder._case import Case
from kugelpendel.builder._half_turn import HalfTurn
from kugelpendel.parameters import Suspension

_NARROW = 0.1
"""Beyond this b/a the formulas for b ≪ a miss by tenths."""


def anisotropy(case: Case) -> Iterator[Answer]:
    """Critical amplitude, critical anisotropies, and the slowest and fastest turning."""
    if not case.earth:
        return
    earth, l, omega = abs(case.earth), case.length, case.omega  # noqa: E741
    most = 8 * (l * earth) ** 2 / (3 * omega * case.a**2)
    yield _answer("Anisotropy that may stall this swing", most, "rad/s", "8 l² Ω_z²/(3 ω0 a²)",
                  "less than this is safe; of the angular frequencies; for a start at b = 0, and "
                  "as all of these formulas for b ≪ a")  # fmt: skip
    yield _answer("The same, of the periods", 2 * math.pi * most / omega**2, "s", "2π δ/ω0²")
    yield _answer("Damping anisotropy that stalls", 2 * earth, "1/s", "|Δγ| = 2 |Ω_z|",
                  "of the decay rates; at any amplitude",
                  _stalled(case) if case.checked else None)  # fmt: skip
    stiff = 0.0 if case.suspension is None else float(case.suspension.anisotropy)
    if stiff:
        critical = l * earth * math.sqrt(8 / (3 * omega * abs(stiff)))
        yield _answer("Critical amplitude", critical, "m", "l |Ω_z| √(8/(3 ω0 |δ|))",
                      "a smaller swing cannot stall by the anisotropy; checked by the slowest "
                      "turning")  # fmt: skip
    for turn in _half_turn.half_turns(case):
        yield from _extremes(case, turn)


def _stalled(case: Case) -> Check:
    """The critical damping anisotropy, with its axis where it turns against the Earth most."""
    critical = 2 * case.earth
    axis = case.azimuth - math.pi / 4
    launch = case.launch(0.0, turning=True)
    motion = case.run(launch, site=True, suspension=Suspension(0.0, 0.0, critical, axis))
    rate = _measured.turning_rate(motion, case.swing)
    # What is left of the turning needs so much more of it.
    measured = abs(critical - 2 * rate)
    return Check(abs(critical), measured, "RealMotion with the Earth and this damping: 10 swings")


def _extremes(case: Case, turn: HalfTurn) -> Iterator[Answer]:
    found = _half_turn.run(case, turn)
    stiff = bool(turn.alone.anisotropy)
    cause = "anisotropy" if stiff else "damping"
    law = "−Ω_z ± Δγ/2"
    if stiff:
        law = "ψ'² = ψ'0² + (3/16) ω0 δ (a/l)² (cos 2(ψ0−χ) − cos 2(ψ−χ))"
    how = f"RealMotion with the Earth and the {cause} alone, for {turn.duration:.4g} s"
    slow = None if found is None else Check(turn.slowest, found.slowest, how, case.earth)
    fast = None if found is None else Check(turn.fastest, found.fastest, how)
    note = "" if not turn.stalls else "it turns back" if stiff else "it stalls"
    yield _answer(f"Slowest turning by the {cause}", turn.slowest, "rad/s", law, note, slow)
    yield _answer(f"Fastest turning by the {cause}", turn.fastest, "rad/s", law, "", fast)
    if stiff:
        gain = 3 / 8 * case.omega * case.a / case.length**2
        opened = max(abs(case.earth + rate) for rate in (turn.slowest, turn.fastest)) / gain
        check = None if found is None else Check(opened, found.widest, how)
        note = "on either side"
        if opened > _NARROW * case.a:
            note = "not small beside a, as these formulas need: trust the run"
        law = "largest |b| = |Ω_z + ψ'|·8l²/(3ω0 a)"
        yield _answer("Ellipse that the anisotropy opens", opened, "m", law, note, check)


def _answer(
    name: str, value: float, unit: str, formula: str, note: str = "", check: Check | None = None
) -> Answer:
    return Answer("suspension", name, value, unit, formula, AVERAGED, note, check)
