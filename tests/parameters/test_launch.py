"""The launch: what it keeps, what it refuses by itself, and what with a pendulum."""

import copy
import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError
from math import inf, nan

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

PENDULUM = Pendulum(2.0, 9.8)


@pytest.mark.parametrize(
    ("launch", "kind", "values"),
    [
        (Launch.ellipse(0.1, 0.2), "ellipse", (0.1, 0.2, 0.0)),
        (Launch.ellipse(a=0.1, b=-0.2, azimuth=1), "ellipse", (0.1, -0.2, 1.0)),
        (Launch.apsides(0.2, -0.1), "apsides", (0.2, -0.1, 0.0)),
        (Launch.apsides(a=0.2, b=0.1, azimuth=2), "apsides", (0.2, 0.1, 2.0)),
        (Launch.plane(0.1, 0.2, 0.3, 0.4), "plane", (0.1, 0.2, 0.3, 0.4)),
        (Launch.plane(x=1, y=0, vx=0, vy=2), "plane", (1.0, 0.0, 0.0, 2.0)),
        (Launch.angles(1.0), "angles", (1.0, 0.0, 0.0, 0.0)),
        (Launch.angles(1.0, phi_rate=3, phi=2), "angles", (1.0, 2.0, 0.0, 3.0)),
        (Launch.at_rest(1.0), "at_rest", (1.0, 0.0)),
        (Launch.at_rest(1.0, 0.5), "at_rest", (1.0, 0.5)),
        (Launch.state([0, 0, 2], [1, 2, 0]), "state", (0.0, 0.0, 2.0, 1.0, 2.0, 0.0)),
    ],
    ids=str,
)
def test_kind_and_values(launch: Launch, kind: str, values: tuple[float, ...]) -> None:
    assert launch.kind == kind
    assert launch.values == values
    assert [type(value) for value in launch.values] == [float] * len(values)
    assert launch.shape == ()


def test_arrays_broadcast() -> None:
    assert Launch.apsides(np.full((3, 1), 0.2), [0.1, 0.0]).shape == (3, 2)
    states = Launch.state(np.ones((4, 1, 3)), np.zeros((5, 3)))
    assert states.shape == (4, 5)
    assert [np.shape(value) for value in states.values] == [(4, 1)] * 3 + [(5,)] * 3


def test_arrays_are_copies_and_read_only() -> None:
    outer = np.array([0.1, 0.2])
    launch = Launch.apsides(outer, 0.05)
    outer[0] = 5.0
    assert_array_equal(launch.values[0], [0.1, 0.2])
    position = np.array([[0.0, 0.0, 2.0]])
    state = Launch.state(position, position * 0)
    position[0, 2] = 5.0
    assert_array_equal(state.values[2], [2.0])
    for copied in (launch, state, copy.copy(launch), copy.deepcopy(launch),
                   pickle.loads(pickle.dumps(launch))):  # fmt: skip
        with pytest.raises(ValueError, match="read-only"):
            copied.values[0][0] = 5.0  # pyright: ignore[reportIndexIssue]


def test_frozen() -> None:
    launch = Launch.at_rest(1.0)
    with pytest.raises(FrozenInstanceError):
        launch.kind = "plane"  # pyright: ignore[reportAttributeAccessIssue]
    with pytest.raises(FrozenInstanceError):
        del launch.values  # pyright: ignore[reportAttributeAccessIssue]


SEVERAL = [
    Launch.ellipse(0.2, 0.1),
    Launch.apsides(0.2, 0.1),
    Launch.apsides(0.2, -0.1),
    Launch.apsides([0.2, 0.3], 0.1),
    Launch.apsides([[0.2, 0.3]], 0.1),
    Launch.plane(0.1, 0.2, 0.3, 0.4),
    Launch.angles(0.1, 0.2, 0.3, 0.4),
    Launch.state([0, 0, 2.0], [0, 0, 0]),
]


def test_equality_and_hash() -> None:
    for i, one in enumerate(SEVERAL):
        again = pickle.loads(pickle.dumps(one))
        assert again == one
        assert hash(again) == hash(one)
        assert copy.deepcopy(one) == one
        assert [other == one for other in SEVERAL] == [i == k for k in range(len(SEVERAL))]
    assert len({*SEVERAL, *SEVERAL}) == len(SEVERAL)
    assert Launch.at_rest(1.0) == Launch.at_rest(1)
    assert Launch.at_rest(1.0) != Launch.angles(1.0)
    assert Launch.at_rest(1.0) != 1.0


@pytest.mark.parametrize("azimuth", [0.0, np.zeros(2)], ids=["number", "array"])
def test_negative_zero_is_zero(azimuth: float) -> None:
    one, other = Launch.ellipse(0.2, 0.0, azimuth), Launch.ellipse(0.2, -0.0, azimuth * -1)
    assert one == other
    assert hash(one) == hash(other)


def test_representation_names_kind_and_values() -> None:
    assert repr(Launch.ellipse(0.1, 0.2)) == "Launch.ellipse(a=0.1 m, b=0.2 m, azimuth=0 rad)"


