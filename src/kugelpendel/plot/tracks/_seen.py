"""A track from above, with the ellipses that were found at its start and its end."""

# matplotlib's and xarray's stubs leave much untyped.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.plot.tracks._labels import label
from kugelpendel.plot.tracks._page import MOST_POINTS, WIDTH, localise
from kugelpendel.spelling import unit_for
from kugelpendel.tracks import Track

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from kugelpendel.errors import Language
    from kugelpendel.tracks import EllipseTable


def seen(
    track: Track | EllipseTable, ellipses: xr.Dataset, *, language: Language = "en"
) -> _ink.Picture:
    """Draw the positions of a track, if there are any, and its first and last ellipse.

    Parameters
    ----------
    track
        As it was read.
    ellipses
        As `kugelpendel.tracks.ellipses` found them.
    language
        Of the words in the figure.

    Returns
    -------
    Picture
        Of matplotlib, without a window.
    """
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(WIDTH, 4.9)
        axes = figure.add_subplot()
        first, last = _ellipse(ellipses, 0), _ellipse(ellipses, -1)
        clouds = [first, last]
        x = y = np.zeros(0)
        if isinstance(track, Track):
            step = max(1, len(track) // MOST_POINTS)
            x, y = track.x[::step], track.y[::step]
        reach = max(float(np.abs(cloud - cloud.mean(axis=1)[:, None]).max()) for cloud in clouds)
        unit = unit_for(reach, "m") if track.unit == "m" else None
        size, symbol = (unit.size, unit.symbol) if unit else (1.0, track.unit)
        if len(x):
            axes.plot(
                x / size, y / size, ".", color=_ink.QUIET, markersize=1.5, alpha=0.6,
                label=label("points", language), rasterized=True,
            )  # fmt: skip
        for cloud, colour, style, key in (
            (first, _ink.INNER, "-", "first"),
            (last, _ink.OUTER, "--", "last"),
        ):
            axes.plot(
                *(cloud / size), style, color=colour, linewidth=1.8, label=label(key, language)
            )
        centre = first.mean(axis=1) / size
        limit = 1.12 * reach / size
        axes.set(
            aspect="equal",
            xlim=(centre[0] - limit, centre[0] + limit),
            ylim=(centre[1] - limit, centre[1] + limit),
            xlabel=f"x ({symbol})",
            ylabel=f"y ({symbol})",
            title=label("seen", language),
        )
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2, frameon=False)
        localise(axes, language)
    return figure


def _ellipse(ellipses: xr.Dataset, at: int) -> NDArray[np.float64]:
    """Points along one ellipse; shape (2, 361)."""
    one = {name: float(ellipses[name].values[at]) for name in ("a", "b", "azimuth", "x0", "y0")}
    phase = np.linspace(0, 2 * np.pi, 361)
    along, across = one["a"] * np.cos(phase), one["b"] * np.sin(phase)
    cos, sin = np.cos(one["azimuth"]), np.sin(one["azimuth"])
    centre = np.nan_to_num(np.array([one["x0"], one["y0"]]))
    return np.array([along * cos - across * sin, along * sin + across * cos]) + centre[:, None]
