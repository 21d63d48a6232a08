"""How much of what moves a result each parameter moves: Sobol indices, with their intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from kugelpendel.errors import require_extra
from kugelpendel.parameters import InvalidInput, Numbers

FEWEST = 16
"""Blocks below which no interval means anything."""

_RESAMPLES = 200
"""Of the bootstrap."""

_TOGETHER = 2_000_000
"""Numbers that are resampled at once."""

_WIDTH = 1.959964
"""Standard deviations in half of a 95 % interval."""


@dataclass(frozen=True)
class Share:
    """A part of a variance.

    Attributes
    ----------
    value
        1 for all of it; an estimate may lie outside of 0 to 1.
    error
        Half of its 95 % interval.
    """

    value: float
    error: float

    @property
    def least(self) -> float:
        """The lower end of the interval."""
        return self.value - self.error

    @property
    def most(self) -> float:
        """The upper end of the interval."""
        return self.value + self.error


@dataclass(frozen=True)
class Sensitivity:
    """What moves a result: shares of its variance.

    Attributes
    ----------
    names
        Of the parameters.
    alone
        What each moves by itself, on the average over the others: first-order indices.
    total
        What each moves together with all others: what would be gone, on the average, if it were
        held.
    together
        What two move between them: first order of both and their interaction; empty where the
        design has no pairs.
    interaction
        The part of that which is in neither alone.
    blocks
        Blocks of Saltelli's design that were used: each is one base point and its variations.
    dropped
        Blocks left out since a case in them has no answer. What is said holds for the rest.
    """

    names: tuple[str, ...]
    alone: dict[str, Share]
    total: dict[str, Share]
    together: dict[tuple[str, str], Share]
    interaction: dict[tuple[str, str], Share]
    blocks: int
    dropped: int


def sensitivity(
    values: Numbers, names: Sequence[str], *, second_order: bool = True, seed: int = 0
) -> Sensitivity:
    """Sobol indices of a result in Saltelli's design.

    Parameters
    ----------
    values
        The result of each case, in the order of the design (`SALib.analyze.sobol`): shape (n,).
        What is not finite has no answer, and its whole block is left out.
    names
        Of the parameters, in the order of the design.
    second_order
        Whether the design has the cases for pairs.
    seed
        Of the bootstrap.

    Raises
    ------
    InvalidInput
        Where the count of cases is not that of the design, fewer than 16 blocks remain, or nothing
        moves.
    MissingExtra
        Without SALib, which the extra [sweep] brings.

    Notes
    -----
    The estimators are SALib's: Saltelli et al., Comput. Phys. Commun. 181, 259 (2010) for one
    parameter, Saltelli, Comput. Phys. Commun. 145, 280 (2002) for two. Intervals are 1.96 standard
    deviations of 200 resamplings of the blocks. SALib itself makes all indices 0 of a single NaN,
    without a word.
    """
    require_extra("sweep", "sensitivity", "SALib")
    count = len(names)
    size = (2 if second_order else 1) * count + 2
    numbers = np.asarray(values, np.float64).ravel()
    if numbers.size == 0 or numbers.size % size:
        raise InvalidInput.of("sweep_blocks", parameters=count, size=size, cases=numbers.size)
    blocks = numbers.reshape(-1, size)
    good = np.isfinite(blocks).all(axis=1)
    kept = blocks[good]
    dropped = int(len(blocks) - len(kept))
    if len(kept) < FEWEST:
        raise InvalidInput.of(
            "sweep_few_blocks", least=FEWEST, size=size, blocks=len(blocks), whole=len(kept)
        )
    spread = float(np.ptp(kept))
    if spread <= 1e-12 * float(np.abs(kept).max()):
        raise InvalidInput.of("sweep_unmoved", found=float(kept.flat[0]), cases=kept.size)
    return _estimated(kept, tuple(names), second_order, seed, dropped)


def _estimated(
    blocks: Numbers, names: tuple[str, ...], second_order: bool, seed: int, dropped: int
) -> Sensitivity:
    from SALib.analyze import sobol  # pyright: ignore[reportMissingTypeStubs]

    estimate: Any = sobol
    count = len(names)
    scaled = (blocks - blocks.mean()) / blocks.std()
    a, b = scaled[:, 0], scaled[:, -1]
    ab, ba = scaled[:, 1 : count + 1], scaled[:, count + 1 : -1]
    together = max(1, _TOGETHER // len(a))
    drawn = [
        np.random.default_rng([seed, first]).integers(
            len(a), size=(len(a), min(together, _RESAMPLES - first))
        )
        for first in range(0, _RESAMPLES, together)
    ]

    def share(function: Any, *columns: Numbers) -> Share:
        resampled = [function(*(column[some] for column in columns)) for some in drawn]
        deviation = float(np.concatenate(resampled).std(ddof=1))
        return Share(float(function(*columns)), _WIDTH * deviation)

    def closed(a: Numbers, abj: Numbers, abk: Numbers, baj: Numbers, b: Numbers) -> Any:
        first, second = estimate.first_order(a, abj, b), estimate.first_order(a, abk, b)
        return estimate.second_order(a, abj, abk, baj, b) + first + second

    alone = {n: share(estimate.first_order, a, ab[:, j], b) for j, n in enumerate(names)}
    total = {n: share(estimate.total_order, a, ab[:, j], b) for j, n in enumerate(names)}
    pairs = [(j, k) for j in range(count) for k in range(j + 1, count)] if second_order else []
    columns = {(names[j], names[k]): (a, ab[:, j], ab[:, k], ba[:, j], b) for j, k in pairs}
    return Sensitivity(
        names=names,
        alone=alone,
        total=total,
        together={pair: share(closed, *given) for pair, given in columns.items()},
        interaction={pair: share(estimate.second_order, *g) for pair, g in columns.items()},
        blocks=len(blocks),
        dropped=dropped,
    )
