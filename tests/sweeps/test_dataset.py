"""The data set is that of the cases, reads what is looked at, and tells of the bad ones."""

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from tests.sweeps.made import averaged, exact

import kugelpendel as kp
from kugelpendel.sweeps import Listed, Spaced, Uniform, results_of, why


@pytest.fixture(scope="module")
def grid(tmp_path_factory: pytest.TempPathFactory) -> xr.Dataset:
    return kp.sweep(averaged(), tmp_path_factory.mktemp("grid"))


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> xr.Dataset:
    return kp.sweep(exact(1000, chunk=128), tmp_path_factory.mktemp("drawn"))


def test_a_grid_has_its_numbers_as_dimensions(grid: xr.Dataset) -> None:
    sweep = averaged()
    assert dict(grid.sizes) == {"launch.a": 10, "suspension.anisotropy": 24, "time": 2}
    assert grid["suspension.anisotropy"].attrs == {
        "units": "rad/s", "long_name": "suspension anisotropy",
    }  # fmt: skip
    assert grid.azimuth.attrs["units"] == "rad"
    expected, status = results_of(sweep, 0, 240)
    assert np.array_equal(grid.azimuth.values, expected["azimuth"].reshape(10, 24, 2))
    assert (grid.status.values == 1).all()
    assert (status == 1).all()
    one = grid.azimuth.sel({"launch.a": 0.05, "time": 3600.0})
    assert np.array_equal(one.values, expected["azimuth"][:24, 1])


KEYS: list[Any] = [
    {"launch.a": 3, "suspension.anisotropy": -1, "time": 0},
    {"launch.a": slice(2, 9, 3), "suspension.anisotropy": [5, 2, 2]},
    {"suspension.anisotropy": slice(None, None, -5), "time": 1},
    {"launch.a": np.array([True] + [False] * 9)},
    {"launch.a": slice(4, 4)},
    {"launch.a": [0, 9], "suspension.anisotropy": [0, 23], "time": [1, 0]},
]


@pytest.mark.parametrize("key", KEYS, ids=str)
def test_any_part_is_that_of_the_whole(key: dict[str, Any], tmp_path: Path) -> None:
    lazy = kp.sweep(averaged(), tmp_path)
    whole = lazy.copy(deep=True).load()
    assert lazy.isel(key).identical(whole.isel(key))
    at = xr.DataArray([0, 3, 3], dims="point")
    assert lazy.isel({"launch.a": at, "time": at % 2}).identical(
        whole.isel({"launch.a": at, "time": at % 2})
    )


def test_what_varies_stands_along_the_cases(drawn: xr.Dataset) -> None:
    sweep = exact(1000)
    assert drawn.precession.dims == ("case",)
    values = sweep.values(0, 1000)
    for name in sweep.names:
        assert np.array_equal(drawn[name].values, values[name])
        assert np.array_equal(drawn[name][[7, 3]].values, values[name][[7, 3]])
    assert drawn["launch.a"][-1].item() == values["launch.a"][-1]
    assert drawn.where(drawn["launch.a"] > 0.3, drop=True).sizes["case"] == int(
        (values["launch.a"] > 0.3).sum()
    )


def test_dask_is_not_imported(tmp_path: Path, repository: Path) -> None:
    import subprocess

    program = (
        "import sys, kugelpendel as kp\n"
        "from tests.sweeps.made import exact\n"
        f"kp.sweep(exact(10), {str(tmp_path)!r})\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules}))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=repository
    )
    loaded = set(done.stdout.split())
    assert "zarr" in loaded
    assert not loaded & {"dask", "distributed", "matplotlib", "pint"}


def test_it_is_read_again(grid: xr.Dataset, tmp_path: Path) -> None:
    kp.sweep(averaged(), tmp_path)
    sweep, again = kp.sweeps.read(tmp_path)
    assert sweep == averaged()
    assert again.identical(grid)
    (tmp_path / "sweep.zarr" / "done" / "c" / "2").unlink()
    counts = kp.sweeps.read(tmp_path)[1].status.attrs["counts"]
    assert counts == [8, 232, 0, 0]  # what is being done is not counted


