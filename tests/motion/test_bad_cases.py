"""One bad case in anything that is given is NaN, has a status and a reason, and stops nothing."""

import math
import tracemalloc
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.errors import problem_kinds

TIMES = np.array([0.0, 1.0, 7.0])
LAUNCH = kp.Launch.ellipse(1.0, 0.02)
HALL = kp.Pendulum(20.0, 9.81)
DRAG = kp.Drag(1e-3)

# Of three cases the second is bad in what is named: (pendulum, launch, forces), kind, sentence.
Given = tuple[kp.Pendulum, kp.Launch, kp.Forces]
BAD: dict[str, tuple[Given, str, str]] = {
    "pendulum": (
        (kp.Pendulum([20.0, -1.0, 21.0]), LAUNCH, kp.Forces()),
        "not_positive", "length must be positive and finite, but it is -1 m",
    ),
    "launch": (
        (HALL, kp.Launch.ellipse([1.0, 20.0, 2.0], 0.02), kp.Forces()),
        "ellipse_too_wide", "a = 20 m does not fit on the lower half of a sphere of radius 20 m",
    ),
    "site": (
        (HALL, LAUNCH, kp.Forces(site=kp.Site([0.5, 48.0, 0.6]))),
        "latitude", r"latitude must lie .* is 48 rad; write math.radians\(48\)",
    ),
    "site's gravity": (
        (HALL, LAUNCH, kp.Forces(site=kp.Site(0.5, [9.81, 9.7, 9.81]))),
        "two_gravities", "site's gravity is 9.7 m/s² and the pendulum's 9.81 m/s²; say it once",
    ),
    "drag": (
        (HALL, LAUNCH, kp.Forces(drag=kp.Drag([1e-3, -1e-3, 0.0]))),
        "negative", "linear drag must be finite and not negative, but it is -0.001 1/s",
    ),
    "suspension": (
        (HALL, LAUNCH, kp.Forces(suspension=kp.Suspension([1e-6, math.inf, 0.0]))),
        "not_finite", "suspension's anisotropy must be finite, but it is inf rad/s",
    ),
    "bob": (
        (HALL, LAUNCH, kp.Forces(bob=kp.Bob(0.1, [8e3, 1.0, 7e3]))),
        "lighter_than_air", "bob's density must exceed that of the air, but it is 1 kg/m³",
    ),
    "bob on a short thread": (
        (kp.Pendulum([20.0, 0.05, 20.0]), kp.Launch.ellipse(0.01, 0.0),
         kp.Forces(bob=kp.Bob(0.1, 8e3))),
        "bob_too_large", "bob's radius must be less than the length of the pendulum, .* 0.1 m",
    ),
    "drive's phase": (
        (HALL, LAUNCH, kp.Forces(drive=kp.Drive(1e-4, phase=[0.0, 4.0, 0.1]), drag=DRAG)),
        "drive_phase", "phase must lie between 0 and π, but it is 4 rad",
    ),
    "drive's radius": (
        (HALL, LAUNCH, kp.Forces(drive=kp.Drive(1e-4, radius=[0.1, -0.1, 0.2]), drag=DRAG)),
        "not_positive", "drive's radius must be positive and finite, but it is -0.1 m",
    ),
    "drive that pumps": (
        (HALL, LAUNCH, kp.Forces(drive=kp.Drive([1e-4, 1.0, 1e-3], phase=0.0), drag=DRAG)),
        "pumping_too_hard", r"push of 1 m/s pumps without end: .*; push=0.00\d+ keeps an amplitude",
    ),
}  # fmt: skip
MOTIONS: tuple[Callable[..., Any], ...] = (kp.RealMotion, kp.EnvelopeMotion)


def of_case(index: int, given: Given) -> Given:
    """What is given for one of the three cases."""

    def part(one: Any) -> Any:
        values = [np.broadcast_to(value, (3,))[index].item() for value in one.named.values()]
        if isinstance(one, kp.Launch):
            return kp.Launch(one.kind, tuple(values))
        return type(one)(**dict(zip(one.named, values, strict=True)))

    pendulum, launch, forces = given
    parts = {name: part(one) for name, one in forces.parts.items()}
    return part(pendulum), part(launch), kp.Forces(**parts)


