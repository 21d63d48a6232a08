"""What all frozen parameters share: copies, pickles, equality, and that nothing can be changed."""

import copy
import pickle
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest

from kugelpendel import Bob, Drag, Drive, Site, Suspension, Wire

SEVERAL: list[Any] = [
    Site(0.5),
    Site(0.5, Site(0.5).gravity),
    Site(0.5, height=100.0),
    Site([0.5, 0.6]),
    Site([[0.5, 0.6]]),
    Drag(1e-5),
    Drag(1e-5, 1e-3),
    Drag(np.array([1e-5, 2e-5])),
    Suspension(1e-5),
    Suspension(1e-5, 0.1),
    Suspension([1e-5, 2e-5], 0.1, 1e-6, 0.2),
    Bob(0.1, 8e3),
    Bob(0.1, 8e3, 0.5, 1.1),
    Bob([0.1, 0.2], 8e3),
    Drive(0.01, phase=0.1),
    Drive(0.01, radius=0.1),
    Drive([0.01, 0.02], radius=0.1),
    Wire(1e-3),
    Wire([1e-3, 2e-3], 1.9e11),
]


def test_equality_hash_and_pickle() -> None:
    for i, one in enumerate(SEVERAL):
        for again in (copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
            assert type(again) is type(one)
            assert again == one
            assert hash(again) == hash(one)
            assert repr(again) == repr(one)
        assert [other == one for other in SEVERAL] == [i == k for k in range(len(SEVERAL))]
        assert one != 1.0
    assert len({*SEVERAL, *SEVERAL}) == len(SEVERAL)


@pytest.mark.parametrize("one", SEVERAL, ids=repr)
def test_nothing_can_be_changed(one: Any) -> None:
    name = next(iter(one.__dataclass_fields__))
    with pytest.raises(FrozenInstanceError):
        setattr(one, name, 1.0)
    for again in (one, copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
        for value in again.values:
            if isinstance(value, np.ndarray):
                with pytest.raises(ValueError, match="read-only"):
                    value[...] = 0.0


@pytest.mark.parametrize("make", [Drag, Suspension, Site, Wire, lambda v: Drive(v, phase=0.0)])
def test_arrays_are_copies(make: Any) -> None:
    given = np.array([0.1, 0.2])
    one = make(given)
    given[0] = 5.0
    assert one.values[0].tolist() == [0.1, 0.2]


def test_single_numbers_are_floats() -> None:
    for one in SEVERAL:
        if one.shape == ():
            assert all(type(value) is float for value in one.values)
