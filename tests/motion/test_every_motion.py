"""One suite for all eight motions: the interface, and each against every other where both hold."""

from __future__ import annotations

import copy
import itertools
import pickle
from collections.abc import Callable
from math import inf, pi

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.motion import EventKind

PENDULUM = kp.Pendulum(1.3, 9.81, 2.0)
LAUNCH = kp.Launch.apsides(0.1, 0.04, 1.0)
CLOCKWISE = kp.Launch.plane(0.05, 0.02, 0.1, -0.2)

Make = Callable[[kp.Pendulum, kp.Launch], kp.Motion]

MAKERS: dict[str, Make] = {
    "ExactMotion": kp.ExactMotion,
    "LinearMotion": kp.LinearMotion,
    "OlssonMotion": kp.OlssonMotion,
    "SeriesMotion": lambda p, launch: kp.SeriesMotion(p, launch, order=8),
    "CubicMotion": kp.CubicMotion,
    "PlaneMotion": kp.PlaneMotion,
    "RealMotion": lambda p, launch: kp.RealMotion(p, launch, drag=kp.Drag(0.0), thread="rod"),
    "EnvelopeMotion": lambda p, launch: kp.EnvelopeMotion(p, launch, drag=kp.Drag(0.0)),
}
FORCED = ("RealMotion", "EnvelopeMotion")
RATES = ("frequency", "precession", "period")

# How far each is from the exact one within 12 s, in m: measured, rounded up.
APART = {
    "ExactMotion": 0.0,
    "LinearMotion": 2e-2,
    "OlssonMotion": 5e-4,
    "SeriesMotion": 1e-9,
    "CubicMotion": 2e-4,
    "PlaneMotion": 1e-13,
    "RealMotion": 1e-13,
    "EnvelopeMotion": 1e-13,
}
TIMES = np.linspace(0.0, 12.0, 121)
every = pytest.mark.parametrize("name", MAKERS)


def made(name: str, launch: kp.Launch = LAUNCH, pendulum: kp.Pendulum = PENDULUM) -> kp.Motion:
    return MAKERS[name](pendulum, launch)


def ensemble(name: str) -> kp.Motion:
    lengths = np.array([[1.0], [1.5], [2.0]])
    return made(name, kp.Launch.apsides([0.05, 0.1], -0.02), kp.Pendulum(lengths, 9.8))


@every
def test_is_a_motion_of_its_name(name: str) -> None:
    motion = made(name)
    assert isinstance(motion, kp.Motion)
    assert type(motion).__name__ == name
    assert (motion.pendulum, motion.launch, motion.shape) == (PENDULUM, LAUNCH, ())
    assert motion.span[0] <= 0.0 < motion.span[1]
    assert motion.trust.endswith(".")
    assert motion.reason == ""


def test_all_eight_are_swept() -> None:
    classes = {
        name
        for name in kp.__all__
        if isinstance(value := getattr(kp, name), type) and issubclass(value, kp.Motion)
    }
    assert classes == {"Motion", *MAKERS}


def test_a_motion_as_such_cannot_be_made() -> None:
    with pytest.raises(TypeError, match="abstract"):
        kp.Motion()  # pyright: ignore[reportAbstractUsage]


@every
def test_velocity_is_the_rate_of_position(name: str) -> None:
    motion, h, times = made(name, CLOCKWISE), 1e-3, TIMES[1:]
    x = [motion.position(times + k * h) for k in (-2, -1, 1, 2)]
    rate = (x[0] - 8 * x[1] + 8 * x[2] - x[3]) / (12 * h)  # error h⁴ x⁽⁵⁾/30, about 1e-11
    np.testing.assert_allclose(motion.velocity(times), rate, atol=1e-10)


@every
def test_stays_on_the_sphere(name: str) -> None:
    np.testing.assert_allclose(np.linalg.norm(made(name).position(TIMES), axis=-1), 1.3, rtol=1e-15)


