"""Times beyond 2^53 half swings: the phase is still that of the exact numbers given."""

from __future__ import annotations

from math import radians
from typing import Any

import mpmath
import numpy as np
import pytest

import kugelpendel as kp

mp: Any = mpmath.mp.clone()
mp.dps = 60


def libration(theta: float, time: float) -> float:
    """x of a plane pendulum of unit length and gravity let go at θ: sin(θ/2) = k cd(t|k²)."""
    modulus = mp.sin(mp.mpf(theta) / 2)
    half_sine = modulus * mp.ellipfun("cd", mp.mpf(time), m=modulus**2)
    return float(2 * half_sine * mp.sqrt(1 - half_sine**2))


@pytest.mark.parametrize("time", [1e15, 2.4e16, 3.3e16, 7.7e16, 2.0**57 + 64, 1e18])
@pytest.mark.parametrize("degrees", [172.0, 173.0, 179.0, 120.0])
def test_no_swing_is_lost(degrees: float, time: float) -> None:
    """Near the separatrix every swing turns the frame by half a turn, and one left out mirrors."""
    theta = radians(degrees)
    motion = kp.ExactMotion(kp.Pendulum(1.0, 1.0), kp.Launch.at_rest(theta))
    times = [time, np.nextafter(time, np.inf), -time]
    expected = [libration(theta, float(t)) for t in times]
    # The rates are good to 1e-31, the phase to that times the swings, and the speed is at most 2.
    found = motion.position(times)[:, 0]
    np.testing.assert_allclose(found, expected, atol=4e-15 + 1e-30 * time)
