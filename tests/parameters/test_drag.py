"""Drag: from quality, half life, and bob and air; and what is refused."""

import math

import numpy as np
import pytest

from kugelpendel import Bob, Drag, InvalidInput, Pendulum

PENDULUM = Pendulum(20.0, 9.81)


def test_from_quality() -> None:
    drag = Drag.from_quality(800.0, PENDULUM)
    # In Q/π swings the amplitude falls to 1/e.
    swings = 800 / math.pi
    time = swings * 2 * math.pi / float(PENDULUM.angular_frequency)
    assert math.exp(-float(drag.linear) * time) == pytest.approx(1 / math.e)
    assert drag.quadratic == 0


def test_from_half_life() -> None:
    assert math.exp(-float(Drag.from_half_life(7200.0).linear) * 7200) == pytest.approx(0.5)


def test_from_bob() -> None:
    bob = Bob(radius=0.1, density=7860.0, air_density=1.2)
    drag = Drag.from_bob(bob, PENDULUM, air_viscosity=1.8e-5, drag_coefficient=0.4)
    # Written once more from the drag itself: F = ½ρCAv², and F = 6πηr(1 + r/s)v, s = √(2η/ρω).
    m = 7860 * 4 / 3 * math.pi * 1e-3
    assert drag.quadratic == pytest.approx(0.5 * 1.2 * 0.4 * math.pi * 0.01 / m)
    layer = math.sqrt(2 * 1.8e-5 / 1.2 / math.sqrt(9.81 / 20))
    assert layer == pytest.approx(6.5e-3, rel=0.01)
    force = 6 * math.pi * 1.8e-5 * 0.1 * (1 + 0.1 / layer)
    assert drag.linear == pytest.approx(force / m / 2)


def test_thread_takes_by_its_power() -> None:
    bob = Bob(radius=0.1, density=7860.0)
    with_thread = Drag.from_bob(bob, PENDULUM, thread_diameter=1e-3, thread_drag_coefficient=1.2)
    more = float(with_thread.quadratic) - float(Drag.from_bob(bob, PENDULUM).quadratic)
    # The thread at distance s moves with v s/l: add up its power for v = 1 by the midpoint rule.
    s = (np.arange(1000) + 0.5) / 1000 * 20.0
    power = float(np.sum(0.5 * 1.204 * 1.2 * 1e-3 * (s / 20) ** 3) * 20.0 / 1000)
    assert more * float(bob.mass) == pytest.approx(power, rel=1e-6)


def test_no_air_no_quadratic_drag() -> None:
    vacuum = Drag.from_bob(Bob(0.1, 7860.0, air_density=0.0), PENDULUM)
    assert vacuum.quadratic == 0
    assert vacuum.linear == pytest.approx(3 * math.pi * 1.81e-5 * 0.1 / 32.9238, rel=1e-5)


def test_arrays_broadcast() -> None:
    assert Drag([1e-4, 2e-4], [[0.0], [1e-3], [2e-3]]).shape == (3, 2)
    assert Drag.from_quality([[100.0], [200.0]], Pendulum([1.0, 2.0, 3.0])).shape == (2, 3)
    assert Drag.from_bob(Bob([0.1, 0.2], 7860.0), PENDULUM).shape == (2,)


REFUSED = [
    (lambda: Drag(-1e-5), "linear drag must be finite and not negative, but it is -1e-05 1/s; .*"
                          "use 0 for none, and kp.Drive"),
    (lambda: Drag(0.0, -1e-5), "quadratic drag must be finite and not negative, but it is -1e-05 "
                               "1/m"),
    (lambda: Drag(math.nan), "linear drag .* is nan 1/s"),
    (lambda: Drag(math.inf), "linear drag .* is inf 1/s"),
    (lambda: Drag("1/h"), "linear drag must be a number .* in 1/s"),  # pyright: ignore[reportArgumentType]
    (lambda: Drag([1.0, 2.0], [1.0, 2.0, 3.0]), "do not fit together"),
    (lambda: Drag.from_quality(0.0, PENDULUM), "quality factor must be positive and finite, but "
                                               "it is 0; for no drag leave it out"),
    (lambda: Drag.from_quality(-5.0, PENDULUM), "quality factor must be positive"),
    (lambda: Drag.from_quality(math.inf, PENDULUM), "quality factor .* is inf; "),
    (lambda: Drag.from_half_life(0.0), "half life must be positive and finite, but it is 0 s"),
    (lambda: Drag.from_bob(Bob(0.1, 8e3), PENDULUM, air_viscosity=0.0), "viscosity must be pos"),
    (lambda: Drag.from_bob(Bob(0.1, 8e3), PENDULUM, drag_coefficient=-1.0), "drag coefficient mu"),
    (lambda: Drag.from_bob(Bob(0.1, 8e3), PENDULUM, thread_diameter=-1.0), "thread's diameter m"),
    (lambda: Drag.from_bob(Bob(0.1, 8e3), PENDULUM, thread_drag_coefficient=0.0), "thread's drag"),
    (lambda: Drag.from_bob(Bob(20.0, 8e3), PENDULUM), "radius must be less than the length"),
]  # fmt: skip


@pytest.mark.parametrize(("make", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(make, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        make()
