"""What a job's report says of its uneven clamp."""

import dataclasses
import math
from pathlib import Path
from typing import Any

import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file.job import Job, read_job
from kugelpendel.cli.run.clamp import clamp_notes, describe_clamp


def test_guelph_goes_round_although_the_clamp_alone_would_not(repository: Path) -> None:
    job = read_job(repository / "examples" / "guelph.toml")
    notes = clamp_notes(job)
    assert "it turns back" in notes["alone"]
    assert "it goes round" in notes["together"]
    assert "drag and drive change what the clamp alone would do" in notes["together"]
    said = describe_clamp(notes, -6.5)
    assert said[0].startswith("The clamp: without drag and drive it turns back: to and fro")
    assert said[1].startswith("With all that acts: it goes round: −360.")
    assert said[2] == "In this run the plane turned by −372.4°."


@pytest.fixture
def changed(repository: Path):
    """The job of Guelph with another launch and other forces."""
    job = read_job(repository / "examples" / "guelph.toml")

    def change(b: float, **parts: Any) -> Job:
        launch = kp.Launch.apsides(0.03, b)
        return dataclasses.replace(job, launch=launch, forces=kp.Forces(**parts))

    return change


@pytest.mark.parametrize(
    ("site", "suspension", "b"),
    [
        (None, kp.Suspension(1e-5), 0.0),
        (kp.Site(0.8), None, 0.0),
        (kp.Site(0.8), kp.Suspension(0.0, 0.0, 1e-6), 0.0),
        (kp.Site(0.8), kp.Suspension(1e-5), 0.029),
    ],
)
def test_nothing_is_said_where_there_is_nothing_to_say(changed, site, suspension, b) -> None:
    notes = clamp_notes(changed(b, site=site, suspension=suspension))
    assert notes == {}
    assert describe_clamp(notes, math.pi) == []


def test_the_clamp_alone_is_all_where_nothing_else_acts(changed) -> None:
    notes = clamp_notes(changed(0.001, site=kp.Site(0.8), suspension=kp.Suspension(1e-5)))
    assert list(notes) == ["alone"]
