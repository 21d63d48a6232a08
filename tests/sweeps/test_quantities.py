"""What is read off every case: the numbers of single motions, and what is refused."""

import math
import os
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.sweeps._quantities import QUANTITIES, measure, require_readable
from kugelpendel.sweeps._readings import READINGS

HOUR = 3600.0
SITE = kp.Site(math.radians(52.5))
PENDULUM = kp.Pendulum(10.0, SITE.gravity, 2.0)
NO_TIMES = np.empty(0)


def averaged(**given) -> kp.EnvelopeMotion:
    launch = kp.Launch.ellipse(given.pop("a", 0.4), given.pop("b", 0.0), given.pop("azimuth", 0.3))
    return kp.EnvelopeMotion(PENDULUM, launch, site=given.pop("site", SITE), **given)


def clamps(delta, axis=0.9, **more) -> kp.Suspension:
    return kp.Suspension(np.asarray(delta, float), axis, **more)


def names_of(kind: str) -> list[str]:
    return [name for name, quantity in QUANTITIES.items() if kind in quantity.motions]


def test_exact_cases_are_those_of_single_motions() -> None:
    a, b = np.array([0.4, 2.0, 0.1]), np.array([0.1, -1.0, 0.0])
    motion = kp.ExactMotion(PENDULUM, kp.Launch.apsides(a, b, 0.7))
    times = np.array([600.0, 7200.0])
    found = measure(motion, names_of("exact"), times)
    for k, one in enumerate(motion):
        assert found["frequency"][k] == one.frequency
        assert found["precession"][k] == one.precession
        assert found["period"][k] == one.period
        least, most = one.tension_range
        assert (found["least_tension"][k], found["largest_tension"][k]) == (least, most)
        np.testing.assert_allclose(found["a"][k], a[k], rtol=1e-13)
        np.testing.assert_allclose(found["b"][k], b[k], rtol=1e-13, atol=1e-15)
        np.testing.assert_allclose(found["azimuth"][k], 0.7 + one.precession * times, rtol=1e-13)
        np.testing.assert_array_equal(found["mean_rate"][k], [one.precession] * 2)
    np.testing.assert_allclose(found["largest_b"], np.abs(b), rtol=1e-13)
    np.testing.assert_array_equal(found["quarter_turn"][[0, 2]], math.inf)
    assert found["quarter_turn"][1] == pytest.approx(0.5 * math.pi / abs(motion.precession[1]))
    rates = kp.olsson.precession(a[:2], b[:2], 10.0, float(SITE.gravity))
    expected = rates / motion.precession[:2] - 1
    np.testing.assert_allclose(found["error_25"][:2], expected, rtol=1e-9)
    frequency = kp.olsson.frequency(a, b, 10.0, float(SITE.gravity))
    np.testing.assert_allclose(found["error_26"], frequency / motion.frequency - 1, rtol=1e-6)


def test_averaged_cases_are_those_of_single_motions() -> None:
    motion = averaged(suspension=clamps([0.0, 3e-5, 6e-4]), drag=kp.Drag(1e-5))
    times = HOUR * np.array([2.0, 30.0])
    found = measure(motion, names_of("averaged"), times)
    for k, one in enumerate(motion):
        np.testing.assert_array_equal(found["azimuth"][k], one.azimuth(times))
        np.testing.assert_array_equal(found["a"][k], one.semi_axes(times)[:, 0])
        np.testing.assert_array_equal(found["b"][k], one.semi_axes(times)[:, 1])
        start, end = one.azimuth(np.array([0.0, 30 * HOUR]))
        assert found["mean_rate"][k, 1] == pytest.approx((end - start) / (30 * HOUR), rel=1e-13)
        grid = np.linspace(0, 30 * HOUR, 20_001)
        widest = np.abs(one.semi_axes(grid)[:, 1]).max()
        assert found["largest_b"][k] == pytest.approx(widest, rel=1e-4)
        later = one.rates(grid[grid >= 2 * HOUR]).total
        spread = float(np.ptp(later)) + 1e-12
        assert found["slowest_rate"][k] == pytest.approx(later.max(), abs=2e-3 * spread)
        assert found["fastest_rate"][k] == pytest.approx(later.min(), abs=2e-3 * spread)
        portrait = kp.Portrait.of(one)
        assert found["clamp_stalls"][k] == (portrait.orbit.verdict != "round")
        turned = np.abs(one.azimuth(grid) - start)
        if turned.max() > 0.5 * math.pi:
            at = one.azimuth(found["quarter_turn"][k])
            assert abs(at - start) == pytest.approx(0.5 * math.pi, abs=1e-11)
        else:
            assert found["quarter_turn"][k] == math.inf