Maker = Callable[..., Launch]
MAKERS: list[tuple[Maker, list[str]]] = [
    (Launch.ellipse, ["a .* in m,", "b .* in m,", "azimuth .* in rad,"]),
    (Launch.apsides, ["a .* in m,", "b .* in m,", "azimuth .* in rad,"]),
    (Launch.plane, ["x .* in m,", "y .* in m,", "vx .* in m/s,", "vy .* in m/s,"]),
    (Launch.angles, ["theta .* in rad,", "phi .*", "theta_rate .* in rad/s,", "phi_rate .*"]),
    (Launch.at_rest, ["theta .* in rad,", "phi .* in rad,"]),
    (Launch.state, ["position .* in m,", "velocity .* in m/s,"]),
]


@pytest.mark.parametrize("value", ["1 cm", None, 1j, [[1.0], [1.0, 2.0]]], ids=repr)
@pytest.mark.parametrize(("maker", "names"), MAKERS, ids=[maker.__name__ for maker, _ in MAKERS])
def test_what_is_no_number(maker: Maker, names: list[str], value: object) -> None:
    for k, name in enumerate(names):
        good = [[0.0, 0.0, 1.0]] * len(names) if maker == Launch.state else [0.1] * len(names)
        arguments: list[object] = [*good[:k], value, *good[k + 1 :]]
        with pytest.raises(InvalidInput, match=f"^The launch's {name}.* leave units out here"):
            maker(*arguments)


