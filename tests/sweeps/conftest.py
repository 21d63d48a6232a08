"""The stores of two sweeps side by side."""

from collections.abc import Callable
from pathlib import Path

import pytest
from tests.sweeps.made import contents


@pytest.fixture
def same() -> Callable[[Path, Path], None]:
    """Assert that two stores are the same to the last bit, whole, and have nothing left over."""

    def same(one: Path, other: Path) -> None:
        a, b = contents(one), contents(other)
        assert list(a) == list(b)
        assert a["done"].all()
        for name, values in a.items():
            assert values.tobytes() == b[name].tobytes(), name
        for folder in (one, other):
            assert not list(folder.rglob("*.partial"))
            assert not list(folder.glob(".sweep*"))

    return same
