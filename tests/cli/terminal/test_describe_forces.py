"""What acts, in words: each part by its phrase, and one without a phrase by its numbers."""

import math

import pytest

import kugelpendel as kp
from kugelpendel.cli.terminal import describe_forces

PENDULUM = kp.Pendulum(20.0, 9.81)


def test_parts_are_told_in_their_order() -> None:
    forces = kp.Forces(
        drive=kp.Drive(-1e-3, radius=0.2),
        suspension=kp.Suspension(1e-5, 0.5, 1e-6),
        site=kp.Site(-0.5),
        bob=kp.Bob(0.1, 7860.0),
    )
    said = describe_forces.describe_forces(PENDULUM, forces)
    assert [name for name, _ in said] == ["Site", "Suspension", "", "Bob", "Drive"]
    assert said[0][1].startswith("28.6479° S, g = 9.7")
    assert said[4][1] == "1 mm/s inwards, on the way out, 20 cm from the axis"


def test_a_part_without_a_phrase_is_told_by_its_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(describe_forces, "_PHRASES", {})
    forces = kp.Forces(drive=kp.Drive(-1e-3, phase=math.radians(25)))
    (said,) = describe_forces.describe_forces(PENDULUM, forces)
    assert said == ("Drive", "push −0.001 m/s, phase 25°")
