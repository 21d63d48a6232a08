"""The factor on the intrinsic precession, which the fits of recorded tracks vary."""

from __future__ import annotations

import numpy as np
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import _core

TIMES = np.array([0.0, 50.0, 500.0])
PRECESSION = 1  # of the seven rates: the Earth's comes first


def motions(factors: list[float] | None) -> _core.EnvelopeMotions:
    """Three averaged motions of one launch, which differ by the factor."""
    one = kp.EnvelopeMotion(
        kp.Pendulum(1.3), kp.Launch.ellipse(0.3, 0.1), drag=kp.Drag(1e-4), site=kp.Site(0.8)
    )
    _, pendulum, launch, acting = one._columns
    column = None if factors is None else np.array(factors)
    return _core.EnvelopeMotions(3, pendulum, launch, acting, True, column)


def test_each_case_turns_by_its_own_factor() -> None:
    rates, _ = motions([1.0, 1.5, 0.0]).read("rates", TIMES)
    axes, _ = motions([1.0, 1.5, 0.0]).read("semi_axes", TIMES)
    intrinsic = rates.reshape(3, TIMES.size, 7)[..., PRECESSION]
    a, b = np.moveaxis(axes.reshape(3, TIMES.size, 2), -1, 0)
    ideal = kp.ExactMotion(kp.Pendulum(1.3), kp.Launch.apsides(a, b)).precession
    assert_allclose(intrinsic, np.array([[1.0], [1.5], [0.0]]) * ideal, rtol=1e-12)


def test_without_a_factor_it_is_one() -> None:
    without, _ = motions(None).read("position", TIMES)
    with_one, _ = motions([1.0]).read("position", TIMES)
    assert (without == with_one).all()


def test_the_launch_is_that_of_every_factor() -> None:
    for what in ("position", "velocity"):
        found, _ = motions([1.0, 1.5, 0.0]).read(what, np.zeros(1))
        assert_allclose(found.reshape(3, 3), np.broadcast_to(found[:3], (3, 3)), atol=1e-14)


def test_a_factor_that_is_no_number_spoils_its_own_case_only() -> None:
    azimuth, _ = motions([1.0, np.nan, 2.0]).read("azimuth", TIMES)
    assert (np.isnan(azimuth.reshape(3, TIMES.size)).any(axis=1) == [False, True, False]).all()
