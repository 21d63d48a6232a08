"""The azimuth of the apsides against time: where the swings point, and by which law they turn."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.plot import _ink
from kugelpendel.plot._constants import Constants
from kugelpendel.plot._turning import apsidal_times, turned_azimuth, turning_rate
from kugelpendel.spelling import spell_percent, spell_rate, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from kugelpendel import ExactMotion

_MARKS = 24
"""Apsides that are marked, evenly spread."""


def draw_apsides(
    axes: Axes, motion: ExactMotion, duration: float, approximate: float | None
) -> None:
    """Draw by how much the outer turning points have moved round since the first one.

    The marks are the azimuths of exact positions, brought to one branch: half a turn between
    successive outer turning points is taken off, or a whole turn where that is closer.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    motion : ExactMotion
        One motion, not an ensemble.
    duration : float
        Length of the time axis, s.
    approximate : float or None
        Precession by another formula, rad/s, drawn beside the exact one.
    """
    times = apsidal_times(motion, duration, most=_MARKS)
    known = Constants.of(motion)
    if times.size == 0 or known.precession == 0:
        _say(axes, _why_nothing(known, times.size))
        return
    turned = turned_azimuth(motion, times)
    rate, over = turning_rate(motion)
    clock = unit_for(duration, "s")
    ends = np.array([times[0], max(duration, times[-1])])
    span = max(float(ends[1] - ends[0]), known.radial_period)
    angle = unit_for(max(abs(rate), abs(approximate or 0.0)) * span, "rad")
    axes.plot(
        ends / clock.size,
        rate * (ends - times[0]) / angle.size,
        color=_ink.INNER,
        linewidth=1.6,
        label=f"exact, {spell_rate(rate)}",
    )
    if approximate is not None:
        error = spell_percent(approximate / known.precession - 1)
        axes.plot(
            ends / clock.size,
            approximate * (ends - times[0]) / angle.size,
            "--",
            color=_ink.OUTER,
            linewidth=1.6,
            label=f"formula (25), {spell_rate(approximate)} ({error})",
        )
    name = "highest" if over else "outer"
    what = "a slight wobble about the cone" if known.is_cone else "the ellipse"
    what = "the highest point" if over else what
    axes.plot(
        times / clock.size,
        turned / angle.size,
        "o",
        color=_ink.TEXT,
        markersize=3.5,
        label=f"{name} turning points" + (", whole turns taken off" if over else ""),
    )
    axes.set(
        title=f"Turning of {what}",
        xlabel=f"time ({clock.symbol})",
        ylabel=f"turned counter-clockwise by ({angle.symbol})",
    )
    axes.margins(y=0.12)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=1, frameon=False)


def _why_nothing(known: Constants, marks: int) -> str:
    if known.high == 0:
        return "The bob is at rest:\nthere are no turning points."
    if known.angular_momentum == 0 and known.frequency > 0:
        return "The bob moves in a vertical plane:\nthat plane does not turn."
    if marks == 0 and known.frequency > 0:
        return "The job ends before\nthe first outer turning point."
    return "The motion never comes back:\nthere is no next turning point."


def _say(axes: Axes, sentence: str) -> None:
    axes.set_axis_off()
    axes.text(0.5, 0.5, sentence, ha="center", va="center", color=_ink.TEXT, fontsize=11)
