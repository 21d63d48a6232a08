"""The factor on the intrinsic precession, which the fits of recorded tracks vary."""

from __future__ import annotations

import numpy as np
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import _core

LENGTH, GRAVITY, A, B = 1.3, 9.81, 0.3, 0.1
TIMES = np.array([0.0, 50.0, 500.0])


def azimuths(*factors: float) -> np.ndarray:
    """ψ of averaged motions of one ellipse without forces, a row for each factor."""
    given = [LENGTH, GRAVITY, A, B, *[0.0] * 8]
    columns = [np.array([value]) for value in given] + [np.array(factors)]
    found = _core.averaged_ellipses(len(factors), columns, TIMES)
    return found.reshape(len(factors), TIMES.size, 3)[..., 2]


def test_each_case_turns_by_its_own_factor() -> None:
    motion = kp.ExactMotion(kp.Pendulum(LENGTH, GRAVITY), kp.Launch.apsides(A, B))
    turned = azimuths(1.0, 1.5, 0.0)
    assert_allclose(turned, np.outer([1.0, 1.5, 0.0], motion.precession * TIMES), rtol=1e-12)


def test_a_factor_that_is_no_number_spoils_its_own_case_only() -> None:
    assert (np.isnan(azimuths(1.0, np.nan, 2.0)).any(axis=1) == [False, True, False]).all()
