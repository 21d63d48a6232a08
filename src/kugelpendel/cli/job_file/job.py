"""A job: the file that says what swings, how it starts, and what is written.

`schema` declares what such a file may say.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.document import JobDocument, read_document
from kugelpendel.cli.job_file.entries import Entries, take_apart
from kugelpendel.cli.job_file.forces import read_forces
from kugelpendel.cli.job_file.sample_times import Grid, read_grid

if TYPE_CHECKING:
    from pathlib import Path

LAUNCHES = {way.word: way.keys for way in schema.LAUNCH.ways}
"""The keys of each kind of launch."""


@dataclass(frozen=True)
class Job:
    """What a job file asks for, checked, in SI; ``has_mass`` where a mass or a bob was given."""

    document: JobDocument
    pendulum: kp.Pendulum
    has_mass: bool
    forces: kp.Forces
    launch: kp.Launch
    grid: Grid
    format: str
    figure: bool

    @property
    def file(self) -> Path:
        """The name of the file."""
        return self.document.path

    @property
    def is_real(self) -> bool:
        """Whether the file has a table of what acts."""
        return bool(self.forces.parts)


def read_job(path: Path) -> Job:
    """Read and check a job file.

    Parameters
    ----------
    path
        The file; ``-`` for standard input.

    Raises
    ------
    InvalidInput
        A sentence that names the file and the line, the key, the value seen, and the way out.
    """
    document = read_document(path, schema.JOB)
    with document.named():
        tables = take_apart(document.tables, schema.JOB)
        launch, output = tables["launch"], tables["output"]
        pendulum, has_mass, forces = read_forces(tables, document.tables)
        return Job(
            document=document,
            pendulum=pendulum,
            has_mass=has_mass,
            forces=forces,
            launch=read_launch(launch),
            grid=read_grid(output),
            format=output.word("format"),
            figure=output.truth("figure"),
        )


def read_launch(table: Entries) -> kp.Launch:
    """Read the table of the launch; raises InvalidInput as `read_job` does."""
    kind = table.word("kind")
    keys = LAUNCHES[kind]
    if kind == "state":
        with table.at():
            return kp.Launch.state(table.vector("position"), table.vector("velocity"))
    # The keys of a kind are the arguments of the constructor of that name.
    make = {
        "ellipse": kp.Launch.ellipse,
        "apsides": kp.Launch.apsides,
        "plane": kp.Launch.plane,
        "angles": kp.Launch.angles,
        "at_rest": kp.Launch.at_rest,
    }[kind]
    with table.at():
        return make(**{key: table.number(key) for key in keys})
