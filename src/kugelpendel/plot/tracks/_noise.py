"""What a fit leaves over and how sure it is: spectrum, correlations, profile."""

# matplotlib's and xarray's stubs leave much untyped.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.plot.tracks._labels import german_words, label
from kugelpendel.plot.tracks._page import WIDTH, localise
from kugelpendel.spelling import localised

if TYPE_CHECKING:
    import xarray as xr

    from kugelpendel.errors import Language
    from kugelpendel.tracks import FittedModel, Profile

_SIGNS = {
    "a": "a",
    "b": "b",
    "azimuth": "ψ",
    "rotation": "Ω$_z$",
    "linear": "γ",
    "quadratic": "c",
    "anisotropy_cos": "δ cos 2χ",
    "anisotropy_sin": "δ sin 2χ",
    "damping_anisotropy_cos": "Δγ cos",
    "damping_anisotropy_sin": "Δγ sin",
    "tilt_cos": "tilt cos",
    "tilt_sin": "tilt sin",
    "intrinsic": "κ",
}
_MOST_CELLS = 800


def spectrum(residuals: xr.Dataset, frequency: float, *, language: Language = "en") -> _ink.Picture:
    """Draw the two-sided spectrum of what the ellipses leave over, with the fitted noise.

    Parameters
    ----------
    residuals
        As `kugelpendel.tracks.residuals` found them.
    frequency
        Of the swing, rad/s.
    language
        Of the words in the figure.

    Returns
    -------
    Picture
        Of matplotlib, without a window.
    """
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(WIDTH, 3.8)
        axes = figure.add_subplot()
        omega, power = _smoothed(
            residuals.angular_frequency.values, residuals.spectrum.values, frequency
        )
        axes.semilogy(omega, power, color=_ink.INNER, linewidth=0.8)
        axes.semilogy(
            residuals.angular_frequency.values,
            residuals.spectrum_model.values,
            "--",
            color=_ink.OUTER,
            linewidth=1.8,
            label=label("line", language),
        )
        for sign in (-1, 1):
            axes.axvline(
                sign * frequency,
                ymax=0.88,  # the legend stands above
                color=_ink.TEXT,
                linestyle=":",
                linewidth=1.2,
                label=label("swing", language) if sign > 0 else None,
            )
        axes.set(
            xlim=(float(omega.min()), float(omega.max())),
            # At 0 next to nothing is left, since the centre is fitted.
            ylim=(0.3 * float(np.percentile(power, 2)), 30 * float(power.max())),
            xlabel=f"{label('frequency', language)} (rad/s)",
            ylabel=label("power", language),
            title=label("spectrum", language),
        )
        axes.legend(loc="upper center", ncols=2, frameon=False)
    return figure


def _smoothed(
    omega: np.ndarray, power: np.ndarray, frequency: float
) -> tuple[np.ndarray, np.ndarray]:
    """Means over as many neighbours as leave some thousand points."""
    near = np.abs(omega) < 4.5 * frequency
    omega, power = omega[near], power[near]
    run = max(1, len(omega) // _MOST_CELLS)
    whole = len(omega) // run * run
    return omega[:whole].reshape(-1, run).mean(axis=1), power[:whole].reshape(-1, run).mean(axis=1)


def correlations(model: FittedModel, *, language: Language = "en") -> _ink.Picture:
    """Draw the figure of a model's correlations: a table of colours and numbers."""
    names = [name for name in model.parameters if name in _SIGNS][: len(model.correlation)]
    table = np.asarray(model.correlation)[: len(names), : len(names)]
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(WIDTH, 4.9)
        axes = figure.add_subplot()
        axes.imshow(table, cmap=mpl.colormaps["RdBu_r"], vmin=-1, vmax=1)
        signs = [german_words(_SIGNS[name], language) for name in names]
        axes.set_xticks(range(len(names)), signs, rotation=45, ha="right")
        axes.set_yticks(range(len(names)), signs)
        for row in range(len(names)):
            for column in range(len(names)):
                value = table[row, column]
                text = localised(f"{value:.1f}".replace("-0.0", "0.0"), language)
                axes.text(
                    column, row, text,
                    ha="center", va="center", fontsize=7,
                    color="white" if abs(value) > 0.6 else _ink.TEXT,
                )  # fmt: skip
        axes.set_title(label("correlations", language))
    return figure


def profile(found: Profile, *, language: Language = "en") -> _ink.Picture:
    """Draw how χ² rises on both sides of the best rate of turning."""
    hour = np.degrees(1.0) * 3600
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(WIDTH, 3.6)
        axes = figure.add_subplot()
        values = np.asarray(found.values) * hour
        rise = np.asarray(found.chi_square) - np.nanmin(found.chi_square)
        axes.plot(values, rise, "o-", color=_ink.INNER, markersize=3, linewidth=1.4)
        axes.axhline(found.level, color=_ink.OUTER, linestyle="--", label=label("level", language))
        axes.set(
            xlabel=f"{label('rotation', language)} (°/h)",
            ylabel=label("excess", language),
            title=label("profile", language),
        )
        axes.set_ylim(0, min(4 * found.level, float(np.nanmax(rise)) * 1.1 or 1.0))
        axes.legend(frameon=False)
        localise(axes, language)
    return figure
