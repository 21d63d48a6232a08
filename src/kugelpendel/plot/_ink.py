"""Colours and line styles, told apart with any colour vision and in grey print."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from io import BytesIO
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from kugelpendel.spelling import unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.typing import RcKeyType
    from numpy.typing import NDArray

OUTER = "#b8443a"
INNER = "#2a6f97"
QUIET = "#8a8f98"
TEXT = "#22262e"

# The light end of viridis is lost on white paper.
TIME = LinearSegmentedColormap.from_list(
    "viridis on white", mpl.colormaps["viridis"](np.linspace(0.0, 0.92, 256))
)

STYLE: dict[RcKeyType, Any] = {
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.labelcolor": TEXT,
    "axes.edgecolor": QUIET,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-4, 5),
    "legend.fontsize": 9,
    "svg.hashsalt": "kugelpendel",
    "svg.fonttype": "none",
}
"""What every figure of this package is drawn with."""

_FEW = 5
"""Fewer points than these are drawn as points: a line between them would be invented."""

_COLOURS = 128
"""Lengths of one colour along the path: enough to look continuous, few enough for a small SVG."""


class Picture(Figure):
    """A figure of matplotlib without a window or a global state, which a notebook shows at once."""

    def _repr_png_(self) -> bytes:
        file = BytesIO()
        with mpl.rc_context(STYLE):
            self.savefig(file, format="png")
        return file.getvalue()


def blank(width: float, height: float, *, w_pad: float = 0.12, h_pad: float = 0.1) -> Picture:
    """A figure of that size in inches, laid out so that nothing overlaps."""
    engine = ConstrainedLayoutEngine(w_pad=w_pad, h_pad=h_pad)
    figure = Picture(figsize=(width, height), layout=engine, dpi=130)
    FigureCanvasAgg(figure)
    return figure


def draw_curve(
    axes: Axes, x: NDArray[np.float64], y: NDArray[np.float64], style: str = "-", **options: Any
) -> None:
    """Draw a curve through its points; fewer than five of them are not joined."""
    if len(x) < _FEW:
        style = "o"
        options = {"markersize": 4, **options}
    axes.plot(x, y, style, **options)


class Timeline:
    """The colours of time, from 0 to the last time drawn.

    Parameters
    ----------
    until
        Last time, s.
    """

    def __init__(self, until: float) -> None:
        self.unit = unit_for(until, "s")
        self._norm = Normalize(0, until / self.unit.size)

    def draw(self, axes: Axes, pieces: list[NDArray[np.float64]]) -> LineCollection:
        """Draw lines coloured by time.

        Parameters
        ----------
        axes
            Where to draw.
        pieces
            Time in s, and the point in the units of the axes.
        """
        segments = sum(len(piece) - 1 for piece in pieces)
        step = max(4, math.ceil(segments / _COLOURS))
        lines: list[NDArray[np.float64]] = []
        times: list[float] = []
        for piece in pieces:
            for first in range(0, len(piece) - 1, step):
                run = piece[first : first + step + 1]
                lines.append(run[:, 1:])
                times.append(float(run[:, 0].mean()) / self.unit.size)
        drawn = LineCollection(lines, cmap=TIME, norm=self._norm, linewidths=1.1)
        drawn.set_capstyle("round")
        drawn.set_array(np.asarray(times))
        axes.add_collection(drawn)
        return drawn
