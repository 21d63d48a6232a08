"""A hundred periods of the laboratory ellipse by every integrator: time, and what it got wrong."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from contenders import ball_joint, cartesian, reference
from contenders.cartesian import GRAVITY, LENGTH, PERIOD, A, B
from contenders.turning_points import Path, apsides
from report import Section, Table, duration
from scipy.integrate import solve_ivp
from timing import paired

import kugelpendel as kp

PERIODS = 100
EVERY = 5e-3  # s between rows of output
JUDGED = 400  # rows compared with the reference

TIMES = EVERY * np.arange(int(PERIODS * PERIOD / EVERY) + 1)


def launched() -> kp.ExactMotion:
    return kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.ellipse(A, B))


def ours() -> tuple[np.ndarray, tuple[float, float]]:
    """From four numbers to positions, period and precession."""
    motion = launched()
    return motion.sample(0.0, EVERY, TIMES.size), (motion.radial_period, motion.precession)


def scipy() -> Path:
    span = (0.0, TIMES[-1])
    options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12, "t_eval": TIMES}
    rows = solve_ivp(cartesian.slope, span, cartesian.start(), **options).y.T
    return rows[:, :3], rows[:, 3:]


def heyoka() -> Callable[[], Path]:
    integrator = cartesian.heyoka()

    def run() -> Path:
        cartesian.rewind(integrator)
        rows = integrator.propagate_grid(TIMES)[-1]
        return rows[:, :3], rows[:, 3:]

    return run


def measure() -> Section:
    truth = reference.Ellipse(A, B, LENGTH, GRAVITY)
    period = float((truth.apsides.period / truth.rate).mid())
    precession = float((truth.apsides.precession * truth.rate).mid())
    judged = np.linspace(0, TIMES.size - 1, JUDGED + 1).astype(int)
    places = np.array([[float(q.mid()) for q in truth.position(TIMES[i])] for i in judged])

    contenders = {
        "kugelpendel": ours,
        "SciPy DOP853, 1e-12": scipy,
        "heyoka": heyoka(),
        f"MuJoCo RK4, {ball_joint.STEP * 1e3:g} ms": ball_joint.runner(TIMES),
    }
    timings = paired(contenders, rounds=3)

    def cost(name: str) -> list[str]:
        ratio = timings.ratio(name, "kugelpendel")
        return [name, duration(timings.seconds(name)), f"{ratio:.3g}"]

    def errors(place: np.ndarray, found: tuple[float, float]) -> list[str]:
        off = np.linalg.norm(place[judged] - places, axis=1).max() / LENGTH
        return [
            f"{e:.1e}" for e in (off, abs(found[0] / period - 1), abs(found[1] / precession - 1))
        ]

    motion = launched()
    path = motion.position(TIMES), motion.velocity(TIMES)
    rows = [
        [*cost("kugelpendel"), *errors(*ours())],
        ["kugelpendel, measured like the rest", "", "", *errors(path[0], apsides(TIMES, path))],
    ]
    for name in list(contenders)[1:]:
        path = contenders[name]()
        rows.append([*cost(name), *errors(path[0], apsides(TIMES, path))])
    head = ("", "time", "times ours", "position / l", "period", "precession")
    caption = (
        f"{PERIODS} periods of the laboratory ellipse (l = {LENGTH:g} m, a = {A:g} m, b = {B:g} m, "
        f"g = {GRAVITY} m/s²), a row every {EVERY * 1e3:g} ms ({TIMES.size} rows): wall time, and "
        "the errors of position, period T_s and precession (relative):"
    )
    notes = (
        f"The reference has 40 digits; position error is the largest of {JUDGED + 1} rows, each in "
        "units of the length.",
        "Period and precession are measured from the turning points of each trajectory. "
        "kugelpendel's first row is timed with construction, sample, and both properties, which "
        "are judged there; its second row measures position(t) and velocity(t) instead.",
        "Integrators get Cartesian coordinates with Λ = (v² + g z)/(r·r), which keeps them on the "
        "sphere. heyoka runs at its default tolerance, compiled beforehand. MuJoCo's pendulum is a "
        "ball joint with a small round body whose equivalent length is l, without damping.",
        f"MuJoCo's time step of {ball_joint.STEP * 1e3:g} ms is our choice.",
    )
    return Section(
        "The laboratory ellipse by integrators", (), (Table(caption, head, rows),), notes
    )
