"""The part of a motion that a figure shows: as much as an eye can tell apart, well resolved."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.spelling import spell

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kugelpendel.motion import Motion
    from kugelpendel.observables import IdealSummary

_ALL = 30
"""Up to so many swings are drawn one and all."""

_CHOSEN = 16
"""Of more than that, so many are drawn, evenly spread."""

_POINTS = 120
"""Points a turn of the phase or of the thread: chords that cannot be told from the curve."""


@dataclass(frozen=True)
class Path:
    """Positions to draw, swing after swing.

    Attributes
    ----------
    pieces
        Time in s, x, y and height above the lowest point in m: an (n, 4) array for each unbroken
        piece.
    until
        Time of the last point, s.
    caption
        Which part of the motion this is; empty for all of it.
    """

    pieces: list[NDArray[np.float64]]
    until: float
    caption: str

    @property
    def points(self) -> NDArray[np.float64]:
        """All points, shape (n, 4)."""
        return np.concatenate(self.pieces)

    @property
    def turn(self) -> NDArray[np.float64]:
        """Rotation of the plan view, shape (2, 2), after which the first swing goes along x.

        Towards the start if no point is farther out, else towards the farthest point.
        """
        first = self.pieces[0]
        distance = np.hypot(first[:, 1], first[:, 2])
        farthest = 0 if distance[0] >= (1 - 1e-6) * distance.max() else int(np.argmax(distance))
        azimuth = math.atan2(first[farthest, 2], first[farthest, 1])
        cosine, sine = math.cos(azimuth), math.sin(azimuth)
        return np.array([[cosine, sine], [-sine, cosine]])


def visible_path(motion: Motion, known: IdealSummary, duration: float) -> Path:
    """Choose and sample what is worth drawing of the first ``duration`` seconds.

    After half a turn of the ellipse the rosette is closed, and further swings would only cover the
    first ones; between two neighbours of more than `_ALL` swings no eye sees a gap.
    """
    swing = known.swing_period
    half_turn = abs(math.pi / known.precession) if known.precession else math.inf
    window = min(duration, max(half_turn, 12 * swing))
    part = f"the first {spell(window, 's', 3)} of {spell(duration, 's', 3)}"
    caption = "" if window == duration else part
    if window <= _ALL * swing:
        return Path([_sampled(motion, known, 0.0, window)], window, caption)
    starts = np.linspace(0.0, window - swing, _CHOSEN)
    some = f"{_CHOSEN} of {round(window / swing)} swings"
    return Path(
        [_sampled(motion, known, start, start + swing) for start in starts],
        window,
        f"{some}, {caption}" if caption else some,
    )


def _sampled(motion: Motion, known: IdealSummary, start: float, stop: float) -> NDArray[np.float64]:
    turns = (stop - start) * known.fastest / (2 * math.pi)
    count = min(max(math.ceil(turns * _POINTS), 48), 40_000) + 1
    times = np.linspace(start, stop, count)
    position = motion.position(times)
    return np.column_stack([times, position[:, :2], _height(motion, position)])


def _height(motion: Motion, position: NDArray[np.float64]) -> NDArray[np.float64]:
    """Height above the lowest point of the sphere, m.

    Below the support it follows from the distance to the vertical, since l − z has no digits left
    for small swings.
    """
    length = float(motion.effective_pendulum.length)
    x, y, z = position.T
    below = (x * x + y * y) / (length + np.maximum(z, 0.0))
    return np.asarray(np.where(z > 0, below, length - z), dtype=np.float64)
