"""What the fits of recorded tracks ask: fundamentals, and a factor on the intrinsic precession."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import _core

LENGTH, GRAVITY, A, B = 1.3, 9.81, 0.3, 0.1
TIMES = np.array([0.0, 50.0, 500.0])


def fundamentals(a: float, b: float, *factors: float) -> np.ndarray:
    """a, b and ψ of averaged motions of one ellipse without forces, a row for each factor."""
    given = [LENGTH, GRAVITY, a, b, *[0.0] * 8]
    columns = [np.array([value]) for value in given] + [np.array(factors)]
    found = _core.averaged_fundamentals(len(factors), columns, TIMES)
    return found.reshape(len(factors), TIMES.size, 3)


def azimuths(*factors: float) -> np.ndarray:
    """ψ alone."""
    return fundamentals(A, B, *factors)[..., 2]


@pytest.mark.parametrize(
    ("a", "b"), [(0.01, 0.003), (0.3, 0.1), (0.9, -0.4), (1.2, 1.2), (1.2, 0.0)]
)
def test_the_fundamental_is_that_of_the_exact_motion(a: float, b: float) -> None:
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.apsides(a, b))
    times = np.arange(256) * (2 * np.pi / motion.frequency / 256)
    x, y, _ = motion.position(times).T
    turning = (x + 1j * y) * np.exp(-1j * motion.precession * times)
    ahead, behind = (
        (turning * np.exp(way * 1j * motion.frequency * times)).mean().real for way in (-1, 1)
    )
    found = fundamentals(a, b, 1.0)[0, :, :2]
    expected = np.array([ahead + behind, ahead - behind])
    assert_allclose(found, np.tile(expected, (TIMES.size, 1)), rtol=1e-12, atol=1e-14)
    share = 3 / 64 * (a**2 - b**2) / LENGTH**2
    assert_allclose(expected, [a * (1 + share), b * (1 - share)], rtol=0.05 * (a / LENGTH) ** 4)


def test_each_case_turns_by_its_own_factor() -> None:
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.apsides(A, B))
    turned = azimuths(1.0, 1.5, 0.0)
    assert_allclose(turned, np.outer([1.0, 1.5, 0.0], motion.precession * TIMES), rtol=1e-12)


def test_a_factor_that_is_no_number_spoils_its_own_case_only() -> None:
    assert (np.isnan(azimuths(1.0, np.nan, 2.0)).any(axis=1) == [False, True, False]).all()
