"""The track of the apsides: mean rate, rate at the end, and where a plane stands."""

import numpy as np
import pytest

from kugelpendel.observables import Apsides


def track(times: np.ndarray, azimuth: np.ndarray, rate: float = -0.05) -> Apsides:
    return Apsides(times, times, times, azimuth, rate, 1.0)


def test_apsides_know_their_mean_rate_and_foucaults() -> None:
    times = np.array([1.0, 2.0, 5.0])
    apsides = track(times, np.array([0.3, 0.2, -0.1]))
    assert apsides.mean_rate == pytest.approx(-0.1)
    assert apsides.foucault_azimuth == pytest.approx([0.3, 0.25, 0.1])
    assert track(times[:1], times[:1]).mean_rate == 0
    assert track(times[:1], times[:1]).stands_since is None


def test_a_plane_stands_since_it_has_stopped() -> None:
    times = np.linspace(0.0, 1000.0, 1001)
    turning = track(times, -0.05 * times)
    assert turning.stands_since is None
    assert turning.rate_at_the_end == pytest.approx(-0.05)
    stopped = track(times, -0.05 * np.minimum(times, 400.0))
    assert stopped.stands_since == pytest.approx(400.0, abs=4.0)
    assert stopped.rate_at_the_end == 0
    assert stopped.mean_rate == pytest.approx(-0.02)
