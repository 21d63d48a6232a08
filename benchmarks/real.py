"""The full equations of the real pendulum beside the integrators: speed, error, cores."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys

import heyoka as hy
import numpy as np
from contenders.cartesian import GRAVITY, LENGTH, OMEGA, PERIOD, A, B, start
from report import Ratio, Section, Table
from scipy.integrate import solve_ivp
from timing import paired

import kugelpendel as kp

PERIODS = 100
ROUNDS = 7
LATITUDE = 0.85  # rad
GAMMA, QUADRATIC = 1e-4, 0.01  # 1/s, 1/m: a metal bob in air
DELTA, AXIS = 1e-4 * OMEGA, 0.5  # rad/s, rad
PENDULUM, LAUNCH = kp.Pendulum(LENGTH, GRAVITY), kp.Launch.ellipse(A, B)
SITE, SUSPENSION = kp.Site(LATITUDE), kp.Suspension(DELTA, AXIS)

KINDS = {
    "ideal": {},
    "Earth, linear drag, suspension": {
        "site": SITE, "drag": kp.Drag(GAMMA), "suspension": SUSPENSION
    },
    "the same and quadratic drag": {
        "site": SITE, "drag": kp.Drag(GAMMA, QUADRATIC), "suspension": SUSPENSION
    },
}  # fmt: skip
ENSEMBLE = 1000
GROWTH = (1, 10, 100, 1000)


def pull_and_force(kind: str, x, y, z, vx, vy, vz, sqrt):
    """The acceleration, for numbers and for heyoka's expressions alike."""
    forces = [0.0 * x, 0.0 * x, GRAVITY + 0.0 * x]
    if kind == "ideal":
        forces = [0.0, 0.0, GRAVITY]
    else:
        around = KINDS[kind]
        up, north = float(SITE.vertical_rotation), float(SITE.horizontal_rotation)
        along = -2 * OMEGA * DELTA * (x * np.cos(AXIS) + y * np.sin(AXIS))
        drag = -2 * GAMMA
        if np.any(around["drag"].quadratic):
            drag = drag - QUADRATIC * sqrt(vx * vx + vy * vy + vz * vz)
        forces = [
            2 * up * vy + 2 * north * vz + along * np.cos(AXIS) + drag * vx,
            -2 * up * vx + along * np.sin(AXIS) + drag * vy,
            GRAVITY - 2 * north * vx + drag * vz,
        ]
    fx, fy, fz = forces
    inward = fz * z if kind == "ideal" else fx * x + fy * y + fz * z
    pull = (vx * vx + vy * vy + vz * vz + inward) / (x * x + y * y + z * z)
    return fx - pull * x, fy - pull * y, fz - pull * z


def heyoka(kind: str) -> hy.taylor_adaptive:
    x, y, z, vx, vy, vz = variables = hy.make_vars("x", "y", "z", "vx", "vy", "vz")
    ax, ay, az = pull_and_force(kind, *variables, hy.sqrt)
    slopes = [(x, vx), (y, vy), (z, vz), (vx, ax), (vy, ay), (vz, az)]
    return hy.taylor_adaptive(slopes, start())


def ours(kind: str, time: float) -> np.ndarray:
    """From the launch, whatever was integrated before."""
    return kp.RealMotion(PENDULUM, LAUNCH, **KINDS[kind]).position(time)


def theirs(integrator: hy.taylor_adaptive, time: float) -> np.ndarray:
    integrator.time = 0.0
    integrator.state[:] = start()
    integrator.propagate_until(time)
    return integrator.state[:3].copy()


def scipys(kind: str, time: float) -> np.ndarray:
    def slope(_: float, state: np.ndarray) -> list[float]:
        numbers = state.tolist()
        return [*numbers[3:], *pull_and_force(kind, *numbers, np.sqrt)]

    done = solve_ivp(slope, (0.0, time), start(), "DOP853", rtol=1e-12, atol=1e-12)
    return done.y[:3, -1]


