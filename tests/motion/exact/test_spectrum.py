"""The harmonics add up to the motion, and the first of them are Olsson's ansatz (20)."""

from math import ceil, log2

import numpy as np
import pytest
from hypothesis import given, settings
from tests.motion.launches import GALLERY, ROD, Start, named, starts, time_unit

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

UNIT = Pendulum(1.0, 1.0)
# Of the length: the position's own error (test_equations), and as much for the sum.
POSITION = 2e-14
MOMENTS = np.array([-7.7, -1.3, 0.0, 0.4, 2.9, 9.6])


def enough(motion: ExactMotion) -> int:
    """How many pairs leave less than 1e-17 of the length.

    The radial period is 2K/w and the amplitudes fall like exp(−πK'/K) or its square root, with
    K' ≥ π/2 and w·(time unit) not above 2: n·π²/2 > 40·K.
    """
    quarter = motion.radial_period / time_unit(motion)
    return 8 + ceil(8.2 * quarter)


def check(motion: ExactMotion) -> None:
    if motion.frequency == 0:
        return
    unit, length = time_unit(motion), float(motion.pendulum.length)
    spectrum = motion.spectrum(enough(motion))
    # Frequencies are rounded, and so is their product with a time: largest where it oscillates.
    phases = np.abs(spectrum.frequency[..., None] * (unit * MOMENTS))
    rounding = 4.5e-16 * np.sum(np.abs(spectrum.amplitude)[..., None] * phases, axis=0)
    gap = spectrum.position(unit * MOMENTS) - motion.position(unit * MOMENTS)
    assert np.all(np.linalg.norm(gap, axis=-1) <= POSITION * length + 2 * rounding)
    check_frequencies(motion)


def check_frequencies(motion: ExactMotion) -> None:
    spectrum = motion.spectrum(3)
    expected = motion.precession + spectrum.order * motion.frequency
    scale = float(abs(motion.precession) + motion.frequency)
    assert spectrum.frequency == pytest.approx(expected, rel=1e-15, abs=1e-15 * scale)
    expected = spectrum.vertical_order * motion.frequency
    assert spectrum.vertical_frequency == pytest.approx(expected, rel=1e-15)
    if motion.apsidal_angle == 2 * np.pi and motion.angular_momentum == 0:
        assert spectrum.order.tolist() == [-2, -1, 0, 1, 2, 3]
        assert spectrum.vertical_order.tolist() == [0, 1, 2, 3]
    else:
        assert spectrum.order.tolist() == [-5, -3, -1, 1, 3, 5]
        assert spectrum.vertical_order.tolist() == [0, 2, 4, 6]


@pytest.mark.parametrize("start", GALLERY.values(), ids=list(GALLERY))
def test_gallery(start: Start) -> None:
    check(ExactMotion(*start))


@settings(deadline=None)
@given(starts())
def test_any_launch(start: Start) -> None:
    check(ExactMotion(*start))


@pytest.mark.parametrize("pairs", [1, 2, 3])
def test_what_is_left_out_is_beyond_the_orders(pairs: int) -> None:
    # Of a moderate ellipse, the sum of the further amplitudes.
    motion = ExactMotion(ROD, Launch.apsides(0.9, 0.3))
    times = np.linspace(-5, 5, 201)
    spectrum, whole = motion.spectrum(pairs), motion.spectrum(30)
    kept = np.isin(whole.order, spectrum.order)
    np.testing.assert_array_equal(spectrum.amplitude, whole.amplitude[kept])
    gap = (spectrum.position(times) - motion.position(times))[:, :2]
    left_out = np.abs(whole.amplitude[~kept]).sum()
    assert 0.3 * left_out < np.linalg.norm(gap, axis=-1).max() <= left_out


@pytest.mark.parametrize("ratio", [0.5, -0.5, 0.9, 0.0])
def test_first_harmonics_are_the_ansatz(ratio: float) -> None:
    # x + iy = e^{iΩt} (a cos ωt + i b sin ωt) has amplitudes (a ± b)/2; the error is of order a².
    errors = []
    for size in (0.04, 0.02):
        motion = ExactMotion(UNIT, Launch.apsides(size, ratio * size))
        minus, plus = motion.spectrum(1).amplitude
        expected = size * np.array([1 - ratio, 1 + ratio]) / 2
        errors.append(np.abs(np.array([minus, plus]) - expected).max() / size)
    assert errors[1] < 0.002 * 0.04
    assert log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.01)


