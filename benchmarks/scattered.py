"""Positions at scattered times beside NumPy's sine and cosine, and one far from the launch."""

from __future__ import annotations

import time

import numpy as np
from contenders import cartesian, reference
from contenders.cartesian import GRAVITY, LENGTH, PERIOD, A, B
from report import Ratio, Section
from timing import paired

import kugelpendel as kp

COUNT = 1_000_000
SPAN = 1e4  # s
FAR = 1e6 * PERIOD  # s
FASTEST = A * cartesian.OMEGA  # m/s, nearly
ROUNDS = 11
AGAIN = 100  # jumps per round, too short to time one by one


def state() -> tuple[np.ndarray, np.ndarray]:
    """From four numbers to position and velocity a million periods later."""
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.ellipse(A, B))
    return motion.position(FAR), motion.velocity(FAR)


def measure() -> Section:
    truth = reference.Ellipse(A, B, LENGTH, GRAVITY)
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.ellipse(A, B))
    times = np.random.default_rng(1).uniform(0.0, SPAN, COUNT)
    contenders = {
        "ours": lambda: motion.position(times),
        "numpy": lambda: (np.sin(times), np.cos(times)),
    }
    timings = paired(contenders, ROUNDS)
    near = Ratio(
        f"position at 1e6 scattered times in {SPAN:g} s",
        "numpy.sin and numpy.cos of them",
        timings.seconds("ours"),
        timings.seconds("numpy"),
        timings.ratio("ours", "numpy"),
        4.0,
    )

    integrator = cartesian.heyoka()
    start = time.perf_counter()
    integrator.propagate_until(FAR)
    walk = time.perf_counter() - start
    jumps = paired({"ours": lambda: [state() for _ in range(AGAIN)]}, rounds=51)
    jump = jumps.seconds("ours") / AGAIN
    far = Ratio(
        "one state a million periods away, from the launch",
        "heyoka propagate_until",
        jump,
        walk,
        walk / jump,
        1e5,
        at_least=True,
    )

    exact = [float(q.mid()) for q in truth.position(FAR)]
    some = times[:1000]
    there = np.array([[float(q.mid()) for q in truth.position(t)] for t in some])
    off = np.linalg.norm(motion.position(some) - there, axis=1).max() / LENGTH
    ends = [np.linalg.norm(r - exact) / LENGTH for r in (state()[0], integrator.state[:3])]
    blur = np.spacing(FAR) / 2 * FASTEST / LENGTH
    notes = (
        f"Position error / l, ours, largest of 1000 of the scattered times: {off:.1e}.",
        f"A million periods away ({FAR:.4g} s): ours {ends[0]:.1e}, heyoka {ends[1]:.1e}; half a "
        f"unit in the last place of the time itself moves the bob by up to {blur:.1e}.",
        "Ours counts everything from the four numbers to position and velocity; heyoka went all "
        "the way, once, compiled beforehand.",
    )
    return Section("Any time at once", (near, far), (), notes)