def test_reductions_are_those_of_all_values(drawn: xr.Dataset, tmp_path: Path) -> None:
    kept: Any = ("moments", "quantiles", "histograms")
    reduced = kp.sweep(exact(1000, keep=kept, chunk=64), tmp_path)
    values = drawn.precession.values
    assert "precession" not in reduced
    assert reduced.precession_count == 1000
    assert reduced.precession_mean == pytest.approx(values.mean(), rel=1e-12)
    assert reduced.precession_std == pytest.approx(values.std(ddof=1), rel=1e-12)
    assert reduced.precession_mean.attrs["units"] == "rad/s"
    exactly = np.quantile(values, reduced["quantile"].values, method="inverted_cdf")
    assert reduced.precession_quantile.values == pytest.approx(
        exactly, rel=kp.sweeps.QUANTILE_ERROR
    )
    histogram = reduced.precession_histogram
    assert histogram.sum() == 1000
    assert (histogram > 0).all()
    for lower, upper, count in zip(
        reduced.precession_lower.values, reduced.precession_upper.values, histogram.values,
        strict=True,
    ):  # fmt: skip
        assert ((values >= lower) & (values < upper)).sum() == count or lower < 0


def test_one_bad_case_of_many_is_found_and_named(tmp_path: Path) -> None:
    """A million cases of which one has no pendulum: all others are done, and that one is named."""
    lengths = (0.999999, *(1.0 + k * 1e-3 for k in range(999)))
    # Of the shortest pendulum alone the widest launch does not lie below the support.
    given = {
        "pendulum": {"length": Listed(lengths)},
        "launch": {"kind": "ellipse", "a": Spaced(0.05, 0.999999, 1000), "b": 0.0},
    }
    sweep = kp.Sweep(given, "grid", "exact", ("period",))
    assert sweep.size == 10**6
    found = kp.sweep(sweep, tmp_path)
    assert found.status.attrs["counts"] == [0, 999_999, 1, 0]
    assert found.status.attrs["first_bad"] == [999]
    assert found.status.values[0, 999] == 2
    assert np.isnan(found.period.values).sum() == 1
    assert why(sweep, 999) == (
        "The launch's displacement a = 0.999999 m does not fit on the lower half of a sphere of "
        "radius 0.999999 m; use Launch.angles or Launch.state for launches from the support's "
        "level and above."
    )
    assert why(sweep, 998) == ""


def test_a_motion_that_ends_early_is_told(tmp_path: Path) -> None:
    """A thread that goes slack ends a full run; the times before are kept."""
    given = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "plane", "x": 0.0, "y": 0.1, "vx": Listed((1.0, 5.2)), "vy": 0.0},
    }
    sweep = kp.Sweep(given, "grid", "real", ("a",), (10.0, 60.0))
    found = kp.sweep(sweep, tmp_path)
    assert found.status.values.tolist() == [1, 3]
    assert found.status.attrs["counts"] == [0, 1, 0, 1]
    assert "goes slack" in why(sweep, 1)
    assert why(sweep, 0) == ""


def test_a_sample_of_random_bad_cases_stops_nothing(tmp_path: Path) -> None:
    given = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "ellipse", "a": Uniform(0.5, 1.5), "b": 0.0},
    }
    sweep = kp.Sweep(given, "sample", "exact", ("period",), count=4000, chunk=256)
    seen: list[tuple[int, int, int]] = []
    found = kp.sweep(sweep, tmp_path, progress=lambda *told: seen.append(told))
    bad = found["launch.a"].values >= 1.0
    assert (found.status.values == np.where(bad, 2, 1)).all()
    assert np.array_equal(np.isnan(found.period.values), bad)
    assert seen[-1] == (4000, 4000, int(bad.sum()))
    assert found.status.attrs["first_bad"] == np.flatnonzero(bad)[:10].tolist()
