"""Every sentence about tracks is provoked: what was wrong, what was seen, and the way out."""

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.errors import KugelpendelError
from kugelpendel.errors._sentences import read

PREFIXES = ("columns_", "table_", "synth_", "fit_", "plan_")
"""The kinds of sentences that are asked here; those of reading are asked in tests/tracks/read."""

T = np.arange(0.0, 120.0, 0.1)
MOTION = kp.RealMotion(kp.Pendulum(2.0, 9.81), kp.Launch.ellipse(0.1, 0.01, 0.3))
ROWS = (np.arange(9.0), np.full(9, 2.0), np.full(9, 0.1), np.zeros(9))


def ellipses(time: Any, z: Any, **options: Any) -> Any:
    return kp.tracks.ellipses(kp.tracks.Track(time, z.real, z.imag), **options)


def swing(time: Any, period: float = 2.8, a: float = 0.1, b: float = 0.01) -> Any:
    phase = 2 * np.pi * time / period
    return a * np.cos(phase) + 1j * b * np.sin(phase)


def noise(count: int, seed: int = 0) -> Any:
    random = np.random.default_rng(seed)
    return random.standard_normal(count) + 1j * random.standard_normal(count)


def synth(**options: Any) -> Any:
    given: dict[str, Any] = {"duration": 60.0, "rate": 10.0} | options
    return kp.tracks.synthesise(MOTION, given.pop("duration"), given.pop("rate"), **given)


def torn() -> Any:
    time = np.concatenate([begin + np.arange(0.0, 5.0, 0.1) for begin in range(0, 200, 10)])
    return ellipses(time, swing(time))


def plan(**options: Any) -> Any:
    given: dict[str, Any] = {"a": 0.1, "b": 0.01, "noise": 1e-3, "rate": 10.0} | options
    return kp.tracks.plan(2.0, **given)


def fit(**options: Any) -> Any:
    return kp.tracks.fit(ellipses(T, swing(T) + 1e-4 * noise(len(T))), **options)


def plane() -> Any:
    motion = kp.RealMotion(kp.Pendulum(2.0, 9.81), kp.Launch.at_rest(0.1))
    return kp.tracks.fit(kp.tracks.synthesise(motion, 240.0, 10.0, noise=1e-3))


REFUSED: dict[str, Callable[[], Any]] = {
    "track_constant": lambda: ellipses(T, np.full(len(T), 1 + 2j)),
    "track_few_points": lambda: ellipses(T[:5], swing(T[:5])),
    "track_gaps": lambda: ellipses(
        np.concatenate([T[:12], 1e6 + T[:12]]), swing(np.concatenate([T[:12], T[:12]]))
    ),
    "track_no_swing": lambda: ellipses(T, noise(len(T))),
    "track_short": lambda: ellipses(T[:60], swing(T[:60])),
    "track_aliased": lambda: ellipses(2.5 * T[:400] / 0.1, swing(2.5 * T[:400] / 0.1)),
    "track_pieces": torn,
    "track_window": lambda: ellipses(T, swing(T), swings=1.0),
    "track_two_motions": lambda: ellipses(
        T, np.where(noise(len(T)).real > 0.2, 0.03j + swing(T + 1.0), swing(T))
    ),
    "track_circle": lambda: ellipses(T, swing(T, b=0.1) + 1e-3 * noise(len(T))),
    "table_rows": lambda: kp.tracks.tabulated([0.0, 1.0], [1.0, 1.0], [0.1, 0.1], [0.0, 0.0]),
    "columns_shape": lambda: kp.tracks.tabulated(ROWS[0], ROWS[1][:5], *ROWS[2:]),
    "columns_finite": lambda: kp.tracks.tabulated(ROWS[0], ROWS[1] * math.nan, *ROWS[2:]),
    "columns_ascending": lambda: kp.tracks.tabulated(-ROWS[0], *ROWS[1:]),
    "synth_share": lambda: synth(jitter=0.7),
    "synth_positive": lambda: synth(duration=-1.0),
    "synth_single": lambda: kp.tracks.synthesise(
        kp.RealMotion(kp.Pendulum([1.0, 2.0]), kp.Launch.ellipse(0.1, 0.01)), 60.0, 10.0
    ),
    "synth_points": lambda: synth(duration=0.1),
    "synth_colour": lambda: synth(noise=1e-3, colour=1.5),
    "fit_positive": lambda: fit(tilt=0.0),
    "fit_windows": lambda: kp.tracks.fit(ellipses(T[:300], swing(T[:300]))),
    "fit_plane": plane,
    "fit_table_length": lambda: kp.tracks.fit(kp.tracks.tabulated(*ROWS)),
    "fit_length": lambda: fit(length=0.5),
    "fit_parameter": lambda: kp.tracks.profile(fit(models=()), "mass", model="narrow"),
    "fit_model": lambda: fit(models=("best",)),
    "plan_ellipse": lambda: plan(b=0.0),
}


def test_every_kind_of_these_is_provoked() -> None:
    for language in ("en", "de"):
        kinds = {kind for kind in read(language)["kinds"] if kind.startswith(PREFIXES)}
        assert kinds == {kind for kind in REFUSED if kind.startswith(PREFIXES)}
        assert set(read(language)["kinds"]) > set(REFUSED)


@pytest.mark.parametrize("kind", REFUSED)
def test_a_sentence_in_two_languages(kind: str) -> None:
    with pytest.raises(kp.InvalidInput) as raised:
        REFUSED[kind]()
    error: KugelpendelError = raised.value
    assert error.kind == kind
    assert error.values
    english, german = (error.sentence(language, "file") for language in ("en", "de"))
    assert english != german
    for sentence in (english, german):
        assert sentence.endswith(".")
        assert not re.search(r"[{}]|nan\b", sentence.replace("is nan", "").replace("ist nan", ""))


def test_what_is_planar_still_has_ellipses() -> None:
    motion = kp.RealMotion(kp.Pendulum(2.0, 9.81), kp.Launch.at_rest(0.1, 0.4))
    found = kp.tracks.ellipses(kp.tracks.synthesise(motion, 240.0, 10.0, noise=1e-3))
    assert found.attrs["planar"] == 1
    assert found["azimuth"].values == pytest.approx(0.4, abs=0.02)
    assert found["a"].values == pytest.approx(2 * math.sin(0.1), rel=0.01)


def test_an_alias_that_jitter_gives_away() -> None:
    random = np.random.default_rng(1)
    period, step = 2.0, 1.9
    time = step * (np.arange(600) + random.uniform(-0.2, 0.2, 600))
    with pytest.raises(kp.InvalidInput) as raised:
        ellipses(time, swing(time, period))
    assert raised.value.kind in ("track_aliased", "track_no_swing")
