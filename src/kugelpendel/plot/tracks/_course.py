"""How a, b and the azimuth of a track change, beside the model, and what the model leaves over."""

# matplotlib's and xarray's stubs leave much untyped.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import MaxNLocator

from kugelpendel.plot import _ink
from kugelpendel.plot.tracks._labels import label
from kugelpendel.plot.tracks._page import WIDTH, localise
from kugelpendel.spelling import unit_for

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes

    from kugelpendel.errors import Language
    from kugelpendel.tracks import FittedModel


def course(
    ellipses: xr.Dataset, model: FittedModel | None = None, *, language: Language = "en"
) -> _ink.Picture:
    """Draw a, b and the azimuth against time with their errors, a model, and the residuals.

    Parameters
    ----------
    ellipses
        As `kugelpendel.tracks.ellipses` found them.
    model
        One that was fitted to them, or None.
    language
        Of the words in the figure.

    Returns
    -------
    Picture
        Of matplotlib, without a window.
    """
    with mpl.rc_context(_ink.STYLE):
        rows = 3 if model is None else 6
        figure = _ink.blank(WIDTH, 6.4 if model is None else 9.4, h_pad=0.03)
        ratios = [1] * 3 if model is None else [2, 1] * 3
        panels: list[Axes] = list(figure.subplots(rows, 1, sharex=True, height_ratios=ratios))
        clock = unit_for(float(np.ptp(ellipses.time.values)) or 1.0, "s")
        time = ellipses.time.values / clock.size
        for index, name in enumerate(("a", "b", "azimuth")):
            size, symbol = _unit(name, ellipses)
            at = panels[index * rows // 3]
            values = ellipses[name].values / size
            errors = ellipses[f"{name}_stderr"].values / size
            _with_errors(at, time, values, errors, label("measured", language))
            if name == "b":
                at.axhline(0, color=_ink.QUIET, linewidth=0.8)
            at.set_title(label(name, language), fontsize=10, loc="left")
            at.set_ylabel(f"({symbol})")
            if model is not None:
                _model(at, panels[2 * index + 1], model, name, clock.size, size, errors, language)
        panels[0].legend(loc="best", frameon=False)
        panels[-1].set_xlabel(f"{label('time', language)} ({clock.symbol})")
        for at in panels:
            at.yaxis.set_major_locator(MaxNLocator(4))
            localise(at, language)
        figure.align_ylabels(panels)
        figure.suptitle(label("course", language), fontsize=11, fontweight="bold")
    return figure


def _model(
    above: Axes,
    below: Axes,
    model: FittedModel,
    name: str,
    second: float,
    size: float,
    errors: np.ndarray,
    language: Language,
) -> None:
    curve = np.asarray(getattr(model, name)) / size
    time = np.asarray(model.time) / second
    above.plot(
        time, curve, "--", color=_ink.OUTER, linewidth=1.6, label=label("model", language), zorder=3
    )
    residual = np.asarray(getattr(model, f"residual_{name}")) / size
    below.axhline(0, color=_ink.OUTER, linestyle="--", linewidth=1.2)
    _with_errors(below, time, residual, errors, "")
    below.set_ylabel(label("left", language))


def _with_errors(
    axes: Axes, time: np.ndarray, values: np.ndarray, errors: np.ndarray, name: str
) -> None:
    errors = np.where(np.isfinite(errors), errors, 0)
    if len(time) > 150:  # bars would run into one another
        axes.fill_between(
            time, values - errors, values + errors, color=_ink.INNER, alpha=0.3, linewidth=0
        )
        axes.plot(time, values, color=_ink.INNER, linewidth=0.9, label=name)
    else:
        axes.errorbar(
            time, values, errors, fmt="o", color=_ink.INNER, markersize=3, linewidth=1, label=name
        )


def _unit(name: str, ellipses: xr.Dataset) -> tuple[float, str]:
    if name == "azimuth":
        return np.pi / 180, "°"
    unit = str(ellipses.attrs.get("unit", "m"))
    if unit != "m":
        return 1.0, unit
    chosen = unit_for(float(np.nanmax(np.abs(ellipses[name].values))), "m")
    return chosen.size, chosen.symbol
