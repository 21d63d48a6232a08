"""Small ellipses: the exact precession and frequency against their expansions.

Ω = (3/8) ω0 (ab/l²) (1 + (7/32)(a² + b²)/l² + …) and ω = ω0 (1 − (a² + b²)/16l² + …), where a and b
are the exact turning radii.
"""

import numpy as np
import pytest

from kugelpendel import ExactMotion, Launch, Pendulum

PENDULUM = Pendulum(67.0, 9.81)
SIZES = [1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6, 1e-4]
# Of the exact rates, and of three roundings in the expected ones.
RELATIVE = 4e-16 + 7e-16


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("ratio", [1.0, -1.0, 0.5, -0.1, 1e-3, 1e-9])
@pytest.mark.parametrize("kind", ["apsides", "ellipse"])
def test_precession(size: float, ratio: float, kind: str) -> None:
    a, b = size * 67.0, ratio * size * 67.0
    motion = ExactMotion(PENDULUM, getattr(Launch, kind)(a, b, 1.0))
    squares = size**2 * (1 + ratio**2)
    expected = 0.375 * PENDULUM.angular_frequency * (a / 67.0) * (b / 67.0)
    # b of "ellipse" is a speed: the turning radius is less by a relative 3/8 (a² − b²)/l² or so.
    beyond = size**4 if kind == "apsides" else size**2
    correction = 1 + 7 / 32 * squares if kind == "apsides" else 1.0
    assert motion.precession == pytest.approx(expected * correction, rel=RELATIVE + beyond)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("ratio", [1.0, -0.5, 0.0])
def test_frequency(size: float, ratio: float) -> None:
    motion = ExactMotion(PENDULUM, Launch.apsides(size * 67.0, ratio * size * 67.0))
    expected = PENDULUM.angular_frequency * (1 - size**2 * (1 + ratio**2) / 16)
    assert motion.frequency == pytest.approx(expected, rel=RELATIVE + size**4)


def test_order_of_what_is_left_out() -> None:
    # Relative errors of the leading and of the corrected precession: slopes 2 and 4.
    sizes = np.array([0.2, 0.1, 0.05, 0.025])
    motion = ExactMotion(Pendulum(1.0, 1.0), Launch.apsides(sizes, 0.3 * sizes))
    leading = 0.375 * 0.3 * sizes**2
    corrected = leading * (1 + 7 / 32 * 1.09 * sizes**2)
    for expansion, order in ((leading, 2), (corrected, 4)):
        errors = np.log(np.abs(expansion / motion.precession - 1))
        slopes = np.diff(errors) / np.diff(np.log(sizes))
        assert slopes[-1] == pytest.approx(order, abs=0.01)


@pytest.mark.parametrize("size", SIZES)
def test_plan_view_is_a_turning_ellipse(size: float) -> None:
    # Over a swing or two the precession and the next harmonic are of the order of size².
    a, b = size * 67.0, 0.4 * size * 67.0
    motion = ExactMotion(PENDULUM, Launch.ellipse(a, b))
    phase = np.linspace(0.0, 10.0, 41)
    x, y, _ = motion.position(phase / PENDULUM.angular_frequency).T
    expected = np.stack([a * np.cos(phase), b * np.sin(phase)])
    # The phase is rounded twice.
    rounding = 5e-15 + 2 * size**2
    assert np.abs(np.stack([x, y]) - expected).max() <= rounding * a


@pytest.mark.parametrize("size", SIZES)
def test_ellipse_has_turned_after_a_million_swings(size: float) -> None:
    a, b = size * 67.0, 0.4 * size * 67.0
    motion = ExactMotion(PENDULUM, Launch.apsides(a, b))
    swings = 1_000_000
    x, y, _ = motion.position(swings * motion.radial_period)
    turn = motion.precession * swings * motion.radial_period
    # The time is rounded by up to 2e-16 of itself, half a million radians.
    assert np.arctan2(y, x) == pytest.approx(turn, abs=4e-16 * 3.2e6)
    assert np.hypot(x, y) == pytest.approx(a, rel=1e-14)
