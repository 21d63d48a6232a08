"""The ladder of approximations: sampling beside a memory fill, and the map of how good they are."""

from __future__ import annotations

import numpy as np
from report import Ratio, Section
from timing import paired

import kugelpendel as kp

COUNT = 10_000_000
STEP = 1e-3  # s: 2000 samples a period
POINTS = 400
ALLOWED = 2.0  # s, for the map
ROUNDS = 5
PENDULUM, LAUNCH = kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1)


def measure() -> Section:
    motions = {
        "LinearMotion": kp.LinearMotion(PENDULUM, LAUNCH),
        "OlssonMotion": kp.OlssonMotion(PENDULUM, LAUNCH),
        "SeriesMotion(6)": kp.SeriesMotion(PENDULUM, LAUNCH, order=6),
        "SeriesMotion(12)": kp.SeriesMotion(PENDULUM, LAUNCH, order=12),
    }
    fill = {"numpy.full": lambda: np.full((COUNT, 3), 1.0)}
    ratios = []
    for name, motion in motions.items():
        ours = {name: lambda motion=motion: motion.sample(0.0, STEP, COUNT)}
        timings = paired(ours | fill, ROUNDS)
        seconds = timings.seconds(name), timings.seconds("numpy.full")
        work = f"{name}.sample of 1e7 positions"
        value = timings.ratio(name, "numpy.full")
        ratios.append(Ratio(work, "numpy.full of the same shape", *seconds, value, 4.0))
    timings = paired({"map": lambda: kp.validity_map(POINTS)}, ROUNDS)
    taken = timings.seconds("map")
    work = f"validity_map of {POINTS} × {POINTS} ellipses"
    ratios.append(Ratio(work, "the time allowed", taken, ALLOWED, taken / ALLOWED, 1.0))
    notes = [
        f"The map has the errors of (25), (26) and of the series of orders 2 … 12 for {POINTS**2} "
        "ellipses; the time allowed for it is on this machine, and no peer's.",
    ]
    return Section("The ladder of approximations", ratios, (), notes)