@pytest.mark.parametrize(
    ("position", "velocity", "said"),
    [
        ([0, 0], [0, 0, 0], r"position must have three components \(x, y, z\) .* shape is \(2,\)"),
        ([0, 0, 1], [0, 0], r"velocity must have three components .* but its shape is \(2,\)"),
        (1.0, [0, 0, 0], r"position must have three components .* but its shape is \(\)"),
        (np.zeros((3, 4)), np.zeros(3), r"position must have three .* but its shape is \(3, 4\)"),
        (np.zeros((4, 3)), np.zeros((5, 3)), r"do not fit together: .*; give them shapes that br"),
    ],
)
def test_states_of_the_wrong_shape(position: object, velocity: object, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        Launch.state(position, velocity)  # pyright: ignore[reportArgumentType, reportCallIssue]


def test_shapes_that_do_not_fit() -> None:
    said = r"^The shapes of the launch's a, b, azimuth do not fit together: \(2,\), \(3,\), \(\); "
    with pytest.raises(InvalidInput, match=said):
        Launch.ellipse([0.1, 0.2], [0.1, 0.2, 0.3])


# Each with the condition, the value seen, and the way out.
REFUSED: list[tuple[Launch, str]] = [
    (Launch.ellipse(2.0, 0.0), "a = 2 m does not fit on the lower half of a sphere of radius 2 m; "
                               "use Launch.angles or Launch.state"),
    (Launch.ellipse(2.5, 0.0), "a = 2.5 m does not fit .*; use Launch.angles or Launch.state"),
    (Launch.ellipse(-0.5, 0.0), "a must not be negative, but it is -0.5 m; turn .* with azimuth"),
    (Launch.apsides(2.0, 0.0), "a must lie between 0 and the length 2 m, but it is 2 m; use "
                               "Launch.angles or Launch.state for motions that rise above"),
    (Launch.apsides(-0.5, 0.0), "a must lie between 0 and the length 2 m, but it is -0.5 m"),
    (Launch.apsides(0.5, 0.6), r"\|b\| = 0.6 m must not exceed the outer one, a = 0.5 m; exchange "
                               "them and turn the launch by 90° with azimuth"),
    (Launch.apsides(0.5, -0.6), r"\|b\| = 0.6 m must not exceed the outer one, a = 0.5 m"),
    (Launch.plane(1.2, 1.6, 0.0, 0.0), r"not on the lower half of the sphere: √\(x² \+ y²\) = 2 m, "
                                       "length = 2 m; use Launch.state or Launch.angles"),
    (Launch.plane(0.0, -7.0, 0.0, 0.0), r"√\(x² \+ y²\) = 7 m, length = 2 m"),
    (Launch.state([0, 0, 2.1], [0, 0, 0]), r"not on the sphere: \|r\| = 2.1 m, length = 2 m; use "
                                           r"Launch.plane\(x, y, vx, vy\) to let z follow"),
    (Launch.state([0, 0, 0], [0, 0, 0]), r"not on the sphere: \|r\| = 0 m, length = 2 m"),
    (Launch.state([0, 0, 2 + 1e-8], [0, 0, 0]), r"not on the sphere: \|r\| = 2.00000001 m"),
    (Launch.state([0, 0, 2], [1, 0, 0.5]), "would stretch the thread: its component along the "
                                           r"thread is 0.5 m/s of 1.118\d* m/s; take that .* away"),
    (Launch.state([2, 0, 0], [1e-8, 1, 0]), "component along the thread is 0.00000001 m/s of 1"),
]  # fmt: skip


@pytest.mark.parametrize(("launch", "said"), REFUSED, ids=[str(launch) for launch, _ in REFUSED])
def test_off_the_sphere(launch: Launch, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        ExactMotion(PENDULUM, launch)
    # In an ensemble the same sentence is the reason.
    arrays = [np.array([value]) for value in launch.values]
    ensemble = ExactMotion(PENDULUM, Launch(launch.kind, tuple(arrays)))
    with pytest.raises(InvalidInput) as raised:
        ExactMotion(PENDULUM, launch)
    assert ensemble.reason.tolist() == [str(raised.value)]
    assert np.isnan(ensemble.position(0.0)).all()


@pytest.mark.parametrize("value", [nan, inf, -inf])
@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("ellipse", ["a", "b", "azimuth"]),
        ("apsides", ["a", "b", "azimuth"]),
        ("plane", ["x", "y", "vx", "vy"]),
        ("angles", ["theta", "phi", "theta_rate", "phi_rate"]),
        ("state", ["x", "y", "z", "vx", "vy", "vz"]),
    ],
)
def test_not_finite(kind: str, names: list[str], value: float) -> None:
    seen = "NaN" if value != value else str(value)
    for k, name in enumerate(names):
        values = [0.0] * len(names)
        values[k] = value
        unit = {"v": "m/s", "theta": "rad", "phi": "rad", "azimuth": "rad"}.get(name, "m")
        unit = "rad/s" if name.endswith("rate") else "m/s" if name.startswith("v") else unit
        with pytest.raises(InvalidInput, match=f"{name} must be a finite number, .* {seen} {unit}"):
            ExactMotion(PENDULUM, Launch(kind, tuple(values)))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Launch.angles(45.0), r"theta must lie between −2π and 2π rad, but it is 45 rad; "
                                      r"write math.radians\(45\) if these are degrees"),
        (lambda: Launch.at_rest(-6.5), "theta must lie between −2π and 2π rad, but it is -6.5 rad"),
        (lambda: Launch.angles(0.1, 90.0), "launch's phi must lie between"),
        (lambda: Launch.ellipse(0.1, 0.0, 90.0), "launch's azimuth must lie between"),
        (lambda: Launch.apsides(0.1, 0.0, -30.0), "launch's azimuth must lie between"),
    ],
)  # fmt: skip
def test_angles_in_degrees(make: Maker, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        make()


def test_angles_in_degrees_of_an_ensemble() -> None:
    motion = ExactMotion(PENDULUM, Launch.at_rest([0.3, 30.0, 0.5]))
    assert list(motion.problems) == [1]
    assert "math.radians(30)" in motion.problems[1]
    assert np.isfinite(motion.position(1.0)[[0, 2]]).all()


@pytest.mark.parametrize(
    ("kind", "values", "said"),
    [
        (
            "circle",
            (0.1,),
            "kind must be one of 'ellipse', .*, but it is 'circle'; make it with La",
        ),
        (3, (0.1,), "kind must be one of .* but it is 3"),
        (np.array(["ellipse"]), (0.1,), "kind must be one of .* but it is array"),
        ("ellipse", (0.1, 0.2), r"takes 3 values \(a, b, azimuth\), but there are 2; make it with"),
        ("ellipse", [0.1, 0.2, 0.3], r"takes 3 values .*, but there are \[0.1, 0.2, 0.3\]"),
        ("ellipse", 0.1, "takes 3 values .*, but there are 0.1"),
        ("ellipse", (0.1, "b", 0.0), "The launch's b must be a number .* but it is 'b'"),
        ("at_rest", (0.1, 0.2, 0.3), "takes 2 values"),
    ],
)
def test_launches_made_by_hand(kind: object, values: object, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        Launch(kind, values)  # pyright: ignore[reportArgumentType]


def test_rounding_of_a_state_is_projected_away() -> None:
    # The state below is exactly on the sphere and tangent to it; it is given with a radial part.
    position, velocity = np.array([1.2, 0.0, 1.6]), np.array([0.8, 0.7, -0.6])
    given = Launch.state(position * (1 + 5e-10), velocity + 4e-10 * position)
    motion = ExactMotion(PENDULUM, given)
    assert motion.position(0.0) == pytest.approx(position, abs=5e-15)
    assert motion.velocity(0.0) == pytest.approx(velocity, abs=5e-15)


def test_limits_that_are_allowed() -> None:
    for launch in (
        Launch.ellipse(np.nextafter(2.0, 0), 3.0),
        Launch.apsides(np.nextafter(2.0, 0), 1.0),
        Launch.apsides(0.5, -0.5),
        Launch.ellipse(0.1, 1e3),
        Launch.plane(0.0, np.nextafter(-2.0, 0), 0.0, 0.0),
        Launch.angles(-2 * np.pi, 2 * np.pi, -30.0, 1e5),
    ):
        assert np.isfinite(ExactMotion(PENDULUM, launch).position([0.0, 1.0])).all()
