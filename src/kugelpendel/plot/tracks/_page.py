"""Figures for a page that is also read on a phone: narrow, one thing below the other."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter

from kugelpendel.errors import Language
from kugelpendel.spelling import general

WIDTH = 5.4
"""In inches; with letters of 10 points a phone still shows these legibly."""

MOST_POINTS = 20_000
"""More points than that are thinned out in a figure: they would lie on one another."""


def localise(axes: Axes, language: Language) -> None:
    """Give the ticks of both axes the decimal mark of the language."""

    def said(value: float, _: int) -> str:
        return general(value, 7, language=language)

    if language == "de":
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(FuncFormatter(said))
