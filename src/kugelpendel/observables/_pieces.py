"""Positions in pieces, so that somebody hears how far the work is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kugelpendel.motion import Motion
from kugelpendel.parameters import Numbers

_PIECES = 50
"""After each of which somebody is told."""


@dataclass
class Told:
    """Who is told of the work, how many positions it has, and how many are worked out.

    Attributes
    ----------
    done
        Told how many of how many; None for nobody.
    """

    done: Callable[[int, int], None] | None
    total: int
    taken: int = 0

    def positions(self, motion: Motion, times: Numbers) -> Numbers:
        """Positions of a single motion at times in order, m: shape (n, 3)."""
        found: list[Numbers] = []
        for piece in np.array_split(times, _PIECES):
            found.append(motion.position(piece))
            self.taken += len(piece)
            if self.done is not None:
                self.done(self.taken, self.total)
        return np.concatenate(found)
