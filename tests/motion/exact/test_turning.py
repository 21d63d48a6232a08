"""Turning points: when, how high, how far out, and how the azimuth advances between them."""

from collections.abc import Callable
from math import inf, isfinite, pi

import numpy as np
import pytest
from hypothesis import given, settings
from tests.motion.launches import (
    GALLERY,
    Start,
    apsides,
    pendulums,
    speed_unit,
    starts,
    time_unit,
)

from kugelpendel import ExactMotion, Launch, Pendulum

# Of the length; where from: test_equations.
POSITION = 1e-14
# Two roundings.
ROUNDING = 4.5e-16


def apsis_is_the_highest_point(motion: ExactMotion) -> None:
    time, period = float(motion.apsis_time), float(motion.radial_period)
    length = float(motion.pendulum.length)
    high, low = motion.turning_heights
    if not isfinite(period):
        assert time == inf or motion.tension_range[0] == motion.tension_range[1]
        return
    assert 0 <= time <= period
    # A height is stationary there, so the rounding of these times does not show.
    heights = length - motion.position([time, time + period / 2, time + period])[:, 2]
    rounding = (np.finfo(float).eps * 2 * period / time_unit(motion)) ** 2
    assert heights == pytest.approx([high, low, high], abs=(POSITION + rounding) * length)
    rate = motion.velocity([time, time + period])[:, 2]
    late = np.finfo(float).eps * 2 * period / time_unit(motion)
    assert np.abs(rate).max() <= (POSITION + late) * speed_unit(motion)


def azimuth_advances_by_the_apsidal_angle(motion: ExactMotion) -> None:
    period, unit = motion.radial_period, time_unit(motion)
    if not isfinite(period) or period > 1e6 * unit:
        return
    times = unit * np.array([0.0, 0.3, 1.1, 2.3])
    turns = 5
    before, after = motion.position(times), motion.position(times + turns * period)
    plan = (before[:, 0] + 1j * before[:, 1]) * np.exp(1j * turns * motion.apsidal_angle)
    # The times and the angle are rounded, and the period five times.
    rounding = np.finfo(float).eps * turns * (2 * period / unit + 2 * pi)
    gap = np.abs(after[:, 0] + 1j * after[:, 1] - plan)
    assert gap.max() <= (2 * POSITION + rounding) * float(motion.pendulum.length)


def radii_and_heights_lie_on_the_sphere(motion: ExactMotion) -> None:
    length = float(motion.pendulum.length)
    height, radius = motion.turning_heights, motion.turning_radii
    # From above, half the height; from the side, the radius: whichever is not small.
    assert height * (2 * length - height) == pytest.approx(
        radius**2, rel=8 * ROUNDING, abs=8 * ROUNDING * length**2 * (height[0] > length)
    )


Check = Callable[[ExactMotion], None]
every_check = pytest.mark.parametrize(
    "check",
    [
        apsis_is_the_highest_point,
        azimuth_advances_by_the_apsidal_angle,
        radii_and_heights_lie_on_the_sphere,
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


@settings(deadline=None)
@given(pendulums.flatmap(lambda pendulum: apsides(pendulum).map(lambda x: (pendulum, x))))
def test_apsides_are_given_back(start: tuple[Pendulum, Launch]) -> None:
    pendulum, launch = start
    outer, inner, _ = (float(value) for value in launch.values)
    motion = ExactMotion(pendulum, launch)
    # Roots are found in twice the precision; what is left is the rounding of a square root.
    assert motion.turning_radii == pytest.approx([outer, abs(inner)], rel=2 * ROUNDING, abs=0)
    assert np.sign(motion.angular_momentum) == np.sign(outer * inner)


def test_apsides_start_at_the_outer_turning_point() -> None:
    for inner in (0.0, 0.1, -0.3):
        assert ExactMotion(Pendulum(1.7), Launch.apsides(0.5, inner, 0.8)).apsis_time == 0


def test_launch_at_the_lowest_point_takes_half_a_period_to_the_apsis() -> None:
    motion = ExactMotion(Pendulum(1.7), Launch.plane(0.2, 0.0, 0.0, 2.0))
    assert motion.turning_radii[1] == pytest.approx(0.2, rel=ROUNDING)
    assert motion.apsis_time == pytest.approx(motion.radial_period / 2, rel=ROUNDING)
