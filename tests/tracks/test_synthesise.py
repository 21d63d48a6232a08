"""Tracks of a known motion: what was asked for is in them, and nothing else."""

import numpy as np
import pytest

import kugelpendel as kp

MOTION = kp.RealMotion(kp.Pendulum(2.0, 9.81), kp.Launch.ellipse(0.1, 0.01, 0.3))


def test_without_noise_it_is_the_motion() -> None:
    track = kp.tracks.synthesise(MOTION, 20.0, 30.0, jitter=0.3, seed=1)
    place = MOTION.position(track.time)
    assert np.array_equal(track.x, place[:, 0])
    assert np.array_equal(track.y, place[:, 1])
    assert (track.unit, track.time[0]) == ("m", 0.0)
    assert np.std(np.diff(track.time)) > 0.1 / 30


def test_the_same_seed_gives_the_same_track() -> None:
    def places(seed: int) -> np.ndarray:
        return kp.tracks.synthesise(MOTION, 20.0, 30.0, noise=1e-3, seed=seed).x

    assert np.array_equal(places(3), places(3))
    assert not np.array_equal(places(3), places(4))


@pytest.mark.parametrize("colour", ["white", "slow", "t3", 0.8, -0.5])
def test_noise_has_the_size_that_is_asked_for(colour: str | float) -> None:
    track = kp.tracks.synthesise(MOTION, 2000.0, 30.0, noise=1e-3, colour=colour, noise_ratio=3.0)  # type: ignore[arg-type]
    rest = np.stack([track.x, track.y], axis=1) - MOTION.position(track.time)[:, :2]
    tolerance = 0.15 if colour in ("slow", "t3") else 0.03
    assert rest.std(axis=0) == pytest.approx(1e-3 * np.sqrt([3, 1 / 3]), rel=tolerance)


def test_gaps_outliers_tilt_and_pixels() -> None:
    track = kp.tracks.synthesise(MOTION, 100.0, 30.0, gaps=[(10.0, 5.0), (50.0, 20.0)])
    assert not ((track.time > 10.001) & (track.time < 14.99)).any()
    assert len(track) == pytest.approx(75 * 30, abs=2)
    spoilt = kp.tracks.synthesise(MOTION, 100.0, 30.0, outliers=0.1, seed=5)
    off = np.abs(spoilt.x - MOTION.position(spoilt.time)[:, 0]) > 0
    assert off.mean() == pytest.approx(0.1, abs=0.03)
    tilted = kp.tracks.synthesise(MOTION, 10.0, 30.0, tilt=0.02, tilt_axis=0.0)
    place = MOTION.position(tilted.time)
    assert tilted.x == pytest.approx(0.99 * place[:, 0])
    assert tilted.y == pytest.approx(1.01 * place[:, 1])
    pixels = kp.tracks.synthesise(MOTION, 10.0, 30.0, pixel=1e-3)
    assert pixels.unit == "px"
    assert np.array_equal(pixels.x, np.rint(pixels.x))


def test_somebody_is_told_how_far_the_track_is() -> None:
    told: list[tuple[int, int]] = []
    kp.tracks.synthesise(MOTION, 20.0, 30.0, done=lambda *far: told.append(far))
    taken = [some for some, _ in told]
    assert taken == sorted(set(taken))
    assert {total for _, total in told} == {601}
    assert (taken[0], taken[-1]) == (13, 601)
