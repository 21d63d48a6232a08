"""The short form of the study in docs/tracks.md, and what a fit says about itself."""

from typing import Any

import numpy as np
import pytest
from studies.pendulums import pendulum
from studies.tracks import KINDS, NAMES, Tally, biases, many, tilted

import kugelpendel as kp

MOTION = kp.RealMotion(
    kp.Pendulum(6.0, 9.81),
    kp.Launch.ellipse(0.3, 0.02, 0.4),
    drag=kp.Drag(2e-4, 1e-4),
    suspension=kp.Suspension(6e-5, 0.4),
    site=kp.Site(0.85),
)
TRACK = kp.tracks.synthesise(MOTION, 1200.0, 10.0, noise=1.5e-3, jitter=0.2, seed=3)
ELLIPSES = kp.tracks.ellipses(TRACK)
FIT = kp.tracks.fit(ELLIPSES, gravity=9.81, latitude=0.85)


QUICK: dict[str, Any] = {"rate": 5.0, "tolerance": 1e-12}
"""Half of the study's points, and a motion a billion times better than the noise."""


@pytest.fixture(scope="module")
def tallies() -> dict[str, Tally]:
    """So many tracks that an interval which holds in 95 % leaves 88 to 99.5 % once in thousands."""
    return {
        name: many(38, spoilt, first=100 * index, **QUICK)
        for index, (name, spoilt) in enumerate(KINDS.items())
    }


def test_intervals_hold(tallies: dict[str, Tally]) -> None:
    held = np.concatenate([tally.held for tally in tallies.values()])
    assert len(held) >= 150
    coverage = held.mean(axis=0)
    assert ((coverage >= 0.88) & (coverage <= 0.995)).all(), dict(zip(NAMES, coverage, strict=True))
    assert sum(tally.failed for tally in tallies.values()) == 0


def test_errors_are_near_the_bound(tallies: dict[str, Tally]) -> None:
    squares = np.concatenate([np.square(tally.of_bound) for tally in tallies.values()])
    assert (np.sqrt(np.nanmean(squares, axis=0)) < 1.25).all()


def test_white_errors_fail_on_coloured_noise() -> None:
    tally = many(20, KINDS["AR(0.8)"], white_errors=True, **QUICK)
    assert 0.4 < tally.coverage.mean() < 0.7  # 0.53 to 0.55 in the study


def test_no_bias_without_noise() -> None:
    assert np.abs(biases(8)).max() < 0.1


def test_a_tilt_that_is_ignored_is_within_the_headline_only() -> None:
    narrow = many(12, tilted, model="narrow", **QUICK)
    headline = many(12, tilted, model="headline", **QUICK)
    for name in ("a", "azimuth"):  # 0 and 1 % in the study
        assert narrow.coverage[NAMES.index(name)] < 0.3
    assert (headline.coverage > 0.85).all()


def test_every_model_is_there_and_the_headline_is_wider() -> None:
    assert list(FIT.models) == [
        "headline", "narrow", "uneven", "tilted", "intrinsic", "intrinsic_narrow",
        "intrinsic_known", "measured", "measured_anisotropy",
    ]  # fmt: skip
    assert not FIT.misfit.is_misfit
    assert 0.6 < FIT.misfit.ratio < 1.6
    for name in ("a", "b", "azimuth", "rotation", "linear"):
        wide, thin = FIT.headline.parameters[name], FIT.narrow.parameters[name]
        assert wide.stderr > thin.stderr
        assert wide.verdict == "determined"
    assert FIT.estimate("tilt_cos").verdict == "nuisance"
    assert FIT.estimate("latitude").low < 0.85 < FIT.estimate("latitude").high
    with pytest.raises(kp.InvalidInput, match="no parameter mass; it has a, b"):
        FIT.estimate("mass")


def test_uneven_damping_that_is_free_determines_nothing() -> None:
    rotation = FIT.models["uneven"].parameters["rotation"]
    assert (rotation.verdict, rotation.reason) == ("not determined", "wide")
    assert np.isnan(rotation.value)


@pytest.mark.parametrize("model", ["intrinsic", "intrinsic_narrow", "intrinsic_known", "measured"])
def test_the_coefficient_is_three_eighths(model: str) -> None:
    kappa = FIT.models[model].parameters["intrinsic"]
    assert kappa.low < 0.375 < kappa.high
    assert kappa.stderr < 0.05


