"""Angular momentum exactly 0: libration, through the bottom, rotation over the top."""

from fractions import Fraction
from math import pi, sqrt
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.special import ellipj, ellipk

from kugelpendel import ExactMotion, Launch, Pendulum

mp: Any = mpmath.mp
UNIT = Pendulum(1.0, 1.0)
TIMES = np.linspace(-11.0, 13.0, 97)
# Of the length; where from: test_equations. SciPy's ellipj, away from m = 1, adds 1e-15 · time.
POSITION = 2e-14
ROUNDING = 4.5e-16


def mean(a: float, b: float) -> float:
    """Gauss's arithmetic-geometric mean."""
    return float(mp.agm(a, b))


@pytest.mark.parametrize("theta", [1e-9, 1e-3, 0.1, 1.0, pi / 2, 2.0, 3.0])
def test_libration_frequency(theta: float) -> None:
    motion = ExactMotion(UNIT, Launch.at_rest(theta, 0.3))
    expected = mean(1, float(mp.cos(mp.mpf(theta) / 2)))
    assert motion.frequency == pytest.approx(expected, rel=ROUNDING)
    assert motion.radial_period == pytest.approx(pi / expected, rel=2 * ROUNDING)
    assert motion.precession == 0
    assert motion.apsidal_angle == pi
    assert motion.angular_momentum == 0


@pytest.mark.parametrize("theta", [1e-3, 0.1, 1.0, 2.0, 3.0])
def test_libration_position(theta: float) -> None:
    # sin(θ/2) = k sn(K + t | k²), k = sin(θ0/2), and cos(θ/2) = dn.
    k = np.sin(theta / 2)
    sn, _, dn, _ = ellipj(TIMES + ellipk(k**2), k**2)
    x, z = 2 * k * sn * dn, 1 - 2 * (k * sn) ** 2
    seen = ExactMotion(UNIT, Launch.at_rest(theta)).position(TIMES)
    assert np.abs(seen - np.stack([x, 0 * x, z], axis=-1)).max() <= POSITION


@pytest.mark.parametrize("speed", [2.1, 3.0, 50.0, 1e6])
def test_rotation(speed: float) -> None:
    # sin(θ/2) = sn(t/k | k²), k = 2/speed; one revolution is from top to top.
    motion = ExactMotion(UNIT, Launch.angles(0.0, 0.0, speed))
    k = 2 / speed
    times = TIMES / speed
    sn, cn, _, _ = ellipj(times / k, k**2)
    seen = motion.position(times)
    expected = np.stack([2 * sn * cn, 0 * sn, 1 - 2 * sn**2], axis=-1)
    assert np.abs(seen - expected).max() <= POSITION
    rate = speed * mean(1, float(mp.sqrt(1 - mp.mpf(k) ** 2)))
    assert motion.frequency == pytest.approx(rate, rel=ROUNDING)
    assert motion.radial_period == pytest.approx(2 * pi / rate, rel=2 * ROUNDING)
    assert motion.precession == 0
    assert motion.apsidal_angle == 2 * pi
    assert motion.turning_heights == pytest.approx([2, 0], rel=ROUNDING)
    assert motion.turning_radii == pytest.approx([0, 0], abs=0)
    assert motion.apsis_time == pytest.approx(pi / rate, rel=2 * ROUNDING)


def test_rotation_comes_back_after_a_revolution() -> None:
    motion = ExactMotion(UNIT, Launch.angles(0.4, 0.3, -2.5))
    before = motion.position(TIMES)
    after = motion.position(TIMES + motion.radial_period)
    # The period, and its sum with the time, are rounded.
    assert np.abs(after - before).max() <= POSITION


def test_libration_comes_back_after_two_swings() -> None:
    motion = ExactMotion(UNIT, Launch.at_rest(2.0, 0.3))
    before, opposite = motion.position(TIMES), motion.position(TIMES + motion.radial_period)
    assert np.abs(opposite - before * [-1, -1, 1]).max() <= POSITION
    again = motion.position(TIMES + 2 * motion.radial_period)
    assert np.abs(again - before).max() <= POSITION


@pytest.mark.parametrize("speed", [1e-9, 0.5, 1.99, 2.01, 7.0])
@pytest.mark.parametrize("azimuth", [0.0, 0.3, -2.0])
def test_stays_in_its_plane(speed: float, azimuth: float) -> None:
    # Through the bottom, where the direction is in the velocity alone.
    along = np.array([np.cos(azimuth), np.sin(azimuth)])
    motion = ExactMotion(UNIT, Launch.plane(0.0, 0.0, *(speed * along)))
    plan = motion.position(TIMES)[:, :2]
    sideways = plan @ [-along[1], along[0]]
    assert np.abs(sideways).max() <= 4 * ROUNDING * np.abs(plan).max()
    assert motion.precession == 0


@pytest.mark.parametrize(
    ("length", "launch"),
    [
        (10.0, Launch.plane(0.3, 0.0, -0.2, 0.0)),
        (10.0, Launch.plane(3.0, -4.0, 1.5, -2.0)),
        (10.0, Launch.plane(0.1, 0.2, 0.7, 1.4)),
        (10.0, Launch.apsides(0.5, 0.0, 1.0)),
        (10.0, Launch.ellipse(0.5, 0.0, 1.0)),
        (10.0, Launch.angles(1.0, 0.3, 0.7)),
        (5.0, Launch.state([3.0, 0.0, 4.0], [4.0, 0.0, -3.0])),
    ],
    ids=str,
)
def test_no_angular_momentum(length: float, launch: Launch) -> None:
    motion = ExactMotion(Pendulum(length), launch)
    assert motion.angular_momentum == 0
    assert motion.precession == 0
    assert motion.turning_radii[1] == 0


def test_parallel_only_as_written() -> None:
    # The binary numbers next to 0.3, 0.1, 0.9 and 0.3 are not proportional, and are what counts.
    x, y, vx, vy = numbers = 0.3, 0.1, 0.9, 0.3
    exact = Fraction(x) * Fraction(vy) - Fraction(y) * Fraction(vx)
    motion = ExactMotion(Pendulum(10.0), Launch.plane(*numbers))
    assert motion.angular_momentum == pytest.approx(float(exact), rel=ROUNDING)
    assert motion.precession < 0


def test_fall_from_the_horizontal() -> None:
    # v² = 2gl at the bottom, a quarter of the full swing later.
    motion = ExactMotion(Pendulum(2.0, 9.81), Launch.at_rest(pi / 2))
    velocity = motion.velocity(motion.radial_period / 2)
    assert velocity == pytest.approx([-sqrt(2 * 9.81 * 2), 0, 0], abs=1e-14 * 7)
