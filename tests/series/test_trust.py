"""The expected errors against the true ones."""

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(length=1.0, gravity=1.0)
ALPHA = np.array([0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99])[:, np.newaxis]
RATIO = np.array([0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 1.0])
BETA = ALPHA * RATIO
EXACT = kp.ExactMotion(PENDULUM, kp.Launch.apsides(ALPHA, BETA))
ROUNDING = 1e-13  # errors below are not compared


@pytest.mark.parametrize("order", [2, 4, 6, 8, 10, 12])
@pytest.mark.parametrize("which", ["frequency", "precession"])
def test_expected_errors_are_the_true_ones(which: str, order: int) -> None:
    series = getattr(kp.series, which)(order)(ALPHA, BETA)
    true = np.abs(series / getattr(EXACT, which) - 1)
    expected = getattr(kp.series.trusted(ALPHA, BETA, order), which)
    share = np.where(true > ROUNDING, true / expected, np.nan)
    # Measured: 1.034 at most, 0.08 at least; the latter at α = 0.99.
    assert np.nanmax(share) < 1.04
    assert np.nanmin(share) > 0.07
    # Measured: 0.69, on cones, whose frequency of order 2 is right near α = 0.64.
    assert np.nanmin(share[:4]) > 0.65


@pytest.mark.parametrize("order", [2, 6])
def test_expected_error_of_the_path(order: int) -> None:
    alpha, beta = 0.3, 0.1
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(alpha, beta))
    series, trust = kp.series.harmonics(order), kp.series.trusted(alpha, beta, order)
    spectrum = exact.spectrum(10)
    left_out = sum(
        abs(value.real - (series.plan[n](alpha, beta) if n in series.plan else 0))
        for n, value in zip(spectrum.order.tolist(), spectrum.amplitude, strict=True)
    )
    assert trust.position == pytest.approx(left_out, rel=0.2)
    drift = abs(kp.series.frequency(order)(alpha, beta) - exact.frequency)
    drift += abs(kp.series.precession(order)(alpha, beta) - exact.precession)
    assert trust.drift == pytest.approx(drift, rel=0.05)


def test_plane_motion_has_a_precession_error_too() -> None:
    """The limit of the relative one."""
    plane, nearly = (kp.series.trusted(0.3, beta, 4) for beta in (0.0, 1e-9))
    assert plane.precession == pytest.approx(nearly.precession, rel=1e-9)
    assert kp.series.trusted(0.0, 0.0, 2).worst == 0.0


def test_orders_whose_next_are_not_in_the_table() -> None:
    expected = kp.series.trusted(0.8, 0.2, 16).frequency
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(0.8, 0.2)).frequency
    assert expected == pytest.approx(abs(kp.series.frequency(16)(0.8, 0.2) / exact - 1), rel=0.3)


def test_signs_and_exchange_do_not_matter() -> None:
    trust = kp.series.trusted(0.3, 0.1, 4)
    for alpha, beta in ((0.3, -0.1), (0.1, 0.3), (-0.3, 0.1)):
        other = kp.series.trusted(alpha, beta, 4)
        for name in ("frequency", "precession", "position", "drift"):
            assert getattr(other, name) == pytest.approx(getattr(trust, name), rel=1e-12)


def test_warning() -> None:
    assert kp.series.trusted(0.15, 0.1, 2).warning is None
    warning = kp.series.trusted(0.9, 0.1, 2).warning
    assert warning is not None
    assert warning.startswith("The series of order 2 is wrong by up to 45 % at a turning ")
    assert "radius of 0.9 l; use a higher order, or ExactMotion" in warning
    assert kp.series.trusted([0.1, 0.9, 2.0], 0.1, 2).warning == warning
    assert kp.series.trusted([2.0, np.nan], 0.1, 2).warning is None


def test_text() -> None:
    assert str(kp.series.trusted(0.3, 0.1, 6)) == (
        "Series of order 6: expected errors of the frequency 3.9e-07, of the precession 5.5e-05 "
        "(relative), of the harmonics 3.7e-07 l."
    )


@pytest.mark.parametrize(("alpha", "beta"), [(1.0, 0.1), (0.1, -1.5), (float("nan"), 0.1)])
def test_beyond_convergence_is_refused(alpha: float, beta: float) -> None:
    with pytest.raises(kp.InvalidInput, match=r"converge while both turning radii are below"):
        kp.series.trusted(alpha, beta, 6)


def test_arrays_have_nan_there() -> None:
    trust = kp.series.trusted([0.1, 1.0, np.nan], 0.1, 6)
    for value in (trust.frequency, trust.precession, trust.position, trust.drift):
        assert np.array_equal(np.isnan(value), [False, True, True])
