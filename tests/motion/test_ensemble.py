"""Many motions at once: the shapes of everything, each the same to the last bit, bad ones apart."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from tests.motion.launches import GALLERY

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

SCALARS = (
    "frequency", "precession", "radial_period", "apsidal_angle", "apsis_time", "energy",
    "angular_momentum", "slack_time", "goes_slack",
)  # fmt: skip
PAIRS = ("turning_radii", "turning_heights", "tension_range")
TIMES = np.array([[-3.0, 0.0, 0.2, 1.0], [7.0, 1e3, 1e6, 1e9]])

LENGTHS = np.array([[0.9], [1.7], [67.0]])
OUTER = np.array([0.1, 0.2, 0.3, 0.8])


def test_shapes() -> None:
    motion = ExactMotion(Pendulum(LENGTHS), Launch.apsides(OUTER, 0.05))
    assert motion.shape == (3, 4)
    for name in SCALARS:
        assert getattr(motion, name).shape == (3, 4), name
    for name in PAIRS:
        assert getattr(motion, name).shape == (3, 4, 2), name
    assert motion.reason.shape == (3, 4)
    assert motion.span == (-np.inf, np.inf)
    for times in (1.0, TIMES[0], TIMES, TIMES[:, :0]):
        shape = np.shape(times)
        assert motion.position(times).shape == (3, 4, *shape, 3)
        assert motion.velocity(times).shape == (3, 4, *shape, 3)
        assert motion.tension(times).shape == (3, 4, *shape)
    assert motion.sample(0.0, 0.1, 5).shape == (3, 4, 5, 3)
    spectrum = motion.spectrum(2)
    for name in ("order", "frequency", "amplitude"):
        assert getattr(spectrum, name).shape == (3, 4, 4), name
        assert getattr(spectrum, f"vertical_{name}").shape == (3, 4, 3), name
    assert spectrum.position(TIMES).shape == (3, 4, 2, 4, 3)


def test_shapes_of_a_single_motion() -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.apsides(0.2, 0.05))
    assert motion.shape == ()
    for name in SCALARS:
        expected = bool if name == "goes_slack" else float
        assert type(getattr(motion, name)) is expected, name
    for name in PAIRS:
        assert getattr(motion, name).shape == (2,), name
    assert motion.reason == ""
    assert motion.reason.shape == ()
    for times in (1.0, 1, TIMES[0], TIMES, []):
        shape = np.shape(times)
        assert motion.position(times).shape == (*shape, 3)
        assert motion.velocity(times).shape == (*shape, 3)
        assert motion.tension(times).shape == shape
    assert motion.spectrum(2).position(TIMES).shape == (2, 4, 3)


def test_empty_ensemble() -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.at_rest([]))
    assert motion.shape == (0,)
    assert motion.frequency.shape == (0,)  # pyright: ignore[reportAttributeAccessIssue]
    assert motion.turning_radii.shape == (0, 2)
    assert motion.position(TIMES).shape == (0, 2, 4, 3)
    assert motion.sample(0.0, 1.0, 5).shape == (0, 5, 3)
    assert motion.reason.shape == (0,)


def same_to_the_last_bit(
    ensemble: ExactMotion, index: tuple[int, ...], single: ExactMotion
) -> None:
    for name in (*SCALARS, *PAIRS):
        assert_array_equal(getattr(ensemble, name)[index], getattr(single, name), name)
    assert_array_equal(ensemble.position(TIMES)[index], single.position(TIMES))
    assert_array_equal(ensemble.velocity(TIMES)[index], single.velocity(TIMES))
    assert_array_equal(ensemble.tension(TIMES)[index], single.tension(TIMES))
    assert_array_equal(ensemble.sample(-1.0, 0.3, 500)[index], single.sample(-1.0, 0.3, 500))


def test_broadcast_is_every_pair() -> None:
    inner = np.array([0.05, -0.2, 1e-9, 0.0])
    ensemble = ExactMotion(Pendulum(LENGTHS, 9.8, 2.0), Launch.apsides(OUTER, inner, 0.4))
    for i, length in enumerate(LENGTHS[:, 0]):
        for j, (a, b) in enumerate(zip(OUTER, inner, strict=True)):
            single = ExactMotion(Pendulum(length, 9.8, 2.0), Launch.apsides(a, b, 0.4))
            same_to_the_last_bit(ensemble, (i, j), single)


@pytest.mark.parametrize("kind", ["ellipse", "apsides", "plane", "angles"])
def test_gallery_at_once(kind: str) -> None:
    # Every kind of motion in one ensemble: whoever converges slowly does not disturb the others.
    chosen = [start for start in GALLERY.values() if start[1].kind == kind]
    pendulums = np.array([pendulum.values for pendulum, _ in chosen]).T
    values = np.array([launch.values for _, launch in chosen]).T
    launch = Launch.angles(*values) if kind == "angles" else getattr(Launch, kind)(*values)
    ensemble = ExactMotion(Pendulum(*pendulums), launch)
    for index, start in enumerate(chosen):
        same_to_the_last_bit(ensemble, (index,), ExactMotion(*start))


def test_launches_of_one_pendulum_and_states() -> None:
    position = np.array([[3.0, 0.0, 4.0], [0.0, -3.0, -4.0]])
    velocity = np.array([[0.0, 2.0, 0.0], [1.0, 0.0, 0.0]])
    ensemble = ExactMotion(Pendulum(5.0), Launch.state(position, velocity))
    assert ensemble.shape == (2,)
    for index in range(2):
        single = ExactMotion(Pendulum(5.0), Launch.state(position[index], velocity[index]))
        same_to_the_last_bit(ensemble, (index,), single)


def test_bad_cases_are_nan_with_a_reason_and_disturb_nobody() -> None:
    lengths = np.array([1.0, -1.0, 1.0, 1.0, 1.0, 1.0, 0.0])
    gravity = np.array([9.8, 9.8, np.nan, 9.8, 9.8, 9.8, 9.8])
    outer = np.array([0.3, 0.3, 0.3, 2.0, 0.3, np.inf, 0.3])
    inner = np.array([0.1, 0.1, 0.1, 0.1, -0.4, 0.1, 0.1])
    ensemble = ExactMotion(Pendulum(lengths, gravity), Launch.apsides(outer, inner))
    said = [
        "",
        "length must be positive and finite, but it is -1 m",
        "Gravity must be positive and finite, but it is NaN m/s²",
        "outer turning radius a must lie between 0 and the length 1 m, but it is 2 m",
        "inner turning radius |b| = 0.4 m must not exceed the outer one, a = 0.3 m",
        "launch's a must be a finite number, but it is inf m",
        "length must be positive and finite, but it is 0 m",
    ]
    for reason, part in zip(ensemble.reason, said, strict=True):
        assert part in reason
    assert ensemble.reason[0] == ""
    single = ExactMotion(Pendulum(1.0, 9.8), Launch.apsides(0.3, 0.1))
    same_to_the_last_bit(ensemble, (0,), single)
    for name in ("frequency", "precession", "slack_time", *PAIRS):
        assert np.isnan(getattr(ensemble, name)[1:]).all(), name
    for quantity in (
        ensemble.position(TIMES),
        ensemble.velocity(TIMES),
        ensemble.tension(TIMES),
        ensemble.sample(0.0, 1.0, 3),
        ensemble.spectrum(3).amplitude,
        ensemble.spectrum(3).frequency,
        ensemble.spectrum(3).vertical_amplitude,
    ):
        assert np.isnan(quantity[1:]).all()
        assert np.isfinite(quantity[0]).all()
    assert_array_equal(ensemble.goes_slack, False)


def test_one_bad_case_alone() -> None:
    ensemble = ExactMotion(Pendulum([-1.0]), Launch.at_rest(0.1))
    assert np.isnan(ensemble.frequency).all()
    assert np.isnan(ensemble.spectrum(3).amplitude).all()
    np.testing.assert_array_equal(ensemble.spectrum(3).order, 0)


def test_shapes_that_do_not_fit() -> None:
    with pytest.raises(InvalidInput, match=r"shape \(3,\) and the launch's \(4,\) do not fit"):
        ExactMotion(Pendulum([1.0, 2.0, 3.0]), Launch.apsides(OUTER, 0.05))


def test_large_ensemble() -> None:
    # Many blocks, the last of them not full.
    count = 5003
    angle = np.linspace(0.01, 3.1, count)
    ensemble = ExactMotion(Pendulum(1.0), Launch.angles(angle, 0.0, 0.1, 2.0))
    for index in (0, 1, 63, 64, 255, 256, 1000, 4095, 5001, 5002):
        single = ExactMotion(Pendulum(1.0), Launch.angles(angle[index], 0.0, 0.1, 2.0))
        for name in SCALARS:
            assert getattr(ensemble, name)[index] == getattr(single, name)
        assert_array_equal(ensemble.position(2.0)[index], single.position(2.0))
