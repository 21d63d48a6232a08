"""The directions in which planes come to stay, over two numbers."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import label
from kugelpendel.plot.sweeps._plane import Panel, Plane, hatched, meshed, plane
from kugelpendel.sweeps._spoken import called

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from kugelpendel.errors import Language

_COLOURS = "twilight"
"""Goes round in a circle: half a turn is the same direction as none."""

_STROKES = 14
"""Across and up, at most."""


def basins(
    dataset: Dataset,
    name: str = "final_direction",
    title: str = "",
    language: Language = "en",
) -> Figure:
    """Draw a direction without a front end over two numbers of a grid.

    Colours go round in a circle with half a turn, and strokes show the direction itself, north up,
    for whoever sees no colours. Hatched cells have none: their plane goes round, or the case is
    bad. Parameters and errors as for `values_map`.
    """
    with mpl.rc_context({**_ink.STYLE, "hatch.linewidth": 0.5}):
        drawn = plane(dataset, name, None, title or called(name, language), language)
        mesh: Any = None
        for panel in drawn.panels:
            hatched(panel.axes)
            across, up, values = meshed(panel, drawn)
            mesh = panel.axes.pcolormesh(
                across, up, np.degrees(values), cmap=_COLOURS, vmin=0, vmax=180
            )
            _strokes(drawn, panel)
        bar = drawn.figure.colorbar(mesh, ax=[panel.axes for panel in drawn.panels], pad=0.02)
        bar.set_label(f"{called(name, language)}, {label('from_east', language)}")
        bar.set_ticks([0, 45, 90, 135, 180])
        if handles := drawn.note_missing("nowhere"):
            drawn.figure.legend(handles=handles, loc="outside lower center", frameon=False)
        return drawn.figure


def _strokes(drawn: Plane, panel: Panel) -> None:
    rows, columns = (_spread(size) for size in panel.values.shape)
    angle = panel.values[np.ix_(rows, columns)]
    seen = np.isfinite(angle)
    x, y = np.meshgrid(drawn.across.values[columns], drawn.up.values[rows])
    for colour, width in (("white", 0.008), (_ink.TEXT, 0.004)):
        panel.axes.quiver(
            x[seen], y[seen], np.cos(angle[seen]), np.sin(angle[seen]), angles="uv", pivot="mid",
            headwidth=0, headlength=0, headaxislength=0, width=width, scale=24, color=colour,
        )  # fmt: skip


def _spread(size: int) -> Any:
    step = -(-size // _STROKES)
    return np.arange((size - 1) % step // 2, size, step)
