"""The keys of a job file make the same pendulum for one case and for many."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.document import read_document
from kugelpendel.cli.job_file.entries import take_apart
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.job_file.kinds import Kind
from kugelpendel.cli.job_file.sweep_schema import SWEEP_FILE
from kugelpendel.cli.sweep.sweep_file import _given
from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Launch
from kugelpendel.sweeps import UNITS, assembled
from kugelpendel.sweeps.cases import motions

REPOSITORY = Path(__file__).resolve().parents[3]
JOBS = sorted((REPOSITORY / "examples").glob("*.toml"))
ODD = """
[pendulum]
length = "3 m"
[launch]
kind = "plane"
x = "20 cm"
y = 0
vx = 0
vy = "5 cm/s"
[site]
latitude = "50 deg"
[bob]
diameter = "20 cm"
density = 7860
[drag]
from_bob = true
[suspension]
period_along = "3.47 s"
period_across = "3.48 s"
axis = "30 deg"
[output]
duration = "1 h"
step = "1 s"
"""


def given(path: Path) -> dict[str, dict[str, Any]]:
    document = read_document(path, schema.JOB)
    tables = take_apart(document.tables, schema.JOB)
    return {name: _given(tables[name]) for name in document.tables if name != "output"}


@pytest.mark.parametrize("path", [*JOBS, None], ids=lambda path: path.stem if path else "odd")
def test_a_file_says_the_same_as_to_run(path: Path | None, tmp_path: Path) -> None:
    if path is None:
        path = tmp_path / "odd.toml"
        path.write_text(ODD, encoding="utf-8")
    job = read_job(path)
    pendulum, launch, forces = assembled(given(path))
    assert pendulum == job.pendulum
    assert launch == job.launch
    assert forces == job.forces


def test_the_units_are_those_of_the_schema() -> None:
    for section in SWEEP_FILE.sections:
        if section.name in ("sweep", "launch"):
            continue
        numbers = {
            key.name: key.holds
            for key in section.keys
            if isinstance(key.holds, (Kind, schema.Number))
        }
        assert set(UNITS[section.name]) == set(numbers), section.name
        for key, holds in numbers.items():
            plain = UNITS[section.name][key].replace("²", "^2").replace("³", "^3")
            assert plain == (holds.unit if isinstance(holds, Kind) else "1"), key
    assert set(UNITS["launch"]) == {name for kind in Launch.kinds.values() for name in kind}


@pytest.mark.parametrize("word", ["exact", "averaged", "real"])
def test_an_ensemble_is_its_motions(word: str) -> None:
    forces = {} if word == "exact" else {"site": {"latitude": 0.8}, "drag": {"half_life": 1800.0}}
    tables: dict[str, Any] = {
        "pendulum": {"length": np.array([1.0, 2.0, -1.0])},
        "launch": {"kind": "ellipse", "a": 0.1, "b": np.array([0.01, 0.02, 0.0])},
        **forces,
    }
    motion = motions(word, tables)
    assert motion.shape == (3,)
    assert motion.status.tolist()[:2] == [0, 0]
    assert motion.status[2] != 0
    assert "length" in str(motion.reason[2])
    alone = motions(word, {**tables, "pendulum": {"length": np.array([2.0])},
                           "launch": {"kind": "ellipse", "a": 0.1, "b": 0.02}})  # fmt: skip
    assert np.array_equal(alone.position([5.0])[0], motion.position([5.0])[1])


def test_drag_of_a_bob_needs_one() -> None:
    tables: dict[str, Any] = {
        "pendulum": {"length": 1.0},
        "launch": {"kind": "ellipse", "a": 0.1, "b": 0.01},
        "drag": {"from_bob": True},
    }
    with pytest.raises(InvalidInput, match=r"^\[drag\] from_bob needs a bob with radius and dens"):
        assembled(tables)
