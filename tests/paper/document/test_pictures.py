"""The pictures show what the formulas say: places, angles and sizes are measured in the SVG."""

import math
import re
import xml.etree.ElementTree as ElementTree
from itertools import pairwise

import pytest

import kugelpendel as kp
from kugelpendel import paper
from kugelpendel.paper.document.example import TO_BUILD, WIDE, Example
from kugelpendel.paper.document.pictures.drawing import Drawing
from kugelpendel.paper.document.pictures.geometry import geometry
from kugelpendel.paper.document.pictures.plan import ellipse, path
from kugelpendel.paper.document.pictures.sizes import sizes, sizes_drawn

WORDS = {"pull": "p", "turning": "t", "neglected": "n"}
NAMESPACE = "{http://www.w3.org/2000/svg}"


def drawn(svg: str) -> ElementTree.Element:
    return ElementTree.fromstring(svg)


def points(svg: str, style: str) -> list[list[tuple[float, float]]]:
    """The points of all paths of one style."""
    found: list[list[tuple[float, float]]] = []
    for element in drawn(svg).iter("path"):
        if element.get("class") == style:
            numbers = [float(q) for q in re.findall(r"-?[\d.]+", element.get("d", ""))]
            found.append(list(zip(numbers[::2], numbers[1::2], strict=True)))
    return found


@pytest.mark.parametrize(
    "svg",
    [
        geometry("name", "told"),
        ellipse("name", "told"),
        path(WIDE, "name", "told", ("first", "last")),
        sizes_drawn(TO_BUILD, "name", "told", WORDS, "en"),
    ],
    ids=["geometry", "ellipse", "path", "sizes"],
)
def test_a_picture_is_an_image_with_name_and_description(svg: str) -> None:
    root = drawn(svg)
    assert root.get("role") == "img"
    texts = {element.get("id"): element.text for element in root if element.get("id")}
    assert texts[root.get("aria-labelledby")] == "name"
    assert texts[root.get("aria-describedby")] == "told"
    _, _, width, height = (float(q) for q in root.get("viewBox", "").split())
    for x, y in re.findall(r'x="(-?[\d.]+)" y="(-?[\d.]+)"', svg):
        assert 0 <= float(x) <= width
        assert 0 <= float(y) <= height


def test_geometry_has_every_name() -> None:
    texts = ["".join(element.itertext()) for element in drawn(geometry("", "")).iter("text")]
    named = {text.replace("\u200b", "").replace("→", "") for text in texts}
    assert named == {"x", "y", "z", "l", "θ", "φ", "ρ", "er", "eθ", "eφ", "T", "mg"}


def test_tension_pulls_along_the_thread_and_weight_straight_down() -> None:
    svg = geometry("", "")
    tension, weight = points(svg, "force")
    (thread,) = points(svg, "thread")
    (support, bob) = thread
    assert tension[0] == weight[0] == bob

    def direction(start: tuple[float, float], end: tuple[float, float]) -> float:
        return math.atan2(end[1] - start[1], end[0] - start[0])

    assert direction(*tension) == pytest.approx(direction(bob, support), abs=0.01)
    assert direction(*weight) == pytest.approx(math.pi / 2, abs=0.01)


def test_the_ellipse_turns_counter_clockwise_and_keeps_its_shape() -> None:
    svg = ellipse("", "")
    before, after = points(svg, "dashed")[0], points(svg, "strong")[0]
    centre = (sum(q[0] for q in before[:-1]) / (len(before) - 1), before[0][1])
    for first, second in zip(before, after, strict=True):
        assert math.dist(first, centre) == pytest.approx(math.dist(second, centre), abs=0.2)
    far = max(after, key=lambda q: math.dist(q, centre))
    far = far if far[0] > centre[0] else (2 * centre[0] - far[0], 2 * centre[1] - far[1])
    assert far[1] < centre[1]  # y points down on the sheet


@pytest.mark.parametrize("swing", [WIDE, Example(1.0, 9.81, 0.9, 0.3)])
def test_the_path_is_that_of_the_exact_motion(swing: Example) -> None:
    """Every point has the azimuth that the core gives when the bob is at its distance."""
    svg = path(swing, "", "", ("", ""))
    centre, scale = (240.0, 200.0), 185.0 / swing.a
    drawn_way = max(points(svg, "way"), key=len)
    pendulum = kp.Pendulum(swing.length, swing.gravity)
    motion = kp.ExactMotion(pendulum, kp.Launch.apsides(swing.a, swing.b))
    period = 2 * math.pi / float(motion.frequency)
    turned = float(motion.precession) * period
    swings = 7
    assert len(drawn_way) == 4 * 20 * swings + 1
    for number in range(swings + 1):
        x, y = drawn_way[number * 80]
        place = motion.position(number * period)
        assert (x - centre[0]) / scale == pytest.approx(float(place[0]), abs=0.1 / scale)
        assert (centre[1] - y) / scale == pytest.approx(float(place[1]), abs=0.1 / scale)
    assert turned > 0.1
    # between the turning points the drawn path keeps to the motion's
    times = [period * number / 4000 for number in range(4001)]
    seen = [(centre[0] + scale * q[0], centre[1] - scale * q[1]) for q in motion.position(times)]
    for point in drawn_way[:80:3]:
        assert min(math.dist(point, other) for other in seen) < 0.5


def test_the_path_goes_round_counter_clockwise() -> None:
    way = max(points(path(WIDE, "", "", ("", "")), "way"), key=len)
    turns = [(a[0] - 240) * -(b[1] - 200) + (a[1] - 200) * (b[0] - 240) for a, b in pairwise(way)]
    assert min(turns) > 0


def test_sizes_of_what_is_neglected() -> None:
    found = {one.label: one.ratio for one in sizes(TO_BUILD)}
    a, b = 0.1, 0.025  # of the length
    # (16) drops −x(x² + y²)/2l² + x(ẋ² + ẏ²)/ω0²l²; at the turning point it is −a² + 2b² halves
    assert found["16:x"] == pytest.approx((a**2 - 2 * b**2) / 2, rel=1e-6)
    assert found[""] == pytest.approx(2 * b / a * 0.375 * a * b, rel=1e-6)
    assert found["20.8:1"] == pytest.approx((a**2 - b**2) / 8, rel=0.01)
    assert found["20.6"] == pytest.approx(2 * a * b * 0.375 * a * b, rel=1e-6)
    neglected = {one.label for one in paper.FORMULAS if one.step.neglected and one.section <= 4}
    # series are not terms of (13a), and what (12.3) and (13b) drop is told by (13a)
    assert neglected - set(found) == {"12.1", "12.2", "12.3:1", "13b", "16:y"}


def test_bars_are_as_long_as_the_logarithm() -> None:
    svg = sizes_drawn(TO_BUILD, "", "", WORDS, "de")
    bars = [float(q.get("width", "")) for q in drawn(svg).iter("rect")]
    ratios = [1.0, *(one.ratio for one in sizes(TO_BUILD))]
    tenfold = (bars[0] - bars[1]) / -math.log10(ratios[1])
    for width, ratio in zip(bars, ratios, strict=True):
        assert width == pytest.approx(bars[0] + tenfold * math.log10(ratio), abs=0.2)
    assert "0,44 %" in svg


def test_a_label_that_cannot_be_written_is_refused() -> None:
    sheet = Drawing("a", 10, 10)
    with pytest.raises(ValueError, match="letters with arrows and indices only"):
        sheet.formula((0, 0), r"\frac{a}{b}")
