"""The budget of the rates that turn the plane of a swing, and how the swing dies away."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import MaxNLocator

from kugelpendel.builder import Design
from kugelpendel.parameters import require_type
from kugelpendel.plot import _ink
from kugelpendel.spelling import hourly, significant, spell, spell_rate, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


_NAMES = {
    "earth": "Earth, $−Ω_z$",
    "intrinsic": "ellipse by itself, Ω(a, b)",
    "anisotropy": "suspension, at the start",
    "damping": "uneven damping, at the start",
}

_SEEN = 0.004
"""A bar shorter than this share of the longest one is no more than its axis, and is not drawn."""

_HALVES = 3
"""The decay is drawn for so many times the time to half the amplitude."""


def design(found: Design, title: str = "") -> Figure:
    """Draw the rates at the start, their extremes over a half turn, and the amplitude.

    Parameters
    ----------
    found
        From `kugelpendel.design`.
    title
        Above the figure.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it. Above it stands which pendulum it is.

    Raises
    ------
    InvalidInput
        For what is no design, and a title that is no text.
    """
    require_type("What is drawn", found, Design, way_out="write kp.design(pendulum, a, b)")
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(11.5, 4.8)
        left, right = figure.subplots(1, 2, width_ratios=(1.35, 1))
        _draw_rates(left, found)
        _draw_decay(right, found)
        _ink.entitle(figure, _ink.naming(title, found.pendulum, found.a, found.b), 100)
    return figure


def _draw_rates(axes: Axes, found: Design) -> None:
    rates = found.budget
    bars = [(_NAMES[name], rate) for name, rate in rates.items()]
    bars.append(("together, at the start", sum(rates.values())))
    spans = _spans(found)
    reach = max([abs(rate) for _, rate in bars] + [abs(end) for _, *pair in spans for end in pair])
    for row, (_, rate) in enumerate(bars):
        colour = _ink.TEXT if row == len(bars) - 1 else _ink.INNER
        if abs(rate) > _SEEN * reach:
            axes.barh(row, hourly(rate), height=0.55, color=colour)
        _write(axes, row, rate, spell_rate(rate, 4) if rate else "0", left=rate < 0)
    for row, (_, slow, fast) in enumerate(spans, start=len(bars)):
        low, high = sorted((hourly(slow), hourly(fast)))
        if high - low > _SEEN * hourly(reach):
            axes.barh(row, high - low, left=low, height=0.55, color=_ink.OUTER)
        else:
            axes.plot((low + high) / 2, row, "d", color=_ink.OUTER, markersize=7)
        text = " to ".join(significant(hourly(value), 4) for value in (slow, fast))
        _write(axes, row, max(slow, fast), f"{text} °/h", left=False)
    axes.set_yticks(range(len(bars) + len(spans)), [name for name, *_ in (*bars, *spans)])
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.axvline(0, color=_ink.QUIET, linewidth=0.8)
    axes.invert_yaxis()
    low, high = axes.get_xlim()
    room = 0.3 * max(hourly(reach), high - low)
    axes.set_xlim(low - (room if low < 0 else 0), high + room)
    axes.xaxis.set_major_locator(MaxNLocator(7, steps=[1, 2, 2.5, 5, 10]))
    axes.set(title="What turns the swing", xlabel="rate (°/h), counter-clockwise from above")


def _spans(found: Design) -> list[tuple[str, float, float]]:
    """Slowest and fastest rates over a half turn, rad/s, counter-clockwise."""
    spans: list[tuple[str, float, float]] = []
    for cause, name in (("anisotropy", "suspension"), ("damping", "uneven damping")):
        if f"slowest_by_{cause}" in found:
            slow, fast = (found[f"{end}_by_{cause}"].value for end in ("slowest", "fastest"))
            spans.append((f"Earth and {name}, half a turn", slow, fast))
    return spans


def _write(axes: Axes, row: int, end: float, text: str, *, left: bool) -> None:
    """Beside the end of a bar, rad/s."""
    axes.annotate(
        text,
        (hourly(end), row),
        (-5 if left else 5, 0),
        textcoords="offset points",
        ha="right" if left else "left",
        va="center",
        fontsize=9,
        color=_ink.TEXT,
    )


def _draw_decay(axes: Axes, found: Design) -> None:
    if "half_time" not in found:
        axes.set_axis_off()
        axes.text(0.5, 0.5, "No drag is given:\nthe swing does not die away.", ha="center",
                  va="center", color=_ink.TEXT, fontsize=11)  # fmt: skip
        return
    half = found["half_time"].value
    times = np.linspace(0, _HALVES * half, 200)
    clock, ruler = unit_for(times[-1], "s"), unit_for(found.a, "m")
    amplitudes = np.array([found.amplitude(float(time)) for time in times])
    axes.plot(times / clock.size, amplitudes / ruler.size, color=_ink.INNER, linewidth=1.8)
    axes.plot([half / clock.size], [found.a / 2 / ruler.size], "o", color=_ink.OUTER)
    axes.annotate(f"half after {spell(half, 's')}", (half / clock.size, found.a / 2
                  / ruler.size), (8, 6), textcoords="offset points", color=_ink.OUTER)  # fmt: skip
    axes.set(
        title="Amplitude without a drive",
        xlabel=f"time ({clock.symbol})",
        ylabel=f"amplitude ({ruler.symbol})",
        xlim=(0, times[-1] / clock.size),
        ylim=(0, 1.08 * found.a / ruler.size),
    )
