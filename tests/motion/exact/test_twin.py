"""Random launches against an independent solution in 50 digits."""

import numpy as np
import pytest
from tests.motion.exact.twin import Twin
from tests.motion.launches import Start, time_unit

from kugelpendel import ExactMotion, Launch, Pendulum

# Of the length; where from: test_equations.
POSITION = 1e-14
# What the docstring of ExactMotion promises; correct rounding alone is 1.1e-16.
RELATIVE = 4e-16
SEED = 1851


def drawn(seed: int) -> Start:
    """A launch with angular momentum: any size, any height, fast and slow."""
    random = np.random.default_rng(seed)
    pendulum = Pendulum(10 ** random.uniform(-2, 3), 10 ** random.uniform(-1, 2))
    length, unit = float(pendulum.length), float(pendulum.angular_frequency)
    size = random.choice([10 ** random.uniform(-9, -1), random.uniform(0.1, 0.99)])
    azimuth, sense = random.uniform(-4, 4), random.choice([-1, 1])
    speeds = random.choice([-1, 1], 2) * 10 ** random.uniform([-9, -3], [0.7, 0.7])
    match seed % 4:
        case 0:
            return pendulum, Launch.ellipse(
                size * length, sense * size * random.uniform() * length, azimuth
            )
        case 1:
            plan = size * length * np.array([np.cos(azimuth), np.sin(azimuth)])
            return pendulum, Launch.plane(*plan, *(speeds * unit * length))
        case 2:
            return pendulum, Launch.angles(random.uniform(0.01, 3.1), azimuth, *(speeds * unit))
        case _:
            theta = random.uniform(0.1, 1.5)
            rate = unit / np.sqrt(np.cos(theta)) * (1 + speeds[0] / 10)
            return pendulum, Launch.angles(theta, azimuth, 0.0, sense * rate)


@pytest.mark.parametrize("seed", range(SEED, SEED + 48))
def test_random_launch(seed: int) -> None:
    start = drawn(seed)
    motion, twin = ExactMotion(*start), Twin(*start)
    for name in ("frequency", "precession", "radial_period"):
        expected = getattr(twin, name)
        assert abs(float(getattr(motion, name) / expected - 1)) <= RELATIVE, name
    times = time_unit(motion) * np.array([0.0, 0.31, -4.7, 1e4])
    expected = np.array([twin.position(time) for time in times])
    gap = np.linalg.norm(motion.position(times) - expected, axis=-1)
    assert gap.max() <= POSITION * float(start[0].length)


@pytest.mark.parametrize(
    "launch",
    [
        Launch.ellipse(1e-8, 1e-8),
        Launch.ellipse(1e-8, -1e-12),
        Launch.plane(1e-8, 2e-8, 3e-9, -1e-8),
        Launch.angles(1e-10, 0.4, 1e-11, -3e-10),
        Launch.angles(3.14159, 0.4, 1e-6, 2.0),
        Launch.angles(1.0, 0.0, 1.7551651237807455, 1e-9),
        Launch.angles(2.0, 0.0, 1.0806046117362795, 1e-8),
        Launch.angles(1.570796, 0.0, 1e-3, 100.0),
        Launch.angles(1.5242283841297444, 0.3, -0.02363281214778413, -4.706083797988464),
        Launch.angles(1.5524926486924124, 0.3, 0.09557903837569472, 7.392923371524419),
        Launch.angles(1.718531499865771, 0.3, 1.4717861676817988e-07, 2.172212320440183),
    ],
    ids=str,
)
def test_corners(launch: Launch) -> None:
    start = Pendulum(1.0, 1.0), launch
    motion, twin = ExactMotion(*start), Twin(*start)
    assert motion.frequency == pytest.approx(float(twin.frequency), rel=RELATIVE)
    assert motion.precession == pytest.approx(float(twin.precession), rel=RELATIVE)
    times = np.array([0.0, 0.1, 7.0, -33.0])
    expected = np.array([twin.position(time) for time in times])
    assert np.linalg.norm(motion.position(times) - expected, axis=-1).max() <= POSITION
