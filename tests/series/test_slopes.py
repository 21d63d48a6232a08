"""The error of order n against the exact motion falls with the amplitude to the power n + 2."""

from typing import Literal

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import kugelpendel as kp

PENDULUM = kp.Pendulum(length=1.0, gravity=1.0)
RATIOS = (0.1, 0.3, 0.5, 1.0)
# Where the error is well above rounding, 4e-16, and the next order well below it. The slope is off
# by about the ratio of the next order to the first, α² times 1 to 3.
AMPLITUDES = {
    2: np.geomspace(0.01, 0.05, 6),
    4: np.geomspace(0.04, 0.1, 6),
    6: np.geomspace(0.1, 0.2, 6),
    8: np.geomspace(0.15, 0.25, 6),
}
TOLERANCE = 0.25


def slope(amplitudes: NDArray[np.float64], errors: ArrayLike) -> float:
    return float(np.polyfit(np.log(amplitudes), np.log(np.abs(errors)), 1)[0])


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("order", AMPLITUDES)
def test_rates(order: int, ratio: float) -> None:
    alpha = AMPLITUDES[order]
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(alpha, ratio * alpha))
    frequency = kp.series.frequency(order)(alpha, ratio * alpha) - exact.frequency
    precession = kp.series.precession(order)(alpha, ratio * alpha) - exact.precession
    assert slope(alpha, frequency) == pytest.approx(order + 2, abs=TOLERANCE)
    assert slope(alpha, precession) == pytest.approx(order + 2, abs=TOLERANCE)


@pytest.mark.parametrize("ratio", [0.1, 0.3, 0.5, 0.9])
@pytest.mark.parametrize("order", AMPLITUDES)
def test_rates_in_the_first_harmonics(order: int, ratio: float) -> None:
    alpha = AMPLITUDES[order]
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(alpha, ratio * alpha))
    first = np.abs(exact.spectrum(1).amplitude)
    a, b = first[:, 1] + first[:, 0], first[:, 1] - first[:, 0]
    frequency = kp.series.frequency(order, "harmonics")(a, b) - exact.frequency
    precession = kp.series.precession(order, "harmonics")(a, b) - exact.precession
    assert slope(a, frequency) == pytest.approx(order + 2, abs=TOLERANCE)
    assert slope(a, precession) == pytest.approx(order + 2, abs=TOLERANCE)


@pytest.mark.parametrize("ratio", [0.1, 0.5])
@pytest.mark.parametrize("order", AMPLITUDES)
@pytest.mark.parametrize("variables", ["radii", "harmonics"])
def test_harmonics(variables: Literal["radii", "harmonics"], order: int, ratio: float) -> None:
    """All together, as they add up to a position: relative to the amplitude, n + 2 again."""
    alpha = AMPLITUDES[order]
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(alpha, ratio * alpha))
    spectrum = exact.spectrum(8)
    a, b = alpha, ratio * alpha
    if variables == "harmonics":
        at = spectrum.order[0].tolist().index(1)
        first = np.abs(spectrum.amplitude)
        a, b = first[:, at] + first[:, at - 1], first[:, at] - first[:, at - 1]
    series = kp.series.harmonics(order, variables)
    # The launch is a highest point on the x axis, so the amplitudes are real, with their signs.
    plan = sum(
        np.abs(spectrum.amplitude[:, i].real - (series.plan[n](a, b) if n in series.plan else 0))
        for i, n in enumerate(spectrum.order[0].tolist())
    )
    height = sum(
        np.abs(
            (1.0 if n == 0 else 0.0)
            - spectrum.vertical_amplitude[:, i].real
            - (series.height[n](a, b) if n in series.height else 0)
        )
        for i, n in enumerate(spectrum.vertical_order[0].tolist())
    )
    assert slope(alpha, np.asarray(plan)) == pytest.approx(order + 3, abs=TOLERANCE)
    if order > 2:  # the heights of order 2 are right to 1e-11, and counted from 1
        assert slope(alpha, np.asarray(height)) == pytest.approx(order + 4, abs=TOLERANCE)


def test_no_harmonic_is_missing_that_the_order_can_see() -> None:
    series = kp.series.harmonics(8)
    assert sorted(series.plan) == [-9, -7, -5, -3, -1, 1, 3, 5, 7, 9]
    assert sorted(series.height) == [0, 2, 4, 6, 8, 10]
