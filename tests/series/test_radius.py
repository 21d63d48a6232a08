"""Where the series stop converging, seen in their own coefficients."""

from fractions import Fraction

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.series._expansion import in_harmonics, rates
from kugelpendel.series._power_series import PowerSeries

DEGREE = 62
SCALE = 256
RATIOS = (0.0, 0.25, 0.5, 0.75)


def on_ray(ratio: float, variables: str) -> list[Fraction]:
    """Coefficients of ω in t², a = t, b = ratio · t."""
    rest = (0,) * (DEGREE - 1)
    a, b = (PowerSeries((0, int(SCALE * share), *rest), slot=64) for share in (1, ratio))
    series = rates(a, b)[0] if variables == "radii" else in_harmonics(a, b).frequency
    return [Fraction(part, SCALE**n) for n, part in enumerate(series.parts)][::2]


@pytest.mark.parametrize("variables", ["radii", "harmonics"])
@pytest.mark.parametrize("ratio", RATIOS)
def test_ratios_of_coefficients_tend_to_the_radius(ratio: float, variables: str) -> None:
    """c_n/c_{n−1} = (1 − 3/2n + …)/radius² at a square root's branch point (Domb and Sykes)."""
    coefficients = on_ray(ratio, variables)
    coarse, fine = (
        float(coefficients[n] / coefficients[n - 1]) / (1 - 1.5 / n)
        for n in (DEGREE // 4, DEGREE // 2)
    )
    limit = (4 * fine - coarse) / 3  # what is left goes like 1/n²
    radius = kp.series.radius(ratio, variables)  # pyright: ignore[reportArgumentType]
    assert limit**-0.5 == pytest.approx(radius, rel=0.004)


def test_cones_diverge_at_the_equator() -> None:
    """ω² = (1 + 3c²)/4c, c² = 1 − α²: a pole of ω⁴, so the coefficients fall like n^(−3/4)."""
    coefficients = on_ray(1.0, "radii")
    n = len(coefficients) - 1
    assert coefficients == on_ray(1.0, "harmonics")
    assert coefficients[n] / coefficients[n - 1] / (1 - 0.75 / n) == pytest.approx(1, rel=0.01)


def test_beyond_the_radius_higher_orders_are_worse_and_within_it_better() -> None:
    pendulum = kp.Pendulum(length=1.0, gravity=1.0)
    exact = kp.ExactMotion(pendulum, kp.Launch.apsides(0.95, 0.3))
    errors = [
        abs(float(kp.series.precession(n)(0.95, 0.3)) - float(exact.precession))
        for n in range(2, 17, 2)
    ]
    assert errors == sorted(errors, reverse=True)
    sizes = [abs(kp.series.frequency(16).homogeneous(n)(1.25, 0.3)) for n in range(8, 17, 2)]
    assert sizes == sorted(sizes)


def test_harmonics_go_on_beyond_the_equator() -> None:
    """A swing to 94°: the turning radius is past its largest value, the first harmonic is not."""
    exact = kp.ExactMotion(kp.Pendulum(1.0, 1.0), kp.Launch.at_rest(np.radians(94.0)))
    first = np.abs(exact.spectrum(1).amplitude)
    a, b = first[1] + first[0], first[1] - first[0]
    assert a < kp.series.radius(0.0, "harmonics")
    errors = [
        float(kp.series.frequency(n, "harmonics")(a, b)) / float(exact.frequency) - 1
        for n in (4, 8, 12, 16)
    ]
    assert errors == sorted(errors, reverse=True)
    assert 0 < errors[-1] < 0.022  # slowly, this near to the radius


def test_values() -> None:
    assert kp.series.radius(0.3) == kp.series.radius(-1) == 1.0
    assert kp.series.radius(0.0, "harmonics") == pytest.approx(1.17503, abs=1e-5)
    assert kp.series.radius(1.0, "harmonics") == 1.0
    assert kp.series.radius(-0.25, "harmonics") == kp.series.radius(0.25, "harmonics")
    several = kp.series.radius([0.0, 1.5, 1.0, np.nan], "harmonics")
    assert np.array_equal(np.isnan(several), [False, True, False, True])


@pytest.mark.parametrize("ratio", [1.5, -2.0, float("nan"), float("inf")])
def test_a_ratio_out_of_range_is_refused(ratio: float) -> None:
    with pytest.raises(kp.InvalidInput, match=r"must lie between −1 and 1, but it is"):
        kp.series.radius(ratio)
