"""Colours, line styles and names, told apart with any colour vision and in grey print."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
import textwrap
from io import BytesIO
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from kugelpendel.parameters import InvalidInput, as_numbers
from kugelpendel.spelling import as_given, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.typing import RcKeyType
    from numpy.typing import NDArray

    from kugelpendel.parameters import Pendulum

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

_APART = 0.045
"""Least distance of two names, as a fraction of the height of the axes."""

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


def require_text(title: str) -> None:
    """Raise InvalidInput for a title that is no text."""
    if not isinstance(title, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(
            f"The title of a figure must be text, but it is {title!r:.60} of type "
            f"{type(title).__name__}; write it in quotes."
        )


def entitle(figure: Figure, title: str, width: int) -> None:
    """Write a title above the figure, in lines of so many signs, beginning with a capital.

    Raises InvalidInput for what is no text.
    """
    require_text(title)
    if title:
        lines = textwrap.fill(title[:1].upper() + title[1:], width)
        # A dollar sign or an underscore of a file's name is no formula.
        figure.suptitle(lines, fontsize=13, color=TEXT, parse_math=False)


def one_number(name: str, value: float, unit: str) -> float:
    """What is asked for of a figure as a single number; raises InvalidInput for anything else."""
    number = as_numbers(value, name, unit)
    if not isinstance(number, float):
        raise InvalidInput(
            f"{name} must be one number in {unit}, but it is an array of shape {np.shape(number)}; "
            f"draw one figure for each."
        )
    return number


def naming(title: str, pendulum: Pendulum, a: float, b: float) -> str:
    """A title that ends with which pendulum and which swing it is; raises as `entitle`."""
    require_text(title)
    swing = f"{as_given(float(pendulum.length), 'm')}, a = {as_given(a, 'm')}"
    width = f", b = {as_given(b, 'm')}" if b else ""
    return f"{title}: {swing}{width}" if title else f"{swing}{width}"


def name_ends(axes: Axes, ends: list[tuple[float, float, str, str]], size: float = 9.5) -> None:
    """Write the name of each line beside the axes, moved up or down where two would meet.

    Parameters
    ----------
    axes
        Where they are drawn, with its limits set.
    ends
        Where each line ends, as fractions of the axes' width and height, its name and colour.
    size
        Of the letters, points.
    """
    ends = sorted(ends, key=lambda end: end[1])
    places = _spread(np.array([height for _, height, _, _ in ends]))
    for (across, height, name, colour), place in zip(ends, places, strict=True):
        axes.annotate(
            name,
            xy=(across, height),
            xytext=(1.03, float(place)),
            xycoords="axes fraction",
            textcoords="axes fraction",
            color=colour,
            fontsize=size,
            va="center",
            arrowprops={
                "arrowstyle": "-",
                "color": colour,
                "linewidth": 0.8,
                "linestyle": ":",
                "relpos": (0, 0.5),
            },
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