@pytest.mark.parametrize("size", [1e-12, 1e-10, 1e-9, 1e-8])
@pytest.mark.parametrize("ratio", [-0.4, 0.01, 0.9])
def test_tiny_ellipse_is_the_ansatz(size: float, ratio: float) -> None:
    motion = ExactMotion(UNIT, Launch.apsides(size, ratio * size))
    spectrum = motion.spectrum(1)
    # The error that the docstring of Spectrum states, of the largest amplitude.
    expected = size * np.array([1 - ratio, 1 + ratio]) / 2
    assert spectrum.amplitude == pytest.approx(expected, rel=0, abs=4e-15 * expected.max())
    assert spectrum.frequency == pytest.approx([-1, 1], rel=1e-15)
    # z = 1 − (x² + y²)/2, of which cos 2t takes (a² − b²)/4.
    vertical = [1, -(size**2) * (1 - ratio) * (1 + ratio) / 4]
    assert spectrum.vertical_amplitude == pytest.approx(vertical, rel=1e-14, abs=0)


def test_clockwise_is_the_mirror_image() -> None:
    there = ExactMotion(ROD, Launch.apsides(0.9, 0.3, 0.7)).spectrum(4)
    mirrored = ExactMotion(ROD, Launch.apsides(0.9, -0.3, -0.7)).spectrum(4)
    np.testing.assert_array_equal(mirrored.order, there.order)
    scale = np.abs(there.amplitude).max()
    assert mirrored.amplitude == pytest.approx(np.conj(there.amplitude)[::-1], abs=1e-15 * scale)
    assert mirrored.frequency == pytest.approx(-there.frequency[::-1], rel=1e-15)


@pytest.mark.parametrize("inner", [0.98789, -0.98789, 0.5, -0.5, 1e-7])
def test_cone_is_one_circle(inner: float) -> None:
    motion = ExactMotion(UNIT, Launch.apsides(abs(inner), inner, 1.0))
    amplitude = np.abs(motion.spectrum(2).amplitude)
    expected = np.where(motion.spectrum(2).order == np.sign(inner), abs(inner), 0)
    assert amplitude == pytest.approx(expected, abs=1e-14 * abs(inner))


def test_ensemble_is_made_of_single_spectra() -> None:
    # A bad case, a rotation and the separatrix among them.
    theta_rates = np.array([0.5, np.nan, 3.0, 2.0, 1.9])
    ensemble = ExactMotion(UNIT, Launch.angles(0.0, 0.3, theta_rates)).spectrum(3)
    for index in (0, 2, 4):
        single = ExactMotion(UNIT, Launch.angles(0.0, 0.3, theta_rates[index])).spectrum(3)
        for name in ("order", "frequency", "amplitude"):
            for part in (name, f"vertical_{name}"):
                seen, expected = getattr(ensemble, part)[index], getattr(single, part)
                np.testing.assert_array_equal(seen, expected, part)
    for index in (1, 3):
        assert np.isnan(ensemble.amplitude[index]).all()
        assert np.isnan(ensemble.position([0.0, 1.0])[index]).all()
        np.testing.assert_array_equal(ensemble.order[index], 0)


def test_every_regime_but_the_separatrix_has_one() -> None:
    for start in named("separatrix", "upright").values():
        assert np.isfinite(ExactMotion(*start).spectrum(2).amplitude).all()


@pytest.mark.parametrize(
    ("n", "said"),
    [
        (0, "it is 0"),
        (-3, "it is -3"),
        (float("nan"), "it is nan"),
        (1.5, "it is 1.5"),
        ("2", "'2'"),
    ],
)
def test_orders_that_make_no_sense(n: float, said: str) -> None:
    with pytest.raises(InvalidInput, match=f"harmonics must be a whole number ≥ 1, but .*{said}"):
        ExactMotion(UNIT, Launch.at_rest(1.0)).spectrum(n)  # pyright: ignore[reportArgumentType]


def test_too_many_orders() -> None:
    with pytest.raises(InvalidInput, match=r"1e\+12 .* of memory"):
        ExactMotion(UNIT, Launch.at_rest(1.0)).spectrum(10**12)
