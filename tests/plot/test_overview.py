"""The figure: it renders in every regime, and shows what it says."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.observables import TurningPoints

ROD = kp.Pendulum(length=1.0)

MOTIONS = {
    "pantheon": (kp.Pendulum(67.0, 9.8094, 28.0), kp.Launch.ellipse(3.0, 0.01), 3600.0),
    "laboratory": (ROD, kp.Launch.apsides(0.2, 0.1), 60.0),
    "clockwise": (ROD, kp.Launch.apsides(0.2, -0.1, 2.0), 60.0),
    "tiny": (ROD, kp.Launch.apsides(1e-7, 3e-8, 0.5), 60.0),
    "tiniest": (ROD, kp.Launch.apsides(1e-9, 1e-9, 0.5), 60.0),
    "plane": (ROD, kp.Launch.ellipse(0.3, 0.0, 0.5), 10.0),
    "high": (ROD, kp.Launch.angles(1.9, 0.3, 0.1, 3.0), 10.0),
    "cone": (ROD, kp.Launch.apsides(0.5, 0.5), 10.0),
    "rest": (ROD, kp.Launch.at_rest(0.0), 10.0),
    "balance": (ROD, kp.Launch.state((0.0, 0.0, -1.0), (0.0, 0.0, 0.0)), 10.0),
    "rotation": (ROD, kp.Launch.plane(0.0, 0.0, 0.0, 7.0), 10.0),
    "separatrix": (kp.Pendulum(1.0, 9.0), kp.Launch.plane(0.0, 0.0, 0.0, 6.0), 10.0),
    "over the top": (ROD, kp.Launch.plane(0.1, 0.0, 0.0, 7.2), 20.0),
    "short": (ROD, kp.Launch.apsides(0.2, 0.1), 1e-3),
    "long": (ROD, kp.Launch.apsides(0.2, 0.05, 1.0), 3e4),
    "years": (ROD, kp.Launch.apsides(0.2, 1e-6), 1e8),
}


@pytest.fixture(params=MOTIONS)
def name(request: pytest.FixtureRequest) -> str:
    return request.param


def draw(name: str, approximate: float | None = None) -> tuple[Figure, np.ndarray]:
    """The figure and its pixels, shape (height, width, 4)."""
    pendulum, launch, duration = MOTIONS[name]
    figure = plot.overview(kp.ExactMotion(pendulum, launch), duration, approximate, "A title")
    figure.canvas.draw()
    return figure, np.asarray(figure.canvas.buffer_rgba())  # pyright: ignore[reportAttributeAccessIssue]


def test_every_regime_renders(name: str) -> None:
    figure, pixels = draw(name, approximate=0.02)
    assert pixels.shape[:2] == (1066, 1430)
    inked = (pixels[..., :3] < 250).any(axis=-1)
    assert 0.003 < inked.mean() < 0.5
    for axes in figure.axes:
        for text in (axes.get_title(), axes.get_xlabel(), axes.get_ylabel()):
            assert "nan" not in text
            assert "inf" not in text


def test_axes_say_their_units(name: str) -> None:
    figure, _ = draw(name)
    for axes in figure.axes:
        if not axes.axison or axes.get_label() == "<colorbar>":
            continue
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            assert label.endswith(")"), label
            assert "(" in label


def test_nothing_sticks_out_or_overlaps(name: str) -> None:
    figure, _ = draw(name, approximate=0.02)
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


def test_ticks_are_few_enough_to_read(name: str) -> None:
    figure, _ = draw(name)
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            shown = [tick for tick in axis.get_majorticklocs() if low <= tick <= high]
            assert len(shown) <= 11


def test_plan_has_one_scale_and_the_turning_circles() -> None:
    figure, _ = draw("laboratory")
    plan = figure.axes[0]
    assert plan.get_aspect() == 1
    radii = [
        np.hypot(*np.asarray(line.get_data()))
        for line in plan.lines
        if "turning circle" in str(line.get_label())
    ]
    assert_allclose(radii[0], 20.0, rtol=1e-12)
    assert_allclose(radii[1], 10.0, rtol=1e-12)
    drawn = [artist for artist in plan.collections if isinstance(artist, LineCollection)]
    points = np.concatenate(drawn[0].get_segments())
    distance = np.hypot(*points.T)
    assert distance.max() == pytest.approx(20.0, rel=1e-4)
    assert distance.min() == pytest.approx(10.0, rel=1e-3)


def test_narrow_ellipse_is_shown_stretched_too() -> None:
    titles = [axes.get_title() for axes in draw("pantheon")[0].axes]
    assert "The same, stretched 100-fold across" in titles
    assert not any("stretched 1" in axes.get_title() for axes in draw("laboratory")[0].axes)


@pytest.mark.parametrize("case", ["laboratory", "clockwise", "high", "over the top", "cone"])
def test_marks_of_the_apsides_lie_on_the_exact_line(case: str) -> None:
    axes = draw(case)[0].axes[-2]
    exact, marks = (np.asarray(line.get_data()) for line in axes.lines)
    line = np.interp(marks[0], *exact)
    assert_allclose(marks[1], line, atol=1e-6 * np.abs(exact[1]).max())


def test_long_tracks_are_thinned_and_say_so() -> None:
    figure, _ = draw("long")
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert any("16 of" in label and "the first" in label for label in labels)


def test_drawing_leaves_no_global_state() -> None:
    before = dict(mpl.rcParams)
    draw("laboratory")
    assert dict(mpl.rcParams) == before


def test_svg_is_small_and_always_the_same(tmp_path: Path) -> None:
    paths = [tmp_path / "first.svg", tmp_path / "second.svg"]
    for path in paths:
        plot.save(draw("laboratory")[0], path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert paths[0].stat().st_size < 300_000


APPROXIMATIONS = [kp.LinearMotion, kp.OlssonMotion, kp.SeriesMotion, kp.CubicMotion, kp.PlaneMotion]
FORCED = [
    kp.RealMotion(ROD, kp.Launch.apsides(0.2, 0.1)),
    kp.RealMotion(ROD, kp.Launch.ellipse(0.2, 0.0), site=kp.Site(0.8, gravity=9.80665)),
    kp.RealMotion(ROD, kp.Launch.apsides(0.2, 0.1), drag=kp.Drag(1e-3)),
    kp.RealMotion(ROD, kp.Launch.angles(1.9, 0.3, 0.1, 3.0), thread="rod"),
    kp.EnvelopeMotion(ROD, kp.Launch.apsides(0.2, 0.1), drag=kp.Drag(1e-3)),
]


@pytest.mark.parametrize(
    "motion",
    [*(make(ROD, kp.Launch.apsides(0.2, 0.1, 0.3)) for make in APPROXIMATIONS), *FORCED],
    ids=lambda motion: type(motion).__name__,
)
def test_any_motion_can_be_drawn(motion: kp.Motion) -> None:
    figure = plot.overview(motion, 40.0)
    figure.canvas.draw()
    (apsides,) = (axes for axes in figure.axes if axes.get_title().startswith("Turning of"))
    assert np.size(apsides.lines[-1].get_data()[0]) > 10
    assert "turning points" in str(apsides.lines[-1].get_label())


@pytest.mark.parametrize("make", APPROXIMATIONS)
def test_marks_of_an_approximation_are_its_own(make: type[kp.Motion]) -> None:
    """The apsides turn by the motion's own precession, not by the exact one beside it."""
    motion = make(ROD, kp.Launch.apsides(0.4, 0.2))  # pyright: ignore[reportCallIssue]
    known = kp.IdealSummary.of(motion)
    apsides = TurningPoints.of(motion, known, 60.0, 24)
    assert len(apsides.times) == 24
    expected = float(motion.precession) * (apsides.times - apsides.times[0])
    assert_allclose(apsides.turned, expected, atol=1e-9)


@pytest.mark.parametrize("duration", [-1.0, 0.0, math.inf, math.nan])
def test_a_duration_that_makes_no_sense(duration: float) -> None:
    with pytest.raises(kp.InvalidInput, match="a duration that is positive and finite, but it is"):
        plot.overview(kp.ExactMotion(ROD, kp.Launch.apsides(0.2, 0.1)), duration)


def test_an_ensemble_is_refused_with_the_way_out() -> None:
    motion = kp.ExactMotion(ROD, kp.Launch.apsides([0.2, 0.3], 0.1))
    with pytest.raises(
        kp.InvalidInput, match=r"shape \(2,\); pick one of its motions, motion\[0\]"
    ):
        plot.overview(motion, 10.0)
    plot.overview(motion[0], 10.0)


def test_a_notebook_shows_the_figure() -> None:
    """A notebook asks an object for `_repr_png_` where no window of pyplot is open."""
    png = draw("laboratory")[0]._repr_png_()  # pyright: ignore[reportAttributeAccessIssue]
    assert png.startswith(b"\x89PNG")
    assert len(png) > 20_000
