"""Times that can be asked for, and those that cannot; what asking leaves untouched."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kugelpendel import (
    EnvelopeMotion,
    ExactMotion,
    InvalidInput,
    Launch,
    Pendulum,
    PlaneMotion,
    RealMotion,
    Site,
)

PENDULUM = Pendulum(1.7, 9.81)
MOTION = ExactMotion(PENDULUM, Launch.apsides(0.5, 0.2, 0.3))
QUANTITIES = ("position", "velocity", "tension")


@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize(
    "times",
    [3, [0, 1, 2], (0.0, 1.5), range(4), np.arange(6, dtype=np.int32).reshape(2, 3),
     np.linspace(0, 1, 7, dtype=np.float32), np.linspace(0, 9, 10)[::3],
     np.linspace(0, 9, 12).reshape(3, 4).T, np.float64(2.0)],
    ids=str,
)  # fmt: skip
def test_any_array_like(quantity: str, times: object) -> None:
    asked = getattr(MOTION, quantity)
    plain = np.array(times, dtype=np.float64)
    expected = [asked(float(time)) for time in plain.ravel()]
    seen = asked(times)
    assert_array_equal(seen, np.reshape(expected, (*plain.shape, *seen.shape[plain.ndim :])))


@pytest.mark.parametrize("quantity", [*QUANTITIES, "to_xarray"])
@pytest.mark.parametrize(
    ("times", "said"),
    [
        ([0.0, np.nan, 1.0], "must be finite, but 1 of 3 are not, the first of them nan s"),
        ([np.inf, np.nan], "but 2 of 2 are not, the first of them inf s"),
        ([0.0, -np.inf], "the first of them -inf s"),
        (["1 s"], "times must be a number or an array of numbers in s, .* leave units out"),
        ([1j], "times must be a number or an array of numbers in s"),
        ([None], "times must be a number or an array of numbers in s"),
        ([[0.0, 1.0], [2.0]], "times must be a number or an array of numbers in s"),
    ],
)
def test_times_that_make_no_sense(quantity: str, times: object, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        getattr(MOTION, quantity)(times)


def test_too_many_times() -> None:
    ensemble = ExactMotion(PENDULUM, Launch.at_rest(np.full(50_000, 0.1)))
    with pytest.raises(InvalidInput, match=r"1e\+06 samples would take 1.2e\+03 GB of memory"):
        ensemble.position(np.zeros(10**6))


def test_times_are_left_alone() -> None:
    times = np.linspace(0, 1, 5)
    before = times.copy()
    times.flags.writeable = False
    seen = MOTION.position(times)
    seen[:] = 0
    assert_array_equal(times, before)
    assert MOTION.position(times).any()


@pytest.mark.parametrize("periods", [1e3, 1e6, 1e9, 1e12])
def test_late_times_are_as_good_as_early_ones(periods: float) -> None:
    # The next binary64 time, 5e-7 s later at 1e9 periods, is another place: velocity times that.
    late = 2.0 ** np.round(np.log2(periods * 2 * MOTION.radial_period))
    step = float(np.spacing(late))
    before, after = MOTION.position([late, late + step])
    middle = MOTION.velocity(late)
    assert after - before == pytest.approx(step * middle, rel=0, abs=20 * step**2 + 1e-14)


@pytest.mark.parametrize("time", [-1e3, -1e9, -1e15])
def test_very_early_times(time: float) -> None:
    # Backwards from the launch is forwards from the opposite one.
    reversed_motion = ExactMotion(PENDULUM, Launch.apsides(0.5, -0.2, 0.3))
    gap = MOTION.position(time) - reversed_motion.position(-time)
    assert np.abs(gap).max() <= 3e-14 * 1.7


@pytest.mark.parametrize("time", [1e18, -1e100, 1.7e308, 5e-324, -0.0])
def test_extreme_times_stay_on_the_sphere(time: float) -> None:
    # Where a binary64 time no longer tells the phase, the path is still the right one.
    position, velocity = MOTION.position(time), MOTION.velocity(time)
    assert np.linalg.norm(position) == pytest.approx(1.7, rel=1e-14)
    energy = velocity @ velocity / 2 + 9.81 * (1.7 - position[2])
    assert energy == pytest.approx(MOTION.energy, abs=1e-13)


@pytest.mark.parametrize("time", [2e100, -1e308, [0.0, 1e250]])
@pytest.mark.parametrize("kind", [PlaneMotion, RealMotion, EnvelopeMotion])
def test_nothing_is_followed_for_ever(
    kind: type[PlaneMotion | RealMotion | EnvelopeMotion], time: float | list[float]
) -> None:
    motion = kind(PENDULUM, Launch.plane(0.1, 0.2, 0.0, 0.3))
    with pytest.raises(InvalidInput, match=r"no further than 1e\+100 s from the launch"):
        motion.position(time)


def test_an_azimuth_stays_a_number_at_the_last_time() -> None:
    # Ω t of 1e308 s overflowed, and the position with it.
    motion = EnvelopeMotion(PENDULUM, Launch.plane(0.1, 0.2, 0.0, 0.3), site=Site(-1.0))
    assert np.isfinite(motion.azimuth(1e100))
    assert np.linalg.norm(motion.position(1e100)) == pytest.approx(1.7, rel=1e-14)