def measure() -> Section:
    ratios, errors = [], []
    time = PERIODS * PERIOD
    for kind in KINDS:
        integrator = heyoka(kind)
        contenders = {
            "ours": lambda kind=kind: ours(kind, time),
            "heyoka": lambda integrator=integrator: theirs(integrator, time),
        }
        timings = paired(contenders, 3 * ROUNDS)
        seconds = timings.seconds("ours"), timings.seconds("heyoka")
        work = f"full equations, {PERIODS} periods: {kind}"
        peer = "heyoka propagate_until"
        ratios.append(Ratio(work, peer, *seconds, timings.ratio("ours", "heyoka"), 1.0))
        contenders = {
            "ours": contenders["ours"],
            "SciPy": lambda kind=kind: scipys(kind, time),
        }
        timings = paired(contenders, 3)
        seconds = timings.seconds("ours"), timings.seconds("SciPy")
        value = timings.ratio("SciPy", "ours")
        ratios.append(Ratio(work, "SciPy DOP853, 1e-12", *seconds, value, 100.0, at_least=True))
        apart = np.linalg.norm(ours(kind, time) - theirs(integrator, time)) / LENGTH
        off = np.linalg.norm(ours(kind, time) - scipys(kind, time)) / LENGTH
        errors.append((kind, f"{apart:.1e}", f"{off:.1e}"))
    ratios.append(scaling())
    tables = [
        Table(
            f"Distance / l between ours and the peers' after {PERIODS} periods:",
            ("equations", "heyoka", "SciPy"),
            errors,
        ),
        growth(),
    ]
    notes = [
        "The laboratory ellipse; every call starts from the launch; heyoka compiled beforehand, at "
        "its own tolerance, which is machine precision, as ours.",
        f"The ensemble is {ENSEMBLE} launches, {PERIODS} periods each, in processes of their own "
        "with one thread and with one for each core.",
    ]
    return Section("The full equations", ratios, tables, notes)


def growth() -> Table:
    """Errors of the integrations against the closed form, all extras off."""
    rows = []
    for name, launch in {
        "ellipse 0.2 l by 0.1 l": LAUNCH,
        "ellipse 1e-3 l by 1e-4 l": kp.Launch.ellipse(1e-3 * LENGTH, 1e-4 * LENGTH),
        "ellipse 0.8 l by 0.3 l": kp.Launch.ellipse(0.8 * LENGTH, 0.3 * LENGTH),
        "cone at 30°": kp.Launch.apsides(0.5 * LENGTH, 0.5 * LENGTH),
        "let go at 90°": kp.Launch.at_rest(np.pi / 2),
    }.items():
        exact = kp.ExactMotion(PENDULUM, launch)
        real = kp.RealMotion(PENDULUM, launch, thread="rod")
        row = [name]
        for periods in GROWTH:
            times = periods * 2 * exact.radial_period + np.linspace(-1.0, 0.0, 9) * PERIOD
            apart = np.linalg.norm(exact.position(times) - real.position(times), axis=-1)
            row.append(f"{apart.max() / LENGTH:.1e}")
        rows.append(row)
    head = ("launch", *(f"{n} periods" for n in GROWTH))
    caption = "Largest error / l of RealMotion with all extras off, by the closed form:"
    return Table(caption, head, rows)


def scaling() -> Ratio:
    cores = os.cpu_count() or 1
    taken: dict[int, list[float]] = {1: [], cores: []}
    for _ in range(ROUNDS):
        for threads, times in taken.items():
            environment = {**os.environ, "RAYON_NUM_THREADS": str(threads)}
            command = [sys.executable, __file__]
            done = subprocess.run(command, env=environment, capture_output=True, check=True)
            times.append(float(done.stdout))
    one, many = (statistics.median(times) for times in taken.values())
    value = statistics.median(a / b for a, b in zip(*taken.values(), strict=True))
    work = f"ensemble of {ENSEMBLE} on {cores} cores"
    return Ratio(work, "the same on one", many, one, value, 0.8 * cores, at_least=True)


def main() -> None:
    """Seconds for the ensemble, with as many threads as the environment allows."""
    amplitudes = np.linspace(0.05, 0.3, ENSEMBLE) * LENGTH
    around = KINDS["Earth, linear drag, suspension"]

    def run() -> None:
        motion = kp.RealMotion(PENDULUM, kp.Launch.ellipse(amplitudes, B), **around)
        motion.position(PERIODS * PERIOD)

    print(paired({"ensemble": run}, 1).seconds("ensemble"))


if __name__ == "__main__":
    main()