@every
def test_a_grid_is_its_times(name: str) -> None:
    motion = made(name)
    times = 1.0 + 0.25 * np.arange(200)  # exact sums
    np.testing.assert_allclose(motion.sample(1.0, 0.25, 200), motion.position(times), atol=2e-15)


@every
@pytest.mark.parametrize("launch", [LAUNCH, CLOCKWISE])
def test_tension_is_the_pull_on_its_own_path(name: str, launch: kp.Launch) -> None:
    """Olsson's (5a), written out once more."""
    motion = made(name, launch)
    z, v = motion.position(TIMES)[:, 2], motion.velocity(TIMES)
    pull = 2.0 * (9.81 * z + np.square(v).sum(axis=-1)) / 1.3
    # That of (13) is its own m·g·Λ, to third order.
    close = 1e-4 if name == "CubicMotion" else 1e-12
    np.testing.assert_allclose(motion.tension(TIMES), pull, rtol=close)


@pytest.mark.parametrize(("first", "second"), [*itertools.combinations(MAKERS, 2)])
@pytest.mark.parametrize("launch", [LAUNCH, CLOCKWISE], ids=["apsides", "clockwise"])
def test_each_against_every_other(first: str, second: str, launch: kp.Launch) -> None:
    apart = made(first, launch).position(TIMES) - made(second, launch).position(TIMES)
    limit = max(APART[first], APART[second])
    assert np.linalg.norm(apart, axis=-1).max() <= limit
    # A limit that any two motions would keep says nothing.
    if limit > 1e-5:
        assert np.linalg.norm(apart, axis=-1).max() > 1e-3 * limit


# Frequency, precession, period.


@pytest.mark.parametrize("name", [name for name in MAKERS if name not in FORCED])
def test_rates_are_floats_near_the_exact_ones(name: str) -> None:
    motion, exact = made(name), made("ExactMotion")
    for rate in RATES:
        assert type(getattr(motion, rate)) is float
    assert motion.period == pytest.approx(2 * pi / float(motion.frequency), rel=1e-15)
    near = {"LinearMotion": 1e-2, "OlssonMotion": 1e-5, "CubicMotion": 1e-4}.get(name, 1e-10)
    assert motion.frequency == pytest.approx(exact.frequency, rel=near)
    if name != "LinearMotion":
        near = {"OlssonMotion": 3e-3, "CubicMotion": 2e-2}.get(name, 1e-9)
        assert motion.precession == pytest.approx(exact.precession, rel=near)


@pytest.mark.parametrize("name", FORCED)
@pytest.mark.parametrize("rate", RATES)
def test_a_motion_under_forces_has_no_rate_that_stays(name: str, rate: str) -> None:
    motion = made(name)
    assert not hasattr(motion, rate)
    with pytest.raises(AttributeError, match=r"forces change it under way\. Ask for"):
        getattr(motion, rate)


@every
def test_scalars_of_an_ensemble_are_read_only_arrays(name: str) -> None:
    if name in FORCED:
        return
    motion = ensemble(name)
    for rate in RATES:
        values = getattr(motion, rate)
        assert values.shape == (3, 2)
        before = values.copy()
        with pytest.raises(ValueError, match="read-only"):
            values *= 2
        np.testing.assert_array_equal(getattr(motion, rate), before)


# Events.


def near(name: str) -> float:
    """How far an event may be from the exact one's within 12 s, s."""
    return {"LinearMotion": 0.05, "OlssonMotion": 1e-2, "CubicMotion": 1e-2}.get(name, 1e-8)


