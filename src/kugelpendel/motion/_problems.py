"""Which cases of an ensemble are bad, and why: as small as their number."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Protocol, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from kugelpendel.errors import InvalidInput, Told
from kugelpendel.parameters import Forces

Index: TypeAlias = int | tuple[int, ...]
"""An int where the ensemble has one axis, else a tuple of as many as it has."""


class Cases(Protocol):
    """The core's motions in a row, as far as this module asks them."""

    def problems(self) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
        """Indices of the bad cases, and the number of each one's kind."""
        ...

    def problem(self, index: int) -> Told | None:
        """What is wrong with one of them."""
        ...


class Problems(Mapping[Index, str]):
    """Index and sentence of each bad case of an ensemble; empty where all are good.

    A sentence is made when it is read: a million cases of which all are bad take 9 MB, of which
    one is bad some bytes (tests/motion/test_bad_cases.py).

    Parameters
    ----------
    cases
        The core's motions.
    shape
        Of the ensemble.
    forces
        What acts, in which numbers may be derived from others that were given.
    """

    def __init__(self, cases: Cases, shape: tuple[int, ...], forces: Forces | None = None):
        self._cases = cases
        self._shape = shape
        self._forces = forces
        self._indices, self._kinds = cases.problems()

    @property
    def status(self) -> NDArray[np.uint8]:
        """0 for a good case, else the number of the kind of its problem: shape of the ensemble.

        `kugelpendel.errors.problem_kinds()` has the kinds by their numbers.
        """
        status = np.zeros(self._shape, np.uint8)
        status.flat[self._indices] = self._kinds
        status.flags.writeable = False
        return status

    @property
    def reasons(self) -> Reasons:
        """The sentence of every case, "" for a good one."""
        return Reasons(self, self._shape)

    def error(self, index: Index) -> InvalidInput:
        """The error of a bad case, with its kind and values; raises KeyError for a good one."""
        flat = self._flat(index)
        told = self._cases.problem(flat)
        if told is None:
            raise KeyError(index)
        return InvalidInput.told(self._by_what_was_given(told, flat))

    def __getitem__(self, index: Index) -> str:
        return str(self.error(index))

    def __iter__(self) -> Iterator[Index]:
        for flat in self._indices:
            index = _place(int(flat), self._shape)
            yield index[0] if len(index) == 1 else index

    def __len__(self) -> int:
        return self._indices.size

    def __repr__(self) -> str:
        count = int(np.prod(self._shape))
        if not self:
            return f"Problems({count} cases, all of them good)"
        index = next(iter(self))
        said = f"Problems({len(self)} of {count} cases, the first at {index}: {self[index]}"
        return f"{said})" if len(said) < 200 else f"{said[:198]}…)"

    def _by_what_was_given(self, told: Told, flat: int) -> Told:
        """The problem of what a bad number was derived from, in place of that number's own."""
        seen = told[1]
        if self._forces is None or not seen or (origin := self._forces.origin(seen[0][0])) is None:
            return told
        return origin.problem(_place(flat, self._shape), self._shape) or told

    def _flat(self, index: Index) -> int:
        positions = index if isinstance(index, tuple) else (index,)
        if len(positions) != len(self._shape):
            raise KeyError(index)
        flat = 0
        for position, size in zip(positions, self._shape, strict=True):
            if not -size <= position < size:
                raise KeyError(index)
            flat = flat * size + position % size
        return flat


class Reasons:
    """The sentence of every case of an ensemble, "" for a good one; made when it is read.

    Behaves as an array of strings does: indices and slices, `shape`, `tolist()`, iteration along
    the first axis, and comparison element by element. That of a single motion has the shape ().
    """

    def __init__(self, problems: Problems, shape: tuple[int, ...]):
        self._problems = problems
        self._shape = shape

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the ensemble."""
        return self._shape

    def __len__(self) -> int:
        return self._shape[0]

    def __getitem__(self, index: Any) -> Any:
        place = cast("tuple[Any, ...]", index) if isinstance(index, tuple) else (index,)
        whole = all(isinstance(k, (int, np.integer)) for k in place)
        if not whole or len(place) != len(self._shape):
            return np.asarray(self)[index]
        if not all(-size <= k < size for k, size in zip(place, self._shape, strict=True)):
            raise IndexError(f"there is no case {index} in an ensemble of shape {self._shape}")
        return self._problems.get(place, "")

    def __iter__(self) -> Iterator[Any]:
        return (self[k] for k in range(len(self)))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[np.object_]:
        array = np.full(self._shape, "", dtype=object)
        for index, sentence in self._problems.items():
            array[index] = sentence
        return array if dtype is None else array.astype(dtype)

    def __eq__(self, other: object) -> Any:
        return np.asarray(self) == (np.asarray(other) if isinstance(other, Reasons) else other)

    __hash__ = None  # pyright: ignore[reportAssignmentType]

    def tolist(self) -> Any:
        """Nested lists of strings."""
        return np.asarray(self).tolist()

    def __repr__(self) -> str:
        return repr(self._problems).replace("Problems", "Reasons", 1)

    def __str__(self) -> str:
        return str(np.asarray(self))


def _place(flat: int, shape: tuple[int, ...]) -> tuple[int, ...]:
    """The index of a case that is given by its number in a row."""
    place: list[int] = []
    for size in reversed(shape):
        flat, k = divmod(flat, size)
        place.append(k)
    return tuple(reversed(place))
