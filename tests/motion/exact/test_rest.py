"""At rest, hanging and upright; and next to it."""

from math import inf, pi

import numpy as np
import pytest

from kugelpendel import ExactMotion, Launch, Pendulum

PENDULUM = Pendulum(2.0, 9.81, mass=3.0)
TIMES = np.array([-1e9, -1.0, 0.0, 0.3, 1e3, 1e12])
HANGING = [
    Launch.at_rest(0.0, 0.7),
    Launch.ellipse(0.0, 0.0),
    Launch.apsides(0.0, 0.0, 1.0),
    Launch.plane(0.0, 0.0, 0.0, 0.0),
    Launch.plane(-0.0, 0.0, 0.0, -0.0),
    Launch.state([0.0, 0.0, 2.0], [0.0, 0.0, 0.0]),
]
UPRIGHT = Launch.state([0.0, 0.0, -2.0], [0.0, 0.0, 0.0])
# One rounding.
ROUNDING = 2.3e-16


@pytest.mark.parametrize("launch", HANGING, ids=str)
def test_hanging(launch: Launch) -> None:
    motion = ExactMotion(PENDULUM, launch)
    np.testing.assert_array_equal(motion.position(TIMES), [[0, 0, 2]] * 6)
    np.testing.assert_array_equal(motion.sample(-1.0, 0.1, 9), [[0, 0, 2]] * 9)
    np.testing.assert_array_equal(motion.velocity(TIMES), np.zeros((6, 3)))
    np.testing.assert_array_equal(motion.tension(TIMES), [3 * 9.81] * 6)
    np.testing.assert_array_equal(motion.tension_range, [3 * 9.81] * 2)
    assert (motion.energy, motion.angular_momentum, motion.precession) == (0, 0, 0)
    assert not motion.goes_slack
    assert motion.slack_time == inf
    np.testing.assert_array_equal(motion.turning_radii, [0, 0])
    np.testing.assert_array_equal(motion.turning_heights, [0, 0])


@pytest.mark.parametrize("launch", HANGING, ids=str)
def test_hanging_has_the_rates_of_small_swings(launch: Launch) -> None:
    motion = ExactMotion(PENDULUM, launch)
    assert motion.frequency == pytest.approx(PENDULUM.angular_frequency, rel=ROUNDING)
    assert motion.radial_period == pytest.approx(pi / motion.frequency, rel=ROUNDING)
    assert motion.apsidal_angle == pi


def test_upright() -> None:
    motion = ExactMotion(PENDULUM, UPRIGHT)
    np.testing.assert_array_equal(motion.position(TIMES), [[0, 0, -2]] * 6)
    np.testing.assert_array_equal(motion.velocity(TIMES), np.zeros((6, 3)))
    assert motion.energy == pytest.approx(2 * 9.81 * 2, rel=ROUNDING)
    assert (motion.frequency, motion.precession, motion.radial_period) == (0, 0, inf)
    assert motion.tension(5.0) == pytest.approx(-3 * 9.81, rel=ROUNDING)
    assert motion.goes_slack
    assert motion.slack_time == 0
    np.testing.assert_array_equal(motion.turning_heights, [4, 4])
    np.testing.assert_array_equal(motion.turning_radii, [0, 0])


def test_pi_is_not_upright_and_falls() -> None:
    # math.pi is 1.2246467991473532e-16 short of upright, which grows like cosh ω0 t.
    motion = ExactMotion(Pendulum(1.0, 1.0), Launch.at_rest(pi, 0.4))
    time = 10.0
    radius = np.hypot(*motion.position(time)[:2])
    assert radius == pytest.approx(1.2246467991473532e-16 * np.cosh(time), rel=1e-14)
    assert motion.position(motion.radial_period / 2)[2] == pytest.approx(1, abs=1e-14)
    assert motion.frequency > 0


@pytest.mark.parametrize("size", [1e-12, 1e-40, 1e-75])
def test_almost_at_rest_is_a_harmonic_oscillator(size: float) -> None:
    # The next term of the frequency is size²/16, far below rounding.
    motion = ExactMotion(Pendulum(1.0, 1.0), Launch.plane(size, 0.0, 0.0, -0.5 * size))
    times = np.array([-4.0, 0.0, 0.8, 2.5, 100.0])
    plan = motion.position(times)[:, :2]
    expected = size * np.stack([np.cos(times), -0.5 * np.sin(times)], axis=-1)
    assert np.abs(plan - expected).max() <= 2e-15 * size
    assert motion.frequency == pytest.approx(1, rel=ROUNDING)
