# pyright: strict
"""A single motion's scalars are floats and an ensemble's are arrays, for type checkers too.

Pyright judges the `assert_type` of this file in `make check`, as it would those of a user; here the
values are asked whether it is right.
"""

from collections.abc import Iterator
from typing import assert_type

import numpy as np
import pytest
from numpy.typing import NDArray

import kugelpendel as kp

Numbers = NDArray[np.float64]

SEVERAL = np.array([0.1, 0.2])
PENDULUM, LAUNCH = kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.02)
LAUNCHES = kp.Launch.ellipse(SEVERAL, 0.02)


def single() -> Iterator[float]:
    """What is a float by its type."""
    yield assert_type(PENDULUM.length, float)
    yield assert_type(kp.Pendulum(np.float64(1.0)).angular_frequency, float)
    yield assert_type(kp.Pendulum(SEVERAL.size).mass, float)
    yield assert_type(LAUNCH.values[0], float)
    yield assert_type(kp.Launch.state([0.1, 0, 0.995**0.5], [0.0, 0, 0]).values[0], float)
    yield assert_type(kp.Drag.from_half_life(600.0).linear, float)
    yield assert_type(kp.Drag.from_quality(1e4, PENDULUM).linear, float)
    yield assert_type(kp.Bob(0.05, 8500.0).mass, float)
    yield assert_type(kp.Bob(0.05, 8500.0).gravity_factor(1.0), float)
    yield assert_type(kp.Suspension.from_periods(2.0, 2.001).anisotropy, float)
    yield assert_type(kp.Site(0.8).vertical_rotation, float)
    yield assert_type(kp.Site(0.8).gravity, float)
    yield assert_type(kp.olsson.precession(0.1, 0.02, 1.0), float)
    yield assert_type(kp.olsson.frequency(0.1, 0.02, 1.0), float)
    exact = kp.ExactMotion(PENDULUM, LAUNCH)
    for motion in (exact, kp.LinearMotion(PENDULUM, LAUNCH), kp.SeriesMotion(PENDULUM, LAUNCH)):
        yield assert_type(motion.frequency, float)
        yield assert_type(motion.precession, float)
        yield assert_type(motion.period, float)
        yield assert_type(motion.pendulum.length, float)
    yield assert_type(exact.energy, float)
    yield assert_type(kp.OlssonMotion(PENDULUM, LAUNCH).frequency, float)
    yield assert_type(kp.CubicMotion(PENDULUM, LAUNCH).frequency, float)
    yield assert_type(kp.PlaneMotion(PENDULUM, LAUNCH).frequency, float)
    drag, site = kp.Drag(1e-4), kp.Site(0.8, 9.80665)
    for real in (
        kp.RealMotion(PENDULUM, LAUNCH),
        kp.RealMotion(PENDULUM, LAUNCH, site=site, drag=drag),
        kp.RealMotion(PENDULUM, LAUNCH, kp.Forces(drag=drag, suspension=None), thread="rod"),
        kp.EnvelopeMotion(PENDULUM, LAUNCH, kp.Forces()),
        kp.EnvelopeMotion(PENDULUM, LAUNCH, drag=drag, exact=False),
    ):
        yield assert_type(real.angular_frequency, float)
        yield assert_type(real.rotation, float)
        yield assert_type(real.effective_pendulum.gravity, float)


def ensemble() -> Iterator[Numbers]:
    """What is an array by its type."""
    yield assert_type(kp.Pendulum(SEVERAL).length, Numbers)
    yield assert_type(kp.Pendulum([1.0, 2.0]).angular_frequency, Numbers)
    yield assert_type(kp.Drag.from_half_life(SEVERAL).linear, Numbers)
    yield assert_type(kp.olsson.precession(SEVERAL, 0.02, 1.0), Numbers)
    exact = kp.ExactMotion(PENDULUM, LAUNCHES)
    yield assert_type(exact.frequency, Numbers)
    yield assert_type(exact.energy, Numbers)
    yield assert_type(kp.ExactMotion(kp.Pendulum(1 + SEVERAL), LAUNCH).frequency, Numbers)
    yield assert_type(kp.SeriesMotion(PENDULUM, LAUNCHES, order=4).precession, Numbers)
    yield assert_type(kp.CubicMotion(PENDULUM, LAUNCHES).frequency, Numbers)
    pendulums = kp.Pendulum(1 + SEVERAL)
    for motion in (
        kp.RealMotion(pendulums, LAUNCH, drag=kp.Drag(1e-4)),
        kp.RealMotion(pendulums, LAUNCHES, site=kp.Site(0.8 + SEVERAL), drag=kp.Drag(1e-4)),
    ):
        yield np.asarray(assert_type(motion.angular_frequency, float | Numbers))
    forces = kp.Forces(site=kp.Site(0.8), drag=kp.Drag(1e-4 * SEVERAL))
    assert_type(forces, kp.Forces[Numbers])
    assert_type(kp.EnvelopeMotion(PENDULUM, LAUNCH, forces), kp.EnvelopeMotion[Numbers])


def either(motion: kp.Motion, pendulum: kp.Pendulum, launch: kp.Launch) -> Iterator[object]:
    """What may be both, as nothing is known of what was given."""
    yield assert_type(motion.frequency, float | Numbers)
    yield assert_type(kp.ExactMotion(pendulum, launch).frequency, float | Numbers)
    yield assert_type(kp.ExactMotion(pendulum, LAUNCH).frequency, float | Numbers)


def test_a_single_motion_has_floats() -> None:
    assert {type(value) for value in single()} == {float}


def test_an_ensemble_has_arrays() -> None:
    assert {type(value) for value in ensemble()} == {np.ndarray}


@pytest.mark.parametrize("launch", [LAUNCH, LAUNCHES])
def test_a_single_motion_and_an_ensemble_are_motions(launch: kp.Launch) -> None:
    found = [type(value) for value in either(kp.ExactMotion(PENDULUM, launch), PENDULUM, launch)]
    kind = float if launch.shape == () else np.ndarray
    assert found == [kind, kind, float]


def test_a_part_of_an_ensemble_may_be_a_single_motion() -> None:
    ensemble = kp.ExactMotion(PENDULUM, LAUNCHES)
    assert isinstance(assert_type(ensemble[0], kp.ExactMotion).frequency, float)
    assert isinstance(assert_type(ensemble[:1], kp.ExactMotion).frequency, np.ndarray)
    for part in ensemble:
        assert isinstance(assert_type(part, kp.ExactMotion).frequency, float)
