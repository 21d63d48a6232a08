"""What is neglected is as small as claimed; what happens where a condition fails is as said."""

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.calculus import EPS, is_zero, taylor
from kugelpendel.paper.algebra.symbols import a, b, l, omega0
from kugelpendel.paper.algebra.sympy_names import sqrt
from kugelpendel.paper.proofs.numeric import measured_order
from kugelpendel.paper.proofs.worlds import balanced, dynamic, ellipse

REMAINDERS = {one.label: one for one in paper.remainders()}
WORLDS = {
    "12.1": dynamic, "12.2": dynamic, "12.3:1": dynamic, "13a": dynamic, "13b": dynamic,
    "20.6": ellipse, "20.9:1": ellipse,
}  # fmt: skip


@pytest.mark.parametrize("label", REMAINDERS)
def test_remainder_is_two_orders_below_what_is_kept(label: str) -> None:
    assert REMAINDERS[label].order == REMAINDERS[label].kept + 2
    assert not is_zero(REMAINDERS[label].term)


@pytest.mark.parametrize("label", WORLDS)
def test_measured_order_of_the_remainder(label: str) -> None:
    """Slope of the logarithm between sizes 1e-12 and 1e-14; the next term bends it by 1e-24."""
    order = measured_order(paper.right(label), WORLDS[label])
    assert abs(order - REMAINDERS[label].order) < 1e-20


@pytest.mark.parametrize(
    ("label", "order"),
    [("23.6:1", 5), ("23.6:2", 5), ("23.8:1", 4), ("23.9", 4), ("25", 4), ("26", 4)],
)
def test_measured_order_of_the_results(label: str, order: int) -> None:
    """Against ω and Ω at which the first harmonics of (13a) cancel, with Ω² and all."""
    assert abs(measured_order(paper.right(label), balanced) - order) < 1e-20


def test_19_is_confirmed_by_25_and_26() -> None:
    """(19) is assumed before it is known: |ω − ω0|/ω0 is (a² + b²)/16l², Ω/ω0 is 3ab/8l²."""
    frequency = taylor(sqrt(paper.right("26").rhs.xreplace({a: EPS * a, b: EPS * b})) / omega0, 2)
    assert is_zero(frequency[1])
    assert is_zero(frequency[2] + (a**2 + b**2) / (16 * l**2))
    turning = paper.right("25").rhs / omega0
    assert is_zero(turning - 3 * a * b / (8 * l**2))


def test_every_neglecting_step_says_what_it_neglects() -> None:
    for one in paper.FORMULAS:
        drops = one.step.kind in (
            paper.StepKind.EXPAND,
            paper.StepKind.NEGLECT,
            paper.StepKind.AVERAGE,
        )
        assert not drops or one.step.neglected, one.label


@pytest.mark.parametrize("name", paper.CONSEQUENCES)
def test_consequence_of_a_failing_condition(name: str) -> None:
    assert paper.CONSEQUENCES[name]()


def test_every_consequence_that_a_condition_names_is_checked() -> None:
    conditions = {c for one in paper.FORMULAS for c in one.step.conditions}
    named = {c.consequence for c in conditions if c.consequence}
    assert named <= set(paper.CONSEQUENCES)
    assert {"circle", "independent", "equator", "x_zero", "upper_half", "axis"} <= named
    keys = [c.key for c in conditions]
    assert len(keys) == len(set(keys))
    assert any(c.silent for c in conditions)
    assert any(not c.silent for c in conditions)
