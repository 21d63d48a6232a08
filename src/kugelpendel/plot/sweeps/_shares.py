"""What moves a result: Sobol indices with their intervals."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
from matplotlib.lines import Line2D

from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import label
from kugelpendel.sweeps._spoken import called

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kugelpendel.errors import Language
    from kugelpendel.sweeps._sensitivity import Sensitivity

_PAIRS = 4
"""Pairs that are drawn, those that move most."""

_MARKS = {
    "alone": ("o", _ink.INNER, _ink.INNER),
    "total": ("s", "white", _ink.OUTER),
    "together": ("D", _ink.TEXT, _ink.TEXT),
}
"""Marker, its filling and its colour."""


def shares(found: Sensitivity, title: str = "", language: Language = "en") -> Figure:
    """Draw the share of each parameter, and of the pairs that move most, with 95 % intervals."""
    names = sorted(found.names, key=lambda name: -found.total[name].value)
    pairs = sorted(found.together, key=lambda pair: -found.together[pair].value)[:_PAIRS]
    rows = len(names) + len(pairs)
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(8.4, 1.6 + 0.42 * rows)
        axes = figure.subplots()
        for row, name in enumerate(names):
            for key, share, shift in (
                ("alone", found.alone[name], -0.13),
                ("total", found.total[name], 0.13),
            ):
                _mark(axes, key, share.value, share.error, row + shift)
        for row, pair in enumerate(pairs, len(names)):
            share = found.together[pair]
            _mark(axes, "together", share.value, share.error, row)
        rows_of = [(name,) for name in names] + pairs
        labels = [" × ".join(called(name, language) for name in row) for row in rows_of]
        axes.set_yticks(range(rows), labels)
        axes.set_ylim(rows - 0.5, -0.5)
        axes.axvline(0, color=_ink.QUIET, linewidth=0.8)
        axes.axvline(100, color=_ink.QUIET, linewidth=0.8, linestyle=":")
        if pairs:
            axes.axhline(len(names) - 0.5, color=_ink.QUIET, linewidth=0.8)
        axes.set_xlabel(label("variance", language))
        axes.grid(axis="x", alpha=0.25)
        handles = [
            Line2D(
                [], [], marker=mark, markerfacecolor=fill, color=colour, linestyle="none",
                label=label(key, language),
            )
            for key, (mark, fill, colour) in _MARKS.items()
            if pairs or key != "together"
        ]  # fmt: skip
        figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False)
        _ink.entitle(figure, title or label("moves", language), 70)
        return figure


def _mark(axes: object, key: str, value: float, error: float, row: float) -> None:
    marker, fill, colour = _MARKS[key]
    axes.errorbar(  # pyright: ignore[reportAttributeAccessIssue]
        100 * value, row, xerr=100 * error, fmt=marker, color=colour, markerfacecolor=fill,
        markersize=6, capsize=3, linewidth=1.3,
    )  # fmt: skip
