"""What must not depend on where one looks from, on the clock's direction, or on the units."""

from collections.abc import Callable
from functools import partial
from math import cos, sin

import numpy as np
import pytest
from hypothesis import given, settings
from tests.motion.launches import (
    GALLERY,
    Start,
    backwards,
    mirrored,
    starts,
    time_unit,
)

from kugelpendel import ExactMotion, Launch, Pendulum

# Two computations of the same exact inputs: twice the error of one, see test_equations.
POSITION = 2e-14
MOMENTS = np.array([-1e9, -31.4, -2.9, 0.0, 0.1, 1.7, 5.3, 12.9, 1e3, 1e9])
CONSTANTS = ("frequency", "radial_period", "energy")


def same(one: ExactMotion, other: ExactMotion, names: tuple[str, ...] = CONSTANTS) -> None:
    for name in names:
        assert getattr(one, name) == getattr(other, name), name


def time_runs_backwards_as_well(motion: ExactMotion) -> None:
    times, length = time_unit(motion) * MOMENTS, float(motion.pendulum.length)
    image = ExactMotion(motion.pendulum, backwards(motion.launch))
    same(motion, image)
    assert image.precession == -motion.precession
    assert image.angular_momentum == -motion.angular_momentum
    gap = image.position(-times) - motion.position(times)
    assert np.abs(gap).max() <= POSITION * length


def mirror_image_is_a_motion(motion: ExactMotion) -> None:
    times, length = time_unit(motion) * MOMENTS, float(motion.pendulum.length)
    image = ExactMotion(motion.pendulum, mirrored(motion.launch))
    same(motion, image, (*CONSTANTS, "slack_time", "apsis_time"))
    assert image.precession == -motion.precession
    gap = image.position(times) - motion.position(times) * [1, -1, 1]
    assert np.abs(gap).max() <= POSITION * length


def azimuth_turns_the_motion(motion: ExactMotion) -> None:
    launch, times = motion.launch, time_unit(motion) * MOMENTS
    where = {"ellipse": 2, "apsides": 2, "angles": 1, "at_rest": 1}.get(launch.kind)
    if where is None:
        return
    turned = [float(value) for value in launch.values]
    turn = 1.25 if turned[where] < 4 else -1.25  # not beyond 2π
    turned[where] += turn  # exact, or rounded by far less than POSITION
    image = ExactMotion(motion.pendulum, Launch(launch.kind, tuple(turned)))
    same(motion, image, (*CONSTANTS, "precession", "angular_momentum", "slack_time", "apsis_time"))
    x, y, z = np.moveaxis(motion.position(times), -1, 0)
    expected = [x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), z]
    gap = image.position(times) - np.stack(expected, axis=-1)
    assert np.abs(gap).max() <= POSITION * float(motion.pendulum.length)


def units_do_not_matter(motion: ExactMotion) -> None:
    # Four times the length is twice the time, with no rounding anywhere.
    pendulum, launch = motion.pendulum, motion.launch
    powers = {
        "ellipse": [4, 4, 1],
        "apsides": [4, 4, 1],
        "plane": [4, 4, 2, 2],
        "angles": [1, 1, 0.5, 0.5],
        "state": [4, 4, 4, 2, 2, 2],
        "at_rest": [1, 1],
    }[launch.kind]
    values = tuple(float(v) * power for v, power in zip(launch.values, powers, strict=True))
    larger = Pendulum(4 * float(pendulum.length), float(pendulum.gravity), float(pendulum.mass))
    image = ExactMotion(larger, Launch(launch.kind, values))
    times = time_unit(motion) * MOMENTS
    # The tolerance is for numbers below 1e-308 only, which have fewer digits.
    exactly = partial(np.testing.assert_allclose, rtol=0, atol=1e-300)
    exactly(image.position(2 * times), 4 * motion.position(times))
    exactly(image.velocity(2 * times), 2 * motion.velocity(times))
    exactly(image.precession, motion.precession / 2)
    exactly(image.frequency, motion.frequency / 2)
    exactly(image.tension(2 * times), motion.tension(times))


Check = Callable[[ExactMotion], None]
every_check = pytest.mark.parametrize(
    "check",
    [
        time_runs_backwards_as_well,
        mirror_image_is_a_motion,
        azimuth_turns_the_motion,
        units_do_not_matter,
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
