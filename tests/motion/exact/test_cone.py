"""On a cone, exactly and nearly: steady rotation, and small oscillations about it."""

from math import atan2, cos, pi, sin, sqrt

import numpy as np
import pytest
from tests.motion.launches import Vector, cone

from kugelpendel import ExactMotion, Launch, Pendulum

UNIT = Pendulum(1.0, 1.0)
TIMES = np.array([-50.0, -1.0, 0.0, 0.3, 7.0, 100.0])
# Of the length; where from: test_equations.
POSITION = 1e-14
# A few roundings.
ROUNDING = 1e-15
# cos θ = 4/5 and 5/13, where radius, height, and one time the rate are exact.
EXACT = [
    (Pendulum(25.0, 0.8), Launch.plane(15.0, 0.0, 0.0, 3.0), 0.8),
    (Pendulum(25.0, 0.8), Launch.plane(0.0, -15.0, -3.0, 0.0), 0.8),
    (Pendulum(13.0, 5.0), Launch.plane(12.0, 0.0, 0.0, 12.0), 5 / 13),
]


def circle(pendulum: Pendulum, cosine: float, sense: float, azimuth: float) -> Vector:
    """Positions at TIMES, m."""
    rate = sense * sqrt(float(pendulum.gravity) / float(pendulum.length) / cosine)
    angle, sine = azimuth + rate * TIMES, sqrt((1 - cosine) * (1 + cosine))
    plan = sine * np.cos(angle), sine * np.sin(angle)
    return float(pendulum.length) * np.stack([*plan, np.full_like(TIMES, cosine)], axis=-1)


@pytest.mark.parametrize(("pendulum", "launch", "cosine"), EXACT, ids=str)
def test_exact_cone(pendulum: Pendulum, launch: Launch, cosine: float) -> None:
    motion = ExactMotion(pendulum, launch)
    x, y, *_ = (float(value) for value in launch.values)
    sense = 1.0 if motion.angular_momentum > 0 else -1.0
    expected = circle(pendulum, cosine, sense, atan2(y, x))
    # The expected angle is rounded: at 100 s and 1 rad/s by 1.5e-14.
    gap = np.linalg.norm(motion.position(TIMES) - expected, axis=-1)
    assert np.all(gap <= (POSITION + 4e-16 * np.abs(TIMES)) * float(pendulum.length))
    heights = (1 - cosine) * float(pendulum.length)
    assert motion.turning_heights == pytest.approx([heights, heights], rel=ROUNDING)
    assert np.ptp(motion.position(TIMES)[:, 2]) <= ROUNDING * float(pendulum.length)


@pytest.mark.parametrize("theta", [1e-9, 1e-4, 0.1, 0.8, 1.2, 1.5, 1.5707])
@pytest.mark.parametrize("factor", [1.0, 1 + 1e-15, 1 + 1e-12, 1 - 1e-9])
def test_rates_of_cones(theta: float, factor: float) -> None:
    # Small oscillations: ω_radial² = (1 + 3 cos²θ)/cos θ; ω is half of it, since one swing is
    # half an oscillation. Relative corrections are of the order of (factor − 1)·(l/z)².
    motion = ExactMotion(UNIT, cone(theta, factor))
    cosine = cos(theta)
    tolerance = ROUNDING * 4 / cosine + 20 * abs(factor - 1) / cosine**2
    radial = sqrt((1 + 3 * cosine**2) / cosine)
    assert motion.radial_period == pytest.approx(2 * pi / radial, rel=tolerance)
    assert motion.frequency == pytest.approx(radial / 2, rel=tolerance)
    # 1/√cos θ − ω, without the cancellation that small angles have: 3 sin²θ/4 on top.
    numerator = 3 * sin(theta) ** 2 / (4 * cosine)
    precession = numerator / (1 / sqrt(cosine) + radial / 2)
    assert motion.precession == pytest.approx(precession, rel=2 * tolerance)
    apsidal = 2 * pi / sqrt(1 + 3 * cosine**2)
    assert motion.apsidal_angle == pytest.approx(apsidal, rel=2 * tolerance)


@pytest.mark.parametrize("theta", [0.1, 0.5, 1.0, 1.4])
def test_apsidal_angle_tends_to_that_of_the_cone(theta: float) -> None:
    # π/√(1 + 3 cos²θ) from highest to lowest point; both signs of the deviation, so that what is
    # left is of second order: four times less for half of it.
    limit = 2 * pi / sqrt(1 + 3 * cos(theta) ** 2)
    gaps = []
    for part in (0.02, 0.01):
        heights = 1 - cos(theta) + part * (1 - cos(theta)) * np.array([1, -1])
        radii = np.sqrt(heights * (2 - heights))
        gaps.append(ExactMotion(UNIT, Launch.apsides(*radii)).apsidal_angle - limit)
    assert gaps[0] / gaps[1] == pytest.approx(4, rel=0.01)


@pytest.mark.parametrize("deviation", [1e-15, 1e-12, 1e-9, 1e-6])
def test_near_cone_stays_near_it(deviation: float) -> None:
    motion = ExactMotion(UNIT, cone(0.8, 1 + deviation))
    expected = circle(UNIT, cos(0.8), 1.0, 0.3)
    gap = np.linalg.norm(motion.position(TIMES) - expected, axis=-1)
    # The circle's angle drifts by less than twice the deviation in each unit of time.
    assert np.all(gap <= POSITION + 4e-16 * np.abs(TIMES) + deviation * (3 + 2 * np.abs(TIMES)))


def test_circle_by_apsides_and_by_ellipse() -> None:
    # a = b: the first is a circle exactly, the second, b·ω0 being too slow for a circle, is not.
    circle_heights = ExactMotion(UNIT, Launch.apsides(0.5, -0.5)).turning_heights
    assert circle_heights[0] == pytest.approx(circle_heights[1], rel=ROUNDING)
    low = ExactMotion(UNIT, Launch.ellipse(0.5, 0.5))
    assert low.turning_radii[1] < 0.5
    assert low.turning_radii[0] == pytest.approx(0.5, rel=ROUNDING)
