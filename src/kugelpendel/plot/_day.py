"""A day of a real pendulum: where its plane goes, what turns it, and how the swing changes."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.ticker import MaxNLocator

from kugelpendel.motion import EnvelopeMotion, PrecessionBudget, RealMotion
from kugelpendel.observables import Apsides
from kugelpendel.parameters import InvalidInput, require_type
from kugelpendel.plot import _ink
from kugelpendel.plot._rates import draw_rates
from kugelpendel.spelling import spell_rate, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

_SWINGS = 6
"""Swings in the plan view, evenly spread over the time."""

_POINTS = 120
"""Points of each of them."""


def day(
    motion: RealMotion | EnvelopeMotion,
    apsides: Apsides,
    shares: PrecessionBudget | None,
    title: str = "",
) -> Figure:
    """Draw how the plane of a real pendulum goes round.

    Parameters
    ----------
    motion
        One motion, not an ensemble; asked for a few swings.
    apsides
        What was measured.
    shares
        What turned the plane, by the averaged equations; None where they do not hold.
    title
        Above the figure.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it.

    Raises
    ------
    InvalidInput
        For an ensemble, for what is of another type, and where no turning point was measured.
    """
    way_out = "write kp.RealMotion(pendulum, launch, forces)"
    require_type("The motion of a day", motion, RealMotion, EnvelopeMotion, way_out=way_out)
    if motion.shape != ():
        raise InvalidInput(
            f"One motion can be shown at a time, and this is an ensemble of shape {motion.shape}; "
            f"pick one of its motions, motion[0] for instance."
        )
    if not isinstance(apsides, Apsides):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(
            f"The measured swings must be a kugelpendel.observables.Apsides, but they are "
            f"{apsides!r:.60} of type {type(apsides).__name__}; write Follower(motion, …).apsides."
        )
    if apsides.times.size == 0:
        raise InvalidInput(
            "No turning point was measured, so that there is no plane to draw; follow the motion "
            "for half a swing at least."
        )
    if shares is not None:
        way_out = "write EnvelopeMotion.rates(times), or None"
        require_type("What turned the plane", shares, PrecessionBudget, way_out=way_out)
    with mpl.rc_context(_ink.STYLE):
        figure = _ink.blank(12, 9.2, h_pad=0.08)
        grid = figure.add_gridspec(2, 2, width_ratios=(1.3, 1), height_ratios=(1, 1))
        left, right = grid[0, 0].subgridspec(2, 1, height_ratios=(2.2, 1)), grid[1, 1]
        azimuth = figure.add_subplot(left[0])
        ahead = figure.add_subplot(left[1], sharex=azimuth)
        rates = figure.add_subplot(grid[1, 0], sharex=azimuth)
        plan = figure.add_subplot(grid[0, 1])
        axes_of_swing = right.subgridspec(2, 1)
        major = figure.add_subplot(axes_of_swing[0], sharex=azimuth)
        minor = figure.add_subplot(axes_of_swing[1], sharex=azimuth)
        clock = unit_for(float(apsides.times[-1]), "s")
        time = apsides.times / clock.size
        _draw_azimuth(azimuth, ahead, apsides, time)
        draw_rates(rates, shares, clock)
        lines, timeline = _draw_swings(plan, motion, apsides)
        _draw_size(major, time, apsides.a, "a", "Half the length of the swing")
        _draw_size(minor, time, apsides.b, "b", "Half its width, + counter-clockwise")
        for axes in (azimuth, major):
            axes.tick_params(labelbottom=False)
        for axes in (ahead, rates, minor):
            axes.set_xlabel(f"time ({clock.symbol})")
        last = shares.times[-1] if shares is not None else apsides.times[-1]
        azimuth.set_xlim(0, float(last) / clock.size)
        azimuth.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 3, 4, 5, 6, 10]))
        for axes in (azimuth, plan):
            axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 3, 5, 6, 9, 10]))
        for axes in (ahead, major, minor):
            axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
        plan.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        bar = figure.colorbar(lines, ax=plan, shrink=0.75, aspect=28)
        bar.set_label(f"time ({timeline.unit.symbol})")
        bar.outline.set_visible(False)  # pyright: ignore[reportCallIssue]
        _ink.entitle(figure, title, 110)
    return figure


def _draw_azimuth(axes: Axes, ahead: Axes, apsides: Apsides, time: NDArray[np.float64]) -> None:
    """The azimuth with the ideal line, and below it how far the plane is from that line."""
    axes.plot(
        time,
        np.degrees(apsides.azimuth),
        color=_ink.INNER,
        linewidth=1.8,
        label=f"full equations, {spell_rate(apsides.mean_rate)} on average",
    )
    apart = np.degrees(apsides.azimuth - apsides.foucault_azimuth)
    if apsides.foucault_rate:
        axes.plot(
            time,
            np.degrees(apsides.foucault_azimuth),
            "--",
            color=_ink.OUTER,
            linewidth=1.4,
            label=rf"$−Ω_\mathrm{{E}}$ sin(latitude), {spell_rate(apsides.foucault_rate)}",
        )
    axes.set(title="Azimuth of the plane", ylabel="azimuth (°)")
    axes.margins(y=0.08)
    axes.legend(loc="best", frameon=False)
    ahead.axhline(0, color=_ink.OUTER, linestyle="--", linewidth=1.2)
    ahead.plot(time, apart, color=_ink.INNER, linewidth=1.5)
    what = "off that line" if apsides.foucault_rate else "turned"
    ahead.set(ylabel=f"{what} (°)")
    ahead.margins(y=0.15)


def _draw_swings(
    axes: Axes, motion: RealMotion | EnvelopeMotion, apsides: Apsides
) -> tuple[LineCollection, _ink.Timeline]:
    """A few swings from above, x to the right and y up, to one scale."""
    swing = 2 * math.pi / float(motion.angular_frequency)
    first, last = float(apsides.times[0]), float(apsides.times[-1])
    starts = np.linspace(first, max(last - swing, first), _SWINGS)
    if last - first < _SWINGS * swing:
        starts, swing = np.array([first]), last - first
    times = (starts[:, np.newaxis] + np.linspace(0.0, swing, _POINTS + 1)).ravel()
    points = motion.position(np.minimum(times, last))[:, :2]
    reach = float(np.hypot(*points.T).max()) or 1e-3 * float(motion.pendulum.length)
    unit = unit_for(reach, "m")
    timeline = _ink.Timeline(last)
    table = np.column_stack([times, points / unit.size])
    lines = timeline.draw(axes, np.split(table, len(starts)))
    axes.plot(0, 0, "+", color=_ink.TEXT, markersize=7, zorder=4)
    limit = 1.08 * reach / unit.size
    some = f"{len(starts)} swings" if len(starts) > 1 else "The path"
    axes.set(
        xlim=(-limit, limit),
        ylim=(-limit, limit),
        aspect="equal",
        xlabel=f"x ({unit.symbol})",
        ylabel=f"y ({unit.symbol})",
        title=f"{some} from above",
    )
    return lines, timeline


def _draw_size(
    axes: Axes, time: NDArray[np.float64], size: NDArray[np.float64], name: str, title: str
) -> None:
    unit = unit_for(float(np.abs(size).max()), "m")
    axes.axhline(0, color=_ink.QUIET, linewidth=0.9)
    axes.plot(time, size / unit.size, color=_ink.TEXT, linewidth=1.6)
    axes.set(title=title, ylabel=f"{name} ({unit.symbol})")
    axes.margins(y=0.12)
