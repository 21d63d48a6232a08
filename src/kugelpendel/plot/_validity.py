"""The map of how good the formulas for small ellipses are, with lines of equal error."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeAlias

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import FuncFormatter, NullFormatter

from kugelpendel.observables import LEVELS, ValidityMap
from kugelpendel.parameters import InvalidInput, as_numbers, require_type
from kugelpendel.plot import _ink

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from kugelpendel.parameters import Scalars

_FLOOR = 1e-16
"""Errors of less than that are rounding."""

_MIDDLE = 0.1
"""a/l in the middle of a large map."""

_HIGH = 0.8
"""b/a from which on a name stands below its mark."""

_LEFT = 0.01
"""a/l at the left edge of a large map."""

_LARGE, _SMALL = (5.6, 3.1), (1.8, 2.3)
"""Width and height of the maps, about, inches."""

_SIGN = (0.13, 0.35)
"""Inches that a name takes, for each of its signs across, with its distance from the mark."""

_AROUND = 0.32
"""Inches around its middle that a label takes, with the mark's half."""

_SHIFTS = (0.0, 0.05, 0.1, 0.15, 0.2, 0.25)
_LOWEST, _HIGHEST = 0.12, 0.92
"""By how much of the map's height a label may be moved, and where it then still fits."""

_MARGIN = 0.08
"""A line that is nearer to the left edge of a small map than this has no label."""

_Box: TypeAlias = tuple[float, float, float, float]
"""Left, low, right and high edge, inches."""

# From good to bad, light enough for the lines and labels on them.
_BANDS = ("#dceaf3", "#d3e8d6", "#f7eec8", "#f5d3ac", "#e8ab9f")


def validity(
    errors: ValidityMap, mark: tuple[float, float] | None = None, name: str = ""
) -> Figure:
    """Draw how good (25), (26) and the series of each order are, over all ellipses.

    Parameters
    ----------
    errors
        From `validity_map`.
    mark
        a/l and b/a of a pendulum to mark.
    name
        What to call it.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it.

    Raises
    ------
    InvalidInput
        For what is no map, a mark that is not two numbers within it, and a name that is no text.
    """
    require_type("What is drawn", errors, ValidityMap, way_out="write kp.validity_map()")
    if mark is not None:
        _check(mark)
    series = errors.errors.series
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(12.5, 10.5, w_pad=0.06, h_pad=0.08)
        halves = figure.add_gridspec(2, 1, height_ratios=(1.3, 2))
        top, bottom = halves[0].subgridspec(1, 2), halves[1].subgridspec(2, len(series))
        large = (
            ("Precession by the formula (25)", errors.errors.formula_25),
            ("Frequency by the formula (26)", errors.errors.formula_26),
        )
        for column, (title, error) in enumerate(large):
            axes = figure.add_subplot(top[0, column])
            _draw(axes, errors, error, mark, name, large=True)
            axes.set(title=title, xlabel="a/l")
            _name_rows(axes, column)
        for column, (order, pair) in enumerate(series.items()):
            for line, what in enumerate(("Precession", "Frequency")):
                axes = figure.add_subplot(bottom[line, column])
                _draw(axes, errors, pair[line], mark, "", large=False)
                axes.set_title(f"{what}, order {order}", fontsize=10)
                _name_rows(axes, column)
                if line:
                    axes.set_xlabel("a/l")
        _ink.entitle(
            figure,
            "How good are the formulas for small ellipses?  "
            "Relative errors; a, b: turning radii, l: length",
            110,
        )
    return figure


def _check(mark: tuple[float, float]) -> None:
    """Raise InvalidInput for a mark that does not lie on the map."""
    numbers = np.atleast_1d(as_numbers(mark, "mark", ""))
    if numbers.shape == (2,) and 0 < numbers[0] < 1 and 0 <= numbers[1] <= 1:
        return
    raise InvalidInput(
        f"A mark is a pair of a/l between 0 and 1 and b/a from 0 to 1, but it is {mark!r:.60}; "
        f"write mark=(a / l, b / a)."
    )


def _name_rows(axes: Axes, column: int) -> None:
    if column:
        axes.yaxis.set_major_formatter(NullFormatter())
    else:
        axes.set_ylabel("b/a")


def _spelled(value: float, _: object) -> str:
    return f"{value:g}"


