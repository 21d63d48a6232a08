"""The map of all ellipses of one size: where the plane goes round, and where it turns back."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

from kugelpendel.motion import EnvelopeMotion, RealMotion
from kugelpendel.observables import Portrait
from kugelpendel.parameters import InvalidInput, require_type
from kugelpendel.plot import _ink
from kugelpendel.spelling import general, minus, spell, spell_rate, unit_for

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import RcKeyType
    from numpy.typing import NDArray

_COLUMNS, _ROWS = 240, 241
"""Of the grid on which the regions are told apart."""

_LINES = 13
"""Orbits that are drawn beside the one that is asked for."""

_STRETCH = 0.5
"""The scale of b is even up to this part of the widest ellipse on the orbit, logarithmic beyond."""

_REGIONS = (
    ("turns back", "#f0c9c2", "//"),
    ("goes round with the Earth", "#dceaf3", ""),
    ("goes round against the Earth", "#f7eec8", ".."),
)
"""What a plane does, its tint, and its hatch for whoever sees no tint."""

_APART = 0.08
"""Between two ticks, of half the height of the map."""

_READINGS = 4000
"""Of a real path."""


def portrait(
    given: Portrait | RealMotion | EnvelopeMotion, until: float | None = None, title: str = ""
) -> Figure:
    """Draw the map of the sphere on which an uneven clamp moves the ellipse.

    Across is the azimuth of the plane, upwards the width of the ellipse, b, counter-clockwise
    above and clockwise below, stretched where it is small; the edges above and below are circles.
    Tints tell what the plane does without drag and drive, lines are orbits, and the thick one is
    that of the pendulum given.

    Parameters
    ----------
    given
        A portrait, or a single motion, of which the launch is looked at.
    until
        s. Of a motion, its averaged path up to this time is drawn as well, with drag and drive.
    title
        Above the figure.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it. Above it stands which pendulum it is.

    Raises
    ------
    InvalidInput
        For an ensemble and for what is neither, for a path without a motion or until a time that
        is not positive and finite, for a title that is no text, and for what `EnvelopeMotion`
        refuses where a path is asked for.
    """
    way_out = "write kp.RealMotion(pendulum, launch, forces)"
    require_type("What is drawn", given, Portrait, RealMotion, EnvelopeMotion, way_out=way_out)
    if until is not None and not 0 < _ink.one_number("until", until, "s") < math.inf:
        raise InvalidInput(
            f"A path can be followed for a time that is positive and finite, but it is until "
            f"{until:.6g} s; give the seconds from the launch on."
        )
    if isinstance(given, Portrait):
        if until is not None:
            raise InvalidInput(
                f"A portrait has no path of its own to follow until {until:.6g} s; give the motion "
                f"in its place."
            )
        found, motion = given, None
    else:
        found, motion = Portrait.of(given), given
    style: dict[RcKeyType, Any] = {**_ink.STYLE, "hatch.color": "#c9a9a3", "hatch.linewidth": 0.6}
    with mpl.rc_context(style):
        figure = _ink.blank(9.0, 7.2)
        axes = figure.subplots()
        handles = _draw_map(axes, found)
        if motion is not None and until is not None:
            handles.append(_draw_path(axes, found, motion, until))
        figure.legend(handles=handles, loc="outside lower center", ncols=3, frameon=False)
        _label(axes, found)
        _ink.entitle(figure, _ink.naming(title, found.pendulum, found.a, found.b), 80)
    return figure


def _draw_map(axes: Axes, found: Portrait) -> list[Artist]:
    ruler = unit_for(found.a, "m")
    size = math.hypot(found.a, found.b) / ruler.size
    circle = size / math.sqrt(2)
    orbit = found.orbit
    linear = min(max(_STRETCH * orbit.widest / ruler.size, 1e-4 * circle), circle)
    axes.set_yscale("asinh", linear_width=linear)
    axes.set_ylim(-circle, circle)
    left, right = (math.degrees(found.axis) + side for side in (-90.0, 90.0))
    axes.set_xlim(left, right)
    azimuth = np.linspace(left, right, _COLUMNS)
    rows = linear * np.sinh(np.linspace(-1, 1, _ROWS) * math.asinh(circle / linear))
    # At the circles themselves no plane turns; their rows are tinted like the next ones.
    b = np.clip(rows, rows[1], rows[-2])
    circularity = np.sin(2 * np.arcsin(b / size))
    longitude = 2 * (np.radians(azimuth) - found.axis)
    handles = _tint(axes, found, azimuth, rows, found.mean_rate(circularity[:, None], longitude))
    heights = found.invariant(circularity[:, None], longitude)
    lines = np.quantile(heights, np.linspace(0.02, 0.98, _LINES))
    levels = np.unique(lines)
    axes.contour(azimuth, rows, heights, levels, colors=_ink.QUIET, linewidths=0.6,
                 negative_linestyles="solid")  # fmt: skip
    for saddle in (place for place in found.equilibria if not place.stable):
        level = float(found.invariant(saddle.circularity, saddle.longitude))
        axes.contour(azimuth, rows, heights, [level], colors=_ink.TEXT, linewidths=1.2,
                     linestyles="dashed")  # fmt: skip
        handles.append(Line2D([], [], color=_ink.TEXT, linestyle="--", label="separatrix"))
    own = "this pendulum, without drag and drive"
    handles.append(_draw_line(axes, found, *found.path(), size, _ink.INNER, 2.2, own))
    for place in found.equilibria:
        x, y = _placed(found, np.array([place.circularity]), np.array([place.longitude]), size)
        axes.plot(x, y, "o" if place.stable else "x", color=_ink.TEXT, markersize=5)
    start = _placed(found, np.array([orbit.circularity]), np.array([orbit.longitude]), size)
    axes.plot(*start, "o", color=_ink.INNER, markersize=8, markeredgecolor="white", zorder=5)
    ticks = _ticks(linear, circle)
    axes.set_yticks(ticks, [general(value) for value in ticks])
    axes.set_yticks([], minor=True)
    axes.xaxis.set_major_locator(MultipleLocator(30))
    axes.set(
        xlabel="azimuth of the plane (°), counter-clockwise from x",
        ylabel=f"half-width of the ellipse b ({ruler.symbol}), + counter-clockwise",
    )
    return handles


def _ticks(linear: float, most: float) -> list[float]:
    """Round numbers up to the largest, apart enough on a scale that is even up to `linear`."""
    room = _APART * math.asinh(most / linear)
    powers = range(math.floor(math.log10(linear)) - 1, math.floor(math.log10(most)) + 1)
    ticks = [0.0]
    for value in (digit * 10.0**power for power in powers for digit in (1, 2, 5)):
        if value <= most and math.asinh(value / linear) - math.asinh(ticks[-1] / linear) > room:
            ticks.append(value)
    return [-value for value in reversed(ticks[1:])] + ticks


def _tint(
    axes: Axes,
    found: Portrait,
    azimuth: NDArray[np.float64],
    rows: NDArray[np.float64],
    rates: NDArray[np.float64],
) -> list[Artist]:
    """Fill the regions, and give what tells of those that are there."""
    site = found.forces.site
    rotation = 0.0 if site is None else float(site.vertical_rotation)
    with_earth = -math.copysign(1.0, rotation) if rotation else 1.0
    senses = np.sign(rates) * with_earth
    names = [name for name, *_ in _REGIONS]
    if not rotation:
        names[1:] = ["goes round counter-clockwise", "goes round clockwise"]
    handles: list[Artist] = []
    for name, (_, tint, hatch), sense in zip(names, _REGIONS, (0, 1, -1), strict=True):
        here = (senses == sense).astype(float)
        if here.any():
            axes.contourf(azimuth, rows, here, [0.5, 1.5], colors=[tint], hatches=[hatch])
            handles.append(Patch(facecolor=tint, hatch=hatch, edgecolor=_ink.QUIET, label=name))
    return handles


def _placed(
    found: Portrait,
    circularity: NDArray[np.float64],
    longitude: NDArray[np.float64],
    size: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Azimuth in degrees, within a quarter turn of the axis, and b in the unit of `size`."""
    wrapped = np.remainder(longitude + math.pi, 2 * math.pi) - math.pi
    azimuth = np.degrees(found.axis + wrapped / 2)
    return azimuth, size * np.sin(np.arcsin(circularity) / 2)


