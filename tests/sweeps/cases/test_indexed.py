"""Cases come from their index: in any order, alone or together, the same to the last bit."""

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from SALib.analyze import sobol as analysed
from SALib.sample import sobol as sampled
from scipy import stats

import kugelpendel as kp
from kugelpendel.sweeps import Listed, Normal, Spaced, Uniform
from kugelpendel.sweeps.cases._indexed import _directions, _sobol_points

LAWS: dict[str, Any] = {
    "launch.a": Uniform(0.1, 0.3),
    "launch.b": Normal(0.0, 0.01),
    "launch.azimuth": Listed((0.0, 1.0, 2.0)),
    "pendulum.length": Spaced(1.0, 10.0, log=True),
    "pendulum.gravity": Spaced(9.7, 9.9),
}


def many(design: Any, laws: dict[str, Any] = LAWS, **options: Any) -> kp.Sweep:
    tables: dict[str, dict[str, Any]] = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "ellipse", "a": 0.1, "b": 0.0},
    }
    for name, law in laws.items():
        section, _, key = name.partition(".")
        tables[section].pop(key, None)
        tables[section][key] = law
    return kp.Sweep(tables, design=design, motion="exact", quantities=("period",), **options)


GRID = many(
    "grid",
    {
        "pendulum.length": Spaced(1.0, 4.0, 4),
        "launch.a": Listed((0.3, 0.1, 0.2)),
        "launch.b": Spaced(0.01, 0.1, 5, log=True),
    },
)
SAMPLE = many("sample", count=1000, seed=7)
SOBOL = many("sobol", count=64, seed=7)
SINGLE = many("sobol", count=64, seed=7, second_order=False)


def test_a_grid_is_the_product_of_its_levels() -> None:
    assert GRID.shape == (4, 3, 5)
    assert GRID.size == 60
    levels = [law.at(np.arange(law.levels or 0)) for law in GRID.varied.values()]
    expected = np.array(list(itertools.product(*levels)))
    found = np.stack(list(GRID.values(0, 60).values()), axis=-1)
    assert np.array_equal(found, expected)
    assert levels[2][0] == 0.01
    assert levels[2][-1] == 0.1
    assert levels[2] == pytest.approx(np.geomspace(0.01, 0.1, 5), rel=1e-14)


@given(st.sampled_from([GRID, SAMPLE, SOBOL, SINGLE]), st.data())
@settings(max_examples=100, deadline=None)
def test_any_stretch_is_the_same_as_its_cases_alone(sweep: kp.Sweep, data: st.DataObject) -> None:
    start = data.draw(st.integers(0, sweep.size - 1))
    stop = data.draw(st.integers(start + 1, min(sweep.size, start + 70)))
    stretch = sweep.values(start, stop)
    order = data.draw(st.permutations(range(start, stop)))
    scattered = sweep.values_at(np.array(order))
    at = data.draw(st.integers(start, stop - 1))
    case = sweep.case(at)
    for name in sweep.names:
        section, _, key = name.partition(".")
        assert stretch[name][at - start] == case[section][key]
        assert np.array_equal(scattered[name], stretch[name][np.array(order) - start])


@pytest.mark.parametrize("sweep", [SAMPLE, many("sobol", count=256, seed=1)])
def test_draws_have_their_distributions(sweep: kp.Sweep) -> None:
    found = sweep.values(0, sweep.size)
    laws = {
        "launch.a": stats.uniform(0.1, 0.2),
        "launch.b": stats.norm(0.0, 0.01),
        "pendulum.length": stats.loguniform(1.0, 10.0),
        "pendulum.gravity": stats.uniform(9.7, 0.2),
    }
    for name, law in laws.items():
        # By chance one in a million is as far off; in a Sobol design points come several times.
        far = stats.kstest(found[name], law.cdf).statistic
        assert far < 2.7 / np.sqrt(sweep.size / (1 if sweep.design == "sample" else 6)), name
    shares = np.unique(found["launch.azimuth"], return_counts=True)[1] / sweep.size
    assert shares == pytest.approx([1 / 3] * 3, abs=0.1)


