"""Reductions are right, and the same to the last bit whatever the pieces they came in."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy import stats

from kugelpendel.sweeps import QUANTILE_ERROR
from kugelpendel.sweeps._dataset import _told
from kugelpendel.sweeps._reductions import BINS, FIELDS, binned, combined, edges, moments, quantiles

NUMBERS = st.floats(-1e10, 1e10).map(lambda x: 0.0 if abs(x) < 1e-12 else x)


def sample(n: int, seed: int = 0) -> np.ndarray[Any, Any]:
    draw = np.random.default_rng(seed)
    return draw.gamma(2.0, 3.0, n) - 4.0


def test_moments_are_those_of_scipy() -> None:
    values = sample(10_001)
    values[17], values[5], values[9_000] = np.nan, np.inf, -np.inf
    finite = values[np.isfinite(values)]
    found = _told(moments(values))
    assert found["count"] == finite.size
    assert found["infinite"] == 2
    assert found["least"] == finite.min()
    assert found["most"] == finite.max()
    assert found["mean"] == pytest.approx(finite.mean(), rel=1e-14)
    assert found["std"] == pytest.approx(finite.std(ddof=1), rel=1e-13)
    assert found["skewness"] == pytest.approx(stats.skew(finite), rel=1e-11)
    assert found["kurtosis"] == pytest.approx(stats.kurtosis(finite), rel=1e-11)


def test_a_large_mean_does_not_hide_a_small_spread() -> None:
    values = 1e6 + 1e-3 * sample(5000)
    assert _told(moments(values))["std"] == pytest.approx(values.std(ddof=1), rel=1e-7)


@pytest.mark.parametrize("values", [np.full(3, np.nan), np.empty(0), np.full((2, 2), np.nan)])
def test_nothing_has_no_moments(values: np.ndarray[Any, Any]) -> None:
    found = _told(moments(values))
    assert (found["count"] == 0).all()
    for name in ("mean", "std", "least", "most"):
        assert np.isnan(found[name]).all()


@pytest.mark.parametrize("chunk", [64, 128, 256, 1024, 1 << 15])
@pytest.mark.parametrize("count", [1, 63, 64, 65, 1000, 5000])
def test_moments_do_not_depend_on_the_chunks(count: int, chunk: int) -> None:
    values = np.stack([sample(count), sample(count, 1)], axis=1)
    values[::7, 0] = np.nan
    parts = [moments(values[k : k + chunk]) for k in range(0, count, chunk)]
    assert combined(np.stack(parts)).tobytes() == moments(values).tobytes()


@given(arrays(np.float64, st.integers(1, 300), elements=NUMBERS))
@settings(max_examples=100, deadline=None)
def test_quantiles_are_right_to_their_error(values: np.ndarray[Any, Any]) -> None:
    shares = np.array([0.01, 0.25, 0.5, 0.9, 0.99])
    found = quantiles(binned(values).astype(np.int64), shares)
    exact = np.quantile(values, shares, method="inverted_cdf")
    assert (np.abs(found - exact) <= QUANTILE_ERROR * np.abs(exact) * (1 + 1e-9) + 1e-15).all()


@given(st.floats(allow_nan=False))
@settings(max_examples=300, deadline=None)
def test_every_number_lies_in_its_bin(value: float) -> None:
    counts = binned(np.array([value, np.nan]))
    assert counts.shape == (BINS,)
    assert counts.sum() == 1
    lower, upper = edges(np.flatnonzero(counts))
    assert lower[0] <= value <= upper[0]


def test_what_never_comes_is_the_largest() -> None:
    """An infinite time, as of a plane that never turns, counts among the quantiles."""
    values = np.concatenate([np.full(30, np.inf), np.arange(1.0, 71.0)])
    found = quantiles(binned(values).astype(np.int64), np.array([0.5, 0.9]))
    assert found[0] == pytest.approx(50, rel=QUANTILE_ERROR)
    assert found[1] == np.inf


def test_fields_have_names() -> None:
    assert moments(np.ones((5, 2))).shape == (len(FIELDS), 2)
