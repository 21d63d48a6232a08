"""The drive: what it keeps, and what is refused."""

import math

import numpy as np
import pytest

from kugelpendel import Drive, InvalidInput


def test_values() -> None:
    assert Drive(0.01, phase=0.2).values == (0.01, 0.2)
    assert Drive(-0.01, radius=0.3).values == (-0.01, 0.3)
    assert Drive(0.01, phase=0.2).radius is None
    assert Drive(0.01, radius=0.3).phase is None
    assert Drive(0.01, phase=0.0).phase == 0
    assert Drive([0.01, 0.02], phase=[[0.1], [0.2]]).shape == (2, 2)


def test_phase_and_radius_are_not_the_same() -> None:
    assert Drive(0.01, phase=0.2) != Drive(0.01, radius=0.2)


REFUSED = [
    (lambda: Drive(0.01), r"exactly one of phase and radius, .* but neither is given; write kp.Dr"),
    (lambda: Drive(0.01, 0.1, 0.1), "exactly one of phase and radius, .* but both are given"),
    (lambda: Drive(math.nan, 0.1), "push must be finite, but it is nan m/s"),
    (lambda: Drive(0.01, -0.1), "phase must lie between 0 and π, but it is -0.1 rad; a push x be"),
    (lambda: Drive(0.01, np.pi), "phase must lie between 0 and π, but it is 3.14159 rad"),
    (lambda: Drive(0.01, math.nan), "phase must lie .* is nan rad"),
    (lambda: Drive(0.01, radius=0.0), "radius must be positive and finite, but it is 0 m; a push"),
    (lambda: Drive(0.01, radius=-0.1), "radius must be positive and finite, but it is -0.1 m"),
    (lambda: Drive(0.01, radius=math.inf), "radius .* is inf m; "),
    (lambda: Drive("1 cm/s", 0.1), "push must be a number .* in m/s"),  # pyright: ignore[reportArgumentType]
    (lambda: Drive([0.1, 0.2], [0.1, 0.2, 0.3]), "push and phase do not fit together"),
    (lambda: Drive([0.1, 0.2], radius=[0.1, 0.2, 0.3]), "push and radius do not fit together"),
]


@pytest.mark.parametrize(("make", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(make, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        make()
