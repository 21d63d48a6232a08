"""What planes do and come to, by name: shapes, what the numbers are of, and what is refused."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(10.0, 9.81)
SITE = kp.Site(0.9)
CLAMPS = kp.Suspension(np.array([[0.0, 3e-5, 6e-4]]), 0.9)
HOUR = 3600.0


def averaged(a: Any = 0.4, **acting: Any) -> kp.EnvelopeMotion:
    return kp.EnvelopeMotion(PENDULUM, kp.Launch.ellipse(a, 0.01, 0.3), site=SITE, **acting)


def real(a: Any = 0.4, **acting: Any) -> kp.RealMotion:
    return kp.RealMotion(PENDULUM, kp.Launch.ellipse(a, 0.01, 0.3), site=SITE, **acting)


def test_each_number_has_the_shape_of_the_motion() -> None:
    sizes = np.array([[0.3], [0.4]])
    for shape, mean, full in (
        ((), averaged(), real()),
        ((2, 3), averaged(sizes, suspension=CLAMPS), real(sizes, suspension=CLAMPS)),
    ):
        told = (mean.settled(), mean.clamp_orbits(), mean.course(HOUR), mean.pace(0.0, HOUR))
        for numbers in told:
            assert {np.shape(one) for one in numbers} == {shape}
        found = full.course([0.0, 60.0])
        assert {np.shape(one) for one in found[:5]} == {shape}
        assert {np.shape(one) for one in found[5:]} == {(*shape, 2)}


def test_what_a_plane_has_settled_to_is_read_off_its_motion() -> None:
    drag = kp.Drag(np.array([0.0, 1e-5]))
    found = averaged(suspension=kp.Suspension(2e-5, 0.9), drag=drag).settled()
    motions = averaged(suspension=kp.Suspension(2e-5, 0.9), drag=drag)
    np.testing.assert_array_equal(found.dies, [0.0, 1.0])
    np.testing.assert_array_equal(found.since, 0.0)
    turn = 2 * math.pi / abs(float(SITE.vertical_rotation))
    for k, one in enumerate(motions):
        start, end = one.azimuth(np.array([0.0, found.until[k]]))
        assert found.turned[k] == pytest.approx(end - start, rel=1e-12)
        a, _ = one.semi_axes(found.until[k])
        assert found.a[k] == pytest.approx(a, rel=1e-12)
        last = np.linspace(0.0 if found.dies[k] else found.until[k] - turn, found.until[k], 4001)
        azimuths, widths = one.azimuth(last), np.abs(one.semi_axes(last)[:, 1])
        assert found.low[k] == pytest.approx(azimuths.min(), abs=0.02)
        assert found.high[k] == pytest.approx(azimuths.max(), abs=0.02)
        assert found.largest_b[k] == pytest.approx(widths.max(), rel=0.01)
    # A tenth of the amplitude is left then.
    assert found.until[1] == pytest.approx(math.log(10) / 1e-5, rel=1e-9)


def test_a_driven_plane_is_looked_at_once_it_has_settled() -> None:
    drag = kp.Drag(1e-4)
    drive = kp.Drive(1e-4 * math.pi * 0.4, phase=0.0)
    found = averaged(drag=drag, drive=drive).settled()
    assert found.since == pytest.approx(15.0 / 1e-4, rel=0.01)
    assert (found.verdict, found.dies) == (0.0, 0.0)


def test_a_real_course_is_that_of_its_ellipses() -> None:
    motion = real(suspension=kp.Suspension(3e-5, 0.9))
    times = np.array([0.5, 1.0, 2.0]) * HOUR
    found = motion.course(times)
    a, b, azimuth = kp.ellipse(motion, times)
    np.testing.assert_allclose(found.a, a, rtol=1e-4)
    np.testing.assert_allclose(found.b, b, atol=1e-4)
    turned = (found.azimuth - azimuth + math.pi / 2) % math.pi - math.pi / 2
    np.testing.assert_allclose(turned, 0.0, atol=1e-3)
    assert found.least_tension < 9.81 < found.largest_tension
    # The last time is a little after the last turning point.
    assert found.largest_b == pytest.approx(np.abs(found.b).max(), rel=1e-3)
    assert (found.quarter_turn, found.stands_since) == (math.inf, math.inf)


MEAN, FULL = averaged(), real()
REFUSED: dict[str, tuple[Any, str]] = {
    "before the launch": (lambda: MEAN.course(-1.0), "The end must lie between 0 and 1e+100 s af"),
    "never": (lambda: MEAN.course(math.inf), "after the launch, but it is inf s."),
    "no number": (lambda: MEAN.course(math.nan), "after the launch, but it is nan s."),
    "words": (lambda: MEAN.pace(0.0, "1 h"), "The stop must be a number"),  # pyright: ignore[reportArgumentType]
    "backwards": (lambda: MEAN.pace(2.0, 1.0), "later than the stop, but they are 2.0 s and 1.0"),
    "one time": (lambda: FULL.course(5.0), "must ascend on one axis, the first of them at 0 s"),
    "no times": (lambda: FULL.course([]), "must ascend on one axis"),
    "falling times": (lambda: FULL.course([2.0, 1.0]), "must ascend on one axis"),
    "an early time": (lambda: FULL.course([-1.0, 1.0]), "must ascend on one axis"),
    "an endless time": (lambda: FULL.course([0.0, math.inf]), "Times must be finite"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name: str) -> None:
    call, said = REFUSED[name]
    with pytest.raises(kp.InvalidInput) as raised:
        call()
    assert said in str(raised.value)


@pytest.mark.parametrize("shape", [(), (0,), (2, 3)])
def test_every_number_has_the_shape_of_the_motions(shape: tuple[int, ...]) -> None:
    launch = kp.Launch.ellipse(np.full(shape, 1.0), 0.0)
    plane = kp.EnvelopeMotion(kp.Pendulum(67.0), launch, site=kp.Site(0.85))
    told = (plane.settled(), plane.clamp_orbits(), plane.course(9.0), plane.pace(0.0, 9.0))
    assert {np.shape(number) for numbers in told for number in numbers} == {shape}
    course = kp.RealMotion(kp.Pendulum(67.0), launch).course([0.0, 50.0])
    assert {np.shape(number) for number in course[:5]} == {shape}
    assert {np.shape(number) for number in course[5:]} == {(*shape, 2)}


def test_a_bad_motion_beside_good_ones_is_not_followed() -> None:
    pendulum = kp.Pendulum(np.array([1.0, 0.0, np.inf, 2.0]), np.array([9.81, 9.81, 9.81, -1.0]))
    motions = kp.RealMotion(pendulum, kp.Launch.ellipse(0.1, 0.0))
    assert (motions.status != 0).tolist() == [False, True, True, True]
    for number in motions.course([0.0, 50.0]):
        unknown = np.isnan(number).reshape(4, -1).any(axis=1)
        assert unknown.tolist() == [False, True, True, True]
