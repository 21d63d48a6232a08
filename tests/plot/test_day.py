"""The figure of a real job: it renders for every story, says its units, and nothing overlaps."""

from __future__ import annotations

import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.motion import PrecessionBudget
from kugelpendel.observables import Apsides

SITE = kp.Site(math.radians(48.0))
PENDULUM = kp.Pendulum(20.0, float(SITE.gravity))
DRAG = kp.Drag.from_half_life(5400.0)

STORIES = {
    "day": (kp.Launch.ellipse(1.0, 0.0), {"site": SITE, "drag": DRAG}, 86400.0),
    "clamp": (
        kp.Launch.ellipse(0.5, 0.0),
        {"site": SITE, "suspension": kp.Suspension(5e-7, 0.4, 2e-5, 0.9)},
        6 * 3600.0,
    ),
    "stalls": (
        kp.Launch.ellipse(0.5, 0.0),
        {"site": SITE, "suspension": kp.Suspension(0.0, 0.0, 3e-4, 0.4), "drag": kp.Drag(3e-4)},
        8 * 3600.0,
    ),
    "no earth": (kp.Launch.apsides(1.0, -0.4), {"drag": DRAG}, 1800.0),
    "one swing": (kp.Launch.ellipse(1.0, 0.0), {"site": SITE}, 20.0),
    "south": (kp.Launch.ellipse(1.0, 0.02), {"site": kp.Site(-0.6), "drag": DRAG}, 7200.0),
}


@pytest.fixture(params=STORIES)
def name(request: pytest.FixtureRequest) -> str:
    return request.param


def draw(name: str, told: bool = True) -> tuple[Figure, Apsides, PrecessionBudget]:
    launch, forces, duration = STORIES[name]
    averaged = kp.EnvelopeMotion(PENDULUM, launch, **forces)
    times = np.linspace(0.0, duration, 500)
    a, b = averaged.semi_axes(times).T
    site = forces.get("site")
    ideal = -float(site.vertical_rotation) if site is not None else 0.0
    apsides = Apsides(times, a, b, averaged.azimuth(times), ideal, float(np.abs(b).max()))
    shares = averaged.rates(times)
    real = kp.RealMotion(PENDULUM, launch, **forces)
    figure = plot.day(real, apsides, shares if told else None, "A title")
    figure.canvas.draw()
    return figure, apsides, shares


def test_every_story_renders(name: str) -> None:
    figure, _, _ = draw(name)
    pixels = np.asarray(figure.canvas.buffer_rgba())  # pyright: ignore[reportAttributeAccessIssue]
    assert pixels.shape[:2] == (1196, 1560)
    inked = (pixels[..., :3] < 250).any(axis=-1)
    assert 0.01 < inked.mean() < 0.5
    for axes in figure.axes:
        for text in (axes.get_title(), axes.get_xlabel(), axes.get_ylabel()):
            assert "nan" not in text
            assert "inf" not in text


def test_axes_say_their_units(name: str) -> None:
    figure, _, _ = draw(name)
    for axes in figure.axes:
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            assert label == "" or re_unit(label), label
        assert axes.get_ylabel() != ""


def re_unit(label: str) -> bool:
    return label.endswith(")") and "(" in label


def test_nothing_sticks_out_or_overlaps(name: str) -> None:
    figure, _, _ = draw(name)
    renderer = figure.canvas.get_renderer()  # pyright: ignore[reportAttributeAccessIssue]
    boxes = [axes.get_tightbbox(renderer) for axes in figure.axes]
    width, height = figure.canvas.get_width_height()
    for index, box in enumerate(boxes):
        assert box is not None
        assert box.x0 >= 0
        assert box.y0 >= 0
        assert box.x1 <= width
        assert box.y1 <= height
        for other in boxes[:index]:
            assert other is not None
            overlap = (
                min(box.x1, other.x1) - max(box.x0, other.x0),
                min(box.y1, other.y1) - max(box.y0, other.y0),
            )
            assert min(overlap) < 1, (name, index)


def test_ideal_line_stands_beside_the_azimuth() -> None:
    figure, apsides, _ = draw("clamp")
    azimuth, ahead = figure.axes[:2]
    seen, ideal = (np.asarray(line.get_ydata()) for line in azimuth.lines)
    assert_allclose(seen, np.degrees(apsides.azimuth))
    assert np.ptp(ideal) == pytest.approx(15.041 * 6 * math.sin(math.radians(48)), rel=1e-4)
    labels = [text.get_text() for text in azimuth.get_legend().get_texts()]  # pyright: ignore[reportOptionalMemberAccess]
    assert labels[1] == r"$−Ω_\mathrm{E}$ sin(latitude), −11.18 °/h"
    apart = np.asarray(ahead.lines[1].get_ydata())
    assert_allclose(apart, seen - ideal, atol=1e-9)


def test_paces_are_shaded_and_named() -> None:
    names = {"clamp": {"hurries", "lags"}, "stalls": {"stalls", "standstill"}}
    for story, wanted in names.items():
        rates = next(axes for axes in draw(story)[0].axes if "What turns" in axes.get_title())
        legend = rates.get_legend()
        assert legend is not None
        assert wanted <= {text.get_text() for text in legend.get_texts()}


def test_causes_add_up_to_the_thick_line() -> None:
    figure, _, shares = draw("clamp")
    rates = next(axes for axes in figure.axes if "What turns" in axes.get_title())
    lines = {str(line.get_label()): np.asarray(line.get_ydata()) for line in rates.lines}
    assert {"intrinsic", "anisotropy", "damping", "together"} <= lines.keys()
    assert "drive" not in lines
    total = lines["intrinsic"] + lines["anisotropy"] + lines["damping"]
    assert_allclose(total, lines["together"], atol=1e-9)
    assert_allclose(lines["together"], np.degrees(shares.beyond_earth) * 3600)


def test_without_averaged_equations_the_figure_says_so() -> None:
    figure, _, _ = draw("day", told=False)
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert any("cannot be told apart" in text for text in texts)


def test_plan_shows_swings_of_the_whole_time() -> None:
    figure, _, _ = draw("clamp")
    plan = next(axes for axes in figure.axes if "from above" in axes.get_title())
    assert plan.get_title() == "6 swings from above"
    assert plan.get_aspect() == 1
    (drawn,) = plan.collections
    times = np.asarray(drawn.get_array())
    assert times.min() < 0.1
    assert times.max() > 5.9
