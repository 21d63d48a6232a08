"""Work enough for every thread, written to the file named: positions of many kinds, many at once.

``python -m tests.motion.workload FILE.npz``: run in processes of its own, since the number of
threads and the arithmetic are settled when the first motion is made.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from tests.motion.launches import GALLERY

from kugelpendel import Drag, ExactMotion, Launch, Pendulum, RealMotion, Site, Suspension

# More than a thread takes at a time of a grid or of scattered times, and no multiple of a block.
MANY = 60_001
SEVERAL = ("ellipse", "over the top", "beyond the separatrix", "cone", "libration")


def results() -> dict[str, np.ndarray]:
    random = np.random.default_rng(26)
    found: dict[str, np.ndarray] = {}
    times = random.uniform(-1e5, 1e5, MANY)
    for name in SEVERAL:
        motion = ExactMotion(*GALLERY[name])
        found[f"{name}: grid"] = motion.sample(-3.0, 0.01, MANY)
        found[f"{name}: position"] = motion.position(times)
        found[f"{name}: velocity"] = motion.velocity(times)
        found[f"{name}: tension"] = motion.tension(times)
    count = 7013
    launch = Launch.angles(
        random.uniform(0, np.pi, count),
        random.uniform(-4, 4, count),
        random.uniform(-2, 2, count),
        random.uniform(-2, 2, count),
    )
    ensemble = ExactMotion(Pendulum(random.uniform(0.5, 2, count), 1.0), launch)
    found["many: position"] = ensemble.position(times[:11] / 1e3)
    found["many: velocity"] = ensemble.velocity(times[:11] / 1e3)
    found["many: grid"] = ensemble.sample(0.0, 0.3, 13)
    for name in ("frequency", "precession", "apsis_time", "slack_time", "turning_heights"):
        found[f"many: {name}"] = np.asarray(getattr(ensemble, name))
    launch = Launch.ellipse(np.linspace(0.01, 0.5, 300), 0.02)
    around = {"site": Site(0.8), "suspension": Suspension(1e-3, 0.4, 1e-4)}
    for name, drag in {"linear": Drag(1e-3), "quadratic": Drag(1e-3, 0.01)}.items():
        real = RealMotion(Pendulum(1.0), launch, drag=drag, **around)
        found[f"real, {name}: position"] = real.position([1.0, 20.0])
    return found


if __name__ == "__main__":
    np.savez(Path(sys.argv[1]), allow_pickle=False, **results())
