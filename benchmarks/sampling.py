"""Ten million positions on a uniform grid, beside a memory fill and heyoka's dense output."""

from __future__ import annotations

import numpy as np
from contenders import cartesian, reference
from contenders.cartesian import GRAVITY, LENGTH, A, B
from flint import arb
from report import Ratio, Section
from timing import paired

import kugelpendel as kp

COUNT = 10_000_000
STEPS = (1e-3, 1e-2, 1e-1)  # s: 2000, 200 and 20 samples per period
PARTS = (COUNT, COUNT, 500_000)  # heyoka's share of the grid; what is left out is scaled linearly
ROUNDS = 5


def measure() -> Section:
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.ellipse(A, B))
    integrator = cartesian.heyoka()
    touched = np.full((COUNT, 3), 1.0)
    truth = reference.Ellipse(A, B, LENGTH, GRAVITY)
    ratios, notes = [], []
    for step, part in zip(STEPS, PARTS, strict=True):
        grid = step * np.arange(part)

        def dense(grid: np.ndarray = grid) -> np.ndarray:
            cartesian.rewind(integrator)
            return integrator.propagate_grid(grid)[-1]

        contenders = {
            "ours": lambda step=step: motion.sample(0.0, step, COUNT),
            "ours again": lambda step=step: motion.sample(0.0, step, COUNT, out=touched),
            "new memory": lambda: np.full((COUNT, 3), 1.0),
            "touched memory": lambda: touched.fill(1.0),
            "heyoka": dense,
        }
        timings = paired(contenders, ROUNDS)
        work = f"sample of 1e7 positions, every {step * 1e3:g} ms"
        ours = timings.seconds("ours")
        if step == STEPS[0]:
            fill = timings.seconds("new memory")
            value = timings.ratio("ours", "new memory")
            ratios.append(Ratio(work, "numpy.full of the same shape", ours, fill, value, 4.0))
            again = timings.seconds("touched memory")
            value = timings.ratio("ours again", "touched memory")
            filled = timings.seconds("ours again")
            name = "fill of an array in use"
            ratios.append(
                Ratio(f"the same, out=…: {step * 1e3:g} ms", name, filled, again, value, 4.0)
            )
        scale = COUNT / part
        peer = "heyoka propagate_grid"
        whole = timings.seconds("heyoka") * scale
        for name, label in (("ours", work), ("ours again", f"the same, out=…: {step * 1e3:g} ms")):
            value = 1 / timings.ratio(name, "heyoka", scale)
            taken = timings.seconds(name)
            ratios.append(Ratio(label, peer, taken, whole, value, 30.0, at_least=True))
        notes.append(f"Every {step * 1e3:g} ms, {errors(motion, step, dense(), part, truth)}")
    notes += [
        "sample returns new memory, as numpy.full and heyoka do; with out=… it fills an array in "
        "use, which leaves out what the system takes to hand out 240 MB.",
        f"Every {STEPS[-1] * 1e3:g} ms heyoka ran {PARTS[-1]} points; its time is scaled by "
        f"{COUNT / PARTS[-1]:g}.",
    ]
    return Section("Sampling on a uniform grid", ratios, (), notes)


def errors(
    motion: kp.ExactMotion, step: float, dense: np.ndarray, part: int, truth: reference.Ellipse
) -> str:
    """Largest position error over the last hundred points, ours of both ends, heyoka of its own."""
    ours = motion.sample(0.0, step, COUNT)
    found = []
    for path, end in ((ours, part), (dense[:, :3], part), (ours, COUNT)):
        rows = range(end - 100, end)
        exact = [[float(q.mid()) for q in truth.position(arb(step) * row)] for row in rows]
        found.append(np.linalg.norm(path[rows] - exact, axis=1).max() / LENGTH)
    return (
        f"position error / l after {step * part:g} s: ours {found[0]:.1e}, heyoka {found[1]:.1e}; "
        f"after all {step * COUNT:g} s: ours {found[2]:.1e}."
    )
