"""The paper's motions: the one interface, and how far each is from the exact one."""

from __future__ import annotations

import pickle
from collections.abc import Callable

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(length=1.3, gravity=9.81, mass=2.0)
FIGURES = [kp.LinearMotion, kp.OlssonMotion, kp.SeriesMotion]
INTEGRATED = [kp.CubicMotion, kp.PlaneMotion]
ALL = [*FIGURES, *INTEGRATED]
LAUNCHES = {
    "clockwise": kp.Launch.plane(0.05, 0.02, 0.1, -0.2),
    "counter-clockwise": kp.Launch.apsides(0.1, 0.04, 1.0),
    "circle": kp.Launch.apsides(0.1, 0.1),
    "straight": kp.Launch.at_rest(0.08, 0.7),
    "through the bottom": kp.Launch.plane(0.0, 0.0, 0.3, 0.1),
}
TIMES = np.linspace(-12.0, 12.0, 101)

Make = Callable[[kp.Pendulum, kp.Launch], kp.ExactMotion]


@pytest.mark.parametrize("launch", LAUNCHES.values(), ids=LAUNCHES.keys())
@pytest.mark.parametrize("make", ALL)
class TestEveryMotion:
    def test_velocity_is_the_rate_of_position(self, make: Make, launch: kp.Launch) -> None:
        motion, h = make(PENDULUM, launch), 1e-3
        x = [motion.position(TIMES + k * h) for k in (-2, -1, 1, 2)]
        rate = (x[0] - 8 * x[1] + 8 * x[2] - x[3]) / (12 * h)  # error h⁴ x⁽⁵⁾/30, about 1e-11
        np.testing.assert_allclose(motion.velocity(TIMES), rate, atol=1e-10)

    def test_stays_on_the_lower_half_of_the_sphere(self, make: Make, launch: kp.Launch) -> None:
        position = make(PENDULUM, launch).position(TIMES)
        np.testing.assert_allclose(np.linalg.norm(position, axis=-1), 1.3, rtol=1e-15)
        assert (position[:, 2] > 0).all()

    def test_a_grid_is_its_times(self, make: Make, launch: kp.Launch) -> None:
        motion = make(PENDULUM, launch)
        times = -3.0 + 0.25 * np.arange(1000)  # exact sums
        np.testing.assert_allclose(
            motion.sample(-3.0, 0.25, 1000), motion.position(times), atol=2e-15
        )

    def test_is_near_the_exact_motion(self, make: Make, launch: kp.Launch) -> None:
        exact = kp.ExactMotion(PENDULUM, launch)
        near = {kp.LinearMotion: 2e-2, kp.OlssonMotion: 5e-4, kp.CubicMotion: 2e-4}
        limit = near.get(make, 1e-8) if make is not kp.PlaneMotion else 1e-13
        difference = make(PENDULUM, launch).position(TIMES) - exact.position(TIMES)
        assert np.abs(difference).max() < limit

    def test_says_where_it_holds_and_can_be_sent(self, make: Make, launch: kp.Launch) -> None:
        motion = make(PENDULUM, launch)
        assert motion.trust.endswith(".")
        assert motion.span == (-np.inf, np.inf)
        assert (motion.pendulum, motion.launch) == (PENDULUM, launch)
        again = pickle.loads(pickle.dumps(motion))
        np.testing.assert_array_equal(again.position(1.0), motion.position(1.0))


