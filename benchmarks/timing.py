"""Paired timing: the contenders take turns, so that a slow moment hits all of them."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Timings:
    """Seconds per round, one tuple per contender; entry i of each was taken in the same round."""

    rounds: Mapping[str, tuple[float, ...]]

    def seconds(self, name: str) -> float:
        """Median time of one contender."""
        return statistics.median(self.rounds[name])

    def ratio(self, name: str, peer: str, scale: float = 1.0) -> float:
        """Median over the rounds of ``name / (peer · scale)``."""
        pairs = zip(self.rounds[name], self.rounds[peer], strict=True)
        return statistics.median(ours / (theirs * scale) for ours, theirs in pairs)


def paired(contenders: Mapping[str, Callable[[], object]], rounds: int, warm: int = 1) -> Timings:
    """Time the contenders in turn, ``rounds`` times, after ``warm`` rounds that do not count.

    Every second round runs in reverse order. Results are dropped outside the timed part, and the
    cyclic garbage collector is off inside it.
    """
    names = list(contenders)
    taken: dict[str, list[float]] = {name: [] for name in names}
    enabled = gc.isenabled()
    for turn in range(-warm, rounds):
        for name in names if turn % 2 == 0 else reversed(names):
            gc.collect()
            gc.disable()
            start = time.perf_counter()
            result = contenders[name]()
            elapsed = time.perf_counter() - start
            del result
            if enabled:
                gc.enable()
            if turn >= 0:
                taken[name].append(elapsed)
    return Timings({name: tuple(times) for name, times in taken.items()})
