"""A result over two numbers, as colours and contours."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import LogLocator, MaxNLocator

from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import with_unit
from kugelpendel.plot.sweeps._plane import Panel, Plane, hatched, meshed, plane, time_of, unit_in
from kugelpendel.spelling import general
from kugelpendel.sweeps._spoken import called, called_after

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray
    from xarray import Dataset

    from kugelpendel.errors import Language

_CONTOURS = 7

_FAR = 300.0
"""Of the largest value to the least, above zero, from which on colours are logarithmic."""

_FEWEST = 4
"""Levels each way below which contours would be invented."""


def values_map(
    dataset: Dataset,
    name: str,
    time: float | None = None,
    title: str = "",
    language: Language = "en",
) -> Figure:
    """Draw a result of a grid over the two numbers that have the most levels.

    Parameters
    ----------
    dataset
        Of a grid, with a dimension for each number that varies.
    name
        Of a result that is a number.
    time
        s; of what is read at several times, the one that is drawn, and the last unless given.
    title
        Above the figure; what is drawn stands there unless given.
    language
        Of the labels.

    Returns
    -------
    A figure of matplotlib, as from all functions of `kugelpendel.plot`. Cells are cases, lines are
    contours between them, cells without an answer are hatched. A third number goes from panel to
    panel, with six of its levels at most.

    Raises
    ------
    InvalidInput
        For what is no grid over two numbers.
    """
    with mpl.rc_context({**_ink.STYLE, "hatch.linewidth": 0.5}):
        usual = called_after(name, time_of(dataset, name, time), language)
        drawn = plane(dataset, name, time, title or usual, language)
        shown = np.concatenate([panel.values.ravel() for panel in drawn.panels])
        shown = shown[np.isfinite(shown)]
        unit = unit_in(dataset, name, shown)
        norm = _norm(shown / unit.size)
        mesh: Any = None
        for panel in drawn.panels:
            mesh = _draw(drawn, panel, unit.size, norm)
        bar = drawn.figure.colorbar(mesh, ax=[panel.axes for panel in drawn.panels], pad=0.02)
        bar.set_label(with_unit(called(name, language), unit.symbol))
        if handles := drawn.note_missing():
            drawn.figure.legend(handles=handles, loc="outside lower center", frameon=False)
        return drawn.figure


def _norm(shown: NDArray[np.float64]) -> Normalize:
    """From the least to the largest value; in the logarithm where they are far apart."""
    low, high = (float(shown.min()), float(shown.max())) if shown.size else (0.0, 1.0)
    return LogNorm(low, high) if 0 < low * _FAR < high else Normalize(low, high)


def _draw(drawn: Plane, panel: Panel, size: float, norm: Normalize) -> Any:
    hatched(panel.axes)
    across, up, values = meshed(panel, drawn)
    values = values / size
    mesh = panel.axes.pcolormesh(across, up, values, cmap=_ink.TIME, norm=norm)
    levels = _levels(norm)
    if min(values.shape) >= _FEWEST and levels.size:
        with np.errstate(invalid="ignore"):
            lines = panel.axes.contour(
                drawn.across.values, drawn.up.values, values, levels,
                colors="white", linewidths=1.1, linestyles="solid",
            )  # fmt: skip

        def said(level: float) -> str:
            return general(level, 4, language=drawn.language)

        for line in panel.axes.clabel(lines, fmt=said, fontsize=8):
            line.set_color(_ink.TEXT)
            line.set_bbox({"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 1})
    return mesh


def _levels(norm: Normalize) -> NDArray[np.float64]:
    low, high = float(norm.vmin or 0.0), float(norm.vmax or 0.0)
    locator = LogLocator(numticks=_CONTOURS) if isinstance(norm, LogNorm) else None
    levels = np.asarray((locator or MaxNLocator(_CONTOURS)).tick_values(low, high))
    return levels[(levels > low) & (levels < high)]
