"""How a plane went round: the mean rate and where the Earth alone would have brought it."""

import numpy as np
import pytest

from kugelpendel.observables import Course


def test_course_knows_its_mean_and_its_ideal() -> None:
    times = np.array([1.0, 2.0, 5.0])
    course = Course(times, times, times, np.array([0.3, 0.2, -0.1]), -0.05, 1.0)
    assert course.mean_rate == pytest.approx(-0.1)
    assert course.ideal_azimuth == pytest.approx([0.3, 0.25, 0.1])
    assert Course(times[:1], times[:1], times[:1], times[:1], -0.05, 1.0).mean_rate == 0