def test_a_modulus_near_zero_has_an_upper_bound() -> None:
    anisotropy = FIT.headline.parameters["anisotropy"]
    assert (anisotropy.verdict, anisotropy.reason) == ("not determined", "modulus")
    assert anisotropy.high > 6e-5
    strong = kp.RealMotion(
        MOTION.pendulum, MOTION.launch, suspension=kp.Suspension(2e-3, 0.7), site=MOTION.site
    )
    track = kp.tracks.synthesise(strong, 1200.0, 10.0, noise=1.5e-3, seed=1)
    parameters = kp.tracks.fit(track, gravity=9.81, models=("narrow",)).narrow.parameters
    assert parameters["anisotropy"].low < 2e-3 < parameters["anisotropy"].high
    assert parameters["axis"].value == pytest.approx(0.7, abs=4 * parameters["axis"].stderr)


def test_length_or_gravity_follow_from_the_frequency() -> None:
    assert FIT.length == pytest.approx(6.0, rel=1e-3)
    other = kp.tracks.fit(ELLIPSES, length=6.0, models=("narrow",))
    assert other.gravity == pytest.approx(9.81, rel=1e-3)
    ours = FIT.narrow.parameters["rotation"].value
    assert other.narrow.parameters["rotation"].value == pytest.approx(ours, abs=1e-7)


def test_without_a_scale_there_is_no_coefficient() -> None:
    pixels = kp.tracks.Track(TRACK.time, 1000 * TRACK.x, 1000 * TRACK.y, "px")
    fit = kp.tracks.fit(pixels, gravity=9.81)
    kappa = fit.narrow.parameters["intrinsic"]
    assert (kappa.verdict, kappa.reason) == ("not determined", "scale")
    assert not fit.scaled
    assert fit.period is not None
    assert fit.period.slope.reason == "scale"
    assert fit.stiffening is None
    assert fit.narrow.parameters["a"].value == pytest.approx(
        1000 * FIT.narrow.parameters["a"].value, rel=1e-3
    )
    assert fit.narrow.parameters["quadratic"].unit == "1/px"


def test_period_against_amplitude() -> None:
    assert FIT.period is not None
    assert FIT.period.slope.low < -1 / 16 < FIT.period.slope.high
    assert FIT.period.drift.low < 0 < FIT.period.drift.high
    assert FIT.stiffening is not None
    assert FIT.stiffening.joint.low < 0 < FIT.stiffening.joint.high
    assert FIT.stiffening.agree


def test_a_motion_that_the_model_has_not_is_a_misfit() -> None:
    driven = kp.RealMotion(
        MOTION.pendulum,
        MOTION.launch,
        drag=kp.Drag(2e-3),
        drive=kp.Drive(3e-4, phase=1.5),
    )
    track = kp.tracks.synthesise(driven, 1200.0, 10.0, noise=1e-4, seed=1)
    fit = kp.tracks.fit(track, gravity=9.81, models=("narrow",))
    assert fit.misfit.is_misfit
    assert fit.misfit.probability < 1e-3


def test_profiles_are_the_intervals() -> None:
    for model, name in (("narrow", "rotation"), ("headline", "linear")):
        found = kp.tracks.profile(FIT, name, model=model, points=9)
        estimate = FIT.models[model].parameters[name]
        assert found.closes
        width = estimate.high - estimate.low
        assert found.low == pytest.approx(estimate.low, abs=0.05 * width)
        assert found.high == pytest.approx(estimate.high, abs=0.05 * width)
        assert found.chi_square.min() == pytest.approx(0.0, abs=0.01)


def test_an_even_pendulum_of_the_study_is_what_it_says() -> None:
    case = pendulum(5)
    rates = case.motion.site
    assert rates is not None
    assert case.truth["rotation"] == pytest.approx(float(rates.vertical_rotation))


def test_a_record_of_hours_ends_in_the_right_minimum() -> None:
    # Its plane turns to and fro by a radian and b passes through 0 while a falls to a tenth.
    motion = kp.RealMotion(
        kp.Pendulum(1.955, 9.805),
        kp.Launch.ellipse(0.28, 0.001, 0.9),
        site=kp.Site(0.764),
        drag=kp.Drag(2e-5, 8e-4),
        suspension=kp.Suspension(6e-5, 0.4),
        tolerance=1e-12,
    )
    track = kp.tracks.synthesise(motion, 33_000.0, 2.0, noise=5e-4, jitter=0.2, seed=1)
    fit = kp.tracks.fit(track, gravity=9.805, models=("narrow",))
    assert fit.narrow.time.size > 1000
    assert not fit.misfit.is_misfit
    truth = {
        "rotation": float(kp.Site(0.764).vertical_rotation),
        "linear": 2e-5,
        "quadratic": 8e-4,
        "anisotropy_cos": 6e-5 * np.cos(0.8),
        "anisotropy_sin": 6e-5 * np.sin(0.8),
    }
    for name, value in truth.items():
        estimate = fit.narrow.parameters[name]
        assert estimate.value == pytest.approx(value, abs=4 * estimate.stderr), name