def _draw(
    axes: Axes,
    errors: ValidityMap,
    error: Scalars,
    mark: tuple[float, float] | None,
    name: str,
    *,
    large: bool,
) -> None:
    digits = np.log10(np.maximum(np.abs(error), _FLOOR))
    levels = np.log10(LEVELS)
    across, up = errors.a_over_l, errors.b_over_a
    axes.contourf(
        across, up, digits, levels=[-20, *levels, 20], colors=_BANDS, antialiased=True, zorder=0
    )
    lines = axes.contour(
        across, up, digits, levels=levels, colors=_ink.TEXT, linewidths=1.1, linestyles="solid"
    )
    axes.set(xlim=(_LEFT if large else 0.0, float(across[-1])), ylim=(0, 1))
    if large:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(FuncFormatter(_spelled))
        axes.set_xticks([0.01, 0.02, 0.05, 0.1, 0.2, 0.5])
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        axes.set_xticks([0, 0.5], ["0", "0.5"])
        axes.set_xticks([0.25, 0.75], minor=True)
    covered = _covered(mark, name, large)
    places = _places(across, up, digits, levels, large, covered)
    axes.clabel(
        lines,
        fmt={level: f"{100 * 10**level:g} %" for level in levels},
        fontsize=10 if large else 8,
        manual=places,
    )
    if mark is not None:
        axes.plot(
            *mark, "o", markersize=7, color=_ink.OUTER, markeredgecolor="white", clip_on=False
        )
        if name:
            left, low = _named_towards(mark)
            axes.annotate(
                name,
                mark,
                (-8 if left else 8, -8 if low else 8),
                textcoords="offset points",
                ha="right" if left else "left",
                va="top" if low else "bottom",
                color=_ink.OUTER,
                parse_math=False,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 1.5},
            )


def _named_towards(mark: tuple[float, float]) -> tuple[bool, bool]:
    """Whether a name stands left of its mark, and below: towards the middle of the map."""
    return mark[0] > _MIDDLE, mark[1] > _HIGH


def _inches(across: float, up: float, large: bool) -> tuple[float, float]:
    """About how far from the lower left corner of a map a point is drawn."""
    width, height = _LARGE if large else _SMALL
    share = math.log10(across / _LEFT) / -math.log10(_LEFT) if large else across
    return width * share, height * up


def _covered(mark: tuple[float, float] | None, name: str, large: bool) -> list[_Box]:
    """What a mark and its name cover of a map."""
    if mark is None or (large and mark[0] < _LEFT):
        return []
    x, y = _inches(*mark, large)
    boxes = [(x, y, x, y)]
    if name:
        left, low = _named_towards(mark)
        width, height = _SIGN[0] * len(name), _SIGN[1]
        low_left = (x - width if left else x, y - height if low else y)
        boxes.append((*low_left, low_left[0] + width, low_left[1] + height))
    return boxes


def _is_free(place: tuple[float, float], covered: list[_Box]) -> bool:
    """Whether a label around a place in inches touches none of the boxes."""
    x, y = place
    return all(
        math.hypot(max(x0 - x, 0.0, x - x1), max(y0 - y, 0.0, y - y1)) > _AROUND
        for x0, y0, x1, y1 in covered
    )


def _places(
    across: NDArray[np.float64],
    up: NDArray[np.float64],
    digits: NDArray[np.float64],
    levels: NDArray[np.float64],
    large: bool,
    covered: list[_Box],
) -> list[tuple[float, float]]:
    """Where the lines are labelled: on one height, or one above the other where they crowd.

    A label moves along its line, up or down, where something covers it.
    """
    found: list[tuple[float, float]] = []
    for k, level in enumerate(levels):
        # Errors of the frequency change their sign: there every line has a second branch.
        for height in (0.5, 0.88) if large else (0.2 + 0.2 * k,):
            moved = (height + sign * shift for shift in _SHIFTS for sign in (-1, 1))
            heights = (one for one in moved if _LOWEST <= one <= _HIGHEST)
            places = (_on_line(across, up, digits, level, one, large) for one in heights)
            on_it = [place for place in places if place is not None]
            if not on_it or _on_line(across, up, digits, level, height, large) is None:
                continue
            free = (one for one in on_it if _is_free(_inches(*one, large), covered))
            found.append(next(free, on_it[0]))
    return found


def _on_line(
    across: NDArray[np.float64],
    up: NDArray[np.float64],
    digits: NDArray[np.float64],
    level: float,
    height: float,
    large: bool,
) -> tuple[float, float] | None:
    """Where a line passes a height of the map; None where it does not, or too near to an edge."""
    row = round((len(up) - 1) * height)
    beyond = np.flatnonzero(digits[row] >= level)
    margin = 0 if large else _MARGIN * len(across)
    if beyond.size and margin < beyond[0] < 0.97 * len(across):
        return float(across[beyond[0]]), float(up[row])
    return None
