"""The map of a clamp: its orbit, its regions, its words, and what is refused."""

import math

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel import plot

SITE = kp.Site(math.radians(43.53))
CLAMP = kp.Suspension(1.5e-4, math.radians(17.2))
GUELPH = kp.RealMotion(
    kp.Pendulum(0.83, SITE.gravity), kp.Launch.ellipse(0.03, 0.0), site=SITE, suspension=CLAMP,
    drag=kp.Drag(1e-3), drive=kp.Drive(1.0395e-4, phase=math.radians(24.95)),
)  # fmt: skip


def labels(figure) -> list[str]:
    (legend,) = figure.legends
    return [text.get_text() for text in legend.get_texts()]


def test_regions_orbit_and_path_of_a_motion() -> None:
    figure = plot.portrait(GUELPH, until=36 * 3600.0, title="guelph")
    (axes,) = figure.axes
    assert labels(figure) == [
        "turns back",
        "goes round with the Earth",
        "goes round against the Earth",
        "separatrix",
        "this pendulum, without drag and drive",
        "with all that acts, 36.0 h",
    ]
    lines = {line.get_label(): line for line in axes.lines}
    portrait = kp.Portrait.of(GUELPH)
    azimuth, b = np.array(lines["this pendulum, without drag and drive"].get_data())
    edges = np.degrees(portrait.orbit.azimuths)
    inside = np.isfinite(azimuth)
    assert np.nanmax(np.abs(b)) == pytest.approx(100 * portrait.orbit.widest, rel=1e-3)  # cm
    # Folded into the half turn that is drawn.
    folded = np.remainder(azimuth[inside] - edges[0] + 1e-6, 180.0)
    assert folded.max() == pytest.approx(edges[1] - edges[0], abs=0.1)
    _, driven = np.array(lines["with all that acts, 36.0 h"].get_data())
    assert np.nanmax(np.abs(driven)) < 0.12  # cm: a twentieth of what the bare clamp opens
    title = axes.get_title()
    assert title.startswith("Without drag and drive the plane swings to and fro between −146.")
    assert "_" not in title + axes.get_xlabel() + axes.get_ylabel() + "".join(labels(figure))


def test_one_that_goes_round_and_one_without_a_clamp() -> None:
    pendulum = kp.Pendulum(67.0, SITE.gravity)
    round_ = kp.Portrait(pendulum, 3.0, site=SITE, suspension=kp.Suspension(3.8e-6, 0.5))
    (axes,) = plot.portrait(round_).axes
    assert "goes round: half a turn in" in axes.get_title()
    even = kp.Portrait(pendulum, 3.0, 0.1, site=SITE)
    figure = plot.portrait(even)
    assert "turns back" not in labels(figure)
    assert "goes round" in figure.axes[0].get_title()


def test_without_a_site_there_is_no_earth() -> None:
    figure = plot.portrait(kp.Portrait(kp.Pendulum(1.0), 0.1, 0.01, suspension=CLAMP))
    assert not any("Earth" in label for label in labels(figure))
    along = kp.Portrait(kp.Pendulum(1.0), 0.1, azimuth=float(CLAMP.axis), suspension=CLAMP)
    still = plot.portrait(along)
    assert still.axes[0].get_title() == "Without drag and drive the plane stays as it is"


def test_refused() -> None:
    with pytest.raises(kp.InvalidInput, match="has no path of its own to follow until 5 s"):
        plot.portrait(kp.Portrait.of(GUELPH), until=5.0)
    many = kp.EnvelopeMotion(kp.Pendulum([1.0, 2.0]), kp.Launch.apsides(0.1, 0.0))
    with pytest.raises(kp.InvalidInput, match=r"the motion has the shape \(2,\)"):
        plot.portrait(many)
