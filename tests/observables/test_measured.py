"""Rates measured at turning points, against motions whose rates are known."""

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.observables import Rates, measured_rates

PENDULUM = kp.Pendulum(length=1.3, gravity=9.81)
ELLIPSES = [(0.1, 0.04), (0.1, -0.04), (0.5, 0.3), (1e-3, 2e-4), (0.3, 0.2999)]


def rates(launch: kp.Launch) -> tuple[Rates, kp.ExactMotion]:
    exact = kp.ExactMotion(PENDULUM, launch)
    return measured_rates(exact, float(exact.radial_period)), exact


@pytest.mark.parametrize(("a", "b"), ELLIPSES)
def test_exact_motion_has_its_own_rates(a: float, b: float) -> None:
    found, exact = rates(kp.Launch.apsides(a, b, 1.0))
    # ε/64(1 − b²/a²) with ε = 1e-15: the roundest of these has 1 − b²/a² = 7e-4.
    assert found.frequency == pytest.approx(exact.frequency, rel=1e-12)
    assert found.precession == pytest.approx(exact.precession, rel=1e-9)


@pytest.mark.parametrize(
    "launch", [kp.Launch.plane(0.05, 0.1, -0.3, 0.1), kp.Launch.ellipse(0.1, 0.2)]
)
def test_any_start_will_do(launch: kp.Launch) -> None:
    found, exact = rates(launch)
    assert found.frequency == pytest.approx(exact.frequency, rel=1e-13)
    assert found.precession == pytest.approx(exact.precession, rel=1e-11)


def test_the_guess_of_the_half_swing_may_be_off() -> None:
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(0.3, 0.1))
    for factor in (0.9, 1.1):
        found = measured_rates(exact, factor * float(exact.radial_period))
        assert found.frequency == pytest.approx(exact.frequency, rel=1e-13)


def test_a_turning_ellipse_has_the_rates_it_was_given() -> None:
    motion = kp.OlssonMotion(PENDULUM, kp.Launch.apsides(0.2, 0.1))
    found = measured_rates(motion, np.pi / float(motion.frequency))
    assert found.frequency == pytest.approx(motion.frequency, rel=1e-13)
    assert found.precession == pytest.approx(motion.precession, rel=1e-11)


def test_a_swing_in_a_plane_does_not_precess() -> None:
    found, exact = rates(kp.Launch.ellipse(0.2, 0.0, 0.4))
    assert found.frequency == pytest.approx(exact.frequency, rel=1e-13)
    assert found.precession is None


@pytest.mark.parametrize("launch", [kp.Launch.apsides(0.2, 0.2), kp.Launch.at_rest(0.0)])
def test_a_circle_shows_no_turning_points(launch: kp.Launch) -> None:
    assert rates(launch)[0] == Rates(None, None)
