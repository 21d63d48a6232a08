"""One test for each mistake that was found after it had been made."""

from __future__ import annotations

import numpy as np
import pytest

import kugelpendel as kp


@pytest.mark.parametrize("a", [0.1148698354997035, 0.5, 0.8, 0.95])
def test_spectrum_of_a_cone_to_the_last_bit(a: float) -> None:
    """Both turning heights equal: the argument of the upper theta function is a limit."""
    spectrum = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.apsides(a, a)).spectrum(2)
    amplitude = np.abs(spectrum.amplitude)
    assert amplitude[spectrum.order == 1] == pytest.approx(a, rel=4e-15)
    np.testing.assert_allclose(amplitude[spectrum.order != 1], 0.0, atol=1e-15)


@pytest.mark.parametrize("step", [0.01, 0.7, 5.0])
def test_a_grid_that_takes_many_swings_in_a_block(step: float) -> None:
    """The table of rotations once lost half a turn where a block spans several swings."""
    motion = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1))
    times = step * np.arange(1000)
    # The times of the grid are not rounded, those asked for are: 1e-16 of 5000 s at 0.6 m/s.
    np.testing.assert_allclose(motion.sample(0.0, step, 1000), motion.position(times), atol=1e-12)
