"""Motions that are integrated, and go on from where they were: stretch by stretch, and late."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from report import Ratio, Section
from timing import paired

import kugelpendel as kp
from kugelpendel.motion import SteppedMotion

STRETCHES = 40
LENGTHS = (10.0, 100.0)  # s, of a stretch
STEP = 0.01  # s
LATE = 86400.0  # s
COUNT = 10_000
ROUNDS = 9
PENDULUM, LAUNCH = kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1)
AIR = kp.Drag(1e-6)  # so little that the swing of a day later is nearly that of the launch

MOTIONS: dict[str, Callable[[], SteppedMotion]] = {
    "RealMotion": lambda: kp.RealMotion(PENDULUM, LAUNCH, drag=AIR),
    "PlaneMotion, (12)": lambda: kp.PlaneMotion(PENDULUM, LAUNCH),
    "CubicMotion, (13)": lambda: kp.CubicMotion(PENDULUM, LAUNCH),
}


def measure() -> Section:
    ratios = [in_turn(name, length) for length in LENGTHS for name in MOTIONS]
    ratios += [late(name) for name in MOTIONS]
    notes = [
        f"In turn: position, then velocity, of each of {STRETCHES} stretches one after the other, "
        f"every {STEP:g} s, from the launch on. The steps are gone twice, since a walk keeps where "
        f"its steps begin, not their series.",
        "At 24 h: once the motion has been asked for a time there; at the launch: of a motion that "
        "has been asked for nothing.",
    ]
    return Section("Going on", ratios, (), notes)


def in_turn(name: str, length: float) -> Ratio:
    """Position and velocity by stretches, beside all positions in one call."""
    count = round(length / STEP)
    times = STEP * np.arange(STRETCHES * count)

    def turn() -> None:
        motion = MOTIONS[name]()
        for stretch in times.reshape(STRETCHES, count):
            motion.position(stretch)
            motion.velocity(stretch)

    once = {"once": lambda: MOTIONS[name]().position(times)}
    # A short run is lengthened by whatever else the machine does; more rounds make up for it.
    timings = paired({"turn": turn} | once, round(ROUNDS * LENGTHS[-1] / length))
    work = f"{name}, in turn in {STRETCHES} stretches of {length:g} s"
    seconds = timings.seconds("turn"), timings.seconds("once")
    return Ratio(work, "all positions at once", *seconds, timings.ratio("turn", "once"), 2.5)


def late(name: str) -> Ratio:
    """Positions a day after the launch, beside those after it."""
    times = STEP * np.arange(COUNT)
    ready: list[SteppedMotion] = []
    for _ in range(ROUNDS + 1):  # one for each round, and one to warm up
        ready.append(MOTIONS[name]())
        ready[-1].position(LATE)
    contenders = {
        "late": lambda: ready.pop().position(LATE + times),
        "early": lambda: MOTIONS[name]().position(times),
    }
    timings = paired(contenders, ROUNDS)
    work = f"{name}, {COUNT} positions at {LATE / 3600:g} h"
    seconds = timings.seconds("late"), timings.seconds("early")
    return Ratio(work, "the same at t = 0", *seconds, timings.ratio("late", "early"), 2.0)
