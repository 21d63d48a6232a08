"""The exceptions: caught by one base, kept through pickles, with the place where they happened."""

import copy
import pickle

import pytest

import kugelpendel as kp
from kugelpendel.errors import FileLine, KugelpendelError, Seen

LOOP = kp.Launch.plane(0.3, 0.0, 5.6, 0.1)
"""Over the support's level of a pendulum of 1 m, but not round."""

SEVERAL = [
    kp.InvalidInput("A sentence of somebody's own."),
    kp.InvalidInput.of("ellipse_negative", a=(-0.1, "m")),
    kp.MotionEnded.of("slack", time=(3.0, "s"), first=(0.0, "s"), last=(9.0, "s")),
    kp.EventNotFound.of("no_event", event="slack", within=(9.0, "s"), after=(0.0, "s")),
    kp.MissingExtra.of("missing_extra", missing="xarray", what="to_xarray", extra="run"),
]


@pytest.mark.parametrize("error", SEVERAL, ids=lambda error: type(error).__name__)
def test_copies_say_the_same(error: KugelpendelError) -> None:
    placed = error.at("job.toml: ").at("again, ")
    assert str(placed) == f"again, job.toml: {error}"
    in_a_file = error.at(FileLine("job.toml", 6))
    assert str(in_a_file) == f"job.toml, line 6: {error}"
    assert in_a_file.sentence("de") == f"job.toml, Zeile 6: {error.sentence('de')}"
    for one in (error, placed, in_a_file):
        for again in (copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
            assert type(again) is type(one)
            assert str(again) == str(one)
            assert again.sentence("de", "file") == one.sentence("de", "file")
            assert (again.kind, again.values, again.place) == (one.kind, one.values, one.place)


def test_one_base_catches_all() -> None:
    for error in SEVERAL:
        assert isinstance(error, kp.KugelpendelError)
        assert type(error).__module__ == "kugelpendel"
    assert not issubclass(kp.MotionEnded, kp.InvalidInput)
    assert not issubclass(kp.EventNotFound, kp.InvalidInput)
    # As the built-in exceptions whose place they take.
    for kind in (kp.InvalidInput, kp.MotionEnded, kp.EventNotFound):
        assert issubclass(kind, ValueError)
    assert issubclass(kp.MissingExtra, ImportError)


def test_a_motion_that_has_ended_says_when() -> None:
    motion = kp.RealMotion(kp.Pendulum(1.0, 9.81), LOOP)
    slack = motion.next_event("slack")
    with pytest.raises(kp.MotionEnded) as raised:
        motion.position([0.0, 10.0])
    assert raised.value.time == pytest.approx(slack, rel=1e-12)
    assert raised.value.values[1:] == (Seen("first", 0.0, "s"), Seen("last", 10.0, "s"))


def test_every_motion_that_can_end_says_when() -> None:
    pendulum = kp.Pendulum(1.0, 9.81)
    for motion in (kp.PlaneMotion(pendulum, LOOP), kp.CubicMotion(pendulum, LOOP)):
        with pytest.raises(kp.MotionEnded) as raised:
            motion.position(100.0)
        assert raised.value.time == pytest.approx(motion.span[1], rel=1e-12)
    mean = kp.EnvelopeMotion(pendulum, kp.Launch.ellipse(0.1, 0.0), drag=kp.Drag(1e-3))
    with pytest.raises(kp.MotionEnded) as raised:
        mean.position(-1e6)
    assert raised.value.time == pytest.approx(mean.span[0], rel=1e-9)


def test_an_event_that_does_not_come() -> None:
    motion = kp.RealMotion(kp.Pendulum(1.0), kp.Launch.ellipse(0.1, 0.0))
    with pytest.raises(kp.EventNotFound, match=r'"slack" does not come within 5 s after 2 s; look'):
        motion.next_event("slack", after=2.0, within=5.0)


def test_what_has_only_a_sentence_says_it_everywhere() -> None:
    error = kp.InvalidInput("so it is.")
    assert error.sentence("de", "file") == str(error) == "so it is."
    assert (error.kind, error.values) == ("", ())
