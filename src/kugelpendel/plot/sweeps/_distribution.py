"""How a result is distributed over all cases."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np

from kugelpendel.parameters import InvalidInput
from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import label, with_unit
from kugelpendel.plot.tracks._page import localise
from kugelpendel.spelling import grouped, significant
from kugelpendel.sweeps._reductions import evenly
from kugelpendel.sweeps._spoken import called, unit_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from kugelpendel.errors import Language
    from kugelpendel.parameters import Numbers

_MOST_BARS = 80
_QUANTILES = (0.05, 0.5, 0.95)
_FAR = 1e-4
"""The bars go from the quantile of this share to that of the rest."""


def distribution(
    values: Numbers,
    name: str,
    units: str,
    title: str = "",
    counts: Numbers | None = None,
    language: Language = "en",
) -> Figure:
    """Draw the histogram of a result with its 5 %, 50 % and 95 % quantiles.

    Parameters
    ----------
    values
        Of all cases, in SI; what is not finite is left out and counted. Of more than a million,
        evenly spread ones are drawn.
    name
        Of the quantity.
    units
        Their SI unit.
    title
        Above the figure.
    counts
        How many cases each value stands for, such as those of the bins of a reduced result; one
        each unless given.
    language
        Of the labels.

    Raises
    ------
    InvalidInput
        Where no case has an answer.
    """
    numbers = np.asarray(values, np.float64).ravel()
    weights = np.ones(numbers.size) if counts is None else np.asarray(counts, np.float64).ravel()
    known = np.flatnonzero(np.isfinite(numbers) & (weights > 0))
    everyone, answers = int(weights.sum()), float(weights[known].sum())
    if not known.size:
        raise InvalidInput(f'None of {everyone} cases has an answer for "{name}".')
    known = evenly(known)
    known = known[np.argsort(numbers[known])]
    finite, weights = numbers[known], weights[known]
    passed = np.cumsum(weights)

    def quantile(share: float) -> float:
        return float(finite[np.searchsorted(passed, share * passed[-1])])

    unit = unit_of(name, float(np.abs(finite).max()), units)
    finite = finite / unit.size
    low, high = quantile(_FAR), quantile(1 - _FAR)
    inside = (finite >= low) & (finite <= high)
    bars = min(_MOST_BARS, max(8, round(2 * float(passed[-1]) ** (1 / 3))))
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(8.0, 5.0)
        axes = figure.subplots()
        bars = bars if high > low else 1
        found, edges = np.histogram(finite[inside], bars, weights=weights[inside])
        shares = 100 * found / passed[-1]
        axes.stairs(shares, edges, fill=True, color=_ink.INNER, alpha=0.35)
        axes.stairs(shares, edges, color=_ink.INNER, linewidth=1.2)
        axes.set_ylim(0, 1.18 * float(shares.max()))
        for k, share in enumerate(_QUANTILES):
            place = quantile(share)
            axes.axvline(place, color=_ink.OUTER, linewidth=1.4, linestyle=("--", "-", "--")[k])
            gap = "" if unit.symbol in ("", "°") else " "
            number = significant(place, 3, language=language)
            axes.annotate(
                f"{100 * share:.0f} %: {number}{gap}{unit.symbol}",
                (place, 1.0 - 0.055 * k), xycoords=("data", "axes fraction"),
                xytext=(4, -3), textcoords="offset points", va="top", fontsize=9, color=_ink.OUTER,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 1},
            )  # fmt: skip
        axes.set_xlabel(with_unit(called(name, language), unit.symbol))
        axes.set_ylabel(label("bars", language))
        localise(axes, language)
        left_out = everyone - round(answers)
        if left_out:
            axes.annotate(
                label("left_out", language).format(left=grouped(left_out), all=grouped(everyone)),
                (1.0, 0.86), xycoords="axes fraction", ha="right", fontsize=9, color=_ink.TEXT,
            )  # fmt: skip
        _ink.entitle(figure, title or called(name, language), 70)
        return figure
