"""The wire: its cross section, and what is refused."""

import math

import pytest

from kugelpendel import InvalidInput, Wire


def test_cross_section() -> None:
    assert Wire(2e-3).cross_section == pytest.approx(math.pi * 1e-6)
    assert Wire([1e-3, 2e-3]).shape == (2,)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((0.0,), "wire's diameter must be positive and finite, but it is 0 m; leave the wire out"),
        ((1e-3, -1.0), "Young's modulus must be positive and finite, but it is -1 Pa; steel has"),
        ((1e-3, 2e11, math.nan), "wire's expansion must be finite, but it is nan 1/K"),
        (("1 mm",), "wire's diameter must be a number .* in m"),
        (([1e-3, 2e-3], [1.0, 2.0, 3.0]), "do not fit together"),
    ],
)
def test_refused(arguments: tuple, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        Wire(*arguments)
