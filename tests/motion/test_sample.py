"""A grid is the same motion as its times one by one."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.motion.launches import GALLERY, ROD, Start, powers_of_ten, starts, time_unit

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

# Of the length, for two computations: see test_symmetry.
POSITION = 2e-14
POWERS = 2.0 ** np.arange(-60, 61)


def exact_grid(motion: ExactMotion, start: int, step: int, scale: float) -> tuple[float, float]:
    """Start and step so that start + step·k has few enough bits to be a binary64 number."""
    unit = POWERS[np.argmin(np.abs(np.log(POWERS / (scale * time_unit(motion)))))]
    return start * unit, step * unit


@pytest.mark.parametrize("start", GALLERY.values(), ids=list(GALLERY))
def test_sample_is_position_on_the_same_times(start: Start) -> None:
    motion = ExactMotion(*start)
    first, step = exact_grid(motion, -1017, 3, 0.02)
    # Longer than the grid's own blocks, whatever they are.
    seen = motion.sample(first, step, 5000)
    expected = motion.position(first + step * np.arange(5000))
    assert np.abs(seen - expected).max() <= POSITION * float(motion.pendulum.length)


@settings(deadline=None)
@given(
    starts(),
    st.integers(-(2**30), 2**30),
    st.integers(-(2**20), 2**20).filter(bool),
    powers_of_ten(-9, 6),
    st.integers(0, 700),
)
def test_sample_of_any_motion(
    launch: Start, start: int, step: int, scale: float, count: int
) -> None:
    motion = ExactMotion(*launch)
    first, step_size = exact_grid(motion, start, step, scale)
    seen = motion.sample(first, step_size, count)
    expected = motion.position(first + step_size * np.arange(count))
    assert seen.shape == (count, 3)
    assert np.abs(seen - expected).max(initial=0) <= POSITION * float(motion.pendulum.length)


def test_sum_of_start_and_step_is_not_rounded() -> None:
    # 1e9 s plus a multiple of 0.1 s is rounded to 1e-7 s as a binary64 number; the grid's is not:
    # it is as close to the later half of a grid that starts at 0.
    motion = ExactMotion(ROD, Launch.apsides(0.5, 0.2))
    step, count = 0.1, 1000
    whole = 2**33
    far = ExactMotion(ROD, Launch.apsides(0.5, 0.2)).sample(whole * step, step, count)
    assert np.abs(far - motion.sample(whole * step, step, count)).max() == 0
    rounded = motion.position(whole * step + step * np.arange(count))
    exact = motion.sample(whole * step - 2**20 * step, step, 2**20 + count)[-count:]
    assert np.abs(rounded - exact).max() > 1e-8
    assert np.abs(far - exact).max() <= 1e-7


def test_empty_grid() -> None:
    assert ExactMotion(ROD, Launch.at_rest(1.0)).sample(0.0, 1.0, 0).shape == (0, 3)


def test_grid_backwards() -> None:
    motion = ExactMotion(ROD, Launch.apsides(0.5, 0.2))
    there, back = motion.sample(0.0, 0.25, 101), motion.sample(25.0, -0.25, 101)
    assert np.abs(there - back[::-1]).max() <= POSITION * 1.7


@pytest.mark.parametrize(
    ("start", "step", "count", "said"),
    [
        (0.0, 0.0, 10, "step must not be 0 s: every sample would be the same; use position"),
        (0.0, -0.0, 10, "step must not be 0 s"),
        (float("nan"), 1.0, 10, "start must be finite, but it is nan s"),
        (float("inf"), 1.0, 10, "start must be finite, but it is inf s"),
        (0.0, float("nan"), 10, "step must be finite, but it is nan s"),
        (0.0, float("-inf"), 10, "step must be finite, but it is -inf s"),
        (0.0, 1.0, -1, "count of samples must be a whole number ≥ 0, but it is -1"),
        (0.0, 1.0, 2.5, "count of samples must be a whole number ≥ 0, but it is 2.5"),
        (0.0, 1.0, float("nan"), "count of samples must be a whole number ≥ 0, but it is nan"),
        (0.0, 1.0, float("inf"), "count of samples must be a whole number ≥ 0, but it is inf"),
        (0.0, 1.0, 10**12, r"1e\+12 samples would take 2.4e\+04 GB of memory"),
        (0.0, 1.0, 1e12, r"1e\+12 samples would take 2.4e\+04 GB .* ask for fewer, or go piece"),
    ],
)
def test_grid_that_makes_no_sense(start: float, step: float, count: float, said: str) -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.at_rest(1.0))
    with pytest.raises(InvalidInput, match=said):
        motion.sample(start, step, count)  # pyright: ignore[reportArgumentType]


def test_whole_count_of_any_type() -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.at_rest(1.0))
    assert motion.sample(0, 1, np.int64(3)).shape == (3, 3)  # pyright: ignore[reportArgumentType]
    assert motion.sample(0, 1, 3.0).shape == (3, 3)  # pyright: ignore[reportArgumentType]


def test_memory_counts_every_motion_of_an_ensemble() -> None:
    ensemble = ExactMotion(Pendulum(1.0), Launch.at_rest([0.1, 0.2, 0.3, 0.4]))
    with pytest.raises(InvalidInput, match=r"1e\+11 samples would take 9.6e\+03 GB of memory"):
        ensemble.sample(0.0, 1.0, 10**11)


def test_sample_into_an_array_that_is_there() -> None:
    motion = ExactMotion(ROD, Launch.apsides([0.5, 0.3], 0.2))
    out = np.full((2, 1000, 3), np.nan)
    assert motion.sample(1.0, 0.01, 1000, out=out) is out
    np.testing.assert_array_equal(out, motion.sample(1.0, 0.01, 1000))


@pytest.mark.parametrize(
    ("out", "sentence"),
    [
        (np.empty((5, 2)), r"shape \(5, 3\), but its shape is \(5, 2\); make it with numpy.empty"),
        (np.empty((5, 3), np.float32), "float64, but its dtype is float32"),
        (np.empty((5, 6))[:, ::2], r"C-contiguous.*its strides \(48, 16\)"),
        (np.broadcast_to(np.empty(3), (5, 3)), "C-contiguous, writeable"),
        ([0.0] * 15, "must be an array to be filled"),
    ],
)
def test_an_out_that_does_not_fit(out: np.ndarray, sentence: str) -> None:
    with pytest.raises(InvalidInput, match=sentence):
        ExactMotion(ROD, Launch.apsides(0.5, 0.2)).sample(0.0, 0.1, 5, out=out)
