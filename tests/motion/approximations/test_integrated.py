"""The integrated motions: their error, and where equation (12) ends."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import kugelpendel as kp

STORED = Path(__file__).parents[2] / "reference" / "cubic.json"
UNIT = kp.Pendulum(length=1.0, gravity=1.0)


def below(highest: float) -> list[tuple[kp.Launch, float]]:
    """200 random launches whose energy takes the bob no higher than this angle, in degrees.

    Each with the time of 100 swings there and back.
    """
    numbers, found = np.random.default_rng(12), []
    while len(found) < 200:
        theta, phi, way = numbers.uniform([0.01, 0.0, 0.0], [np.radians(highest), 6.28, 6.28])
        most = 2 * (np.cos(theta) - np.cos(np.radians(highest)))
        speed = np.sqrt(most * numbers.uniform())
        rates = speed * np.cos(way), speed * np.sin(way) / np.sin(theta)
        launch = kp.Launch.angles(theta, phi, *rates)
        found.append((launch, 200 * float(kp.ExactMotion(UNIT, launch).radial_period)))
    return found


@pytest.mark.parametrize(("highest", "worst"), [(60.0, 1e-12), (89.0, 2e-11)])
def test_plane_motion_is_as_exact_over_100_swings_as_it_says(highest: float, worst: float) -> None:
    largest = 0.0
    for launch, last in below(highest):
        times = np.linspace(0.0, last, 301)
        error = kp.PlaneMotion(UNIT, launch).position(times)
        error -= kp.ExactMotion(UNIT, launch).position(times)
        largest = max(largest, float(np.linalg.norm(error, axis=-1).max()))
    assert worst / 10 < largest < worst


def test_cubic_motion_is_as_exact_over_100_swings_as_it_says() -> None:
    """Against (13) in fixed point (references/equations/cubic.py): 200 launches below 60°."""
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    assert len(stored["cases"]) == 200
    largest = 0.0
    for case in stored["cases"]:
        places = np.array(case["places"], dtype=float)
        motion = kp.CubicMotion(UNIT, kp.Launch.plane(*case["launch"]))
        error = motion.position(stored["times"])[:, :2] - places
        largest = max(largest, float(np.linalg.norm(error, axis=-1).max()))
    assert 1e-13 < largest < 1e-12


def test_cubic_motion_keeps_its_own_integral_over_100_swings() -> None:
    """Along (13), d(v²)/dt = −Λ d(ρ²)/dt with Λ = 1 − ρ²/2 + v²: a linear equation for w = v² as a
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
