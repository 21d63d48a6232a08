"""The osculating ellipse where the bob all but stands still: rounding must not spoil it."""

import math

import numpy as np

import kugelpendel as kp


def test_every_turning_point_has_its_ellipse() -> None:
    """Where the speed is 1e-7 of the largest one, rounding of the position shows in it."""
    site = kp.Site(math.radians(48.846))

    def motion() -> kp.RealMotion:
        return kp.RealMotion(
            kp.Pendulum(67.0, float(site.gravity)),
            kp.Launch.ellipse(3.0, 0.0),
            site=site,
            drag=kp.Drag.from_half_life(4 * 3600.0),
            suspension=kp.Suspension(3.8e-6, 0.5),
        )

    times = motion().events("outer", 0.0, 86400.0)
    a, b, azimuth = kp.ellipse(motion(), times)
    assert np.isfinite([a, b, azimuth]).all()
    x, y, _ = motion().position(times).T
    np.testing.assert_allclose(a, np.hypot(x, y), rtol=1e-5)
