"""Figures of tracks can be drawn in both languages, and their colours told apart."""

import math
from io import BytesIO

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.errors import Language


@pytest.fixture(scope="module")
def track() -> kp.tracks.Track:
    motion = kp.RealMotion(kp.Pendulum(1.0), kp.Launch.apsides(0.1, 0.01), drag=kp.Drag(2e-4))
    return kp.tracks.synthesise(motion, 200.0, 10.0, noise=5e-4, seed=2)


@pytest.mark.parametrize("language", ["en", "de"])
def test_every_figure(track: kp.tracks.Track, language: Language) -> None:
    ellipses = kp.tracks.ellipses(track)
    fit = kp.tracks.fit(ellipses)
    model = fit.headline
    residuals = kp.tracks.residuals(track)
    profile = kp.tracks.profile(fit)
    frequency = math.sqrt(9.80665)
    figures = [
        plot.tracks.seen(track, ellipses, language=language),
        plot.tracks.course(ellipses, model, language=language),
        plot.tracks.course(ellipses, language=language),
        plot.tracks.spectrum(residuals, frequency, language=language),
        plot.tracks.correlations(model, language=language),
        plot.tracks.profile(profile, language=language),
    ]
    for figure in figures:
        plot.save(figure, file := BytesIO())
        assert file.getvalue().startswith(b"\x89PNG")
        # What is drawn lies within the page: nothing is cut off.
        width, height = figure.get_size_inches() * figure.dpi
        box = figure.get_tightbbox()
        assert box.x0 * figure.dpi > -2
        assert box.x1 * figure.dpi < width + 2
        assert box.y1 * figure.dpi < height + 2
    # The lines at ±ω end below the legend, whose words they would cross.
    (axes,) = figures[3].axes
    legend = axes.get_legend()
    assert legend is not None
    swings = [line for line in axes.lines if line.get_linestyle() == ":"]
    tops = [line.get_window_extent().y1 for line in swings]
    assert len(tops) == 2
    assert max(tops) < min(text.get_window_extent().y0 for text in legend.get_texts())
    # The model lies within the errors of what was measured.
    panels = figures[1].axes
    assert len(panels) == 6
    assert len(figures[2].axes) == 3
    residual = np.abs(model.residual_a) / ellipses.a_stderr.values
    assert residual.mean() < 2
