"""What stands in one figure can be told apart by everyone: by colour, or by its dashes."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from matplotlib.colors import to_rgb

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.plot import _ink
from kugelpendel.plot._compared import _LINES
from kugelpendel.plot._rates import _SHADES, _STROKES

# Linear RGB as seen without the medium, the long and the short cones, severity 1.0: Machado,
# Oliveira & Fernandes, IEEE Trans. Vis. Comput. Graph. 15, 1291 (2009).
VISION = {
    "full": np.eye(3),
    "deuteranope": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "protanope": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "tritanope": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
}
JUST_APART = 12.0
"""Distance in CIE L*a*b* from which two lines beside one another are told apart at a glance."""


def lab(colour: str, vision: str) -> np.ndarray:
    """CIE L*a*b* under D65 of a colour as somebody sees it."""
    rgb = np.asarray(to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    linear = np.clip(VISION[vision] @ linear, 0.0, 1.0)
    to_xyz = np.array(
        [
            [0.4124564, 0.3575761, 0.1804375],
            [0.2126729, 0.7151522, 0.0721750],
            [0.0193339, 0.1191920, 0.9503041],
        ]
    )
    t = to_xyz @ linear / np.array([0.95047, 1.0, 1.08883])
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def apart(first: str, second: str, vision: str) -> float:
    return float(np.linalg.norm(lab(first, vision) - lab(second, vision)))


def test_the_simulation_knows_red_from_green_but_not_as_a_deuteranope() -> None:
    assert apart("#ff0000", "#00a000", "full") > 100
    assert apart("#c07030", "#809030", "deuteranope") < JUST_APART


@pytest.mark.parametrize("vision", VISION)
def test_colours_of_the_overview(vision: str) -> None:
    colours = (_ink.OUTER, _ink.INNER, _ink.QUIET, _ink.TEXT)
    for first, second in itertools.combinations(colours, 2):
        assert apart(first, second, vision) > JUST_APART, (first, second)


@pytest.mark.parametrize("vision", VISION)
def test_lines_of_the_comparison_differ_in_colour_or_dashes(vision: str) -> None:
    for (first, dashes), (second, others) in itertools.combinations(_LINES, 2):
        assert apart(first, second, vision) > JUST_APART or dashes != others, (first, second)


@pytest.mark.parametrize("vision", [*VISION, "grey"])
def test_causes_differ_in_colour_or_dashes(vision: str) -> None:
    """In colour, and in dashes as well, so that grey print will do."""
    strokes = {**_STROKES, "together": (_ink.TEXT, "-")}
    for (first, dashes), (second, others) in itertools.combinations(strokes.values(), 2):
        if vision == "grey":
            lightness = abs(lab(first, "full")[0] - lab(second, "full")[0])
            assert lightness > JUST_APART or dashes != others, (first, second)
        else:
            assert apart(first, second, vision) > JUST_APART, (first, second)


def test_paces_differ_in_their_hatch() -> None:
    assert len({hatch for _, hatch in _SHADES.values()}) == len(_SHADES)


@pytest.mark.parametrize("vision", VISION)
def test_time_runs_one_way_for_everyone(vision: str) -> None:
    from matplotlib.colors import to_hex

    lightness = [lab(to_hex(_ink.TIME(x)), vision)[0] for x in np.linspace(0, 1, 30)]
    assert (np.diff(lightness) > 0).all()


def test_a_few_points_are_not_joined() -> None:
    figure = _ink.blank(4, 3)
    axes = figure.add_subplot()
    _ink.draw_curve(axes, np.arange(4.0), np.arange(4.0), "--", color=_ink.TEXT)
    _ink.draw_curve(axes, np.arange(5.0), np.arange(5.0), "--", color=_ink.TEXT)
    few, enough = axes.lines
    assert (few.get_linestyle(), few.get_marker()) == ("None", "o")
    assert (enough.get_linestyle(), enough.get_marker()) == ("--", "None")


def test_no_point_of_a_comparison_is_invented() -> None:
    comparison = kp.compare(kp.Pendulum(1.0), kp.Launch.apsides(0.2, 0.1), 60.0)
    (axes,) = plot.compared(comparison).axes
    lines = [line for line in axes.lines if np.size(line.get_xdata()) > 10]
    assert len(lines) == len(comparison.rows)
    for line, row in zip(lines, comparison.rows, strict=True):
        assert row.errors is not None
        known = dict(zip(comparison.times, row.errors / comparison.amplitude, strict=True))
        unit = 60.0 if "min" in axes.get_xlabel() else 1.0
        for time, error in np.asarray(line.get_xydata()):
            nearest = min(known, key=lambda t, time=time: abs(t - time * unit))
            assert nearest == pytest.approx(time * unit, rel=1e-12)
            assert error == pytest.approx(max(known[nearest], 1e-17), rel=1e-12)


def test_plot_draws_and_holds_nothing_else() -> None:
    """The command line takes figures from here; numbers and words come from other rooms."""
    for name in plot.__all__:
        if name not in ("sweeps", "tracks"):
            assert callable(getattr(plot, name))
            assert "figure" in (getattr(plot, name).__doc__ or "").lower()
    for room in (plot.sweeps, plot.tracks):
        for name in room.__all__:
            assert callable(getattr(room, name))
            assert (getattr(room, name).__doc__ or "").startswith("Draw ")
