"""Exactly on the separatrix, by its elementary solution, and a few units in the last place beside.

With ω0 = l = 1 and from the bottom with speed 2, sin(θ/2) = tanh t: x = 2 tanh t/cosh t, and
z = 1 − 2 tanh² t.
"""

from math import asinh, inf, pi, sqrt

import numpy as np
import pytest
from tests.motion.launches import Vector, escape

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

UNIT = Pendulum(1.0, 1.0)
WIDE = Pendulum(25.0, 10.0)
TIMES = np.concatenate([np.linspace(-20, 20, 81), [-300.0, -40.0, 40.0, 300.0, 1e9]])
# Of the length; where from: test_equations.
POSITION = 1e-14
# Slack where the height is (2·2 + 1)/3 lengths: tanh² t = 5/6.
SLACK = asinh(sqrt(5))


def elementary(times: Vector) -> tuple[Vector, Vector]:
    """Outward position and speed, and height: (x, z), (vx, vz)."""
    tanh, sech = np.tanh(times), 1 / np.cosh(np.minimum(np.abs(times), 700))
    position = np.stack([2 * tanh * sech, 1 - 2 * tanh**2], axis=-1)
    velocity = np.stack([2 * sech * (sech**2 - tanh**2), -4 * tanh * sech**2], axis=-1)
    return position, velocity


@pytest.mark.parametrize(
    ("pendulum", "launch", "phase"),
    [
        (UNIT, Launch.plane(0.0, 0.0, 2.0, 0.0), 0.0),
        (UNIT, Launch.angles(0.0, 0.0, 2.0), 0.0),
        # At 15 m of 25 m out, z = 20 m and v² = 2·10·(20 + 25): tanh² = (25 − 20)/50.
        (WIDE, Launch.plane(15.0, 0.0, 24.0, 0.0), asinh(1 / 3)),
        (WIDE, Launch.plane(-15.0, 0.0, 24.0, 0.0), -asinh(1 / 3)),
        # Above the support, z = −20 m: tanh² = 45/50.
        (WIDE, Launch.state([15.0, 0.0, -20.0], [-8.0, 0.0, -6.0]), asinh(3)),
        (WIDE, Launch.state([-15.0, 0.0, -20.0], [-8.0, 0.0, 6.0]), -asinh(3)),
    ],
)
def test_elementary_solution(pendulum: Pendulum, launch: Launch, phase: float) -> None:
    motion = ExactMotion(pendulum, launch)
    length, rate = float(pendulum.length), float(pendulum.angular_frequency)
    position, velocity = elementary(TIMES + phase)
    seen = motion.position(TIMES / rate) / length
    assert np.abs(seen[:, [0, 2]] - position).max() <= POSITION
    assert np.abs(seen[:, 1]).max() <= POSITION
    seen = motion.velocity(TIMES / rate) / (length * rate)
    assert np.abs(seen[:, [0, 2]] - velocity).max() <= POSITION
    grid = motion.sample(-20 / rate, 0.5 / rate, 81) / length
    assert np.abs(grid[:, [0, 2]] - position[:81]).max() <= 2 * POSITION
    assert (motion.frequency, motion.precession) == (0, 0)
    assert (motion.radial_period, motion.apsis_time) == (inf, inf)
    assert motion.slack_time == pytest.approx(
        0 if abs(phase) > SLACK else (SLACK - phase) / rate, rel=1e-15
    )
    assert motion.tension_range == pytest.approx(
        np.array([-1, 5]) * float(pendulum.gravity), rel=1e-15
    )
    assert motion.turning_heights == pytest.approx([2 * length, 0], rel=1e-15, abs=0)


def test_no_spectrum() -> None:
    motion = ExactMotion(UNIT, Launch.plane(0.0, 0.0, 2.0, 0.0))
    with pytest.raises(InvalidInput, match=r"on the separatrix \(energy 2 J/kg.*never repeats"):
        motion.spectrum(4)


@pytest.mark.parametrize("theta", [0.0, 0.5, 1.0, 2.0, 2.5, 3.0])
@pytest.mark.parametrize("ulps", [-40, -3, -2, -1, 0, 1, 2, 3, 40])
def test_beside_the_separatrix(theta: float, ulps: int) -> None:
    # Until it is near the top it cannot be told from the separatrix: the difference grows like
    # e^t from some ulps.
    motion = ExactMotion(UNIT, escape(theta, ulps))
    phase = asinh(np.tan(theta / 2))
    times = np.linspace(0, 4, 41)
    position, _ = elementary(times + phase)
    seen = motion.position(times)
    outward = seen[:, :2] @ [np.cos(0.4), -np.sin(0.4)]
    away = (2 + abs(ulps)) * 2.2e-16 * np.exp(times + phase)
    gap = np.hypot(outward - position[:, 0], seen[:, 2] - position[:, 1])
    assert np.all(gap <= POSITION + away)


@pytest.mark.parametrize("theta", [0.0, 0.5, 1.0, 2.0, 2.5])
@pytest.mark.parametrize("ulps", [-4, -3, -2, -1, 1, 2, 3, 4])
def test_turns_back_or_goes_over(theta: float, ulps: int) -> None:
    motion = ExactMotion(UNIT, escape(theta, ulps))
    if motion.frequency == 0:
        pytest.fail("a launch with some bits more or less is not on the separatrix")
    after = motion.position(motion.apsis_time + motion.radial_period / 4)
    outward = after[:2] @ [np.cos(0.4), -np.sin(0.4)]
    over = outward < 0
    assert motion.apsidal_angle == (2 * pi if over else pi)
    assert motion.frequency * motion.radial_period == pytest.approx(
        2 * pi if over else pi, rel=1e-15
    )
