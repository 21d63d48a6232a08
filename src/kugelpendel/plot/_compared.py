"""How far each motion goes astray: errors of position against time, on a logarithmic scale."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
import textwrap
from itertools import cycle
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter

from kugelpendel.plot import _ink
from kugelpendel.spelling import spell, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from kugelpendel import Comparison

_LOWEST = 1e-17
"""What is smaller than this fraction of the amplitude is drawn there."""

_APART = 0.045
"""Least distance of two labels, as a fraction of the height of the axes."""

_FEW = 3
"""Up to so many half swings the errors are drawn as they are, of more their largest in each."""

_LINES = tuple(
    zip(
        ("#8a8f98", "#b8443a", "#c98a1b", "#3b7d4f", "#2a6f97", "#6a4c93", "#22262e"),
        ("-", "--", "-", "-.", "-", "--", ":"),
        strict=True,
    )
)
"""Colour and dashes of each motion; where two colours look alike to some, the dashes differ."""


def compared(comparison: Comparison, title: str = "") -> Figure:
    """Draw the error of each motion's position against time, as a fraction of the amplitude.

    Parameters
    ----------
    comparison
        Of all motions from one launch; those that do not hold are named below the axes.
    title
        A line above the figure.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it.
    """
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(9.5, 5.6)
        axes = figure.add_subplot()
        duration = _last_known(comparison)
        clock = unit_for(duration, "s")
        scale = comparison.amplitude or 1.0
        few = _half_swings(comparison, duration) <= _FEW
        what = "error of the position" if few else "largest error in a half swing"
        ends: list[tuple[float, str, str]] = []
        for row, (colour, dashes) in zip(comparison.rows, cycle(_LINES), strict=False):
            if row.errors is None:
                continue
            errors = np.maximum(row.errors / scale, _LOWEST)
            times, largest = _envelope(comparison, errors)
            _ink.draw_curve(axes, times / clock.size, largest, dashes, color=colour, linewidth=1.7)
            ends.append((float(largest[-1]), f"{row.name}  {row.equation}", colour))
        axes.set(
            yscale="log",
            xlim=(0, duration / clock.size),
            xlabel=f"time ({clock.symbol})",
            ylabel=f"{what}, as a fraction of {spell(scale, 'm')}",
        )
        figure.suptitle(
            textwrap.fill(title or "Errors of position against the exact motion", 90),
            fontsize=12,
            color=_ink.TEXT,
        )
        low, high = axes.get_ylim()
        axes.set_ylim(max(low / 2, _LOWEST / 3), min(high * 2, 10))
        axes.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 2.5, 5, 10]))
        axes.yaxis.set_major_locator(LogLocator(numticks=12))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.grid(axis="y", which="major", color=_ink.QUIET, alpha=0.25, linewidth=0.8)
        _label(axes, ends)
        missing = [row.name for row in comparison.rows if row.errors is None]
        if not ends:
            axes.set_axis_off()
            says = "Only the exact motion holds for this launch."
            axes.text(0.5, 0.5, says, transform=axes.transAxes, ha="center", fontsize=11)
        elif missing:
            says = f"Not drawn, as they do not hold for this launch: {', '.join(missing)}."
            figure.supxlabel(says, fontsize=9, color=_ink.TEXT)
    return figure


def _last_known(comparison: Comparison) -> float:
    """When the last motion ends, or the comparison does, s."""
    times = comparison.times
    ends = [times[~np.isnan(row.errors)][-1] for row in comparison.rows if row.errors is not None]
    return float(max(ends, default=times[-1]))


def _envelope(
    comparison: Comparison, errors: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The largest error in each half swing, where it is: within one it goes up and down."""
    times = comparison.times
    known = ~np.isnan(errors)
    times, errors = times[known], errors[known]
    bins = _half_swings(comparison, float(times[-1]))
    if bins <= _FEW:
        return times, errors
    parts = [part for part in np.array_split(np.arange(len(times)), min(bins, 600)) if part.size]
    largest = [part[errors[part].argmax()] for part in parts]
    return times[largest], errors[largest]


def _half_swings(comparison: Comparison, duration: float) -> int:
    half_swing = float(comparison.exact.radial_period)
    return math.floor(duration / half_swing) if half_swing < math.inf else 0


def _label(axes: Axes, ends: list[tuple[float, str, str]]) -> None:
    """Write each line's name at its right end, moved up or down where two would meet."""
    low, high = np.log10(axes.get_ylim())
    ends = sorted(ends)
    wanted = np.array([(math.log10(value) - low) / (high - low) for value, _, _ in ends])
    places = _spread(wanted)
    for (_, text, colour), want, place in zip(ends, wanted, places, strict=True):
        axes.annotate(
            text,
            xy=(1, float(want)),
            xytext=(1.03, float(place)),
            xycoords="axes fraction",
            textcoords="axes fraction",
            color=colour,
            fontsize=9.5,
            va="center",
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.8, "relpos": (0, 0.5)},
        )


def _spread(wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    """The sorted places, moved as little as it takes to lie `_APART`."""
    groups: list[list[float]] = []
    for place in wanted:
        groups.append([float(place)])
        while len(groups) > 1:
            above, below = groups[-1], groups[-2]
            reach = (len(above) + len(below)) / 2 * _APART
            if np.mean(above) - np.mean(below) >= reach:
                break
            groups[-2:] = [below + above]
    return np.concatenate(
        [
            np.mean(group) + _APART * (np.arange(len(group)) - (len(group) - 1) / 2)
            for group in groups
        ]
        or [np.empty(0)]
    )
