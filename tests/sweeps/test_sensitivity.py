"""Sobol indices: those of a function whose indices are known, and what spoils them."""

import math

import numpy as np
import pytest
from scipy.stats import qmc

import kugelpendel as kp
from kugelpendel.sweeps._sensitivity import FEWEST, sensitivity

NAMES = ("first", "second", "third")


def design(points: int, *, second_order: bool = True) -> np.ndarray:
    """Saltelli's design in the unit cube, in the order of SALib."""
    count = len(NAMES)
    base = qmc.Sobol(2 * count, scramble=True, rng=np.random.default_rng(3)).random(points)
    a, b = base[:, :count], base[:, count:]
    rows = [a]
    for one, other in ((a, b), (b, a))[: 1 + second_order]:
        for k in range(count):
            row = one.copy()
            row[:, k] = other[:, k]
            rows.append(row)
    rows.append(b)
    return np.stack(rows, axis=1).reshape(-1, count)


def ishigami(x: np.ndarray) -> np.ndarray:
    x = math.pi * (2 * x - 1)
    return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


# Ishigami & Homma (1990): the variance and its parts in closed form, a = 7 and b = 0.1.
FIRST = 0.5 * (1 + 0.1 * math.pi**4 / 5) ** 2
SECOND = 49 / 8
BOTH = 0.01 * math.pi**8 * (1 / 18 - 1 / 50)
ALL = FIRST + SECOND + BOTH


def test_indices_and_intervals_of_a_known_function() -> None:
    found = sensitivity(ishigami(design(4096)), NAMES)
    alone = {"first": FIRST / ALL, "second": SECOND / ALL, "third": 0.0}
    total = {"first": (FIRST + BOTH) / ALL, "second": SECOND / ALL, "third": BOTH / ALL}
    for name in NAMES:
        for share, expected in ((found.alone[name], alone), (found.total[name], total)):
            assert abs(share.value - expected[name]) < share.error < 0.08, name
    assert found.together["first", "third"].value == pytest.approx((FIRST + BOTH) / ALL, abs=0.03)
    inner = found.interaction["first", "third"]
    assert abs(inner.value - BOTH / ALL) < inner.error < 0.1
    assert (
        found.interaction["first", "second"].least < 0 < found.interaction["first", "second"].most
    )
    assert (found.blocks, found.dropped) == (4096, 0)


def test_without_pairs() -> None:
    found = sensitivity(ishigami(design(1024, second_order=False)), NAMES, second_order=False)
    assert found.together == {} == found.interaction
    assert found.alone["second"].value == pytest.approx(SECOND / ALL, abs=0.05)


@pytest.mark.parametrize("spoilt", [math.nan, math.inf])
def test_a_bad_case_takes_its_block_along_and_is_counted(spoilt: float) -> None:
    from SALib.analyze import sobol

    values = ishigami(design(1024))
    whole = sensitivity(values, NAMES)
    values[[5, 6, 8 * 77]] = spoilt
    found = sensitivity(values, NAMES)
    assert (found.blocks, found.dropped) == (1022, 2)
    for name in NAMES:
        assert found.total[name].value == pytest.approx(whole.total[name].value, abs=0.02)
    if math.isnan(spoilt):
        # What it is for: SALib's own answer is that nothing moves it, without a word.
        problem = {"num_vars": 3, "names": list(NAMES), "bounds": [[0, 1]] * 3}
        alone = sobol.analyze(problem, values, seed=1)["ST"]
        assert not np.isfinite(alone).any() or not np.any(alone)


def test_the_same_seed_gives_the_same_bits_and_another_one_other_intervals() -> None:
    values = ishigami(design(256))
    assert sensitivity(values, NAMES, seed=4) == sensitivity(values, NAMES, seed=4)
    one, other = sensitivity(values, NAMES, seed=4), sensitivity(values, NAMES, seed=5)
    assert one.alone["first"].value == other.alone["first"].value
    assert one.alone["first"].error != other.alone["first"].error


def test_refused() -> None:
    values = ishigami(design(64))
    with pytest.raises(kp.InvalidInput, match="need blocks of 8 cases, but there are 511 cases"):
        sensitivity(values[:-1], NAMES)
    bad = values.copy()
    bad[: 8 * (64 - FEWEST + 1) : 8] = math.nan
    with pytest.raises(kp.InvalidInput, match=f"of 64 only {FEWEST - 1} have an answer"):
        sensitivity(bad, NAMES)
    with pytest.raises(kp.InvalidInput, match=r"Nothing moves this result: it is 3 in all 512"):
        sensitivity(np.full(512, 3.0), NAMES)
