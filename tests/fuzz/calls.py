"""Calls from Python with what people hand over: each is an answer without NaN, or a sentence."""

import contextlib
import random
import traceback
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from tests.fuzz.in_process import TooLong, patience

import kugelpendel as kp

_PATIENCE = 2.0
"""s: a call that somebody asked for may last, if it can be interrupted, as it is here."""

SINGLE = (
    0, 0.0, -0.0, 1, 1.0, -1.0, 0.1, 0.3, 2.0, 3.0, 67.0, 1e-9, 1e-80, 1e-300, 5e-324, 1e9, 1e17,
    1e78, 1e200, 1e308, float("nan"), float("inf"), -float("inf"), 10**400, True, None, "1", "1 m",
    "", b"1", 1j, [], [1.0, 2.0], (0.1,), {}, object(), np.float32(0.5), np.int8(3), np.nan,
    np.array(0.2), np.array([0.1, np.nan]), np.array([[0.1, 0.2], [0.3, 0.4]]), np.zeros((0, 3)),
    np.ma.array([0.1, 0.2], mask=[True, False]), np.array(["a"]), np.datetime64("now"),
)  # fmt: skip

TIMES = (0.0, 1.0, -1.0, 1e3, [0.0, 1.0, 2.0], [1.0, 0.0], [], np.linspace(0, 9, 50), *SINGLE)

LAUNCHES = {
    "ellipse": 3, "apsides": 3, "plane": 4, "angles": 4, "at_rest": 2, "state": 2,
}  # fmt: skip
FORCES = ("site", "drag", "suspension", "bob", "drive")
MOTIONS = (
    "ExactMotion", "LinearMotion", "OlssonMotion", "SeriesMotion", "CubicMotion", "PlaneMotion",
    "RealMotion", "EnvelopeMotion",
)  # fmt: skip


def call_faults(count: int, seed: int, tick: Callable[[], None]) -> list[str]:
    """Every call that ended in something else than an answer or one of our own sentences."""
    chance = random.Random(seed)
    found: list[str] = []
    for _ in range(count):
        said: list[str] = []
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                with contextlib.suppress(TooLong), patience(_PATIENCE):
                    _ask(chance, said)
        except kp.KugelpendelError as error:
            if len(str(error)) < 20:
                found.append(f"{said}: {error!r} is no sentence")
        except Exception:  # noqa: BLE001 — any of them is what is looked for
            found.append(f"{said}\n{traceback.format_exc()}")
        tick()
    return found


def _ask(chance: random.Random, said: list[str]) -> None:
    """One motion out of odd values, and one question to it."""
    length = chance.choice((1.0, 1.0, 67.0, chance.choice(SINGLE)))
    pendulum = _call(said, kp.Pendulum, length, chance.choice((9.81, 9.81, chance.choice(SINGLE))))
    kind = chance.choice(list(LAUNCHES))
    values = [chance.choice((0.1, 0.2, 0.05, chance.choice(SINGLE))) for _ in range(LAUNCHES[kind])]
    if kind == "state" and chance.random() < 0.7:
        values = [(0.0, 0.6 * 1.0, 0.8 * 1.0), (chance.choice((0.1, 1.0, 1e-9)), 0.0, 0.0)]
    launch = _call(said, getattr(kp.Launch, kind), *values)
    name = chance.choice(MOTIONS)
    options: dict[str, Any] = {}
    if name in ("RealMotion", "EnvelopeMotion"):
        options = {which: _force(chance, said, which) for which in FORCES if chance.random() < 0.3}
    elif name == "SeriesMotion":
        options = {"order": chance.choice((2, 4, 6, 3, -2, chance.choice(SINGLE)))}
    motion = _call(said, getattr(kp, name), pendulum, launch, **options)
    question = chance.choice(("position", "velocity", "repr", "precession", "sample", "events"))
    match question:
        case "position" | "velocity":
            answer = _call(said, getattr(motion, question), chance.choice(TIMES))
            if motion.shape == () and not np.isfinite(answer).all():
                raise AssertionError("an answer that is not finite")
        case "repr":
            if len(repr(motion)) > 200 or " at 0x" in repr(motion):
                raise AssertionError(repr(motion))
        case "precession":
            getattr(motion, "precession", None)
        case "sample":
            _call(
                said, motion.sample, 0.0, chance.choice(SINGLE), chance.choice((0, 1, 7, -1, 2.5))
            )
        case _:
            kind = chance.choice(("outer", "inner", "azimuth", "slack", "round", 3))
            _call(said, motion.events, kind, 0.0, chance.choice((1.0, 5.0, chance.choice(SINGLE))))


def _force(chance: random.Random, said: list[str], which: str) -> Any:
    odd = chance.choice(SINGLE)
    match which:
        case "site":
            return _call(said, kp.Site, chance.choice((0.85, -1.0, odd)))
        case "drag":
            return _call(said, kp.Drag, chance.choice((1e-5, 1e-4, odd)), chance.choice((0.0, odd)))
        case "suspension":
            return _call(said, kp.Suspension, chance.choice((1e-5, odd)), chance.choice((0.0, odd)))
        case "bob":
            return _call(said, kp.Bob, chance.choice((0.03, odd)), chance.choice((7860.0, odd)))
        case _:
            return _call(
                said, kp.Drive, chance.choice((1e-6, odd)), phase=chance.choice((0.4, odd))
            )


def _call(said: list[str], what: Callable[..., Any], *values: Any, **named: Any) -> Any:
    shown = [*(f"{v!r:.60}" for v in values), *(f"{k}={v!r:.60}" for k, v in named.items())]
    said.append(f"{getattr(what, '__qualname__', what)}({', '.join(shown)})")
    return what(*values, **named)
