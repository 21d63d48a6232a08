"""What must hold at every instant of every motion: the constraint, the invariants, Newton's law."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from tests.motion.launches import (
    DOWN,
    GALLERY,
    Start,
    Vector,
    launched,
    speed_unit,
    starts,
    time_unit,
)

from kugelpendel import ExactMotion, Launch, Pendulum

# Of the length: the largest seen in 5 million random launches, in fast rotation; slower ones stay
# below 5e-15, the stored references below 2e-15.
POSITION = 1e-14
# Times to look at, in units of time_unit: few turns away, as a difference of times loses digits.
MOMENTS = np.array([-31.4, -2.9, -0.4, 0.0, 0.1, 1.7, 5.3, 12.9])
# Central differences of order 8. The steps are well inside the radius of convergence, π/2 units,
# so the order leaves 1e-15, and rounding POSITION·2.1/STEP.
WEIGHTS = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280])
STEP = 0.02
SLOPE = POSITION * 2.1 / STEP


def slope(function: Callable[[Vector], Vector], times: Vector, step: float) -> Vector:
    steps = step * np.arange(1, 5)
    later, earlier = function(times[:, None] + steps), function(times[:, None] - steps)
    return np.einsum("tkc,k->tc", later - earlier, WEIGHTS) / step


def starts_at_the_launch(motion: ExactMotion) -> None:
    position, velocity = launched(motion.pendulum, motion.launch)
    length, speed = float(motion.pendulum.length), speed_unit(motion)
    assert np.linalg.norm(motion.position(0.0) - position) <= POSITION * length
    # On the lower half z follows from a square root, which loses as the point nears the rim.
    steepness = length / abs(position[2]) if motion.launch.kind == "plane" else 1.0
    if motion.launch.kind != "apsides":
        gap = np.linalg.norm(motion.velocity(0.0) - velocity)
        assert gap <= POSITION * steepness * speed


def stays_on_the_sphere(motion: ExactMotion) -> None:
    times = time_unit(motion) * np.append(MOMENTS, [1e3, -1e6, 1e12])
    length, speed = float(motion.pendulum.length), speed_unit(motion)
    position, velocity = motion.position(times), motion.velocity(times)
    assert np.abs(np.linalg.norm(position, axis=-1) - length).max() <= POSITION * length
    assert np.abs(np.sum(position * velocity, axis=-1)).max() <= POSITION * length * speed


def keeps_energy_and_angular_momentum(motion: ExactMotion) -> None:
    times = time_unit(motion) * np.append(MOMENTS, [1e3, -1e6, 1e12])
    length, speed = float(motion.pendulum.length), speed_unit(motion)
    x, y, z = np.moveaxis(motion.position(times), -1, 0)
    u, v, w = np.moveaxis(motion.velocity(times), -1, 0)
    energy = (u**2 + v**2 + w**2) / 2 + motion.pendulum.gravity * (length - z)
    assert np.abs(energy - motion.energy).max() <= POSITION * speed**2
    assert np.abs(x * v - y * u - motion.angular_momentum).max() <= POSITION * length * speed


def velocity_is_the_slope_of_position(motion: ExactMotion) -> None:
    unit, speed = time_unit(motion), speed_unit(motion)
    expected = slope(motion.position, unit * MOMENTS, STEP * unit)
    assert np.abs(motion.velocity(unit * MOMENTS) - expected).max() <= SLOPE * speed


def obeys_newton(motion: ExactMotion) -> None:
    unit, speed = time_unit(motion), speed_unit(motion)
    length, gravity = float(motion.pendulum.length), float(motion.pendulum.gravity)
    position, velocity = motion.position(unit * MOMENTS), motion.velocity(unit * MOMENTS)
    acceleration = slope(motion.velocity, unit * MOMENTS, STEP * unit)
    pull = np.sum(velocity**2, axis=-1) + gravity * position[..., 2]
    expected = gravity * DOWN - pull[..., None] * position / length**2
    assert np.abs(acceleration - expected).max() <= SLOPE * speed / unit


def turns_at_the_turning_heights(motion: ExactMotion) -> None:
    length = float(motion.pendulum.length)
    heights = length - motion.sample(0.0, 0.11 * time_unit(motion), 1000)[:, 2]
    high, low = motion.turning_heights
    assert 0 <= low <= high <= 2 * length * (1 + 1e-15)
    assert heights.max() <= high + POSITION * length
    assert heights.min() >= low - POSITION * length


def test_many_launches_between_cone_and_separatrix() -> None:
    # The number of terms of the series changes with two parameters: no corner may be left out.
    random, count = np.random.default_rng(25), 40_000
    theta = random.uniform(0.01, 3.13, count)
    deviation = 10 ** random.uniform(-15, -0.5, count) * random.choice([-1, 1], count)
    steady = np.where(theta < 1.57, 1 / np.sqrt(np.cos(np.minimum(theta, 1.57))), 3.0)
    for rates in ((deviation, steady * (1 + deviation)), (2 * deviation, 4.9 * np.sin(theta))):
        motion = ExactMotion(Pendulum(1.0, 1.0), Launch.angles(theta, 0.3, *rates))
        unit = np.sqrt(2 * np.maximum(motion.energy, 0.5))
        expected = [np.sin(theta) * np.cos(0.3), np.sin(theta) * np.sin(0.3), np.cos(theta)]
        gap = motion.position(0.0) - np.stack(expected, axis=-1)
        assert np.linalg.norm(gap, axis=-1).max() <= 6e-15
        for time in (-3.3, 0.1, 11.0):
            position, velocity = motion.position(time), motion.velocity(time)
            assert np.abs(np.linalg.norm(position, axis=-1) - 1).max() <= 6e-15
            energy = np.sum(velocity**2, axis=-1) / 2 + 1 - position[:, 2]
            assert (np.abs(energy - motion.energy) / unit**2).max() <= 6e-15


Check = Callable[[ExactMotion], None]
every_check = pytest.mark.parametrize(
    "check",
    [
        starts_at_the_launch,
        stays_on_the_sphere,
        keeps_energy_and_angular_momentum,
        velocity_is_the_slope_of_position,
        obeys_newton,
        turns_at_the_turning_heights,
    ],
    ids=lambda check: check.__name__,
)


@every_check
@pytest.mark.parametrize("start", GALLERY.values(), ids=list(GALLERY))
def test_gallery(start: Start, check: Check) -> None:
    check(ExactMotion(*start))


@every_check
@settings(deadline=None)
@given(starts())
def test_any_launch(check: Check, start: Start) -> None:
    check(ExactMotion(*start))