def test_real_cases_are_read_at_their_turning_points() -> None:
    drag, clamp = kp.Drag(2e-5), clamps([2e-5, 4e-4])
    launch = kp.Launch.ellipse(0.4, 0.0, 0.3)
    motion = kp.RealMotion(PENDULUM, launch, site=SITE, suspension=clamp, drag=drag)
    times = HOUR * np.array([0.5, 3.0])
    found = measure(motion, names_of("real"), times)
    means = kp.EnvelopeMotion(PENDULUM, launch, site=SITE, suspension=clamp, drag=drag)
    expected = measure(means, ["azimuth", "a", "b", "largest_b"], times)
    for name, error in {"azimuth": 5e-4, "a": 1e-4, "b": 1e-4}.items():
        np.testing.assert_allclose(found[name], expected[name], rtol=0, atol=error, err_msg=name)
    np.testing.assert_allclose(found["largest_b"], expected["largest_b"], rtol=1e-3)
    apart = np.abs(found["azimuth"] - expected["azimuth"])
    np.testing.assert_allclose(found["averaging_error"], apart, rtol=0, atol=1e-12)
    assert (found["averaging_error"] > 0).all()
    for k, one in enumerate(motion):
        weight = 2.0 * float(one.effective_pendulum.gravity)
        assert found["least_tension"][k] == pytest.approx(float(one.tension(0.0)), rel=1e-4)
        assert found["largest_tension"][k] == pytest.approx(weight * (1 + 0.04**2), rel=1e-4)


def test_where_friction_alone_brings_the_plane_to_rest() -> None:
    delta = np.array([4e-4, 1e-5])
    clamp = kp.Suspension(0.0, 0.0, damping_anisotropy=delta, damping_axis=0.2)
    damped = averaged(drag=kp.Drag(2e-4), suspension=clamp, azimuth=1.6)
    times = np.array([5e4])
    found = measure(damped, ["azimuth", "stalls", "final_direction", "stands_since"], times)
    np.testing.assert_array_equal(found["stalls"], [1.0, 0.0])
    # ψ' = −Ω_z + (Δγ/2) sin 2(ψ − χd) = 0 where that falls.
    rest = 0.2 + 0.5 * (math.pi - math.asin(float(SITE.vertical_rotation) / 2e-4))
    assert found["azimuth"][0, 0] % math.pi == pytest.approx(rest % math.pi, abs=1e-3)
    assert found["stands_since"][0] < 5e3
    # The direction is the one in which a tenth of the amplitude is left, ln 10/γ after the launch.
    left = damped[0].azimuth(math.log(10) / 2e-4)
    assert found["final_direction"][0] == pytest.approx(left % math.pi, abs=1e-6)
    assert math.isnan(found["final_direction"][1])
    assert found["stands_since"][1] == math.inf


def test_a_plane_that_swings_to_and_fro_does_so_about_its_final_direction() -> None:
    motion = averaged(suspension=clamps([2e-6, 4e-4]), a=0.05)
    found = measure(motion, ["stalls", "final_direction", "clamp_stalls"], NO_TIMES)
    np.testing.assert_array_equal(found["stalls"], [0.0, 1.0])
    np.testing.assert_array_equal(found["clamp_stalls"], [0.0, 1.0])
    middle = np.mean(kp.Portrait.of(motion[1]).orbit.azimuths)
    assert found["final_direction"][1] == pytest.approx(middle % math.pi, abs=0.02)


def test_bad_and_ended_cases_have_no_answer() -> None:
    pendulum = kp.Pendulum(np.array([10.0, -1.0, 10.0]))
    launch = kp.Launch.angles(np.array([0.1, 0.1, 2.0]), 0.0, 0.0, 0.1)
    motion = kp.RealMotion(pendulum, launch)
    found = measure(motion, ["azimuth", "largest_b", "least_tension"], np.array([100.0]))
    for name, values in found.items():
        assert np.isfinite(values).reshape(3, -1).all(axis=1).tolist() == [True, False, False], name


def test_less_than_a_swing_has_no_plane() -> None:
    motion = kp.RealMotion(PENDULUM, kp.Launch.ellipse(np.array([0.1]), 0.01))
    assert np.isnan(measure(motion, ["azimuth"], np.array([0.5]))["azimuth"]).all()


