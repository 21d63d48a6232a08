"""What is no number, no motion and no pendulum gets a sentence at every public function."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM: Any = kp.Pendulum(1.0)
LAUNCH: Any = kp.Launch.ellipse(0.1, 0.02)
MOTION: Any = kp.ExactMotion(PENDULUM, LAUNCH)

NUMBERS = ["x", None, {}, MOTION, 1j, True, 10**400, ["a"], np.array(["a"]), np.zeros((2, 3))]
OBJECTS = ["x", None, {}, 1.0, np.zeros((2, 3)), LAUNCH]

TAKES_A_NUMBER: dict[str, Callable[[Any], Any]] = {
    "compare": lambda odd: kp.compare(PENDULUM, LAUNCH, odd),
    "design a": lambda odd: kp.design(PENDULUM, odd, checked=False),
    "design b": lambda odd: kp.design(PENDULUM, 0.1, odd, checked=False),
    "design share": lambda odd: kp.design(PENDULUM, 0.1, share=odd, checked=False),
    "portrait a": lambda odd: kp.Portrait(PENDULUM, odd),
    "portrait b": lambda odd: kp.Portrait(PENDULUM, 0.1, odd),
    "portrait azimuth": lambda odd: kp.Portrait(PENDULUM, 0.1, 0.0, odd),
    "events": lambda odd: MOTION.events("outer", 0.0, odd),
    "sample": lambda odd: MOTION.sample(0.0, odd, 3),
}  # fmt: skip
TAKES_AN_OBJECT: dict[str, Callable[[Any], Any]] = {
    "ellipse": lambda odd: kp.ellipse(odd, 0.0),
    "summary": lambda odd: kp.IdealSummary.of(odd),
    "portrait of": lambda odd: kp.Portrait.of(odd),
    "portrait": lambda odd: kp.Portrait(odd, 0.1),
    "design": lambda odd: kp.design(odd, 0.1, checked=False),
    "compare": lambda odd: kp.compare(odd, odd),
    "exact": lambda odd: kp.ExactMotion(odd, LAUNCH),
    "real": lambda odd: kp.RealMotion(odd, LAUNCH),
    "quality": lambda odd: kp.Drag.from_quality(100.0, odd),
    "from bob": lambda odd: kp.Drag.from_bob(odd, PENDULUM),
}  # fmt: skip


@pytest.mark.parametrize("odd", NUMBERS, ids=[repr(odd)[:20] for odd in NUMBERS])
@pytest.mark.parametrize("name", TAKES_A_NUMBER)
def test_what_is_not_one_number(name: str, odd: Any) -> None:
    if name == "compare" and odd is None:
        return  # as many swings as are usual
    with pytest.raises(kp.InvalidInput) as caught:
        TAKES_A_NUMBER[name](odd)
    assert len(str(caught.value)) > 30


@pytest.mark.parametrize("odd", OBJECTS, ids=[repr(odd)[:20] for odd in OBJECTS])
@pytest.mark.parametrize("name", TAKES_AN_OBJECT)
def test_what_is_no_motion_or_pendulum(name: str, odd: Any) -> None:
    with pytest.raises(kp.InvalidInput, match=r"must be a kugelpendel\.[\w .]+, but it is .*; \w+"):
        TAKES_AN_OBJECT[name](odd)


@pytest.mark.parametrize("odd", ["x", None, {}, 1j, 10**400, np.array(["a"])])
def test_an_ellipse_needs_times(odd: Any) -> None:
    with pytest.raises(kp.InvalidInput, match="The times must be"):
        kp.ellipse(MOTION, odd)


def test_a_wire_is_a_wire() -> None:
    wire: Any = "steel"
    with pytest.raises(kp.InvalidInput, match=r"The wire must be a kugelpendel\.Wire"):
        kp.design(PENDULUM, 0.1, wire=wire, checked=False)


def test_indexing_a_single_motion_is_a_sentence() -> None:
    for key in (0, "x", np.zeros((2, 3)), slice(None)):
        with pytest.raises(IndexError, match="only an ensemble can"):
            MOTION[key]
    assert MOTION[()] == MOTION