@pytest.mark.filterwarnings("ignore:On swings as wide as this")  # of an averaged case that is good
@pytest.mark.parametrize("make", MOTIONS, ids=lambda make: make.__name__)
@pytest.mark.parametrize(("given", "kind", "said"), BAD.values(), ids=BAD)
def test_in_anything_that_is_given(make: Any, given: Given, kind: str, said: str) -> None:
    motion = make(*given)
    assert motion.shape == (3,)
    places = motion.position(TIMES)
    assert np.isnan(places[1]).all()
    assert np.isnan(motion.velocity(TIMES)[1]).all()
    for index in (0, 2):
        alone = make(*of_case(index, given))
        np.testing.assert_array_equal(places[index], alone.position(TIMES))
    assert motion.status.dtype == np.uint8
    assert motion.status[[0, 2]].tolist() == [0, 0]
    assert problem_kinds()[motion.status[1]] == kind
    assert list(motion.problems) == [1]
    assert motion.problems.error(1).kind == kind
    with pytest.raises(kp.InvalidInput, match=said):
        raise motion.problems.error(1)
    assert [reason == "" for reason in motion.reason] == [True, False, True]
    assert motion.reason[1] == motion.problems[1]


@pytest.mark.parametrize("make", MOTIONS, ids=lambda make: make.__name__)
@pytest.mark.parametrize(("given", "kind", "said"), BAD.values(), ids=BAD)
def test_alone_it_is_refused(make: Any, given: Given, kind: str, said: str) -> None:
    with pytest.raises(kp.InvalidInput) as raised:
        make(*of_case(1, given))
    # What is derived of something bad is refused where it is derived.
    assert raised.value.kind == kind


def test_problems_of_several_axes() -> None:
    lengths = np.array([[1.0], [-1.0]])
    motion = kp.ExactMotion(kp.Pendulum(lengths), kp.Launch.ellipse([0.1, 3.0, 0.2], 0.0))
    assert list(motion.problems) == [(0, 1), (1, 0), (1, 1), (1, 2)]
    assert "does not fit" in motion.problems[0, 1]
    assert motion.problems[-1, -1] == motion.problems[1, 2]
    assert (0, 0) not in motion.problems
    for wrong in (0, (0, 0), (2, 0), (0, 1, 0)):
        with pytest.raises(KeyError):
            motion.problems[wrong]
    assert motion.reason.shape == (2, 3)  # pyright: ignore[reportAttributeAccessIssue]
    assert motion.reason[1].tolist()[0] == motion.problems[1, 0]  # pyright: ignore[reportAttributeAccessIssue]
    assert len(motion.reason) == 2
    assert repr(motion.problems).startswith("Problems(4 of 6 cases, the first at (0, 1): The lau")
    good = kp.ExactMotion(HALL, kp.Launch.ellipse([0.1, 0.2], 0.0))
    assert not good.problems
    assert repr(good.problems) == "Problems(2 cases, all of them good)"
    assert good.status.tolist() == [0, 0]


def test_a_single_motion_has_none() -> None:
    motion = kp.ExactMotion(HALL, LAUNCH)
    assert dict(motion.problems) == {}
    assert motion.status == 0
    assert motion.status.shape == ()
    assert motion.reason == ""


@pytest.mark.parametrize("bad", [1, 1_000_000])
def test_problems_are_as_small_as_their_number(bad: int) -> None:
    # One bad case in a million takes kilobytes, not a sentence's room for each.
    widths = np.full(1_000_000, 0.1)
    widths[:bad] = 3.0
    motion = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.ellipse(widths, 0.0))
    tracemalloc.start()
    try:
        assert len(motion.problems) == bad
        assert "does not fit" in motion.reason[0]
        assert motion.reason[999_999] == ("" if bad == 1 else motion.problems[0])
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < (100e3 if bad == 1 else 10e6)
