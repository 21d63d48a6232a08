"""Where something holds over two numbers: regions, with the border that another criterion draws."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import label
from kugelpendel.plot.sweeps._plane import hatched, meshed, plane
from kugelpendel.sweeps._spoken import called

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import RcKeyType
    from xarray import Dataset

    from kugelpendel.errors import Language
    from kugelpendel.parameters import Numbers

_NO, _YES = "#dceaf3", "#f0c9c2"
_LINES = "#b98d86"
_WORDS = {"stalls": ("round", "stalls"), "clamp_stalls": ("free", "held")}


def regions(
    dataset: Dataset,
    name: str,
    beside: str | None = None,
    title: str = "",
    language: Language = "en",
) -> Figure:
    """Draw where a result that is 0 or 1 holds, over two numbers of a grid.

    Parameters
    ----------
    dataset, title, language
        As for `values_map`.
    name
        Of a result that is 0 or 1: "stalls" or "clamp_stalls".
    beside
        The other of them, whose border is drawn as a line over the regions.

    Returns
    -------
    A figure; where the result holds is tinted and hatched. Errors as in `values_map`.
    """
    style: dict[RcKeyType, Any] = {
        **_ink.STYLE,
        "hatch.color": _LINES,
        "hatch.linewidth": 0.6,
    }
    with mpl.rc_context(style):
        drawn = plane(dataset, name, None, title or called(name, language), language)
        tints = ListedColormap([_NO, _YES])
        for panel in drawn.panels:
            hatched(panel.axes)
            across, up, values = meshed(panel, drawn)
            panel.axes.pcolormesh(across, up, values, cmap=tints, vmin=0, vmax=1)
            _hatch(panel.axes, across, up, values)
            if beside is not None:
                other = drawn.other(beside, panel)
                if np.ptp(other[np.isfinite(other)]) > 0:
                    panel.axes.contour(
                        drawn.across.values, drawn.up.values, other, [0.5],
                        colors=_ink.TEXT, linewidths=1.8, linestyles="--",
                    )  # fmt: skip
        no, yes = (label(key, language) for key in _WORDS[name])
        handles: list[Artist] = [
            Patch(facecolor=_NO, edgecolor=_ink.QUIET, label=no),
            Patch(facecolor=_YES, edgecolor=_LINES, hatch="///", label=yes),
            *drawn.note_missing(),
        ]
        if beside is not None:
            said = label("border", language)
            line = Line2D([], [], color=_ink.TEXT, linewidth=1.8, linestyle="--", label=said)
            handles.append(line)
        drawn.figure.legend(handles=handles, loc="outside lower center", ncols=4, frameon=False)
        return drawn.figure


def _hatch(axes: Axes, across: Numbers, up: Numbers, values: Numbers) -> None:
    """Hatch the cells in which it holds, for whoever sees no tint."""
    rows, columns = np.nonzero(np.ma.filled(values, 0.0) > 0.5)
    cells = [
        (
            (across[k], up[j]),
            (across[k + 1], up[j]),
            (across[k + 1], up[j + 1]),
            (across[k], up[j + 1]),
        )
        for j, k in zip(rows, columns, strict=True)
    ]
    held = PolyCollection(cells, facecolors="none", edgecolors=_LINES, linewidths=0, hatch="///")
    axes.add_collection(held, autolim=False)
