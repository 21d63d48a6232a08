"""The site: rotation, normal gravity against published values, and what is refused."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from kugelpendel import InvalidInput, Site


@pytest.mark.parametrize(
    ("latitude", "published", "rounding"),
    [
        # NIMA TR8350.2 (2000), table 3.4: at the equator and at the poles, each to its last digit.
        (0.0, 9.7803253359, 5e-11),
        (90.0, 9.8321849378, 1e-10),
        (-90.0, 9.8321849378, 1e-10),
    ],
)
def test_normal_gravity(latitude: float, published: float, rounding: float) -> None:
    assert Site(math.radians(latitude)).gravity == pytest.approx(published, abs=rounding)


def test_normal_gravity_against_the_older_ellipsoid() -> None:
    # GRS 80 at 45° (H. Moritz, Geodetic Reference System 1980): 9.806199203 m/s². The two
    # ellipsoids differ by 1.4e-6 m/s² at the equator and the poles, so here as well.
    assert Site(math.pi / 4).gravity == pytest.approx(9.806199203, abs=2e-6)


def test_gravity_falls_with_the_height() -> None:
    low, high = Site(math.pi / 4), Site(math.pi / 4, height=10.0)
    # The free-air gradient, 0.3086 mGal/m, near the ground, to the digits surveyors use.
    assert (float(low.gravity) - float(high.gravity)) / 10 == pytest.approx(3.086e-6, rel=2e-4)


def test_gravity_that_is_given_stays() -> None:
    site = Site(0.5, 9.81, height=3000.0)
    assert site.gravity == 9.81
    assert site.gravity_given
    assert not Site(0.5).gravity_given


def test_rotation() -> None:
    # A turn against the stars takes 23 h 56 min 4.1 s.
    assert 2 * math.pi / Site(0.0).rotation == pytest.approx(86164.1, abs=0.1)
    north, south = Site(math.radians(30)), Site(math.radians(-30))
    assert north.vertical_rotation == pytest.approx(7.292115e-5 / 2)
    assert south.vertical_rotation == pytest.approx(-7.292115e-5 / 2)
    assert south.horizontal_rotation == north.horizontal_rotation
    assert north.horizontal_rotation == pytest.approx(7.292115e-5 * math.sqrt(0.75))


def test_arrays_broadcast() -> None:
    site = Site(np.radians([[10.0], [20.0]]), height=[0.0, 100.0, 200.0])
    assert site.shape == (2, 3)
    assert np.shape(site.gravity) == (2, 3)
    assert_allclose(np.asarray(site.gravity)[1, 2], Site(math.radians(20), height=200.0).gravity)


REFUSED = [
    ((48.8,), r"latitude must lie .* 48.8 rad; write math.radians\(48.8\) if these are degrees"),
    ((-80.0,), r"is -80 rad; write math.radians\(-80\) if these are degrees"),
    ((91.0,), "is 91 rad; it is at most 90 degrees"),
    ((math.nan,), "latitude must be finite, but it is nan rad"),
    ((math.inf,), "latitude must be finite, but it is inf rad"),
    ((0.5, 0.0), "gravity must be positive and finite, but it is 0 m/s²; leave it out for"),
    ((0.5, -9.8), "gravity must be positive"),
    ((0.5, math.nan), "gravity must be positive and finite, but it is nan m/s²"),
    ((0.5, None, 1e6), r"height must lie between −20000 and 20000 m, but it is 1e\+06 m"),
    ((0.5, None, math.nan), "height must lie .* but it is nan m"),
    (("48 deg",), "latitude must be a number .* in rad, .* leave units out here"),
    (([0.1, 0.2], [9.8, 9.8, 9.8]), "latitude, gravity and height do not fit together"),
    (([0.1, 0.2], None, [1.0, 2.0, 3.0]), "latitude, gravity and height do not fit together"),
]


@pytest.mark.parametrize(("arguments", "said"), REFUSED)
def test_refused(arguments: tuple, said: str) -> None:
    with pytest.raises(InvalidInput, match=f"[Tt]he site's {said}|{said}"):
        Site(*arguments)


def test_poles_are_allowed() -> None:
    for pole in (math.pi / 2, math.radians(-90)):
        assert abs(float(Site(pole).horizontal_rotation)) < 1e-20
