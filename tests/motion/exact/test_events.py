"""Events of the closed form, against those of the full equations, which are found step by step."""

from __future__ import annotations

from math import acos, inf, pi

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.motion import EventKind

UNIT = kp.Pendulum(1.0, 1.0)

LAUNCHES = {
    "ellipse": kp.Launch.apsides(0.5, 0.2, 0.3),
    "clockwise": kp.Launch.plane(0.3, -0.2, -0.5, -0.4),
    "narrow": kp.Launch.apsides(0.6, 0.01, 1.0),
    "above": kp.Launch.angles(1.9, 0.3, 0.1, 1.0),
    "over the top": kp.Launch.plane(0.1, 0.0, 0.0, 2.3),
    "near the separatrix": kp.Launch.angles(2.9, 0.3, 0.0, 0.05),
    "fast spin": kp.Launch.angles(1.5, 0.3, 0.2, 8.0),
}
PLANES = {
    "libration": kp.Launch.at_rest(1.1, 0.7),
    "libration from above": kp.Launch.at_rest(2.5, 0.7),
    "rotation": kp.Launch.plane(0.0, 0.0, 2.2, 0.4),
}
KINDS: list[tuple[EventKind, float | None]] = [
    ("outer", None),
    ("inner", None),
    ("bottom", None),
    ("azimuth", 0.9),
    ("azimuth", -2.0),
    ("radius", 0.35),
    ("radius", 0.9),
    ("slack", None),
    ("taut", None),
]


@pytest.mark.parametrize(("kind", "value"), KINDS)
@pytest.mark.parametrize("name", LAUNCHES)
def test_the_full_equations_see_the_same(name: str, kind: EventKind, value: float | None) -> None:
    start, stop = 0.05, 20.05
    exact = kp.ExactMotion(UNIT, LAUNCHES[name])
    rod = kp.RealMotion(UNIT, LAUNCHES[name], thread="rod")
    seen = exact.events(kind, start, stop, value)
    expected = rod.events(kind, start, stop, value)
    if kind == "taut":  # a rod is never straightened
        slack = exact.events("slack", start, stop)
        assert abs(len(seen) - len(slack)) <= 1
        np.testing.assert_allclose(exact.tension(seen), 0.0, atol=1e-13)
        return
    assert len(seen) == len(expected)
    # Near the separatrix the integration's own error grows like e^t.
    np.testing.assert_allclose(seen, expected, atol=1e-7 if "separatrix" in name else 1e-10)


@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("kind", ["outer", "inner", "bottom", "radius"])
def test_in_a_vertical_plane(name: str, kind: EventKind) -> None:
    value = 0.4 if kind == "radius" else None
    motion = kp.ExactMotion(UNIT, PLANES[name])
    times = motion.events(kind, 0.0, 15.0, value)
    rod = kp.RealMotion(UNIT, PLANES[name], thread="rod")
    expected = rod.events(kind, 0.05, 15.0, value)
    np.testing.assert_allclose(times[times > 0.05], expected, atol=1e-9)
    assert motion.events("azimuth", 0.0, 15.0, 0.7).size == 0


def test_turning_points_have_the_bits_of_the_phase() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(0.3, 0.1))
    times = motion.events("outer", 0.0, 1000.0)
    assert times[0] == 0.0
    expected = motion.radial_period * np.arange(len(times))
    np.testing.assert_allclose(times, expected, rtol=4e-16)
    late = motion.events("inner", 1e12, 1e12 + 20)
    ratio = late / motion.radial_period
    np.testing.assert_allclose(ratio - np.floor(ratio), 0.5, atol=2e-3)
    assert len(late) in (6, 7)


def test_times_before_the_launch() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(0.3, 0.1))
    before = motion.events("outer", -20.0, 0.0)
    after = motion.events("outer", 0.0, 20.0)
    np.testing.assert_allclose(before[::-1], -after, atol=1e-14)
    mirrored = -motion.events("azimuth", -20.0, -0.1, -1.2)[::-1]
    np.testing.assert_allclose(mirrored, motion.events("azimuth", 0.1, 20.0, 1.2), atol=1e-12)


def test_a_wobble_about_a_cone_is_the_limit() -> None:
    cone = kp.ExactMotion(UNIT, kp.Launch.apsides(0.5, 0.5))
    near = kp.ExactMotion(UNIT, kp.Launch.apsides(0.5, 0.4999999))
    seen, expected = (motion.events("inner", 0.0, 20.0) for motion in (cone, near))
    assert len(seen) > 4
    np.testing.assert_allclose(np.diff(seen), np.diff(expected)[: len(seen) - 1], rtol=1e-6)


def test_the_separatrix_is_passed_once() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.plane(0.0, 0.0, -2.0, 0.0))  # towards −x
    assert motion.frequency == 0
    assert motion.events("bottom", -30.0, 30.0).tolist() == [0.0]
    outer = motion.events("outer", -30.0, 30.0)
    np.testing.assert_allclose(motion.position(outer)[:, 2], 0.0, atol=1e-15)
    assert len(outer) == 2
    np.testing.assert_allclose(
        np.abs(motion.position(motion.events("radius", -30.0, 30.0, 0.5))[:, 0]), 0.5, rtol=1e-13
    )
    slack = motion.next_event("slack")
    assert motion.position(slack)[2] == pytest.approx(-2 / 3, rel=1e-13)


@pytest.mark.parametrize("launch", [kp.Launch.at_rest(0.0), kp.Launch.at_rest(0.0, 0.3)])
@pytest.mark.parametrize("kind", ["outer", "inner", "bottom", "slack"])
def test_nothing_happens_at_rest(launch: kp.Launch, kind: EventKind) -> None:
    assert kp.ExactMotion(UNIT, launch).events(kind, 0.0, 1e6).size == 0


def test_a_radius_that_is_never_reached_or_just_touched() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(0.5, 0.2))
    assert motion.events("radius", 0.0, 100.0, 0.6).size == 0
    assert motion.events("radius", 0.0, 100.0, 0.1).size == 0
    inside = motion.events("radius", 0.0, 100.0, 0.5 - 1e-12)
    assert len(inside) == pytest.approx(2 * 100 / float(motion.radial_period), abs=2)


def test_slack_is_where_a_thread_goes_slack() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.at_rest(acos(-0.3)))
    times = motion.events("slack", 0.0, 20.0)
    assert motion.slack_time in (0.0, pytest.approx(times[0], rel=1e-14))
    np.testing.assert_allclose(motion.tension(times), 0.0, atol=1e-14)
    assert (motion.tension(times + 1e-3) < 0).all()
    taut = motion.events("taut", 0.0, 20.0)
    assert (motion.tension(taut + 1e-3) > 0).all()


def test_a_long_search_is_cut_at_the_first() -> None:
    motion = kp.ExactMotion(UNIT, kp.Launch.apsides(0.3, 0.1))
    assert motion.next_event("outer", after=1e9, within=1e12) < 1e9 + 2 * pi
    assert motion.next_event("azimuth", after=0.0, within=1e15, value=0.3) < inf
