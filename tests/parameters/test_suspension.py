"""The suspension: from two periods, and what is refused."""

import math

import pytest

from kugelpendel import InvalidInput, Suspension


def test_from_periods() -> None:
    # The axis is the stiff one where the period along it is the shorter.
    suspension = Suspension.from_periods(8.97, 8.98, 0.3, 1e-6, 0.4)
    assert suspension.anisotropy == pytest.approx(2 * math.pi / 8.97 - 2 * math.pi / 8.98)
    assert float(suspension.anisotropy) > 0
    assert suspension.values[1:] == (0.3, 1e-6, 0.4)


def test_nearly_equal_periods_lose_no_digits() -> None:
    anisotropy = Suspension.from_periods(8.0, 8.0 + 2.0**-40).anisotropy
    assert anisotropy == pytest.approx(2 * math.pi * 2.0**-40 / 64, rel=1e-12)
    assert Suspension.from_periods(8.0, 8.0).anisotropy == 0


def test_default_is_none() -> None:
    assert Suspension().values == (0.0, 0.0, 0.0, 0.0)


def test_arrays_broadcast() -> None:
    assert Suspension([1e-5, -1e-5], [[0.0], [1.0]]).shape == (2, 2)
    assert Suspension.from_periods([8.0, 8.1], 8.05).shape == (2,)


REFUSED = [
    (lambda: Suspension(math.nan), "suspension's anisotropy must be finite, but it is nan rad/s"),
    (lambda: Suspension(0.0, math.inf), "suspension's axis must be finite, but it is inf rad"),
    (lambda: Suspension(0, 0, -math.inf), "damping anisotropy must be finite, but it is -inf 1/s"),
    (lambda: Suspension(0, 0, 0, math.nan), "damping axis .* is nan rad; "),
    (lambda: Suspension("1 deg/h"), "must be a number .* in rad/s"),  # pyright: ignore[reportArgumentType]
    (lambda: Suspension([1.0, 2.0], [1.0, 2.0, 3.0]), "do not fit together"),
    (lambda: Suspension.from_periods(0.0, 8.0), "period along the axis must be positive .* 0 s"),
    (lambda: Suspension.from_periods(8.0, -8.0), "period across the axis must be positive"),
    (lambda: Suspension.from_periods(8.0, math.inf), "period across the axis .* is inf s"),
    (lambda: Suspension.from_periods([8.0, 9.0], [1.0, 2.0, 3.0]), "two periods do not fit"),
]


@pytest.mark.parametrize(("make", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(make, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        make()
