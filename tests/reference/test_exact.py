"""The exact motion against every stored reference motion, by every way to ask for it."""

import os
import subprocess
import sys
from collections.abc import Callable
from itertools import groupby
from math import inf, pi
from pathlib import Path

import numpy as np
import pytest
from tests.reference.accuracy import PLAN, POSITION, RELATIVE, VELOCITY
from tests.reference.cases import CONSTANTS, STORED, Case, read

from kugelpendel import ExactMotion, Launch, Pendulum

# Rounding of two or three operations in binary64: 2.2e-16 each.
ROUNDING = 7e-16
CASES = read()


def positions(case: Case) -> None:
    seen = case.motion.position(case.times)
    assert np.all(case.position_errors(seen) <= POSITION * case.unit)
    assert not np.any(case.plan_errors(seen) > PLAN)


def velocities(case: Case) -> None:
    errors = case.velocity_errors(case.motion.velocity(case.times))
    assert np.all(errors <= VELOCITY * case.unit)


def grid_starts(case: Case) -> None:
    seen = np.array([case.motion.sample(time, 1.0, 2)[0] for time in case.times])
    assert np.all(case.position_errors(seen) <= POSITION * case.unit)


def grid_ends(case: Case) -> None:
    # A 1024th is exact, and 1024 steps take a grid through several blocks.
    seen = [case.motion.sample(0.0, (time or 1.0) / 1024, 1025) for time in case.times]
    ends = np.array([s[-1] if t else s[0] for s, t in zip(seen, case.times, strict=True)])
    assert np.all(case.position_errors(ends) <= POSITION * case.unit)


def rates(case: Case) -> None:
    assert case.constant_error("frequency") <= RELATIVE
    assert case.constant_error("precession") <= RELATIVE


def constants(case: Case) -> None:
    # They are rounded once or twice more than the rates are.
    for name in CONSTANTS:
        assert case.constant_error(name) <= RELATIVE + 2.2e-16, name


def conventions(case: Case) -> None:
    motion, kind = case.motion, case.kind
    assert isinstance(motion.frequency, float)
    if kind in ("separatrix", "upright"):
        assert (motion.frequency, motion.precession, motion.radial_period) == (0, 0, inf)
        return
    revolves = kind == "plane" and motion.energy > 2 * case.pendulum.gravity * case.pendulum.length
    turn = motion.precession * motion.radial_period
    sense = -1 if motion.angular_momentum < 0 else 1
    assert motion.frequency * motion.radial_period == pytest.approx(
        2 * pi if revolves else pi, rel=ROUNDING
    )
    assert motion.apsidal_angle == pytest.approx(
        2 * pi if revolves else sense * pi + turn, rel=ROUNDING
    )
    if kind in ("plane", "rest"):
        assert motion.precession == 0
    if kind == "rest":
        assert motion.frequency == pytest.approx(case.pendulum.angular_frequency, rel=ROUNDING)
    if kind == "cone":
        high, low = motion.turning_heights
        assert high == pytest.approx(low, rel=1e-15)


Check = Callable[[Case], None]
every_check = pytest.mark.parametrize(
    "check",
    [positions, velocities, grid_starts, grid_ends, rates, constants, conventions],
    ids=lambda check: check.__name__,
)


@every_check
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_stored(case: Case, check: Check) -> None:
    check(case)


@every_check
def test_shared(shared: Path, check: Check) -> None:
    for case in read(shared / "golden" / "ideal.json"):
        try:
            check(case)
        except AssertionError as error:
            error.add_note(f"in the shared case {case.name}")
            raise


def by_kind() -> dict[str, list[Case]]:
    def kind(case: Case) -> str:
        return case.launch.kind

    return {name: list(cases) for name, cases in groupby(sorted(CASES, key=kind), key=kind)}


@pytest.mark.parametrize("kind", by_kind())
def test_ensemble_is_made_of_the_single_motions(kind: str) -> None:
    cases = by_kind()[kind]
    pendulum = Pendulum(*np.array([case.pendulum.values for case in cases]).T)
    values = np.array([case.launch.values for case in cases])
    launch = {
        "plane": lambda: Launch.plane(*values.T),
        "angles": lambda: Launch.angles(*values.T),
        "state": lambda: Launch.state(values[:, :3], values[:, 3:]),
    }[kind]()
    ensemble = ExactMotion(pendulum, launch)
    for name in (*CONSTANTS, "apsidal_angle", "apsis_time", "slack_time"):
        single = [getattr(case.motion, name) for case in cases]
        np.testing.assert_array_equal(getattr(ensemble, name), single, err_msg=name)
    times = np.concatenate([case.times for case in cases])
    ends = np.cumsum([case.times.size for case in cases])
    for name in ("position", "velocity", "tension"):
        together = getattr(ensemble, name)(times)
        for row, case, end in zip(together, cases, ends, strict=True):
            own = row[end - case.times.size : end]
            np.testing.assert_array_equal(own, getattr(case.motion, name)(case.times), case.name)


def accuracy(repository: Path, *files: Path, **environment: str) -> str:
    """What the table's command prints in a process of its own; it must end well."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.reference.accuracy", *files],
        cwd=repository,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_portable_arithmetic_is_as_accurate(repository: Path) -> None:
    printed = accuracy(repository, KUGELPENDEL_PORTABLE="1")
    assert f"all{len(CASES):24}" in printed


def test_portable_arithmetic_is_as_accurate_on_the_shared_set(
    repository: Path, shared: Path
) -> None:
    golden = shared / "golden" / "ideal.json"
    assert "near-separatrix" in accuracy(repository, golden, KUGELPENDEL_PORTABLE="1")


def test_accuracy_ends_with_1_where_a_promise_is_broken(repository: Path, tmp_path: Path) -> None:
    wrong = STORED.read_text().replace('"precession": "3.13', '"precession": "3.14', 1)
    (tmp_path / "wrong.json").write_text(wrong)
    with pytest.raises(AssertionError, match="tiny-1e-9"):
        accuracy(repository, tmp_path / "wrong.json")
