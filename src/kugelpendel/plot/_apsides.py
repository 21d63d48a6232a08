"""The azimuth of the apsides against time: where the swings point, and by which law they turn."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kugelpendel.motion import ExactMotion
from kugelpendel.observables import TurningPoints
from kugelpendel.plot import _ink
from kugelpendel.spelling import Unit, spell_percent, spell_rate, unit_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from kugelpendel.motion import Motion
    from kugelpendel.observables import IdealSummary

_MARKS = 24
"""TurningPoints that are marked, evenly spread."""


class _Line(NamedTuple):
    """A law by which the apsides turn: its rate, rad/s, and how it is drawn."""

    name: str
    rate: float
    colour: str
    style: str


def draw_apsides(
    axes: Axes,
    motion: Motion,
    known: IdealSummary,
    duration: float,
    approximate: float | None,
) -> None:
    """Draw by how much the outer turning points have moved round since the first one.

    The marks are the azimuths of the motion's own positions, brought to one branch: half a turn
    between successive outer turning points is taken off, or a whole turn where that is closer.

    Parameters
    ----------
    axes
        Where to draw.
    motion
        A single motion.
    known
        What the ideal motion from its launch is.
    duration
        Length of the time axis, s.
    approximate
        Precession by another formula, rad/s, drawn beside the exact one.
    """
    apsides = TurningPoints.of(motion, known, duration, _MARKS)
    lines = _lines(motion, known, approximate)
    if apsides.times.size == 0 or (known.precession == 0 and isinstance(motion, ExactMotion)):
        _say(axes, _why_nothing(known, apsides.times.size))
        return
    clock = unit_for(duration, "s")
    ends = np.array([apsides.times[0], max(duration, apsides.times[-1])])
    span = max(float(ends[1] - ends[0]), known.swing_period / 2)
    reach = max(float(np.abs(apsides.turned).max()), *(abs(line.rate) * span for line in lines))
    angle = unit_for(reach, "rad")
    for line in lines:
        axes.plot(
            ends / clock.size,
            line.rate * (ends - apsides.times[0]) / angle.size,
            line.style,
            color=line.colour,
            linewidth=1.6,
            label=line.name,
        )
    _draw_marks(axes, apsides, known, clock, angle)
    axes.set(
        title=f"Turning of {_what(known)}",
        xlabel=f"time ({clock.symbol})",
        ylabel=f"turned counter-clockwise by ({angle.symbol})",
    )
    axes.margins(y=0.12)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=1, frameon=False)


def _lines(motion: Motion, known: IdealSummary, approximate: float | None) -> list[_Line]:
    exact = f"exact, {spell_rate(known.turning)}"
    lines = [_Line(exact, known.turning, _ink.INNER, "-")]
    if not isinstance(motion, ExactMotion):
        lines = [_Line(f"ideal: {exact}", known.turning, _ink.INNER, "-")]
    if approximate is not None:
        error = (
            f" ({spell_percent(approximate / known.precession - 1)})" if known.precession else ""
        )
        name = f"formula (25), {spell_rate(approximate)}{error}"
        lines.append(_Line(name, approximate, _ink.OUTER, "--"))
    if ground := -float(motion.rotation):
        name = f"the turning ground alone, {spell_rate(ground)}"
        lines.append(_Line(name, ground, _ink.OUTER, "-."))
    return lines


def _draw_marks(
    axes: Axes, apsides: TurningPoints, known: IdealSummary, clock: Unit, angle: Unit
) -> None:
    name = "highest" if known.whole_turns else "outer"
    axes.plot(
        apsides.times / clock.size,
        apsides.turned / angle.size,
        "o",
        color=_ink.TEXT,
        markersize=3.5,
        label=f"{name} turning points" + (", whole turns taken off" if known.whole_turns else ""),
    )


def _what(known: IdealSummary) -> str:
    if known.whole_turns:
        return "the highest point"
    return "a slight wobble about the cone" if known.is_cone else "the ellipse"


def _why_nothing(known: IdealSummary, marks: int) -> str:
    if known.high == 0:
        return "The bob is at rest:\nthere are no turning points."
    if known.regime in ("plane", "rotation"):
        return "The bob moves in a vertical plane:\nthat plane does not turn."
    if marks == 0 and math.isfinite(known.swing_period):
        return "The job ends before\nthe first outer turning point."
    return "The motion never comes back:\nthere is no next turning point."


def _say(axes: Axes, sentence: str) -> None:
    axes.set_axis_off()
    axes.text(0.5, 0.5, sentence, ha="center", va="center", color=_ink.TEXT, fontsize=11)