@every
@pytest.mark.parametrize("kind", ["outer", "inner", "bottom"])
def test_turning_points_of_every_motion(name: str, kind: EventKind) -> None:
    motion, exact = made(name, CLOCKWISE), made("ExactMotion", CLOCKWISE)
    times = motion.events(kind, 0.0, 12.0)
    period = float(exact.radial_period)  # pyright: ignore[reportAttributeAccessIssue]
    first = float(exact.apsis_time)  # pyright: ignore[reportAttributeAccessIssue]
    if kind != "outer":
        first = (first + period / 2) % period
    expected = first + period * np.arange(len(times))
    assert len(times) == int((12.0 - first) / period) + 1
    np.testing.assert_allclose(times, expected, atol=near(name))
    x, v = motion.position(times)[:, :2], motion.velocity(times)[:, :2]
    outward = np.sum(x * v, axis=-1)
    # What passes through zero, at the motion's own error over its rate of change.
    np.testing.assert_allclose(outward, 0.0, atol=1e-12 if name != "EnvelopeMotion" else 1e-10)


@every
def test_azimuth_and_radius_are_where_they_are_asked_for(name: str) -> None:
    motion = made(name)
    times = motion.events("azimuth", 0.0, 12.0, 2.5)
    x, y, _ = motion.position(times).T
    np.testing.assert_allclose(np.arctan2(y, x), 2.5, rtol=1e-12)
    swings = 12.0 / float(made("ExactMotion").period)
    assert len(times) == pytest.approx(swings, abs=1)
    times = motion.events("radius", 0.0, 12.0, 0.07)
    np.testing.assert_allclose(np.hypot(*motion.position(times).T[:2]), 0.07, rtol=1e-12)
    assert len(times) == pytest.approx(4 * swings, abs=2)
    assert (np.diff(times) > 0).all()
    for radius in (0.2, 0.01):
        assert motion.events("radius", 0.0, 12.0, radius).size == 0


@every
def test_the_next_event_is_the_first_of_them(name: str) -> None:
    motion = made(name)
    times = motion.events("inner", 0.0, 12.0)
    assert motion.next_event("inner") == pytest.approx(times[0], rel=1e-14)
    assert motion.next_event("inner", after=float(times[0])) == pytest.approx(times[1], rel=1e-13)
    with pytest.raises(kp.EventNotFound, match=r'"radius" does not come within 5 s after 0 s'):
        motion.next_event("radius", within=5.0, value=0.5)
    with pytest.raises(kp.EventNotFound, match=r"does not come"):
        motion.next_event("slack", within=5.0)


@every
@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("sideways", 0.0, 1.0), r"must be one of 'outer', 'inner', 'bottom', .* 'sideways'"),
        ((np.array(["outer"]), 0.0, 1.0), "must be one of"),
        (("azimuth", 0.0, 1.0), "needs a value, the azimuth in rad"),
        (("radius", 0.0, 1.0), "needs a value, the radius in m"),
        (("outer", 0.0, 1.0, 0.3), "does not take a value"),
        (("azimuth", 0.0, 1.0, np.nan), "The azimuth must be finite, but it is nan rad"),
        (("azimuth", 0.0, 1.0, [0.1, 0.2]), "The azimuth must be one number"),
        (("outer", 2.0, 1.0), r"start ≤ stop, but from 2.0 s to 1.0 s"),
        (("outer", 0.0, inf), "but from 0.0 s to inf s"),
        (("outer", np.nan, 1.0), "but from nan s"),
    ],
)
def test_events_that_make_no_sense(name: str, arguments: tuple[object, ...], sentence: str) -> None:
    with pytest.raises(kp.InvalidInput, match=sentence):
        made(name).events(*arguments)  # pyright: ignore[reportArgumentType]


@every
def test_events_are_those_of_a_single_motion(name: str) -> None:
    with pytest.raises(kp.InvalidInput, match=r"ensemble of shape \(3, 2\)"):
        ensemble(name).events("outer", 0.0, 1.0)
    assert ensemble(name)[1, 1].events("outer", 0.0, 3.0).size > 1


# Ensembles.


