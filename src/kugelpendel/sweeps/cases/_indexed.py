"""Cases from their index: any of them alone, in any order, the same to the last bit.

Every function takes the sweep, its laws and indices, and gives the values of each law.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from kugelpendel.parameters import Numbers
from kugelpendel.sweeps.cases._laws import Law

if TYPE_CHECKING:
    from kugelpendel.sweeps.cases._sweep import Sweep

Indices = NDArray[np.int64]

_WORDS = 4
"""Random words of 64 bits for each count of Philox 4×64."""

_BITS = 30
"""Of a point of Sobol's sequence."""

_STREAM = 0x6B7567656C
"""The second half of the key, so that draws are not those of others with the same seed."""


def grid_cases(sweep: Sweep, laws: Sequence[Law], index: Indices) -> list[Numbers]:
    """All combinations: the digits of the index in mixed radix, the last changing fastest."""
    values: list[Numbers] = []
    rest = index
    for law in reversed(laws):
        rest, level = np.divmod(rest, cast("int", law.levels))
        values.append(law.at(level))
    return values[::-1]


def grid_stretch(laws: Sequence[Law], start: int, stop: int) -> list[Numbers]:
    """The same for the indices from start to stop − 1, in a tenth of the time.

    In a stretch the outer numbers change seldom and the inner ones repeat.
    """
    if not laws:
        return []
    law, levels = laws[-1], cast("int", laws[-1].levels)
    if levels > stop - start:
        inner = law.at(np.arange(start, stop, dtype=np.int64) % levels)
    else:
        rows = -(-stop // levels) - start // levels
        skipped = start % levels
        inner = np.tile(law.at(np.arange(levels)), rows)[skipped : skipped + stop - start]
    first = start // levels
    outer = grid_stretch(laws[:-1], first, -(-stop // levels))
    skipped = start - first * levels
    # The first row and the last may be cut short.
    repeats = np.full(-(-stop // levels) - first, levels)
    repeats[0] -= skipped
    repeats[-1] -= -(-stop // levels) * levels - stop
    return [*(np.repeat(values, repeats) for values in outer), inner]


def sample_cases(sweep: Sweep, laws: Sequence[Law], index: Indices) -> list[Numbers]:
    """Independent draws, with the index as the counter of the generator."""
    words = [np.empty((0, _width(laws)), dtype=np.uint64)]
    words += [_words(sweep, laws, start, stop) for start, stop in _runs(index)]
    return _drawn(laws, np.concatenate(words))


def sample_stretch(sweep: Sweep, laws: Sequence[Law], start: int, stop: int) -> list[Numbers]:
    """The same for the indices from start to stop − 1, without writing them down."""
    return _drawn(laws, _words(sweep, laws, start, stop))


def _words(sweep: Sweep, laws: Sequence[Law], start: int, stop: int) -> NDArray[np.uint64]:
    """The random words of the cases from start to stop − 1: shape (stop − start, width)."""
    width = _width(laws)
    count, skipped = divmod(start * width, _WORDS)
    generator = cast("Any", np.random.Philox(key=_key(sweep.seed), counter=count))
    raw: NDArray[np.uint64] = generator.random_raw(skipped + (stop - start) * width)
    return raw[skipped:].reshape(-1, width)


def _width(laws: Sequence[Law]) -> int:
    """Words of a case: one or two share a count with other cases; more have counts of their own."""
    return len(laws) if len(laws) < 3 else -(-len(laws) // _WORDS) * _WORDS


def _drawn(laws: Sequence[Law], words: NDArray[np.uint64]) -> list[Numbers]:
    return [law.drawn(_chance(words[:, k])) for k, law in enumerate(laws)]


def sobol_cases(sweep: Sweep, laws: Sequence[Law], index: Indices) -> list[Numbers]:
    """Saltelli's design: for each base point A, then A with one column of B each, … , B.

    With pairs, B with one column of A each comes before the last, as SALib has it.
    """
    count = len(laws)
    point, row = np.divmod(index, sweep.block)
    if point.size == 0:
        return [law.drawn(np.empty(0)) for law in laws]
    first, last = int(point.min()), int(point.max())
    # One sequence for all columns: those of A, then those of B.
    directions = _directions(2 * count, sweep.seed, cast("int", sweep.count).bit_length() - 1)
    base = _sobol_points(directions, first, last + 1)
    values: list[Numbers] = []
    for k, law in enumerate(laws):
        of_b = (row == k + 1) | (row == sweep.block - 1)
        if sweep.second_order:
            of_b |= (row > count) & (row != count + 1 + k)
        one, other = base[k][point - first], base[count + k][point - first]
        word = np.asarray(np.where(of_b, other, one), dtype=np.float64)
        # Among the points is 0; they are taken in the middle of their cells.
        values.append(law.drawn((word + 0.5) * 2.0**-_BITS))
    return values


def _runs(index: Indices) -> list[tuple[int, int]]:
    """Stretches of indices that go up one by one: the first of each, and the one after its last."""
    if index.size == 0:
        return []
    edges = [0, *(np.flatnonzero(np.diff(index) != 1) + 1).tolist(), index.size]
    return [(int(index[here]), int(index[after - 1]) + 1) for here, after in pairwise(edges)]


def _chance(words: NDArray[np.uint64]) -> Numbers:
    """Probabilities strictly between 0 and 1, at the middles of 2⁵² cells."""
    chance = (words >> np.uint64(12)).astype(np.float64)
    chance += 0.5
    chance *= 2.0**-52
    return chance


def _sobol_points(directions: NDArray[np.uint32], start: int, stop: int) -> NDArray[np.uint32]:
    """Points of Sobol's sequence from start to stop − 1: shape (dimensions, stop − start).

    From one to the next one direction changes (Antonov & Saleev, USSR Comput. Maths. Math. Phys.
    19, 252 (1980)); the first is entered by the bits of its Gray code.
    """
    gray = start ^ (start >> 1)
    point = directions[:, 0].copy()
    for bit in range(gray.bit_length()):
        if gray >> bit & 1:
            point ^= directions[:, bit + 1]
    index = np.arange(start, stop, dtype=np.int64)
    changed = np.log2((index & -index).clip(1)).astype(np.int64) + 1
    # The last direction of a sequence of one point stands for none.
    steps = directions[:, np.minimum(changed, directions.shape[1] - 1)]
    steps[:, 0] = point
    return np.bitwise_xor.accumulate(steps, axis=1)


@lru_cache(maxsize=8)
def _directions(dimensions: int, seed: int, bits: int) -> NDArray[np.uint32]:
    """The scrambled shift and directions of a sequence of 2^bits points: (dimensions, 1 + bits).

    They are read off the points that SciPy makes, whose own way to a later point goes through all
    before it.
    """
    from scipy.stats import qmc  # pyright: ignore[reportMissingTypeStubs]

    generator = np.random.Generator(np.random.Philox(np.random.SeedSequence((seed, _STREAM))))
    make: Any = qmc.Sobol
    sequence = make(dimensions, scramble=True, bits=_BITS, rng=generator)
    found = np.empty((dimensions, 1 + bits), dtype=np.uint32)
    at = 0
    for column, place in enumerate([0, *(2 ** (bit + 1) - 1 for bit in range(bits))]):
        if place > at:
            sequence.fast_forward(place - at)
        found[:, column] = np.asarray(sequence.random(1))[0] * 2**_BITS
        at = place + 1
    found[:, 1:] ^= found[:, :1]
    return found


def _key(seed: int) -> int:
    """The key of Philox: 128 bits."""
    return seed % 2**64 | _STREAM << 64