@pytest.mark.parametrize("make", ALL)
class TestEnsembles:
    def test_rows_are_the_motions(self, make: Make) -> None:
        a = np.array([0.05, 0.1])
        lengths = np.array([[1.0], [1.5], [2.0]])
        motion = make(kp.Pendulum(lengths), kp.Launch.apsides(a, -a / 2))
        assert motion.shape == (3, 2)
        position = motion.position([[0.5, 1.0]])
        assert position.shape == (3, 2, 1, 2, 3)
        assert motion.velocity(0.5).shape == (3, 2, 3)
        assert motion.sample(0.0, 0.5, 4).shape == (3, 2, 4, 3)
        alone = make(kp.Pendulum(1.5), kp.Launch.apsides(0.1, -0.05))
        np.testing.assert_array_equal(position[1, 1], alone.position([[0.5, 1.0]]))

    def test_a_bad_case_is_nan(self, make: Make) -> None:
        motion = make(kp.Pendulum(1.0), kp.Launch.angles([0.1, 2.0], 0.0, 0.0, [0.5, 0.5]))
        position = motion.position(1.0)
        assert np.isfinite(position[0]).all()
        assert np.isnan(position[1]).all()

    def test_the_upper_half_is_refused(self, make: Make) -> None:
        with pytest.raises(kp.InvalidInput, match=r"use ExactMotion"):
            make(kp.Pendulum(1.0), kp.Launch.angles(2.0, 0.0, 0.0, 0.5))

    def test_times_are_checked(self, make: Make) -> None:
        motion = make(PENDULUM, LAUNCHES["clockwise"])
        with pytest.raises(kp.InvalidInput, match="finite"):
            motion.position(np.nan)
        with pytest.raises(kp.InvalidInput, match="step must not be 0"):
            motion.sample(0.0, 0.0, 3)


@pytest.mark.parametrize("make", FIGURES)
def test_a_figure_that_rises_above_the_support_is_refused(make: Make) -> None:
    with pytest.raises(kp.InvalidInput, match=r"rises to 1\.32\d+ m .* length is 1 m"):
        make(kp.Pendulum(1.0), kp.Launch.plane(0.3, 0.2, 0.5, 5.0))


def test_linear_and_olsson_have_the_paper_s_rates() -> None:
    launch = kp.Launch.apsides(0.2, -0.1)
    linear, olsson = (m(PENDULUM, launch) for m in (kp.LinearMotion, kp.OlssonMotion))
    assert (linear.frequency, linear.precession) == (PENDULUM.angular_frequency, 0.0)
    expected = kp.olsson.precession(0.2, -0.1, 1.3, 9.81)
    assert olsson.precession == pytest.approx(expected, rel=1e-14)
    assert olsson.frequency == pytest.approx(kp.olsson.frequency(0.2, 0.1, 1.3, 9.81), rel=1e-14)


def test_olsson_is_the_ansatz() -> None:
    """x, y of (20) itself, started at the outer turning point."""
    a, b, t = 0.2, 0.1, np.linspace(0.0, 30.0, 50)
    motion = kp.OlssonMotion(PENDULUM, kp.Launch.apsides(a, b))
    w, turn = motion.frequency * t, motion.precession * t
    x = a * np.cos(w) * np.cos(turn) - b * np.sin(w) * np.sin(turn)
    y = a * np.cos(w) * np.sin(turn) + b * np.sin(w) * np.cos(turn)
    np.testing.assert_allclose(motion.position(t)[:, :2], np.stack([x, y], axis=-1), atol=2e-15)


def test_a_series_says_how_wrong_it_is() -> None:
    with pytest.warns(UserWarning, match=r"order 2 is wrong by up to .* use a higher order"):
        motion = kp.SeriesMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.6, 0.3), order=2)
    exact = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.6, 0.3))
    error = motion.precession / exact.precession - 1
    assert motion.expected.precession == pytest.approx(-error, rel=0.3)


@pytest.mark.parametrize("order", [1, 3, 0, -2, 14, 2.5, "6"])
def test_orders_that_make_no_sense(order: object) -> None:
    with pytest.raises(kp.InvalidInput, match="order"):
        kp.SeriesMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1), order=order)  # pyright: ignore[reportArgumentType, reportCallIssue]


def test_events_later_than_times_can_tell() -> None:
    motion = kp.LinearMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.3, 0.1))
    with pytest.raises(kp.errors.InvalidInput, match="in which more than one event happens"):
        motion.events("inner", 0.0, 1e78)


def test_a_series_of_no_case_at_all() -> None:
    motion = kp.SeriesMotion(kp.Pendulum([]), kp.Launch.ellipse(0.1, 0.02))
    assert motion.position(1.0).shape == (0, 3)