@every
def test_an_index_is_the_motion_of_that_case(name: str) -> None:
    motion = ensemble(name)
    one = motion[2, 1]
    assert type(one) is type(motion)
    assert one.shape == ()
    assert one == made(name, kp.Launch.apsides(0.1, -0.02), kp.Pendulum(2.0, 9.8))
    np.testing.assert_array_equal(motion.position(TIMES)[2, 1], one.position(TIMES))
    assert motion[1:, 0].shape == (2,)
    assert motion[-1].shape == (2,)
    np.testing.assert_array_equal(motion[::2].velocity(1.0), motion.velocity(1.0)[::2])
    mask = np.array([[True, False], [False, True], [False, False]])
    np.testing.assert_array_equal(motion[mask].position(0.7), motion.position(0.7)[mask])


@every
def test_length_and_iteration_go_along_the_first_axis(name: str) -> None:
    motion = ensemble(name)
    assert len(motion) == 3
    rows = list(motion)
    assert [row.shape for row in rows] == [(2,)] * 3
    np.testing.assert_array_equal(
        np.stack([row.position(1.0) for row in rows]), motion.position(1.0)
    )
    single = made(name)
    assert bool(single)
    with pytest.raises(TypeError, match="a single motion has no length"):
        len(single)
    with pytest.raises(TypeError, match="a single motion has no length"):
        list(single)
    with pytest.raises(IndexError, match="a single motion cannot be indexed"):
        _ = single[0]
    with pytest.raises(IndexError):
        _ = motion[3]


@every
def test_a_bad_case_stops_nothing_and_says_why(name: str) -> None:
    motion = made(name, kp.Launch.angles([0.1, 0.2], 0.0, 0.0, [0.5, np.nan]))
    assert motion.reason[0] == ""
    assert "finite" in str(motion.reason[1])
    position = motion.position(1.0)
    assert np.isfinite(position[0]).all()
    assert np.isnan(position[1]).all()
    with pytest.raises(kp.InvalidInput, match="finite"):
        _ = motion[1]


@every
def test_problems_are_those_of_the_bad_cases_only(name: str) -> None:
    motion = made(name, kp.Launch.angles([[0.1, np.inf], [0.2, 0.3]], 0.0, 0.0, 0.5))
    assert motion.status.shape == motion.reason.shape == (2, 2)
    assert (motion.status == 0).tolist() == [[True, False], [True, True]]
    assert list(motion.problems) == [(0, 1)]
    assert motion.problems[0, 1] == motion.reason[0, 1]
    assert motion[1].status.tolist() == [0, 0]
    good = made(name)
    assert (good.status.shape, int(good.status), len(good.problems)) == ((), 0, 0)
    again = pickle.loads(pickle.dumps(motion))
    assert again == motion
    np.testing.assert_array_equal(again.status, motion.status)


@every
@pytest.mark.parametrize("make", [made, ensemble])
def test_no_attribute_can_be_changed_in_place(name: str, make: Callable[[str], kp.Motion]) -> None:
    motion = make(name)
    seen = 0
    for attribute in dir(type(motion)):
        if attribute.startswith("_") or (attribute in RATES and name in FORCED):
            continue
        value = getattr(motion, attribute)
        if isinstance(value, np.ndarray):
            seen += 1
            assert not value.flags.writeable, attribute
    assert seen > 0


@every
def test_what_was_given_is_a_copy(name: str) -> None:
    lengths = np.array([1.0, 1.5])
    motion = made(name, pendulum=kp.Pendulum(lengths, 9.8))
    before = hash(motion), motion.position(1.0)
    lengths *= 2
    np.testing.assert_array_equal(motion.position(1.0), before[1])
    assert hash(motion) == before[0]


@every
def test_a_data_set_has_the_motion_in_it(name: str) -> None:
    motion = ensemble(name)
    data = motion.to_xarray(TIMES)
    assert data["position"].dims == ("case_0", "case_1", "time", "component")
    np.testing.assert_array_equal(data["velocity"], motion.velocity(TIMES))
    np.testing.assert_array_equal(data["tension"], motion.tension(TIMES))
    assert data.attrs["title"] == f"{name} of a spherical pendulum"


