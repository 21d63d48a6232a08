"""The integrated motions: their error, and where equation (12) ends."""

from __future__ import annotations

import numpy as np
import pytest

import kugelpendel as kp

UNIT = kp.Pendulum(length=1.0, gravity=1.0)


def test_plane_motion_is_exact_to_1e_12_over_100_swings() -> None:
    launch = kp.Launch.apsides(0.5, 0.2)
    exact = kp.ExactMotion(UNIT, launch)
    times = np.linspace(0.0, 200 * exact.radial_period, 3001)
    error = kp.PlaneMotion(UNIT, launch).position(times) - exact.position(times)
    assert np.abs(error).max() < 1e-12


def test_cubic_motion_is_integrated_to_1e_12_over_100_swings() -> None:
    """Against its own integral of motion.

    Along (13), d(v²)/dt = −Λ d(ρ²)/dt with Λ = 1 − ρ²/2 + v²: a linear equation for w = v² as a
    function of u = ρ², dw/du = −(1 − u/2 + w), solved by w = u/2 − 3/2 + C e^{−u}.
    """
    motion = kp.CubicMotion(UNIT, kp.Launch.apsides(0.5, 0.2))
    times = np.linspace(0.0, 200 * np.pi, 3001)
    position, velocity = motion.position(times), motion.velocity(times)
    u = (position[:, :2] ** 2).sum(axis=-1)
    w = (velocity[:, :2] ** 2).sum(axis=-1)
    constant = (w - u / 2 + 1.5) * np.exp(u)
    np.testing.assert_allclose(constant, constant[0], rtol=1e-12)
    spin = position[:, 0] * velocity[:, 1] - position[:, 1] * velocity[:, 0]
    np.testing.assert_allclose(spin, spin[0], rtol=1e-12)


class TestSupportLevel:
    launch = kp.Launch.plane(0.3, 0.2, 0.2, 1.6)

    def test_span_ends_where_the_bob_reaches_it(self) -> None:
        motion = kp.PlaneMotion(UNIT, self.launch)
        first, last = motion.span
        assert first < 0 < last
        heights = kp.ExactMotion(UNIT, self.launch).position([first, last])[:, 2]
        # The law divides by the depth below the support, so the last step loses four digits.
        np.testing.assert_allclose(heights, 0.0, atol=1e-10)
        np.testing.assert_allclose(
            motion.position([first, last])[:, :2],
            kp.ExactMotion(UNIT, self.launch).position([first, last])[:, :2],
            atol=1e-10,
        )

    def test_beyond_is_an_error_with_the_times(self) -> None:
        motion = kp.PlaneMotion(UNIT, self.launch)
        for time, end in zip((-10.0, 10.0), motion.span, strict=True):
            with pytest.raises(kp.MotionEnded) as caught:
                motion.position(time)
            for part in (f"ends at {end:.6g} s", f"{time:g} s", "height of the support", "span"):
                assert part in str(caught.value)

    def test_in_an_ensemble_it_is_nan_from_there_on(self) -> None:
        motion = kp.PlaneMotion(UNIT, kp.Launch.plane(0.3, 0.2, 0.2, [0.1, 1.6]))
        position = motion.position([-10.0, 0.0, 10.0])
        np.testing.assert_array_equal(
            np.isnan(position).any(axis=-1), [[False, False, False], [True, False, True]]
        )

    def test_below_there_is_no_end(self) -> None:
        assert kp.PlaneMotion(UNIT, kp.Launch.apsides(0.9, 0.3)).span == (-np.inf, np.inf)


def test_cubic_motion_ends_where_it_would_leave_the_sphere() -> None:
    motion = kp.CubicMotion(UNIT, kp.Launch.plane(0.3, 0.2, 0.2, 1.6))
    first, last = motion.span
    assert first < 0 < last
    radii = np.linalg.norm(motion.position([first, last])[:, :2], axis=-1)
    np.testing.assert_allclose(radii, 1.0, atol=1e-10)
    with pytest.raises(kp.MotionEnded, match="CubicMotion ends at"):
        motion.position(1e6)


def test_at_rest_nothing_happens() -> None:
    for make in (kp.CubicMotion, kp.PlaneMotion):
        motion = make(UNIT, kp.Launch.plane(0.0, 0.0, 0.0, 0.0))
        np.testing.assert_array_equal(motion.position([0.0, 1e3]), [[0.0, 0.0, 1.0]] * 2)


def test_order_of_times_does_not_matter() -> None:
    motion = kp.PlaneMotion(UNIT, kp.Launch.apsides(0.5, 0.2))
    times = np.random.default_rng(1).uniform(-50.0, 50.0, 200)
    ordered = motion.position(np.sort(times))
    np.testing.assert_array_equal(motion.position(times)[np.argsort(times)], ordered)
