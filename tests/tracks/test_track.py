"""What a track may be."""

import math

import numpy as np
import pytest

import kugelpendel as kp


def test_keeps_what_it_is_given_and_cannot_be_changed():
    times = np.array([0.0, 0.5, 0.7])
    track = kp.tracks.Track(times, np.arange(3.0), np.ones(3), unit="px")
    times[0] = 9.0
    assert (len(track), track.time[0], track.unit) == (3, 0.0, "px")
    with pytest.raises(ValueError, match="read-only"):
        track.x[0] = 5.0


@pytest.mark.parametrize(
    ("time", "x", "said"),
    [
        ([0.0, 1.0], [0.0], r"x has the shape \(1,\), and the times have \(2,\)"),
        ([0.0, 1.0], [0.0, math.nan], r"x\[1\] is NaN"),
        ([0.0, 0.0], [0.0, 1.0], "after 0 s comes 0 s"),
        ([[0.0]], [[0.0]], "flat array"),
    ],
)
def test_refuses_what_is_no_track(time, x, said):
    with pytest.raises(kp.InvalidInput, match=said):
        kp.tracks.Track(np.array(time), np.array(x), np.array(x))


def test_refuses_what_is_no_table_of_ellipses():
    one = np.ones(2)
    with pytest.raises(kp.InvalidInput, match=r"b\[1\] is inf; leave out what was not"):
        kp.tracks.EllipseTable(np.arange(2.0), one, np.array([0.0, math.inf]), one)
    with pytest.raises(kp.InvalidInput, match=r"times of a recording ascend.*keep one row"):
        kp.tracks.EllipseTable(one, one, one, one)
    with pytest.raises(
        kp.InvalidInput, match=r"azimuth has the shape \(3,\), and the times have \(2,\)"
    ):
        kp.tracks.EllipseTable(np.arange(2.0), one, one, np.ones(3))
