"""What holds for every figure: a notebook shows it, nothing is cut off, bad input is refused."""

# What is wrong on purpose, and what matplotlib leaves untyped.
# pyright: reportArgumentType=false, reportAttributeAccessIssue=false

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.observables import Apsides

SITE = kp.Site(math.radians(48.0))
PENDULUM = kp.Pendulum(4.803, float(SITE.gravity))
UNEVEN = kp.Forces(
    site=SITE,
    drag=kp.Drag(2e-4),
    suspension=kp.Suspension(1e-4, 0.4, 1e-5, 0.9),
    drive=kp.Drive(4e-5, phase=0.3),
)
LAUNCH = kp.Launch.ellipse(0.12, 0.003)
REAL = kp.RealMotion(PENDULUM, LAUNCH, UNEVEN)
MEAN = kp.EnvelopeMotion(PENDULUM, LAUNCH, UNEVEN)
DESIGN = kp.design(PENDULUM, 0.12, 0.003, forces=UNEVEN, checked=False)
TITLE = "größe_und maß_2, 5 $ je Stück"


def apsides(count: int = 200) -> Apsides:
    times = np.linspace(0.0, 7200.0, count)
    a, b = MEAN.semi_axes(times).T
    return Apsides(times, a, b, MEAN.azimuth(times), -float(SITE.vertical_rotation), 0.01)


FIGURES: dict[str, Callable[[str], Figure]] = {
    "overview": lambda title: plot.overview(
        kp.ExactMotion(PENDULUM, LAUNCH), 600.0, 1e-6, title=title
    ),
    "day": lambda title: plot.day(REAL, apsides(), MEAN.rates(apsides().times), title),
    "design": lambda title: plot.design(DESIGN, title),
    "portrait": lambda title: plot.portrait(MEAN, 7200.0, title),
    "compared": lambda title: plot.compared(kp.compare(PENDULUM, LAUNCH), title),
    "validity": lambda title: plot.validity(kp.validity_map(n=60), (0.1, 0.2), title),
}

MOTIONS: dict[str, kp.Motion] = {
    "exact": kp.ExactMotion(PENDULUM, LAUNCH),
    "real": REAL,
    "envelope": MEAN,
    "linear": kp.LinearMotion(PENDULUM, LAUNCH),
    "olsson": kp.OlssonMotion(PENDULUM, LAUNCH),
    "series": kp.SeriesMotion(PENDULUM, LAUNCH, order=6),
    "plane": kp.PlaneMotion(PENDULUM, LAUNCH),
    "cubic": kp.CubicMotion(PENDULUM, LAUNCH),
}


@pytest.fixture(params=FIGURES, scope="module")
def figure(request: pytest.FixtureRequest) -> Figure:
    return FIGURES[request.param](TITLE)


def shown(figure: Figure) -> bytes:
    """What a notebook gets of a figure that is the last line of a cell."""
    return figure._repr_png_()


def test_every_figure_is_asked_for_here() -> None:
    # Those of sweeps and tracks are drawn by test_sweeps.py and test_tracks.py.
    assert {*FIGURES, "save", "sweeps", "tracks"} == set(plot.__all__)


def test_a_notebook_shows_it(figure: Figure) -> None:
    assert shown(figure).startswith(b"\x89PNG")


@pytest.mark.parametrize("name", MOTIONS)
def test_a_notebook_shows_every_motion(name: str) -> None:
    assert shown(plot.overview(MOTIONS[name], 30.0)).startswith(b"\x89PNG")


def texts(figure: Figure) -> list[Text]:
    found = figure.findobj(Text)
    return [text for text in found if isinstance(text, Text) and text.get_text().strip()]


def test_no_label_is_raw(figure: Figure) -> None:
    """No underscore but in a formula, no hyphen for a minus sign; the title is that given."""
    title = figure.get_suptitle()
    for text in texts(figure):
        if text.get_text() in (title, TITLE):
            assert not text.get_parse_math()
            continue
        said = re.sub(r"\$[^$]*\$", "", text.get_text())
        assert "_" not in said, said
        assert not re.search(r"(?<![a-z])-\d", said), said


def test_the_title_is_not_read_as_a_formula(figure: Figure) -> None:
    if "formulas for small ellipses" not in figure.get_suptitle():
        assert figure.get_suptitle().startswith("Größe_und maß_2, 5 $ je Stück")