# What a motion is, as an object.


@every
def test_equal_by_value(name: str) -> None:
    first, second = made(name), made(name)
    assert first == second
    assert hash(first) == hash(second)
    assert len({first, second}) == 1
    assert first != made(name, CLOCKWISE)
    assert first != made(name, LAUNCH, kp.Pendulum(1.4, 9.81, 2.0))
    assert first != PENDULUM
    assert ensemble(name) == ensemble(name)
    for other in MAKERS:
        assert (made(other) == first) is (other == name)


def test_what_else_was_given_counts_too() -> None:
    assert kp.SeriesMotion(PENDULUM, LAUNCH, 6) != kp.SeriesMotion(PENDULUM, LAUNCH, 8)
    assert kp.RealMotion(PENDULUM, LAUNCH) != kp.RealMotion(PENDULUM, LAUNCH, thread="rod")
    assert kp.RealMotion(PENDULUM, LAUNCH) != kp.RealMotion(PENDULUM, LAUNCH, drag=kp.Drag(1e-4))
    assert kp.EnvelopeMotion(PENDULUM, LAUNCH) != kp.EnvelopeMotion(PENDULUM, LAUNCH, exact=False)


@every
@pytest.mark.parametrize("make", [made, ensemble])
def test_a_copy_is_the_same_motion(name: str, make: Callable[[str], kp.Motion]) -> None:
    motion = make(name)
    for again in (pickle.loads(pickle.dumps(motion)), copy.copy(motion), copy.deepcopy(motion)):
        assert again == motion
        assert repr(again) == repr(motion)
        np.testing.assert_array_equal(again.position(1.5), motion.position(1.5))


@every
def test_shows_what_was_given_in_one_short_line(name: str) -> None:
    text = repr(made(name))
    assert text.startswith(f"{name}(")
    for number in ("1.3", "9.81", "0.1", "0.04"):
        assert number in text
    large = made(name, kp.Launch.apsides(np.linspace(0.01, 0.1, 1000), 0.0))
    for shown in (text, repr(ensemble(name)), repr(large)):
        assert len(shown) <= 200
        assert "0x" not in shown
        assert "\n" not in shown


@every
@pytest.mark.parametrize("attribute", ["pendulum", "launch", "shape", "span", "trust", "reason"])
def test_nothing_can_be_set(name: str, attribute: str) -> None:
    motion = made(name)
    with pytest.raises(AttributeError, match=rf"{attribute} of a motion cannot be set; make anoth"):
        setattr(motion, attribute, None)
    with pytest.raises(AttributeError, match="anything of a motion cannot be set"):
        motion.anything = 1  # pyright: ignore[reportAttributeAccessIssue]


@every
def test_the_ellipse_of_the_launch(name: str) -> None:
    found = kp.ellipse(made(name), 0.0)
    # To the part by which the motion's own velocity is not that of its launch.
    close = {"LinearMotion": 1e-2, "OlssonMotion": 1e-2}.get(name, 1e-5)
    assert found.a == pytest.approx(0.1, rel=close)
    assert found.b == pytest.approx(0.04, rel=close)
    assert found.azimuth == pytest.approx(1.0, abs=close)


def test_semi_axes_of_the_averaged_motion_are_its_ellipse() -> None:
    motion = kp.EnvelopeMotion(PENDULUM, LAUNCH)
    a, b = np.moveaxis(motion.semi_axes(TIMES), -1, 0)
    found = kp.ellipse(motion, TIMES)
    np.testing.assert_allclose(found.a, a, rtol=1e-12)
    np.testing.assert_allclose(found.b, b, rtol=1e-12)
    np.testing.assert_allclose(found.azimuth, motion.azimuth(TIMES), atol=1e-11)
