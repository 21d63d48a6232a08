"""Ensembles go several cases at a time: what each gives depends on nobody beside it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import kugelpendel as kp

LABORATORY = kp.Pendulum(1.0, 9.81)
TIMES = np.array([0.0, 40.0, 3.0, 3.01, 12.0])
AROUND = {"site": kp.Site(0.8), "suspension": kp.Suspension(1e-3, 0.3, 1e-4)}
COUNT = 17
RANDOM = np.random.default_rng(13)
A, B = RANDOM.uniform(0.02, 0.6, COUNT), RANDOM.uniform(-0.02, 0.02, COUNT)
DRAG = RANDOM.uniform(0.001, 0.01, COUNT)
CAST = RANDOM.uniform(2.0, 7.5, COUNT)  # rad/s: some swing, some leave the sphere
PUSH = RANDOM.uniform(1e-3, 1e-2, COUNT)  # m/s


def ideal(chosen: np.ndarray | int) -> kp.RealMotion:
    return kp.RealMotion(LABORATORY, kp.Launch.ellipse(A[chosen], B[chosen]))


def forced(chosen: np.ndarray | int) -> kp.RealMotion:
    launch, drag = kp.Launch.ellipse(A[chosen], B[chosen]), kp.Drag(DRAG[chosen])
    return kp.RealMotion(LABORATORY, launch, drag=drag, **AROUND)


def braked(chosen: np.ndarray | int) -> kp.RealMotion:
    """With plane swings among them, which stop at their turning points."""
    b = np.where(np.arange(COUNT) % 3 == 0, 0.0, B)
    launch, drag = kp.Launch.ellipse(A[chosen], b[chosen]), kp.Drag(0.0, 10 * DRAG[chosen])
    return kp.RealMotion(LABORATORY, launch, drag=drag)


def partly_braked(chosen: np.ndarray | int) -> kp.RealMotion:
    """Two kinds of equations in turn, which do not go side by side."""
    quadratic = np.where(np.arange(COUNT) % 2 == 0, 0.0, DRAG)
    launch, drag = kp.Launch.ellipse(A[chosen], B[chosen]), kp.Drag(DRAG[chosen], quadratic[chosen])
    return kp.RealMotion(LABORATORY, launch, drag=drag)


def ending(chosen: np.ndarray | int) -> kp.RealMotion:
    return kp.RealMotion(LABORATORY, kp.Launch.angles(0.1, 0.0, CAST[chosen], 0.2))


def flying(chosen: np.ndarray | int) -> kp.RealMotion:
    launch = kp.Launch.angles(0.1, 0.0, CAST[chosen], 0.2)
    return kp.RealMotion(LABORATORY, launch, thread="flies", drag=kp.Drag(DRAG[chosen]))


def pushed(chosen: np.ndarray | int) -> kp.RealMotion:
    launch, drive = kp.Launch.ellipse(A[chosen], B[chosen]), kp.Drive(PUSH[chosen], phase=0.4)
    return kp.RealMotion(LABORATORY, launch, drag=kp.Drag(0.05), drive=drive)


def pushed_outside(chosen: np.ndarray | int) -> kp.RealMotion:
    launch, drive = kp.Launch.ellipse(A[chosen], B[chosen]), kp.Drive(PUSH[chosen], radius=0.05)
    return kp.RealMotion(LABORATORY, launch, drag=kp.Drag(0.05, 0.01), drive=drive)


ENSEMBLES = (ideal, forced, braked, partly_braked, ending, flying, pushed, pushed_outside)


def read(motion: kp.RealMotion, times: np.ndarray = TIMES) -> np.ndarray:
    """Position, velocity and tension, seven numbers to a time; NaN once the motion has ended."""
    found = motion.position(times), motion.velocity(times), motion.tension(times)[..., np.newaxis]
    return np.concatenate(found, axis=-1)


def one(make, index: int) -> np.ndarray:
    """A motion on its own, up to its end."""
    motion = make(index)
    row = np.full((TIMES.size, 7), np.nan)
    inside = motion.span[1] >= TIMES
    row[inside] = read(motion, TIMES[inside])
    return row


@pytest.fixture(scope="module", params=ENSEMBLES, ids=lambda make: make.__name__)
def make(request: pytest.FixtureRequest):
    return request.param


@pytest.fixture(scope="module")
def alone(make) -> np.ndarray:
    return np.array([one(make, index) for index in range(COUNT)])


@pytest.mark.parametrize("count", [1, 3, 4, 5, 8, 9, 17])
def test_any_number_of_cases(count: int, make, alone: np.ndarray) -> None:
    assert_array_equal(read(make(np.arange(count))), alone[:count])


def test_any_neighbours(make, alone: np.ndarray) -> None:
    for chosen in (
        np.arange(COUNT)[::-1],
        np.random.default_rng(3).permutation(COUNT),
        np.arange(0, COUNT, 3),
        np.repeat(4, 6),
    ):
        assert_array_equal(read(make(chosen)), alone[chosen])


def test_what_was_asked_before_changes_nothing(make, alone: np.ndarray) -> None:
    motion = make(np.arange(COUNT))
    for index in (3, 0, 1, 4, 2):
        assert_array_equal(read(motion, TIMES[index : index + 1]), alone[:, index : index + 1])
    assert_array_equal(read(motion), alone)
    assert_array_equal(read(motion[2:9]), alone[2:9])


def test_bad_cases_disturb_nobody() -> None:
    a = np.where(np.arange(COUNT) % 4 == 1, 2.0, A)
    found = read(kp.RealMotion(LABORATORY, kp.Launch.ellipse(a, B)))
    bad = a == 2.0
    assert np.isnan(found[bad]).all()
    assert_array_equal(found[~bad], read(ideal(np.flatnonzero(~bad))))


def test_some_end_and_some_do_not(alone: np.ndarray, make) -> None:
    ended = np.isnan(alone[:, 1, 0]).sum()
    assert 0 < ended < COUNT if make is ending else ended == 0


def test_before_and_after_the_launch() -> None:
    times = np.array([5.0, -7.0, 0.0, -0.3, 11.0])
    together = read(forced(np.arange(COUNT)), times)
    for index in range(COUNT):
        assert_array_equal(together[index], read(forced(index), times))


def test_as_a_data_set() -> None:
    times = np.linspace(0.0, 10.0, 21)
    data = forced(np.arange(9)).to_xarray(times)
    for index in range(9):
        assert_array_equal(data.position[index], forced(index).position(times))


SHARED = """
import sys
import numpy as np
from tests.motion.real.test_side_by_side import COUNT, ENSEMBLES, read
np.save(sys.argv[1], [read(make(np.arange(COUNT))) for make in ENSEMBLES])
"""


def test_any_number_of_threads(repository: Path, tmp_path: Path) -> None:
    found = []
    for threads in ("1", "2", "16"):
        path = tmp_path / f"{threads}.npy"
        subprocess.run(
            [sys.executable, "-c", SHARED, path],
            cwd=repository,
            env=os.environ | {"RAYON_NUM_THREADS": threads},
            check=True,
        )
        found.append(np.load(path))
    assert_array_equal(found[1], found[0])
    assert_array_equal(found[2], found[0])
