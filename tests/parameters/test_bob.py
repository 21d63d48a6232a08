"""The bob: its mass, its effect on the period, and what is refused."""

import math

import pytest

from kugelpendel import Bob, InvalidInput


def test_mass() -> None:
    # A ball of iron, 19 cm across, is about the 28 kg of Foucault's bob.
    assert Bob(0.0947, 7860.0).mass == pytest.approx(27.96, abs=0.01)


def period_change(bob: Bob, length: float) -> float:
    return 1 / math.sqrt(float(bob.gravity_factor(length))) - 1


@pytest.mark.parametrize(
    ("bob", "first_order"),
    [
        # Nelson and Olsson (1986), each alone, and small enough for the first order.
        (Bob(0.01, 8000.0, air_density=0.0), 1 / 5 * 1e-4),
        (Bob(1e-9, 8000.0, 1e-3 * 8000 * 4 / 3 * math.pi * 1e-27, 0.0), -1e-3 / 12),
        (Bob(1e-9, 8000.0, air_density=0.8), (1 / 2 + 1 / 4) * 1e-4),
    ],
    ids=["radius", "thread", "air"],
)
def test_first_orders(bob: Bob, first_order: float) -> None:
    assert period_change(bob, 1.0) == pytest.approx(first_order, rel=1e-3)


def test_heavy_thread_without_a_bob_is_a_rod() -> None:
    # Of a uniform rod T = 2π√(2l/3g), so κ = 3/2.
    assert Bob(1e-9, 1.0, 1.0, 0.0).gravity_factor(1.0) == pytest.approx(1.5)


def test_buoyancy_is_that_of_the_bob_alone() -> None:
    # The torque on bob and thread, over that on a point of the bob's mass.
    bob = Bob(1e-6, 2.0, 2.0 * 4 / 3 * math.pi * 1e-18, 1.0)
    assert bob.gravity_factor(1.0) == pytest.approx((0.5 + 0.5) / (1 + 0.25 + 1 / 3))


def test_arrays_broadcast() -> None:
    bob = Bob([0.1, 0.2], [[7860.0], [8500.0], [11340.0]])
    assert bob.shape == (3, 2)
    assert bob.gravity_factor(20.0).shape == (3, 2)  # pyright: ignore[reportAttributeAccessIssue]
    assert Bob(0.1, 7860.0).gravity_factor([10.0, 20.0]).shape == (2,)  # pyright: ignore[reportAttributeAccessIssue]


REFUSED = [
    (lambda: Bob(0.0, 8e3), "bob's radius must be positive and finite, but it is 0 m; a point is"),
    (lambda: Bob(-0.1, 8e3), "bob's radius must be positive"),
    (lambda: Bob(0.1, 0.0), "bob's density must be positive and finite, but it is 0 kg/m³"),
    (lambda: Bob(0.1, math.nan), "bob's density .* is nan kg/m³; "),
    (lambda: Bob(0.1, 8e3, -1.0), "thread's mass must be finite and not negative, .* -1 kg"),
    (lambda: Bob(0.1, 8e3, 0.0, -1.0), "air's density must be finite and not negative"),
    (lambda: Bob(0.1, 1.1), "bob's density must exceed that of the air, but it is 1.1 kg/m³; a"),
    (lambda: Bob(0.1, 1.204), "bob's density must exceed that of the air"),
    (lambda: Bob(0.1, 8e3, 0.0, 9e3), "is 8000 kg/m³; a bob lighter than air"),
    (lambda: Bob("10 cm", 8e3), "bob's radius must be a number .* in m"),  # pyright: ignore[reportArgumentType]
    (lambda: Bob([0.1, 0.2], [1e3, 2e3, 3e3]), "do not fit together"),
    (lambda: Bob(1.0, 8e3).gravity_factor(1.0), "radius must be less than the length .* is 1 m; "),
    (lambda: Bob(1.0, 8e3).gravity_factor(-1.0), "length must be positive"),
    (lambda: Bob([0.1, 0.2], 8e3).gravity_factor([1.0, 2.0, 3.0]), "do not fit together"),
]


@pytest.mark.parametrize(("make", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(make, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        make()
