"""The side view: height over the distance along the first swing."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.spelling import unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from kugelpendel.observables import IdealSummary
    from kugelpendel.plot._ink import Timeline
    from kugelpendel.plot._path import Path

_WIDE = math.radians(25)
"""From this angle on the whole sphere is shown to one scale; below, heights are stretched."""


def draw_side(axes: Axes, known: IdealSummary, path: Path, timeline: Timeline) -> None:
    """Draw the path from the side, with the turning heights."""
    length = known.length
    along = [piece[:, 1:3] @ path.turn[0] for piece in path.pieces]
    top = max(float(path.points[:, 3].max()), known.high)
    reach = max(float(np.abs(np.concatenate(along)).max()), 1e-3 * length if top == 0 else 0.0)
    wide = top > length * (1 - math.cos(_WIDE))
    horizontal = unit_for(length if wide else reach, "m")
    vertical = horizontal if wide else unit_for(top, "m")
    seen = [
        np.column_stack([piece[:, 0], x / horizontal.size, piece[:, 3] / vertical.size])
        for x, piece in zip(along, path.pieces, strict=True)
    ]
    # On a cone both are one height, told by the colour of the one circle in the plan view.
    heights = ((known.high, _ink.OUTER, "--"), (known.low, _ink.INNER, "-"))
    for turning, colour, style in heights[: 1 if known.is_cone else 2]:
        level = turning / vertical.size
        axes.axhline(level, color=colour, linestyle=style, linewidth=1.2, zorder=0.5)
    timeline.draw(axes, seen)
    axes.set(
        xlabel=f"along the first swing ({horizontal.symbol})",
        ylabel=f"height ({vertical.symbol})",
    )
    if wide:
        _draw_sphere(axes, length / horizontal.size, seen[0][0, 1:])
        axes.set(title="From the side", aspect="equal")
    else:
        limit = 1.08 * reach / horizontal.size
        margin = 0.08 * (top / vertical.size or 1.0)
        axes.set(
            xlim=(-limit, limit),
            ylim=(-margin, top / vertical.size + margin),
            title="From the side, heights stretched" if top else "From the side",
        )


def _draw_sphere(axes: Axes, radius: float, start: NDArray[np.float64]) -> None:
    angle = np.linspace(0, 2 * math.pi, 361)
    outline = (radius * np.sin(angle), radius * (1 - np.cos(angle)))
    axes.plot(*outline, ":", color=_ink.QUIET, linewidth=1.2, zorder=0)
    axes.plot([0, start[0]], [radius, start[1]], color=_ink.TEXT, linewidth=0.9, zorder=3)
    axes.plot(0, radius, "+", color=_ink.TEXT, markersize=7, zorder=4)
    axes.plot(*start, "o", markersize=6, markerfacecolor="white", markeredgecolor=_ink.TEXT)
    axes.set(xlim=(-1.1 * radius, 1.1 * radius), ylim=(-0.1 * radius, 2.1 * radius))
