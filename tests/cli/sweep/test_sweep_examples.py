"""The files in examples/sweep are read, take the time that they may, and say what they say."""

import math
from pathlib import Path

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.sweep.sweep_file import read_sweep_file
from kugelpendel.sweeps import Sweep, results_of

NAMES = ["final-direction", "guelph-search", "museum-tolerances", "stall-map", "validity-3d"]


def example(repository: Path, name: str) -> Sweep:
    return read_sweep_file(repository / "examples/sweep" / f"{name}.toml").sweep


def some(spec: Sweep, *index: int) -> tuple[dict[str, np.ndarray], list[dict]]:
    """The results of single cases, and what these were given."""
    found = [results_of(spec, k, k + 1)[0] for k in index]
    joined = {name: np.concatenate([one[name] for one in found]) for name in spec.quantities}
    return joined, [spec.case(k) for k in index]


def test_every_example_is_known(repository: Path) -> None:
    paths = (repository / "examples/sweep").glob("*.toml")
    assert sorted(path.stem for path in paths) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_each_says_what_it_asks_and_its_cases_are_good(name: str, repository: Path) -> None:
    text = (repository / "examples/sweep" / f"{name}.toml").read_text(encoding="utf-8")
    assert text.startswith("# ")
    assert "?" in text.partition("[pendulum]")[0]
    spec = example(repository, name)
    _, status = results_of(spec, spec.size - 1, spec.size)
    assert status.tolist() == [1]


def test_the_motion_and_the_portrait_agree_on_the_stall_map(repository: Path) -> None:
    spec = example(repository, "stall-map")
    index = np.random.default_rng(7).choice(spec.size, 40, replace=False)
    # Next to the border, where the ellipse passes by a circle: 15° from the axis, and small.
    a, azimuth, delta = spec.varied["launch.a"], spec.varied["launch.azimuth"], 13
    near = (0 * (azimuth.levels or 0) + 1) * 25 + delta
    found, cases = some(spec, *index.tolist(), near)
    assert a.levels == 24
    assert cases[-1]["suspension"]["anisotropy"] == pytest.approx(1.2115e-4, rel=1e-4)
    np.testing.assert_array_equal(found["stalls"], found["clamp_stalls"])


def test_two_basins_of_the_final_direction(repository: Path) -> None:
    spec = example(repository, "final-direction")
    levels = spec.varied["suspension.anisotropy"].levels or 0
    weak, strong = 0, levels - 1
    places = [launch * levels + clamp for launch in (5, 20) for clamp in (weak, strong)]
    found, cases = some(spec, *places)
    assert [round(math.degrees(float(c["launch"]["azimuth"]))) for c in cases] == [30, 30, 120, 120]
    ends = np.degrees(found["final_direction"])
    np.testing.assert_allclose(ends, [115.0, 30.0, 115.0, 120.0], atol=6.0)


def test_guelph_is_among_what_is_searched(repository: Path) -> None:
    spec = example(repository, "guelph-search")
    levels = spec.varied["suspension.damping_anisotropy"].levels or 0
    found, (case,) = some(spec, 7 * levels + 3)
    assert case["suspension"]["anisotropy"] == pytest.approx(1.4e-4)
    assert case["suspension"]["damping_anisotropy"] == pytest.approx(3e-6)
    hourly = 3600 * np.degrees([found["slowest_rate"][0], found["fastest_rate"][0]])
    assert -9.8 < hourly[0] < -9.5
    assert -11.2 < hourly[1] < -10.9
    assert 3600 * np.degrees(found["mean_rate"][0, 1]) == pytest.approx(-10.36, abs=0.05)


def test_the_averaged_equations_hold_where_the_clamp_is_weak(repository: Path) -> None:
    spec = example(repository, "validity-3d")
    found, cases = some(spec, 0, spec.size - 1)
    assert cases[0]["suspension"]["anisotropy"] == pytest.approx(1e-6)
    error = found["averaging_error"][:, 0]
    assert error[0] < math.radians(1e-3)
    assert error[1] > 10 * error[0]


def test_what_is_drawn_of_the_museum_is_what_is_said(repository: Path) -> None:
    spec = example(repository, "museum-tolerances")
    assert spec.block == 2 * len(spec.names) + 2 == 16
    omega = kp.Pendulum(20.0, kp.Site(math.radians(52.52)).gravity).angular_frequency
    assert float(omega) / 1e-5 == pytest.approx(70_000, rel=0.01)
    values, _ = results_of(spec, 0, 512)
    azimuth = np.degrees(values["azimuth"])
    assert -83 < azimuth.min() < azimuth.max() < -60
