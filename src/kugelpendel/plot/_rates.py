"""The rate of a plane against time, cause by cause, and where it hurries, lags or stalls."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from kugelpendel.plot import _ink
from kugelpendel.spelling import rate_unit, spell_rate

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from kugelpendel.motion import PrecessionBudget
    from kugelpendel.spelling import Unit

# Apart in hue and in lightness, and from the shades behind them.
_COLOURS = {
    "intrinsic": "#2a6f97",
    "anisotropy": "#3b7d4f",
    "damping": "#b8443a",
    "drive": "#6a4c93",
}

_SHADES = {"hurries": "#dceaf3", "lags": "#f7eec8", "stalls": "#f0c9c2"}

_NEGLIGIBLE = 1e-6
"""A share that never reaches this fraction of the largest one has no line."""

_CANCELLED = 0.3
"""A drive that leaves no more than this of what the ellipse turns by itself shares its line."""

_SPIKES = 4.0
"""The axis ends at so many times the range of the middle 96 % of the values."""


def draw_rates(axes: Axes, shares: PrecessionBudget | None, clock: Unit) -> None:
    """Draw what the causes add to the Earth's share, and their sum.

    Parameters
    ----------
    axes
        Where to draw; its time axis is in units of ``clock``.
    shares
        None where the averaged equations do not hold.
    clock
        Of the time axis.
    """
    if shares is None:
        axes.set_axis_off()
        says = "The averaged equations do not hold here:\nthe causes cannot be told apart."
        axes.text(0.5, 0.5, says, transform=axes.transAxes, ha="center", fontsize=11)
        return
    time = shares.times / clock.size
    beyond = shares.beyond_earth
    unit = rate_unit(float(np.abs(beyond).max()))
    handles: list[Artist] = []
    for pace, shade in _SHADES.items():
        here = [stretch for stretch in shares.stretches() if stretch.pace == pace]
        for stretch in here:
            axes.axvspan(
                stretch.start / clock.size, stretch.stop / clock.size, color=shade, linewidth=0
            )
        if here:
            handles.append(Patch(color=shade, label=pace))
    lines = _lines(shares)
    largest = max(float(np.abs(share).max()) for _, share, _ in lines)
    for name, share, colour in lines:
        if np.abs(share).max() > _NEGLIGIBLE * largest:
            handles += axes.plot(time, share / unit.size, color=colour, linewidth=1.3, label=name)
    handles += axes.plot(time, beyond / unit.size, color=_ink.TEXT, linewidth=2.0, label="together")
    axes.axhline(0, color=_ink.OUTER, linestyle="--", linewidth=1.2, zorder=1)
    low, high = _limits([line / unit.size for line in (*(share for _, share, _ in lines), beyond)])
    axes.set_ylim(low, high)
    earth = float(shares.earth[0])
    if earth and low < -earth / unit.size < high:
        handles.append(
            axes.axhline(
                -earth / unit.size,
                color=_ink.OUTER,
                linestyle=":",
                linewidth=1.4,
                label="standstill",
            )
        )
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    beyond_what = f" beyond the Earth's {spell_rate(earth)}" if earth else ""
    axes.set(
        title=f"What turns the plane{beyond_what}",
        ylabel=f"added to the rate ({unit.symbol})",
    )
    axes.legend(
        handles=handles,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.17),
        ncols=min(len(handles), 4),
        frameon=False,
    )


def _lines(shares: PrecessionBudget) -> list[tuple[str, NDArray[np.float64], str]]:
    """What is drawn beside the sum: name, share and colour; as one what all but cancels."""
    lines = [(cause, getattr(shares, cause), colour) for cause, colour in _COLOURS.items()]
    both = shares.intrinsic + shares.drive
    size = float(np.abs(shares.intrinsic).max())
    if not np.any(shares.drive) or float(np.abs(both).max()) > _CANCELLED * size:
        return lines
    name = f"intrinsic and drive (each up to {spell_rate(size, 3).lstrip('+')})"
    rest = [line for line in lines if line[0] not in ("intrinsic", "drive")]
    return [(name, both, _COLOURS["drive"]), *rest]


def _limits(lines: list[NDArray[np.float64]]) -> tuple[float, float]:
    """Of the axis: all of the lines, but for spikes where a swing is all but round."""
    values = np.concatenate(lines)
    low, high = np.percentile(values, [2, 98])
    span = max(float(high - low), 1e-12)
    bottom = max(float(values.min()), float(low) - _SPIKES * span)
    top = min(float(values.max()), float(high) + _SPIKES * span)
    margin = 0.06 * max(top - bottom, 1e-12)
    return bottom - margin, top + margin
