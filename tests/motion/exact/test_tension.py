"""The pull of the thread, and when a thread goes slack."""

from math import acos, inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from tests.motion.launches import GALLERY, Start, speed_unit, starts, time_unit

from kugelpendel import ExactMotion, Launch, Pendulum

# Of m·(g + 5 v²/l): three times the rounding of the height, see test_equations.
TENSION = 3e-14


def unit(motion: ExactMotion) -> float:
    """N: of a thread that holds the largest speed."""
    pendulum = motion.pendulum
    return float(pendulum.mass) * speed_unit(motion) ** 2 / float(pendulum.length)


def check(motion: ExactMotion) -> None:
    pendulum = motion.pendulum
    times = time_unit(motion) * np.array([-900.0, -3.0, 0.0, 0.4, 2.0, 11.0])
    cosine = motion.position(times)[:, 2] / pendulum.length
    speed_squared = np.sum(motion.velocity(times) ** 2, axis=-1)
    expected = pendulum.mass * (pendulum.gravity * cosine + speed_squared / pendulum.length)
    tension = motion.tension(times)
    assert np.abs(tension - expected).max() <= TENSION * unit(motion)
    least, most = motion.tension_range
    assert least - TENSION * unit(motion) <= tension.min()
    assert tension.max() <= most + TENSION * unit(motion)
    period, apsis = float(motion.radial_period), float(motion.apsis_time)
    if np.isfinite(period):
        # Stationary at the turning points; their times are rounded.
        rounding = (4.5e-16 * period / time_unit(motion)) ** 2
        ends = motion.tension([apsis, apsis + period / 2])
        assert ends == pytest.approx([least, most], abs=(TENSION + rounding) * unit(motion))
    assert motion.goes_slack == (least < 0)
    check_slack(motion)


def check_slack(motion: ExactMotion) -> None:
    slack = motion.slack_time
    if not motion.goes_slack:
        assert slack == inf
        return
    if motion.tension(0.0) < -TENSION * unit(motion):
        assert slack == 0
        return
    if not np.isfinite(slack):
        # Only on the way down from the top along the separatrix, which comes back never.
        assert motion.frequency == 0
        return
    assert 0 <= slack <= motion.radial_period
    # Where it is nearly tangent the moment is ill-defined, but not the pull.
    late = 4.5e-16 * slack / time_unit(motion)
    assert abs(float(motion.tension(slack))) <= (TENSION + 3 * late) * unit(motion)
    before = motion.tension(np.linspace(0.0, slack, 200))
    assert before.min() >= -(TENSION + 3 * late) * unit(motion)


@pytest.mark.parametrize("start", GALLERY.values(), ids=list(GALLERY))
def test_gallery(start: Start) -> None:
    check(ExactMotion(*start))


@settings(deadline=None)
@given(starts())
def test_any_launch(start: Start) -> None:
    check(ExactMotion(*start))


@pytest.mark.parametrize(
    "launch",
    [
        Launch.angles(0.4, 0.3, 1.95),
        Launch.angles(0.4, 0.3, -2.0, 0.2),
        Launch.angles(1.7, 0.3, 0.5),
        Launch.plane(0.0, 0.0, 2.0, 0.0),
        Launch.plane(0.9, 0.0, 0.5, 0.1),
    ],
    ids=str,
)
def test_changes_its_sign_there(launch: Launch) -> None:
    motion = ExactMotion(Pendulum(1.0, 1.0), launch)
    if not motion.goes_slack:
        pytest.fail("this launch was meant to go slack")
    slack = motion.slack_time
    assert slack > 0
    assert motion.tension(slack - 1e-6) > 1e-8
    assert motion.tension(slack + 1e-6) < -1e-8


def test_released_from_rest_above_the_support_is_slack_at_once() -> None:
    # The pull at rest is m g cos θ.
    motion = ExactMotion(Pendulum(1.0, 9.8, 2.0), Launch.at_rest(2.0))
    assert motion.tension(0.0) == pytest.approx(2 * 9.8 * np.cos(2.0), rel=1e-15)
    assert motion.slack_time == 0
    below = ExactMotion(Pendulum(1.0, 9.8), Launch.at_rest(1.5))
    assert not below.goes_slack
    assert below.slack_time == inf


@pytest.mark.parametrize("theta", np.linspace(1.6, 3.1, 16))
@pytest.mark.parametrize("course", [-1.5, -0.7, 0.0, 0.7, 1.5])
def test_launched_upwards_where_the_pull_vanishes(theta: float, course: float) -> None:
    # g cos θ + v²/l = 0, up to rounding: slack there, and not a swing later. The moment is as
    # sharp as the pull changes, by 3 times the upward speed.
    speed = sqrt(-np.cos(theta))
    rates = speed * np.cos(course), speed * np.sin(course) / np.sin(theta)
    motion = ExactMotion(Pendulum(1.0, 1.0), Launch.angles(theta, 0.3, *rates))
    climb = np.sin(theta) * rates[0]
    assert motion.slack_time <= TENSION * unit(motion) / (3 * climb)


@pytest.mark.parametrize("speed", [sqrt(2.0), sqrt(5.0)])
def test_speeds_that_just_hold_a_thread(speed: float) -> None:
    # Through the bottom with v² < 2gl it stays below the support, from 5gl on it flies over.
    for factor, slack in ((1 - 1e-9, speed > 2), (1 + 1e-9, speed < 2)):
        motion = ExactMotion(Pendulum(1.0, 1.0), Launch.plane(0.0, 0.0, speed * factor, 0.0))
        assert motion.goes_slack == slack
        assert np.isfinite(motion.slack_time) == slack


def test_height_where_a_thread_goes_slack() -> None:
    # Its own law: cos θ = −(2/3)(v0²/2gl − 1) when launched through the bottom.
    speed = 1.9
    motion = ExactMotion(Pendulum(1.0, 1.0), Launch.plane(0.0, 0.0, speed, 0.0))
    theta = acos(-2 / 3 * (speed**2 / 2 - 1))
    assert motion.position(motion.slack_time) == pytest.approx(
        [np.sin(theta), 0, np.cos(theta)], abs=1e-14
    )


def test_known_values() -> None:
    # From the horizontal: 0 there, 3mg at the bottom. On a cone: mg/cos θ.
    falling = ExactMotion(Pendulum(2.0, 9.81, 3.0), Launch.at_rest(pi / 2))
    assert falling.tension_range == pytest.approx([0, 9 * 9.81], rel=1e-15, abs=1e-14)
    steady = ExactMotion(Pendulum(25.0, 0.8, 3.0), Launch.plane(15.0, 0.0, 0.0, 3.0))
    assert steady.tension_range == pytest.approx([3.0, 3.0], rel=1e-15)


def test_mass_scales_it() -> None:
    launch = Launch.angles(1.0, 0.0, 0.5, 1.0)
    light, heavy = (ExactMotion(Pendulum(1.0, 9.8, mass), launch) for mass in (1.0, 8.0))
    times = np.linspace(0, 5, 7)
    np.testing.assert_array_equal(heavy.tension(times), 8 * light.tension(times))
    np.testing.assert_array_equal(heavy.position(times), light.position(times))
