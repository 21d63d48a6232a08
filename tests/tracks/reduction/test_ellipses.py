"""Ellipses of tracks with a known truth, and their errors."""

from typing import Any

import numpy as np
import pytest
from studies.pendulums import level, pendulum, shape

import kugelpendel as kp
from kugelpendel.tracks.reduction import _ellipses

CASE = pendulum(1)
TRACK = kp.tracks.synthesise(CASE.motion, 900.0, 10.0, noise=CASE.noise, jitter=0.2, seed=1)
NAMES = ("a", "b", "azimuth", "frequency", "x0", "y0")


def pulls(ellipses, motion) -> dict[str, np.ndarray]:  # type: ignore[no-untyped-def]
    """Errors in units of the standard errors, against the real motion in every window."""
    truth = [shape(type(CASE)(motion, {}, 0.0, 9.81), t) for t in ellipses["time"].values]
    length = float(motion.pendulum.length)
    out = {}
    for name, sign in (("a", 1), ("b", -1), ("azimuth", 0)):
        true = np.array([one[name] for one in truth])
        more = (3 / 64) * np.array([one["a"] ** 2 - one["b"] ** 2 for one in truth]) / length**2
        apart = ellipses[name].values - true * (1 + sign * more)
        if name == "azimuth":
            apart = (apart + np.pi / 2) % np.pi - np.pi / 2
        out[name] = apart / ellipses[f"{name}_stderr"].values
    return out


def test_names_units_and_what_was_seen() -> None:
    ellipses = kp.tracks.ellipses(TRACK)
    assert list(ellipses["time"].dims) == ["time"]
    for name in NAMES:
        assert ellipses[name].attrs["units"] == ellipses[f"{name}_stderr"].attrs["units"]
        assert (ellipses[f"{name}_stderr"] > 0).all()
    assert (ellipses["azimuth"].attrs["units"], ellipses["a"].attrs["units"]) == ("rad", "m")
    covariance = ellipses["covariance"].values
    assert covariance == pytest.approx(covariance.swapaxes(1, 2))
    assert (np.linalg.eigvalsh(covariance) > 0).all()
    assert ellipses.attrs["noise"] == pytest.approx(CASE.noise, rel=0.05)
    assert ellipses.attrs["rejected"] < 5
    assert ellipses["points"].values.sum() == ellipses.attrs["points"]


@pytest.mark.parametrize("swings", [4.0, 8.0, 16.0])
def test_errors_are_as_large_as_they_say(swings: float) -> None:
    for seed in (1, 2, 3, 4):
        case = pendulum(seed)
        track = kp.tracks.synthesise(case.motion, 900.0, 10.0, noise=case.noise, seed=seed)
        ellipses = kp.tracks.ellipses(track, swings=swings)
        for name, pull in pulls(ellipses, case.motion).items():
            # A slope within the window is fitted and its curvature is not: within three σ of 1.
            allowed = 3 / np.sqrt(2 * len(pull))
            assert abs(np.sqrt(np.mean(pull**2)) - 1) < allowed + 0.1, (seed, name)


@pytest.mark.parametrize("colour", ["white", "slow", 0.8])
def test_the_spectrum_at_the_swing_is_the_true_one(colour: Any) -> None:
    ratios = []
    for seed in range(8):
        case = pendulum(seed)
        track = kp.tracks.synthesise(
            case.motion, 1200.0, 10.0, noise=case.noise, colour=colour, jitter=0.2, seed=seed
        )  # type: ignore[arg-type]
        seen = kp.tracks.ellipses(track).attrs
        true = level(colour, case.noise, float(case.motion.angular_frequency))
        ratios.append(np.sqrt(seen["noise_ahead"] * seen["noise_behind"]) / true)
    assert 0.9 < np.mean(ratios) < 1.15


def test_outliers_gaps_and_a_far_origin_change_little() -> None:
    clean = kp.tracks.ellipses(TRACK)
    spoilt = kp.tracks.synthesise(
        CASE.motion, 900.0, 10.0, noise=CASE.noise, jitter=0.2, outliers=0.03, seed=1,
        gaps=[(200.0, 40.0)],
    )  # fmt: skip
    moved = kp.tracks.Track(spoilt.time, spoilt.x + 5.0, spoilt.y - 3.0)
    ellipses = kp.tracks.ellipses(moved)
    assert ellipses.attrs["rejected"] > 150
    assert ellipses.attrs["pieces"] == 2
    assert not ((ellipses["time"] > 205) & (ellipses["time"] < 235)).any()
    assert ellipses["x0"].values == pytest.approx(5.0, abs=5 * ellipses["x0_stderr"].values.max())
    assert ellipses["y0"].values == pytest.approx(-3.0, abs=5 * ellipses["y0_stderr"].values.max())
    at = np.interp(ellipses["time"].values, clean["time"].values, clean["a"].values)
    assert ellipses["a"].values == pytest.approx(at, abs=6 * clean["a_stderr"].values.max())


