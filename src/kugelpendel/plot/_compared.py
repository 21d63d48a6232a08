"""How far each motion goes astray: errors of position against time, on a logarithmic scale."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from itertools import cycle
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter

from kugelpendel.observables import Comparison
from kugelpendel.parameters import require_type
from kugelpendel.plot import _ink
from kugelpendel.spelling import spell, unit_for

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

_LOWEST = 1e-17
"""What is smaller than this fraction of the amplitude is drawn there."""

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

    Raises
    ------
    InvalidInput
        For what is no comparison, and a title that is no text.
    """
    require_type("What is drawn", comparison, Comparison, way_out="write kp.compare(…)")
    _ink.require_text(title)
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(9.5, 5.6)
        axes = figure.add_subplot()
        duration = _last_known(comparison)
        clock = unit_for(duration, "s")
        scale = comparison.amplitude or 1.0
        few = _half_swings(comparison, duration) <= _FEW
        what = "error of the position" if few else "largest error in a half swing"
        ends: list[tuple[float, float, str, str]] = []
        for row, (colour, dashes) in zip(comparison.rows, cycle(_LINES), strict=False):
            if row.errors is None:
                continue
            errors = np.maximum(row.errors / scale, _LOWEST)
            times, largest = _envelope(comparison, errors)
            _ink.draw_curve(axes, times / clock.size, largest, dashes, color=colour, linewidth=1.7)
            across = float(times[-1]) / duration
            ends.append((across, float(largest[-1]), f"{row.name}  {row.equation}", colour))
        axes.set(
            yscale="log",
            xlim=(0, duration / clock.size),
            xlabel=f"time ({clock.symbol})",
            ylabel=f"{what}, as a fraction of {spell(scale, 'm')}",
        )
        _ink.entitle(figure, title or "Errors of position against the exact motion", 95)
        low, high = axes.get_ylim()
        axes.set_ylim(max(low / 2, _LOWEST / 3), min(high * 2, 10))
        axes.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 2.5, 5, 10]))
        axes.yaxis.set_major_locator(LogLocator(numticks=12))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.grid(axis="y", which="major", color=_ink.QUIET, alpha=0.25, linewidth=0.8)
        low, high = np.log10(axes.get_ylim())
        heights = [(math.log10(value) - low) / (high - low) for _, value, _, _ in ends]
        _ink.name_ends(axes, [(e[0], h, *e[2:]) for e, h in zip(ends, heights, strict=True)])
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
