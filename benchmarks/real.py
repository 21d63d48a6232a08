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
ENSEMBLE = 1000  # a multiple of any number of lanes
AMPLITUDES = np.linspace(0.05, 0.3, ENSEMBLE) * LENGTH
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


def slopes(kind: str) -> list[tuple[hy.expression, hy.expression]]:
    x, y, z, vx, vy, vz = variables = hy.make_vars("x", "y", "z", "vx", "vy", "vz")
    ax, ay, az = pull_and_force(kind, *variables, hy.sqrt)
    return [(x, vx), (y, vy), (z, vz), (vx, ax), (vy, ay), (vz, az)]


def heyoka(kind: str) -> hy.taylor_adaptive:
    return hy.taylor_adaptive(slopes(kind), start())


def heyoka_batch(kind: str) -> hy.taylor_adaptive_batch:
    """As many cases side by side as the widest vectors of this machine hold."""
    state = np.repeat(np.array(start())[:, np.newaxis], hy.recommended_simd_size(), axis=1)
    return hy.taylor_adaptive_batch(slopes(kind), state)


def ours(kind: str, time: float) -> np.ndarray:
    """From the launch, whatever was integrated before."""
    return kp.RealMotion(PENDULUM, LAUNCH, **KINDS[kind]).position(time)


def theirs(integrator: hy.taylor_adaptive, time: float) -> np.ndarray:
    integrator.time = 0.0
    integrator.state[:] = start()
    integrator.propagate_until(time)
    return integrator.state[:3].copy()


def our_ensemble(kind: str, time: float) -> np.ndarray:
    launch = kp.Launch.ellipse(AMPLITUDES, B)
    return kp.RealMotion(PENDULUM, launch, **KINDS[kind]).position(time)


def their_ensemble(integrator: hy.taylor_adaptive_batch, time: float) -> np.ndarray:
    a, zero = AMPLITUDES, np.zeros(ENSEMBLE)
    launch = [a, zero, np.sqrt(LENGTH**2 - a**2), zero, np.full(ENSEMBLE, B * OMEGA), zero]
    states = np.array(launch).reshape(6, -1, integrator.batch_size)
    found = np.empty_like(states[:3])
    for batch in range(states.shape[1]):
        integrator.set_time(0.0)
        integrator.state[:] = states[:, batch]
        integrator.propagate_until(time)
        found[:, batch] = integrator.state[:3]
    return found.reshape(3, -1).T


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
        together, distance = ensemble(kind, time)
        ratios.append(together)
        errors.append((kind, f"{apart:.1e}", f"{off:.1e}", f"{distance:.1e}"))
    ratios.append(scaling())
    tables = [
        Table(
            f"Distance / l between ours and the peers' after {PERIODS} periods:",
            ("equations", "heyoka", "SciPy", "heyoka, ensemble"),
            errors,
        ),
        growth(),
    ]
    notes = [
        "The laboratory ellipse; every call starts from the launch; heyoka compiled beforehand, at "
        "its own tolerance, which is machine precision, as ours.",
        f"The ensembles are {ENSEMBLE} launches with semi-axes a from 0.05 l to 0.3 l; on all "
        "cores and on one in processes of their own, under the second equations.",
    ]
    return Section("The full equations", ratios, tables, notes)


def ensemble(kind: str, time: float) -> tuple[Ratio, float]:
    """Many cases on one thread, several side by side, and the largest distance / l of all."""
    integrator = heyoka_batch(kind)
    contenders = {
        "ours": lambda: our_ensemble(kind, time),
        "heyoka": lambda: their_ensemble(integrator, time),
    }
    timings = paired(contenders, ROUNDS)
    seconds = timings.seconds("ours"), timings.seconds("heyoka")
    work = f"ensemble of {ENSEMBLE} full runs of {PERIODS} periods, one thread: {kind}"
    peer = f"heyoka's batch mode, {integrator.batch_size} lanes"
    apart = np.linalg.norm(our_ensemble(kind, time) - their_ensemble(integrator, time), axis=-1)
    return Ratio(work, peer, *seconds, timings.ratio("ours", "heyoka"), 1.0), apart.max() / LENGTH


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
    kind = "Earth, linear drag, suspension"
    run = {"ensemble": lambda: our_ensemble(kind, PERIODS * PERIOD)}
    print(paired(run, 1).seconds("ensemble"))


if __name__ == "__main__":
    main()