def test_draws_do_not_depend_on_one_another() -> None:
    found = np.stack(list(SAMPLE.values(0, 1000).values()))
    apart = np.corrcoef(found) - np.eye(len(found))
    assert np.abs(apart).max() < 0.15


def test_a_seed_makes_another_sample() -> None:
    other = many("sample", count=1000, seed=8)
    for name, values in SAMPLE.values(0, 1000).items():
        assert (other.values(0, 1000)[name] == values).mean() < 0.5


def test_points_of_the_sequence_are_those_of_scipy() -> None:
    generator = np.random.Generator(np.random.Philox(np.random.SeedSequence((5, 0x6B7567656C))))
    sequence = stats.qmc.Sobol(6, scramble=True, bits=30, rng=generator)
    expected = sequence.random(256).T
    directions = _directions(6, 5, 8)
    assert np.array_equal(_sobol_points(directions, 0, 256) * 2.0**-30, expected)
    for start in (1, 2, 77, 128, 255):
        part = _sobol_points(directions, start, 256) * 2.0**-30
        assert np.array_equal(part, expected[:, start:]), start


@pytest.mark.parametrize("second_order", [True, False])
def test_the_design_has_the_layout_of_salib(second_order: bool) -> None:
    laws = {name: Uniform(0.1, 0.3) for name in ("launch.a", "launch.b", "pendulum.length")}
    ours = many("sobol", laws, count=8, seed=0, second_order=second_order)
    problem = {"num_vars": 3, "names": list(ours.names), "bounds": [[0.1, 0.3]] * 3}
    theirs = sampled.sample(problem, 8, calc_second_order=second_order, seed=1)
    assert len(theirs) == ours.size
    found = np.stack(list(ours.values(0, ours.size).values()), axis=-1)
    # The same entries are repeated at the same places, whatever their values.
    for k in range(3):
        for block in range(8):
            rows = slice(block * ours.block, (block + 1) * ours.block)
            _, one = np.unique(found[rows, k], return_inverse=True)
            _, other = np.unique(theirs[rows, k], return_inverse=True)
            assert np.array_equal(one == one[0], other == other[0])


def test_indices_of_a_known_function() -> None:
    """Ishigami's, whose indices have a closed form; Ishigami & Homma, ISUMA (1990)."""
    names = ("launch.azimuth", "launch.a", "launch.b")
    laws = {name: Uniform(-np.pi, np.pi) for name in names}
    ours = many("sobol", laws, count=4096, seed=2)
    x = ours.values(0, ours.size)
    first, second, third = (x[name] for name in names)
    values = np.sin(first) + 7 * np.sin(second) ** 2 + 0.1 * third**4 * np.sin(first)
    problem = {"num_vars": 3, "names": list(names), "bounds": [[-np.pi, np.pi]] * 3}
    order = [list(ours.names).index(name) for name in names]
    assert order == [0, 1, 2]
    found = analysed.analyze(problem, values, seed=1)
    assert found["S1"] == pytest.approx([0.3139, 0.4424, 0.0], abs=0.01)
    assert found["ST"] == pytest.approx([0.5576, 0.4424, 0.2437], abs=0.01)


def test_a_million_and_first_case_is_made_at_once() -> None:
    """Memory is that of what is asked for, and a late case takes no longer than an early one."""
    giant = many("sample", count=10**9)
    assert giant.values(10**9 - 3, 10**9)["launch.a"].shape == (3,)
    wide = many("grid", {"launch.a": Spaced(0.1, 0.2, 10**5), "launch.b": Spaced(0, 0.1, 10**4)})
    last = wide.values(10**9 - 2, 10**9)
    assert last["launch.a"].tolist() == [0.2, 0.2]
    assert last["launch.b"][-1] == 0.1