@pytest.mark.parametrize("kind", ["exact", "averaged", "real"])
def test_a_case_does_not_depend_on_the_others(kind: str) -> None:
    a = np.linspace(0.1, 0.6, 5)
    made = {"exact": kp.ExactMotion, "averaged": kp.EnvelopeMotion, "real": kp.RealMotion}[kind]
    acting = {} if kind == "exact" else {"site": SITE, "suspension": kp.Suspension(5e-5, 0.9)}
    times = np.array([600.0, 1200.0])
    motion = made(PENDULUM, kp.Launch.ellipse(a, 0.03), **acting)
    names = names_of(kind)
    together = measure(motion, names, times)
    some = measure(motion[3:], names, times)
    for name in names:
        np.testing.assert_array_equal(together[name][3:], some[name], name)


def test_threads_change_no_bit(repository: Path) -> None:
    code = (
        "import sys, numpy as np, kugelpendel as kp\n"
        "from kugelpendel.sweeps._quantities import measure\n"
        "site, clamp = kp.Site(0.9), kp.Suspension(np.geomspace(1e-6, 1e-3, 9), 0.9)\n"
        "given = kp.Pendulum(10.0), kp.Launch.ellipse(0.4, 0.0, 0.3)\n"
        "times = np.array([3600.0])\n"
        "for made in kp.EnvelopeMotion, kp.RealMotion:\n"
        "    motion = made(*given, site=site, suspension=clamp)\n"
        "    found = measure(motion, ['azimuth', 'b', 'largest_b', 'stands_since'], times)\n"
        "    print([values.tobytes().hex() for values in found.values()])\n"
    )
    said = [
        subprocess.run(
            [sys.executable, "-c", code], cwd=repository, capture_output=True, text=True,
            check=True, env={**os.environ, "RAYON_NUM_THREADS": threads},
        ).stdout
        for threads in ("1", "3")
    ]  # fmt: skip
    assert said[0] == said[1] != ""


def test_every_quantity_is_read_by_the_motions_that_it_names() -> None:
    for kind, readings in READINGS.items():
        able = {name for name in vars(readings) if not name.startswith("_")}
        assert able == set(names_of(kind)), kind


@pytest.mark.parametrize(
    ("kind", "names", "times", "grounded", "said"),
    [
        ("exact", ["colour"], [], True, "A sweep cannot read 'colour'; it reads frequency, "),
        (
            "real",
            ["stalls"],
            [1.0],
            True,
            'cannot be read off the motion "real", but off these: "averaged".',
        ),
        ("averaged", ["azimuth"], [], True, '"azimuth" needs times; write times=(21600.0,)'),
        ("averaged", ["largest_b"], [], True, '"largest_b" needs times'),
        ("averaged", ["stalls"], [], False, '"stalls" needs a ground that turns; add a table'),
        ("exact", ["a"], [-1.0], True, "A sweep reads after the launch, but one of its times is"),
        (
            "exact",
            ["a"],
            [2.0, 1.0],
            True,
            "must grow from one to the next, but after 2 s comes 1 s; ",
        ),
        ("exact", ["mean_rate"], [0.0], True, "one of the times is 0 s; leave that one out"),
    ],
)
def test_refused(kind: str, names: list[str], times: list, grounded: bool, said: str) -> None:
    with pytest.raises(kp.InvalidInput) as error:
        require_readable(kind, names, np.array(times), grounded=grounded)
    assert said in str(error.value)


def test_only_three_motions_are_read() -> None:
    motion = kp.LinearMotion(PENDULUM, kp.Launch.ellipse(np.array([0.1]), 0.0))
    with pytest.raises(kp.InvalidInput, match="but this is LinearMotion"):
        measure(motion, ["a"], NO_TIMES)


def test_the_portrait_and_the_motion_agree_away_from_the_separatrix() -> None:
    """As in examples/sweep/stall-map.toml, on random clamps, sizes and azimuths."""
    random = np.random.default_rng(5)
    count = 150
    delta = 10 ** random.uniform(-6, -3, count)
    a, azimuth = 10.0 * 10 ** random.uniform(-3, -1.1, count), random.uniform(0, math.pi, count)
    launch = kp.Launch.ellipse(a, 0.0, azimuth)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        motion = kp.EnvelopeMotion(PENDULUM, launch, site=SITE, suspension=clamps(delta))
    found = measure(motion, ["stalls", "clamp_stalls"], NO_TIMES)
    apart = found["stalls"] != found["clamp_stalls"]
    # Next to the separatrix an orbit takes longer than the four turns of the Earth that are looked
    # at, and beyond them nothing is said: there the two may differ.
    for one in motion[apart]:
        orbit = kp.Portrait.of(one).orbit
        assert orbit.period > 2 * math.pi / float(SITE.vertical_rotation)
    assert apart.sum() <= 0.03 * count