def test_the_sense_and_the_handedness() -> None:
    mirrored = kp.tracks.Track(TRACK.time, TRACK.x, -TRACK.y)
    ours, theirs = kp.tracks.ellipses(TRACK), kp.tracks.ellipses(mirrored)
    assert theirs["b"].values == pytest.approx(-ours["b"].values)
    turned = theirs["azimuth"].values + ours["azimuth"].values
    assert turned - np.pi * np.rint(turned[0] / np.pi) == pytest.approx(0.0, abs=1e-9)
    assert ours["frequency"].values == pytest.approx(float(CASE.motion.angular_frequency), rel=1e-3)


def test_noise_of_x_and_y_that_differ() -> None:
    for axis in (0.0, np.pi / 2):
        launch = kp.Launch.ellipse(0.1, 0.01, axis)
        motion = kp.RealMotion(kp.Pendulum(2.0, 9.81), launch)
        squares: dict[str, list[float]] = {}
        for seed in range(6):
            track = kp.tracks.synthesise(
                motion, 600.0, 10.0, noise=5e-4, noise_ratio=3.0, jitter=0.2, seed=seed
            )
            for name, pull in pulls(kp.tracks.ellipses(track), motion).items():
                squares.setdefault(name, []).extend(pull**2)
        for name, values in squares.items():
            assert 0.8 < np.sqrt(np.mean(values)) < 1.2, (axis, name)


def test_progress_is_told_and_its_interrupt_obeyed() -> None:
    told: list[float] = []
    kp.tracks.ellipses(TRACK, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def stop(share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        kp.tracks.ellipses(TRACK, progress=stop)


def test_a_table_becomes_ellipses() -> None:
    random = np.random.default_rng(0)
    time = np.arange(200) * 60.0
    azimuth = 0.3 + 1e-4 * time + 1e-3 * random.standard_normal(200)
    wrapped = (azimuth + np.pi / 2) % np.pi - np.pi / 2
    table = kp.tracks.tabulated(time, np.full(200, 3.0), np.full(200, 0.1), wrapped, unit="px")
    assert np.diff(table["azimuth"].values - azimuth) == pytest.approx(0.0, abs=1e-9)
    assert table["azimuth_stderr"].values == pytest.approx(1e-3, rel=0.25)
    assert table.attrs["origin"] == "table"
    assert np.isnan(table["frequency"].values).all()


def test_residuals_and_their_spectrum() -> None:
    rest = kp.tracks.residuals(TRACK)
    assert rest.sizes["time"] == len(TRACK)
    assert (rest["x"] + rest["model_x"]).values == pytest.approx(TRACK.x)
    assert float(rest["x"].values[rest["kept"].values].std()) == pytest.approx(CASE.noise, rel=0.1)
    near = np.abs(np.abs(rest["angular_frequency"]) / rest.attrs["swing_frequency"] - 0.7) < 0.1
    seen, line = rest["spectrum"].values[near], rest["spectrum_model"].values[near]
    assert seen.mean() == pytest.approx(line.mean(), rel=0.2)


def test_a_track_is_taken_apart_once_for_ellipses_and_residuals(monkeypatch):
    track = kp.tracks.Track(TRACK.time, TRACK.x, TRACK.y)
    taken = []
    reduce = _ellipses._reduce
    monkeypatch.setattr(
        _ellipses, "_reduce", lambda *given: taken.append(given[1]) or reduce(*given)
    )
    first, rest = kp.tracks.ellipses(track), kp.tracks.residuals(track)
    assert taken == [8.0]
    # what was handed out belongs to whoever asked
    spoilt = kp.tracks.ellipses(track)
    for name in ("a", "spread", "points"):
        spoilt[name].values[:] = 0
    kp.tracks.residuals(track).kept.values[:] = False
    assert kp.tracks.ellipses(track).identical(first)
    assert kp.tracks.residuals(track).identical(rest)
    # other windows are another reduction
    wide = kp.tracks.ellipses(track, swings=12.0)
    assert taken == [8.0, 12.0]
    assert wide.sizes["time"] < first.sizes["time"]