def _draw_line(
    axes: Axes,
    found: Portrait,
    circularity: NDArray[np.float64],
    longitude: NDArray[np.float64],
    size: float,
    colour: str,
    width: float,
    label: str,
) -> Artist:
    azimuth, b = _placed(found, circularity, longitude, size)
    # Not across the map where a line leaves it on one side and comes in on the other.
    leaves = np.flatnonzero(np.abs(np.diff(azimuth)) > 90) + 1
    azimuth, b = np.insert(azimuth, leaves, np.nan), np.insert(b, leaves, np.nan)
    (line,) = axes.plot(azimuth, b, color=colour, linewidth=width, label=label, zorder=4)
    return line


def _draw_path(
    axes: Axes, found: Portrait, motion: RealMotion | EnvelopeMotion, until: float
) -> Artist:
    """Where the averaged motion goes on this map with everything that acts."""
    averaged = motion
    if not isinstance(averaged, EnvelopeMotion):
        averaged = EnvelopeMotion(motion.pendulum, motion.launch, motion.forces)
    times = np.linspace(0.0, until, _READINGS)
    a, b = np.moveaxis(averaged.semi_axes(times), -1, 0)
    circularity = np.clip(2 * a * b / (a**2 + b**2), -1.0, 1.0)
    longitude = 2 * (averaged.azimuth(times) - found.axis)
    size = math.hypot(found.a, found.b) / unit_for(found.a, "m").size
    label = f"with all that acts, {spell(until, 's', 3)}"
    return _draw_line(axes, found, circularity, longitude, size, _ink.OUTER, 1.1, label)


def _label(axes: Axes, found: Portrait) -> None:
    """Say what the plane of this pendulum does."""
    orbit = found.orbit
    time = "" if math.isinf(orbit.period) else f"in {spell(orbit.period, 's', 3)}"
    if orbit.verdict == "round":
        said = f"goes round: half a turn {time}, {spell_rate(orbit.rate, 4)} in the mean"
    elif orbit.verdict == "stands":
        said = "stays as it is"
    else:
        west, east = (minus(f"{math.degrees(edge):.1f}°") for edge in orbit.azimuths)
        said = f"swings to and fro between {west} and {east}, once {time}"
    axes.set_title(textwrap.fill(f"Without drag and drive the plane {said}", 72))
