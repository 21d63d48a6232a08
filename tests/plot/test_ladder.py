"""The figures of the ladder: errors against time, and the map of the formulas."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.contour import QuadContourSet
from matplotlib.figure import Figure
from numpy.testing import assert_allclose

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.observables import LEVELS

UNIT = kp.Pendulum(length=1.0)
LAUNCHES = {
    "ellipse": kp.Launch.apsides(0.2, 0.1),
    "circle": kp.Launch.apsides(0.2, 0.2),
    "rest": kp.Launch.at_rest(0.0),
    "above": kp.Launch.at_rest(2.0),
    "crossing": kp.Launch.plane(0.1, 0.0, 0.0, 7.2),
}


def texts(figure: Figure) -> list[str]:
    return [text.get_text() for axes in figure.axes for text in axes.texts]


def drawn(figure: Figure) -> np.ndarray:
    figure.canvas.draw()
    return np.asarray(figure.canvas.buffer_rgba())  # pyright: ignore[reportAttributeAccessIssue]


@pytest.mark.parametrize("name", LAUNCHES)
def test_errors_of_every_launch_can_be_drawn(name: str) -> None:
    comparison = kp.compare(UNIT, LAUNCHES[name])
    figure = plot.compared(comparison, "A title")
    assert drawn(figure).std() > 0
    lines = figure.axes[0].lines
    shown = [row for row in comparison.rows if row.errors is not None]
    assert len(lines) == len(shown)
    if shown:
        assert len(texts(figure)) == len(lines)
    else:
        assert texts(figure) == ["Only the exact motion holds for this launch."]


def test_lines_are_the_largest_errors_of_each_half_swing() -> None:
    comparison = kp.compare(UNIT, LAUNCHES["ellipse"])
    axes = plot.compared(comparison).axes[0]
    assert axes.get_yscale() == "log"
    for line, row in zip(axes.lines, comparison.rows, strict=True):
        times, errors = np.asarray(line.get_data())
        assert len(times) == 40  # half swings
        assert row.largest is not None
        assert errors.max() == pytest.approx(row.largest / 0.2)


def test_motions_that_do_not_hold_are_named() -> None:
    figure = plot.compared(kp.compare(UNIT, LAUNCHES["crossing"]))
    assert "OlssonMotion" in figure.get_supxlabel()
    assert len(figure.axes[0].lines) == 2


def test_labels_do_not_touch() -> None:
    figure = plot.compared(kp.compare(UNIT, LAUNCHES["rest"]))
    heights = sorted(text.xyann[1] for text in figure.axes[0].texts)  # pyright: ignore[reportAttributeAccessIssue]
    assert min(np.diff(heights)) > 0.04


@pytest.fixture(scope="module")
def validity_map() -> kp.ValidityMap:
    return kp.validity_map(n=200)


def test_map_has_every_formula_and_order(validity_map: kp.ValidityMap) -> None:
    figure = plot.validity(validity_map, (0.05, 0.3), "my pendulum")
    assert drawn(figure).std() > 0
    titles = [axes.get_title() for axes in figure.axes]
    assert titles[:2] == ["Precession by the formula (25)", "Frequency by the formula (26)"]
    assert sum("Precession, order" in title for title in titles) == 6
    assert sum("Frequency, order" in title for title in titles) == 6
    assert texts(figure).count("my pendulum") == 2
    for label in ("0.01 %", "0.1 %", "1 %", "10 %"):
        assert label in texts(figure)


def test_lines_lie_where_the_error_is(validity_map: kp.ValidityMap) -> None:
    axes = plot.validity(validity_map).axes[0]
    (lines,) = [c for c in axes.collections if isinstance(c, QuadContourSet) and not c.filled]
    for level, path in zip(LEVELS, lines.get_paths(), strict=True):
        vertices = np.asarray(path.vertices)
        a, ratio = vertices[:: max(1, len(vertices) // 20)].T
        error = np.asarray(kp.validity(a, a * ratio, 1.0).formula_25)
        assert_allclose(-error, level, rtol=0.03)  # between points 0.005 apart


@pytest.mark.parametrize("mark", [(0.6, 0.4), (0.45, 0.2), (0.3, 0.6), (0.05, 0.5), (0.55, 0.9)])
def test_a_mark_and_its_name_cover_no_label(
    validity_map: kp.ValidityMap, mark: tuple[float, float]
) -> None:
    figure = plot.validity(validity_map, mark, "museum")
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    for axes in figure.axes:
        point = axes.transData.transform(mark)
        names = [text for text in axes.texts if text.get_text() == "museum"]
        for label in axes.texts:
            if label in names:
                continue
            seen = label.get_window_extent(canvas.get_renderer())
            assert not seen.padded(3.0).contains(*point), (axes.get_title(), label.get_text())
            for name in names:
                assert not seen.overlaps(name.get_window_extent(canvas.get_renderer()))


def test_on_a_circle_one_height_is_drawn() -> None:
    # Both turning heights are one; the line is that of the circle in the plan view.
    circle = kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.3, 0.3))
    figure = plot.overview(circle, 20.0)
    (side,) = (axes for axes in figure.axes if axes.get_title().startswith("From the side"))
    assert [line.get_linestyle() for line in side.lines] == ["--"]
