"""The plan view: the path seen from above, between its exact turning circles."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.spelling import significant, spell, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection
    from numpy.typing import NDArray

    from kugelpendel.observables import IdealSummary
    from kugelpendel.plot._ink import Timeline
    from kugelpendel.plot._path import Path

_NARROW = 1 / 8
"""A path that is thinner than this has a second view, stretched sideways."""


def draw_plan(axes: Axes, known: IdealSummary, path: Path, timeline: Timeline) -> LineCollection:
    """Draw the path from above, x to the right and y up, to one scale."""
    points = path.points
    reach = max(known.outer, known.inner, float(np.hypot(points[:, 1], points[:, 2]).max()))
    if known.rises_above:
        reach = known.length
    reach = reach or 1e-3 * known.length
    unit = unit_for(reach, "m")
    lines = _draw(axes, path, timeline, np.eye(2), (unit.size, unit.size))
    if known.rises_above:
        _circle(axes, known.length, unit.size, color=_ink.QUIET, linestyle=":", label="the sphere")
    _draw_circles(axes, known, unit.size)
    axes.plot(0, 0, "+", color=_ink.TEXT, markersize=7, zorder=4)
    start = points[0]
    axes.plot(
        start[1] / unit.size,
        start[2] / unit.size,
        "o",
        markersize=6,
        markerfacecolor="white",
        markeredgecolor=_ink.TEXT,
        zorder=5,
        label="start",
    )
    limit = 1.08 * reach / unit.size
    axes.set(
        xlim=(-limit, limit),
        ylim=(-limit, limit),
        aspect="equal",
        xlabel=f"x ({unit.symbol})",
        ylabel=f"y ({unit.symbol})",
        title="From above",
    )
    if is_narrow(path):
        # Beside the square there is room enough; the layout must not make more.
        legend = axes.legend(
            loc="center left", bbox_to_anchor=(1.02, 0.5), frameon=False, handlelength=1.4
        )
        legend.set_in_layout(False)
    else:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=2, frameon=False)
    return lines


def is_narrow(path: Path) -> bool:
    """Whether the path is so thin that the plan view shows a mere line."""
    along, across = _extents(path)
    return 1e-12 * along < across < _NARROW * along


def draw_stretched(axes: Axes, known: IdealSummary, path: Path, timeline: Timeline) -> None:
    """Draw a narrow path again, along and across its first direction, stretched across."""
    along, across = _extents(path)
    factor = float(f"{0.5 * along / across:.1e}")
    horizontal, vertical = unit_for(along, "m"), unit_for(across, "m")
    sizes = (horizontal.size, vertical.size)
    _draw(axes, path, timeline, path.turn, sizes)
    edge = np.linspace(-1.2, 1.2, 121) * across
    for side in (-1, 1):
        axes.plot(
            side * np.sqrt(np.maximum(known.outer**2 - edge**2, 0)) / horizontal.size,
            edge / vertical.size,
            "--",
            color=_ink.OUTER,
            linewidth=1.2,
        )
    angle = np.linspace(0, 2 * math.pi, 181)
    axes.plot(
        known.inner * np.cos(angle) / horizontal.size,
        known.inner * np.sin(angle) / vertical.size,
        "-",
        color=_ink.INNER,
        linewidth=1.6,
        zorder=4,
    )
    limit = 1.08 * along / horizontal.size
    edge_limit = 1.2 * across / vertical.size
    axes.set(
        xlim=(-limit, limit),
        ylim=(-edge_limit, edge_limit),
        xlabel=f"along the first swing ({horizontal.symbol})",
        ylabel=f"across ({vertical.symbol})",
        title=f"The same, stretched {significant(factor, 2)}-fold across",
        aspect=factor * vertical.size / horizontal.size,
    )


def _draw_circles(axes: Axes, known: IdealSummary, size: float) -> None:
    """Draw the exact turning circles, with their radii as labels; a mere point is left out."""
    if known.is_cone:
        circles = [(known.outer, _ink.OUTER, "--", "circle of radius")]
    else:
        names = ("highest", "lowest") if known.rises_above else ("outer", "inner")
        circles = [
            (known.outer, _ink.OUTER, "--", f"{names[0]} turning circle,"),
            (known.inner, _ink.INNER, "-", f"{names[1]} turning circle,"),
        ]
    for radius, colour, style, name in circles:
        if radius > 1e-9 * max(known.outer, known.inner):
            label = f"{name} {spell(radius, 'm')}"
            _circle(axes, radius, size, color=colour, linestyle=style, label=label)


def _draw(
    axes: Axes,
    path: Path,
    timeline: Timeline,
    turn: NDArray[np.float64],
    sizes: tuple[float, float],
) -> LineCollection:
    return timeline.draw(
        axes,
        [
            np.column_stack([piece[:, 0], piece[:, 1:3] @ turn.T / np.asarray(sizes)])
            for piece in path.pieces
        ],
    )


def _extents(path: Path) -> tuple[float, float]:
    seen = np.abs(path.points[:, 1:3] @ path.turn.T).max(axis=0)
    return float(seen[0]), float(seen[1])


def _circle(axes: Axes, radius: float, size: float, **style: str) -> None:
    angle = np.linspace(0, 2 * math.pi, 361)
    axes.plot(
        radius * np.cos(angle) / size,
        radius * np.sin(angle) / size,
        linewidth=1.3,
        zorder=3,
        **style,  # pyright: ignore[reportArgumentType]
    )
