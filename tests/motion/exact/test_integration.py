"""The exact motion against integration of the constrained equations with SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.motion.launches import Start, Vector, time_unit

from kugelpendel import ExactMotion, Launch, Pendulum

SEED = 531
# DOP853 with relative 1e-13 of each step; neighbouring paths part at most like e^(ω0 t), here e^6.
DISTANCE = 2e-10


def drawn(seed: int) -> Start:
    """Position and velocity from all of the sphere; every other one goes above the support."""
    random = np.random.default_rng(seed)
    pendulum = Pendulum(10 ** random.uniform(-1, 2), random.uniform(1, 20))
    length, unit = float(pendulum.length), float(pendulum.angular_frequency)
    place = random.normal(size=3)
    place[2] = -abs(place[2]) if seed % 2 else abs(place[2])
    place *= length / np.linalg.norm(place)
    course = np.cross(place, random.normal(size=3))
    course *= random.uniform(0, 3) * unit * length / np.linalg.norm(course)
    return pendulum, Launch.state(place, course)


@pytest.mark.parametrize("seed", range(SEED, SEED + 12))
def test_random_launch(seed: int) -> None:
    pendulum, launch = drawn(seed)
    motion = ExactMotion(pendulum, launch)
    length, gravity = float(pendulum.length), float(pendulum.gravity)

    def newton(_: float, state: Vector) -> Vector:
        r, v = state[:3], state[3:]
        # Divided by r·r and not by l²: this is what keeps it on the sphere above the support.
        pull = (v @ v + gravity * r[2]) / (r @ r)
        return np.concatenate([v, [0, 0, gravity] - pull * r])

    end = 6 / float(pendulum.angular_frequency)
    times = np.linspace(0, end, 7)
    start = np.array([float(value) for value in launch.values])
    solution = solve_ivp(newton, (0, end), start, "DOP853", times, rtol=1e-13, atol=1e-13 * length)
    assert solution.success
    gap = np.linalg.norm(solution.y[:3].T - motion.position(times), axis=-1)
    assert gap.max() <= DISTANCE * length
    speed = length / time_unit(motion)
    gap = np.linalg.norm(solution.y[3:].T - motion.velocity(times), axis=-1)
    assert gap.max() <= DISTANCE * speed
