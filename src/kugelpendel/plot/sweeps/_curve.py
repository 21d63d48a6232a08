"""A result over the one number that varies."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np

from kugelpendel.parameters import InvalidInput
from kugelpendel.plot import _ink
from kugelpendel.plot.sweeps._labels import with_unit
from kugelpendel.plot.sweeps._plane import at_time, side_of, time_of, unit_in
from kugelpendel.plot.tracks._page import localise
from kugelpendel.sweeps._spoken import called, called_after

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from kugelpendel.errors import Language


def curve(
    dataset: Dataset,
    name: str,
    time: float | None = None,
    title: str = "",
    language: Language = "en",
) -> Figure:
    """Draw a result of a grid over its one number; gaps where there is no answer.

    Parameters as for `values_map`. Raises InvalidInput for a grid over several numbers.
    """
    data = at_time(dataset, name, time)
    wide = [str(dim) for dim, size in data.sizes.items() if size > 1]
    if len(wide) != 1 or wide == ["case"]:
        raise InvalidInput(
            f'A curve needs a grid over one number, but "{name}" varies over '
            f"{', '.join(wide) or 'none'}."
        )
    values = np.asarray(data.values, np.float64).ravel()
    unit = unit_in(dataset, name, values[np.isfinite(values)])
    side = side_of(dataset, wide[0], language)
    usual = called_after(name, time_of(dataset, name, time), language)
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(8.0, 5.0)
        axes = figure.subplots()
        if side.log:
            axes.set_xscale("log")
        shown = np.where(np.isfinite(values), values, np.nan) / unit.size
        axes.plot(side.values, shown, "o-", color=_ink.INNER, markersize=3.5, linewidth=1.2)
        axes.set_xlabel(side.label)
        axes.set_ylabel(with_unit(called(name, language), unit.symbol))
        localise(axes, language)
        axes.grid(alpha=0.25)
        _ink.entitle(figure, title or usual, 70)
        return figure
