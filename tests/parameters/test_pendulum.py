"""The pendulum: values, shapes, and what it refuses."""

import copy
import pickle
import re
from dataclasses import FrozenInstanceError
from math import inf, nan, sqrt

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum


def test_standard_values() -> None:
    pendulum = Pendulum(67.0)
    assert pendulum.values == (67.0, 9.80665, 1.0)
    assert pendulum.shape == ()
    assert pendulum.angular_frequency == sqrt(9.80665 / 67.0)


@pytest.mark.parametrize(
    "length", [2, 2.0, np.float64(2), np.float32(2), np.array(2.0), np.int8(2)]
)
def test_any_number_becomes_a_float(length: float) -> None:
    pendulum = Pendulum(length, gravity=length, mass=length)
    assert [type(value) for value in pendulum.values] == [float] * 3
    assert type(pendulum.angular_frequency) is float
    assert pendulum == Pendulum(2.0, 2.0, 2.0)


def test_arrays_broadcast() -> None:
    pendulum = Pendulum([[1.0], [4.0], [9.0]], [9.0, 36.0], 3)
    assert pendulum.shape == (3, 2)
    assert pendulum.mass == 3.0
    assert_array_equal(pendulum.angular_frequency, [[3, 6], [1.5, 3], [1, 2]])


def test_arrays_are_copies_and_read_only() -> None:
    lengths = np.array([1.0, 2.0])
    pendulum = Pendulum(lengths)
    lengths[0] = 5.0
    assert_array_equal(pendulum.length, [1, 2])
    for copied in (pendulum, copy.copy(pendulum), copy.deepcopy(pendulum),
                   pickle.loads(pickle.dumps(pendulum))):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            copied.length[0] = 5.0  # pyright: ignore[reportIndexIssue]


def test_frozen() -> None:
    pendulum = Pendulum(1.0)
    with pytest.raises(FrozenInstanceError):
        pendulum.length = 2.0  # pyright: ignore[reportAttributeAccessIssue]
    with pytest.raises(FrozenInstanceError):
        del pendulum.gravity  # pyright: ignore[reportAttributeAccessIssue]


SEVERAL = [
    Pendulum(1.0),
    Pendulum(1.0, mass=2.0),
    Pendulum(1.0, 9.8),
    Pendulum([1.0, 2.0]),
    Pendulum([[1.0, 2.0]]),
    Pendulum([1.0, 3.0]),
    Pendulum(1.0, [9.8, 9.9]),
]


def test_equality_and_hash() -> None:
    for i, one in enumerate(SEVERAL):
        again = pickle.loads(pickle.dumps(one))
        assert again == one
        assert hash(again) == hash(one)
        assert copy.deepcopy(one) == one
        assert [other == one for other in SEVERAL] == [i == k for k in range(len(SEVERAL))]
    assert len({*SEVERAL, *SEVERAL}) == len(SEVERAL)
    assert Pendulum(1.0) != 1.0
    # In an ensemble a bad length may be 0 or −0: equal, and so must be their hashes.
    assert Pendulum([0.0, 1.0]) == Pendulum([-0.0, 1.0])
    assert hash(Pendulum([0.0, 1.0])) == hash(Pendulum([-0.0, 1.0]))


def test_representation_has_units() -> None:
    said = "Pendulum(length=67 m, gravity=9.80665 m/s², mass=28 kg)"
    assert repr(Pendulum(67.0, mass=28)) == said


@pytest.mark.parametrize("value", [0.0, -0.0, -1.5, nan, inf, -inf, 0])
def test_single_numbers_must_be_positive_and_finite(value: float) -> None:
    seen = {0.0: "-?0", -1.5: "-1.5", inf: "inf", -inf: "-inf"}.get(value, "NaN")
    with pytest.raises(InvalidInput, match=f"^The pendulum's length .* is {seen} m; give the dist"):
        Pendulum(value)
    with pytest.raises(
        InvalidInput, match=f"^Gravity .* is {seen} m/s²; leave it out for the stan"
    ):
        Pendulum(1.0, value)
    with pytest.raises(InvalidInput, match=f"^The bob's mass .* is {seen} kg; leave it out for 1"):
        Pendulum(1.0, 9.8, value)


def test_bad_cases_of_an_ensemble_wait_for_the_motion() -> None:
    pendulum = Pendulum([1.0, -1.0, 0.0, nan, inf], [9.8, -9.8, 9.8, 9.8, 9.8])
    assert_array_equal(np.isnan(pendulum.angular_frequency), [False, True, True, True, False])


@pytest.mark.parametrize(
    ("value", "seen"),
    [
        ("67 m", "'67 m'"),
        (["1", "2"], r"\['1', '2'\]"),
        (None, "None"),
        (True, "True"),
        (1j, "1j"),
        ([[1.0, 2.0], [3.0]], r"\[\[1.0, 2.0\], \[3.0\]\]"),
        ({"m": 1}, r"\{'m': 1\}"),
    ],
)
def test_what_is_no_number(value: object, seen: str) -> None:
    said = (
        f"^The pendulum's length must be a number or an array of numbers in m, but it is {seen}; "
        f"leave units out here: they are read from files and on the command line only.$"
    )
    with pytest.raises(InvalidInput, match=said):
        Pendulum(value)  # pyright: ignore[reportArgumentType, reportCallIssue]
    with pytest.raises(
        InvalidInput, match=f"^Gravity must be a number .* in m/s², but it is {seen}"
    ):
        Pendulum(1.0, value)  # pyright: ignore[reportArgumentType, reportCallIssue]
    with pytest.raises(InvalidInput, match=f"^The bob's mass must be a number .* in kg, .* {seen}"):
        Pendulum(1.0, mass=value)  # pyright: ignore[reportArgumentType, reportCallIssue]


def test_shapes_that_do_not_fit() -> None:
    said = (
        r"^The shapes of length, gravity and mass do not fit together: \(2,\), \(3,\), \(\); give "
        r"them shapes that broadcast.$"
    )
    with pytest.raises(InvalidInput, match=said):
        Pendulum([1.0, 2.0], [1.0, 2.0, 3.0])


def test_invalid_input_is_a_value_error() -> None:
    with pytest.raises(ValueError, match="length"):
        Pendulum(-1.0)


@pytest.mark.parametrize("what", ["length", "gravity", "mass"])
@pytest.mark.parametrize("value", [1e51, 1e308, 1e-51, 5e-324])
def test_what_the_numbers_do_not_hold_is_refused(what: str, value: float) -> None:
    # Squares of such numbers are inf or 0, and places were not numbers.
    said = rf"must lie between 1e-50 and 1e\+50 (m|m/s²|kg), .* but it is {re.escape(str(value))}"
    with pytest.raises(InvalidInput, match=said):
        Pendulum(**{"length": 1.0, what: value})


@pytest.mark.parametrize("value", [1e50, 1e-50])
def test_to_the_edge_of_the_numbers_all_is_finite(value: float) -> None:
    motion = ExactMotion(Pendulum(value, value, value), Launch.at_rest(0.2, 0.1))
    assert np.linalg.norm(motion.position(1.0)) == pytest.approx(value)
    assert np.isfinite(motion.velocity(1.0)).all()
    assert np.isfinite(motion.tension(1.0))
