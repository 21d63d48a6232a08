"""The portrait on the sphere: as the averaged and the full equations have it."""

import math
import pickle

import numpy as np
import pytest
from numpy.testing import assert_allclose

import kugelpendel as kp

SALVA = {
    # 4.803 m, periods 4.4000 s and 4.4005 s, 41.133° S: 1.2 cm at 5° from the axis.
    "pendulum": kp.Pendulum(4.803, 9.803),
    "site": kp.Site(math.radians(-41.133)),
    "suspension": kp.Suspension(2 * math.pi / 4.4 - 2 * math.pi / 4.4005, 0.0),
}
LAUNCH = kp.Launch.apsides(0.012, 0.0, math.radians(5))
DAYS = 60 * 3600.0


def test_a_swing_of_half_the_old_bound_turns_back() -> None:
    portrait = kp.Portrait(a=0.012, azimuth=math.radians(5), **SALVA)
    assert portrait.orbit.verdict == "to and fro"
    west, east = portrait.orbit.azimuths
    mean = kp.EnvelopeMotion(launch=LAUNCH, **SALVA)
    azimuth = mean.azimuth(np.linspace(0.0, DAYS, 2000))
    azimuth += math.radians(5) - azimuth[0]  # an angle of a whole turn more is the same
    assert azimuth.min() == pytest.approx(west, abs=2e-3)
    assert azimuth.max() == pytest.approx(east, abs=2e-3)
    # −10°, where the Earth alone turns by +593°.
    assert math.degrees(azimuth[-1] - azimuth[0]) == pytest.approx(-9.7, abs=0.5)
    assert math.degrees(-SALVA["site"].vertical_rotation * DAYS) == pytest.approx(593, abs=3)


@pytest.mark.parametrize(
    ("a", "b", "azimuth", "anisotropy"),
    [
        (0.012, 0.0, 5.0, None),
        (0.012, 0.0, 40.0, None),
        (0.012, 0.004, -60.0, None),
        (0.3, 0.0, 90.0, 2e-6),
        (0.3, 0.0, 90.0, 5e-7),
        (0.3, -0.05, 20.0, -2e-5),
    ],
)
def test_the_full_equations_go_the_same_way(
    a: float, b: float, azimuth: float, anisotropy: float | None
) -> None:
    given = dict(SALVA)
    if anisotropy is not None:
        given["suspension"] = kp.Suspension(anisotropy, 0.0)
    # The launch of an ellipse that has these axes where nothing turns.
    still = kp.ExactMotion(SALVA["pendulum"], kp.Launch.apsides(a, b, math.radians(azimuth)))
    x, y, _ = still.position(0.0)
    vx, vy, _ = still.velocity(0.0)
    earth = float(SALVA["site"].vertical_rotation)
    launch = kp.Launch.plane(x, y, vx + earth * y, vy - earth * x)
    real = kp.RealMotion(launch=launch, thread="rod", tolerance=1e-12, **given)
    portrait = kp.Portrait.of(real)
    assert portrait.a == pytest.approx(a)
    assert portrait.b == pytest.approx(b, abs=1e-6 * a)
    orbit = portrait.orbit
    times = np.linspace(0.0, orbit.period, 300)
    seen, width, axis = kp.ellipse(real, times)
    turned = math.degrees(axis[-1] - axis[0])
    way = {"round": math.copysign(180.0, orbit.rate), "to and fro": 0.0}[orbit.verdict]
    assert turned == pytest.approx(way, abs=1.0)
    circularity = 2 * seen * width / (seen**2 + width**2)
    assert circularity.min() == pytest.approx(orbit.limits[0], abs=0.01)
    assert circularity.max() == pytest.approx(orbit.limits[1], abs=0.01)
    assert np.abs(width).max() == pytest.approx(orbit.widest, rel=0.02)


def test_an_orbit_keeps_its_invariant() -> None:
    portrait = kp.Portrait(a=0.012, b=0.003, azimuth=1.0, **SALVA)
    circularity, longitude = portrait.path(100)
    start = portrait.invariant(portrait.orbit.circularity, portrait.orbit.longitude)
    assert_allclose(portrait.invariant(circularity, longitude), start, rtol=1e-9)
    grid = portrait.mean_rate(circularity[:, None], longitude[:3])
    assert grid.shape == (100, 3)
    assert grid[0, 0] == pytest.approx(portrait.orbit.rate)


def test_the_frequency_is_that_with_the_bob() -> None:
    bob = kp.Bob(0.1, 2000.0)
    plain = kp.Portrait(a=0.3, **SALVA).orbit.period
    assert kp.Portrait(a=0.3, bob=bob, **SALVA).orbit.period != plain
    motion = kp.EnvelopeMotion(launch=kp.Launch.apsides(0.3, 0.0), bob=bob, **SALVA)
    assert kp.Portrait.of(motion).orbit.period != plain


def test_it_is_plain_data() -> None:
    portrait = kp.Portrait(a=0.012, **SALVA)
    again = pickle.loads(pickle.dumps(portrait))
    assert again == portrait
    assert again.orbit == portrait.orbit
    assert len([place for place in portrait.equilibria if place.stable]) in (2, 3)


def test_without_clamp_or_ground() -> None:
    pendulum, site = SALVA["pendulum"], SALVA["site"]
    even = kp.Portrait(pendulum, 0.1, 0.01, site=site).orbit
    exact = kp.ExactMotion(pendulum, kp.Launch.apsides(0.1, 0.01))
    assert even.verdict == "round"
    assert even.rate == pytest.approx(float(exact.precession) - site.vertical_rotation, rel=1e-6)
    assert kp.Portrait(pendulum, 0.1).orbit.verdict == "stands"
    assert kp.Portrait(pendulum, 0.1, suspension=SALVA["suspension"]).orbit.verdict == "stands"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"a": 0.1, "b": 0.2}, r"\|b\| ≤ a < length and a > 0, but a = 0.1 m, b = 0.2 m"),
        ({"a": 5.0}, r"a = 5 m, b = 0 m, and the length is 4.803 m"),
        ({"a": math.nan}, "a = nan m"),
        ({"a": 0.0}, "a = 0 m"),
        ({"a": 0.1, "azimuth": math.inf}, "azimuth must be finite, but it is inf rad"),
        ({"a": 0.1, "pendulum": kp.Pendulum([1.0, 2.0])}, r"the pendulum has the shape \(2,\)"),
    ],
)
def test_refused(changes: dict, said: str) -> None:
    with pytest.raises(kp.InvalidInput, match=said):
        kp.Portrait(**{**SALVA, **changes})
    with pytest.raises(kp.InvalidInput, match=r"the motion has the shape \(2,\)"):
        kp.Portrait.of(kp.RealMotion(kp.Pendulum([1.0, 2.0]), kp.Launch.apsides(0.1, 0.0)))
