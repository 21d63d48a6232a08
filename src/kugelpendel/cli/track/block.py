"""A stretch of a track: what is known at some of its times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kugelpendel import ExactMotion

COLUMNS = {
    "time": "s",
    "x": "m",
    "y": "m",
    "z": "m",
    "vx": "m/s",
    "vy": "m/s",
    "vz": "m/s",
    "tension": "N",
}
"""Columns of a track as a table, with their units."""


@dataclass(frozen=True)
class Block:
    """Part of a track.

    Attributes
    ----------
    first
        Index of its first sample.
    time, tension
        s, N.
    position, velocity
        m, m/s.
    """

    first: int
    time: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    tension: NDArray[np.float64]

    @classmethod
    def of(cls, motion: ExactMotion, first: int, time: NDArray[np.float64]) -> Block:
        """Ask one motion about some times."""
        return cls(first, time, motion.position(time), motion.velocity(time), motion.tension(time))

    def columns(self) -> list[NDArray[np.float64]]:
        """The columns of the table, in the order of `COLUMNS`."""
        return [self.time, *self.position.T, *self.velocity.T, self.tension]
