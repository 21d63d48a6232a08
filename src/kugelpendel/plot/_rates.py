"""The rate of a plane against time, cause by cause, and where it hurries, lags or stalls."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING, Any

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

_Stroke = str | tuple[int, tuple[float, ...]]

_STROKES: dict[str, tuple[str, _Stroke]] = {
    "intrinsic": ("#2a6f97", "-"),
    "anisotropy": ("#c07f10", (0, (6, 1.5))),
    "damping": ("#8f2d20", (0, (5, 1.5, 1, 1.5))),
    "drive": ("#9c7fd0", (0, (2.5, 1.2))),
}
"""Colour and dashes of each cause: apart in hue and in lightness, and where there is neither."""

_SHADES = {"hurries": ("#dceaf3", ""), "lags": ("#f7eec8", ".."), "stalls": ("#f0c9c2", "//")}
"""Tint of each pace, and its hatch for whoever sees no tint."""

_HATCH = "#d9cdb8"

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
    for pace, (tint, hatch) in _SHADES.items():
        look: dict[str, Any] = {
            "facecolor": tint, "hatch": hatch, "edgecolor": _HATCH, "linewidth": 0,
        }  # fmt: skip
        here = [stretch for stretch in shares.stretches() if stretch.pace == pace]
        for stretch in here:
            axes.axvspan(stretch.start / clock.size, stretch.stop / clock.size, **look)
        if here:
            handles.append(Patch(**look, label=pace))
    lines = _lines(shares)
    largest = max(float(np.abs(share).max()) for _, share, _ in lines)
    ends: list[tuple[float, str, str]] = []
    for name, share, (colour, dashes) in lines:
        if np.abs(share).max() > _NEGLIGIBLE * largest:
            handles += axes.plot(
                time, share / unit.size, color=colour, linestyle=dashes, linewidth=1.5, label=name
            )
            ends.append((float(share[-1]) / unit.size, name.partition(" (")[0], colour))
    handles += axes.plot(time, beyond / unit.size, color=_ink.TEXT, linewidth=2.2, label="together")
    ends.append((float(beyond[-1]) / unit.size, "together", _ink.TEXT))
    axes.axhline(0, color=_ink.QUIET, linewidth=0.9, zorder=1)
    low, high = _limits([line / unit.size for line in (*(share for _, share, _ in lines), beyond)])
    axes.set_ylim(low, high)
    heights = [(min(max(end, low), high) - low) / (high - low) for end, _, _ in ends]
    named = [(1.0, height, *end[1:]) for height, end in zip(heights, ends, strict=True)]
    _ink.name_ends(axes, named, size=9)
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
        handlelength=3,
    )


def _lines(
    shares: PrecessionBudget,
) -> list[tuple[str, NDArray[np.float64], tuple[str, _Stroke]]]:
    """What is drawn beside the sum: name, share and stroke; as one what all but cancels."""
    lines = [(cause, getattr(shares, cause), stroke) for cause, stroke in _STROKES.items()]
    both = shares.intrinsic + shares.drive
    size = float(np.abs(shares.intrinsic).max())
    if not np.any(shares.drive) or float(np.abs(both).max()) > _CANCELLED * size:
        return lines
    name = f"intrinsic and drive (each up to {spell_rate(size, 3).lstrip('+')})"
    rest = [line for line in lines if line[0] not in ("intrinsic", "drive")]
    return [(name, both, _STROKES["drive"]), *rest]


def _limits(lines: list[NDArray[np.float64]]) -> tuple[float, float]:
    """Of the axis: all of the lines, but for spikes where a swing is all but round."""
    values = np.concatenate(lines)
    low, high = np.percentile(values, [2, 98])
    span = max(float(high - low), 1e-12)
    bottom = max(float(values.min()), float(low) - _SPIKES * span)
    top = min(float(values.max()), float(high) + _SPIKES * span)
    margin = 0.06 * max(top - bottom, 1e-12)
    return bottom - margin, top + margin