def test_nothing_is_cut_off(figure: Figure) -> None:
    figure.canvas.draw()
    box = figure.get_tightbbox()  # inches
    width, height = figure.get_size_inches()
    assert min(box.x0, box.y0) > -0.02
    assert box.x1 < width + 0.02
    assert box.y1 < height + 0.02


def test_a_design_says_which_pendulum() -> None:
    assert plot.design(DESIGN).get_suptitle() == "4.803 m, a = 12 cm, b = 3 mm"
    assert plot.portrait(DESIGN.portrait, title="x").get_suptitle().startswith("X: 4.803 m, a = ")


def test_a_bar_that_cannot_be_seen_is_not_drawn() -> None:
    even = kp.Suspension(1e-9, 0.4)
    found = kp.design(PENDULUM, 0.12, 0.003, site=SITE, suspension=even, checked=False)
    axes = plot.design(found).axes[0]
    widths = [bar.get_width() for bar in axes.patches]
    low, high = axes.get_xlim()
    assert min(abs(width) for width in widths) > 0.002 * (high - low)
    assert len(widths) < len(axes.get_yticks())


BAD: dict[str, tuple[Callable[[], Any], str]] = {
    "backwards": (lambda: plot.overview(REAL, duration=-1), r"positive and finite, but it is -1 s"),
    "no time": (lambda: plot.overview(REAL, 0.0), r"positive and finite, but it is 0 s"),
    "for ever": (lambda: plot.overview(REAL, math.inf), r"but it is inf s"),
    "no number": (lambda: plot.overview(REAL, "1 h"), r"duration .*'1 h'"),
    "many times": (lambda: plot.overview(REAL, [1.0, 2.0]), r"shape \(2,\)"),
    "no motion": (lambda: plot.overview(PENDULUM, 1.0), r"kp\.ExactMotion\("),
    "no rate": (lambda: plot.overview(REAL, 1.0, math.nan), r"finite rate in rad/s, but it is nan"),
    "title": (lambda: plot.overview(REAL, 1.0, None, 3), r"must be text, but it is 3"),
    "ensemble": (
        lambda: plot.overview(kp.ExactMotion(PENDULUM, kp.Launch.ellipse([0.1, 0.2], 0.0)), 1.0),
        r"ensemble of shape \(2,\); pick one",
    ),
    "day of an ideal one": (
        lambda: plot.day(MOTIONS["exact"], apsides(), None),
        r"RealMotion or kugelpendel\.EnvelopeMotion",
    ),
    "no apsides": (lambda: plot.day(REAL, None, None), r"must be a .*Apsides, but they are None"),
    "no turning point": (lambda: plot.day(REAL, apsides(0), None), r"No turning point"),
    "no shares": (lambda: plot.day(REAL, apsides(), 3), r"EnvelopeMotion\.rates"),
    "no design": (lambda: plot.design(PENDULUM), r"kp\.design\(pendulum, a, b\)"),
    "no portrait": (lambda: plot.portrait(3), r"Portrait or .* it is 3 of type int"),
    "path back": (lambda: plot.portrait(MEAN, -1.0), r"positive and finite, but it is until -1 s"),
    "no comparison": (lambda: plot.compared(None), r"write kp\.compare"),
    "no map": (lambda: plot.validity(DESIGN), r"write kp\.validity_map\(\)"),
    "mark": (lambda: plot.validity(kp.validity_map(n=20), (3.0, 0.1)), r"a/l between 0 and 1.*3"),
    "half a mark": (lambda: plot.validity(kp.validity_map(n=20), 0.1), r"mark=\(a / l, b / a\)"),
    "no figure": (lambda: plot.save(None, "x.png"), r"Only a figure can be saved"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_input_gets_a_sentence(name: str) -> None:
    call, sentence = BAD[name]
    with pytest.raises(kp.InvalidInput, match=sentence) as caught:
        call()
    assert str(caught.value).endswith(".")


def test_a_kind_of_picture_that_is_not_known(tmp_path: Path) -> None:
    figure = plot.design(DESIGN)
    for name in ("figure.docx", "figure"):
        with pytest.raises(kp.InvalidInput, match=r"let it end with \.png, \.svg or \.pdf"):
            plot.save(figure, tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_a_german_name_of_a_file(tmp_path: Path) -> None:
    path = tmp_path / "größe und maß.svg"
    plot.save(FIGURES["overview"](TITLE), path)
    assert "Größe_und maß_2, 5 $ je Stück" in path.read_text(encoding="utf-8")
