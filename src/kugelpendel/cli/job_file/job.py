"""A job: the file that says what swings, how it starts, and what is written.

A job file is TOML with three tables, and for a real pendulum up to five more, which `_sections`
describes together with ``[pendulum]``. Quantities are strings with a unit (``"67 m"``,
``"30 deg"``) or plain numbers in SI (m, s, kg, m/s, rad, rad/s).

``[pendulum]``
    length, gravity (9.80665 m/s² or the site's unless given), mass (1 kg or the bob's unless given;
    it scales the tension)

``[launch]``
    kind, and the arguments of the constructor of `kugelpendel.Launch` of that name:

    ============  ================================================================================
    ``ellipse``   a, b, azimuth: displaced by a, pushed sideways with b·√(g/l)
    ``apsides``   a, b, azimuth: outer and inner turning radius; starts at the outer one
    ``plane``     x, y, vx, vy: plan view from above, below the support
    ``angles``    theta, phi, theta_rate, phi_rate: theta from the downward vertical
    ``state``     position, velocity: [x, y, z] from the support, z down
    ``at_rest``   theta, phi: let go without a push
    ============  ================================================================================

    Azimuths and the sign of b are positive counter-clockwise seen from above. azimuth, phi and the
    two rates are 0 unless given.

``[output]``
    duration; step or samples (one of the two); format (``"csv"``, ``"netcdf"`` or ``"parquet"``,
    csv unless given); figure (true unless given)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.job_file import toml_text
from kugelpendel.cli.job_file.forces import FORCES, read_forces
from kugelpendel.cli.job_file.quantity import ANGLE, LENGTH, RATE, SPEED
from kugelpendel.cli.job_file.sample_times import Grid, read_grid
from kugelpendel.cli.job_file.table import Table, split

if TYPE_CHECKING:
    from pathlib import Path

FORMATS = ("csv", "netcdf", "parquet")

LAUNCHES = {
    "ellipse": ("a", "b", "azimuth"),
    "apsides": ("a", "b", "azimuth"),
    "plane": ("x", "y", "vx", "vy"),
    "angles": ("theta", "phi", "theta_rate", "phi_rate"),
    "state": ("position", "velocity"),
    "at_rest": ("theta", "phi"),
}


@dataclass(frozen=True)
class Job:
    """What a job file asks for, checked, in SI; `has_mass` where a mass or a bob was given."""

    file: Path
    pendulum: kp.Pendulum
    has_mass: bool
    forces: kp.Forces
    launch: kp.Launch
    grid: Grid
    format: str
    figure: bool

    @property
    def is_real(self) -> bool:
        """Whether the file has a table of what acts."""
        return bool(self.forces.parts)


def read_job(path: Path) -> Job:
    """Read and check a job file.

    Raises
    ------
    InvalidInput
        A sentence that names the file, the key, the value seen, and the way out.
    """
    tables = toml_text.read_file(path)
    try:
        present = split(tables, ("pendulum", "launch", "output"), FORCES)
        _, launch, output, *_ = present
        output.allow(("duration", "step", "samples", "format", "figure"))
        kind = launch.choice("kind", LAUNCHES)
        launch.allow(("kind", *LAUNCHES[kind]), owner=f' for kind = "{kind}"')
        pendulum, has_mass, forces = read_forces({table.name: table for table in present})
        return Job(
            file=path,
            pendulum=pendulum,
            has_mass=has_mass,
            forces=forces,
            launch=_launch(launch, kind),
            grid=read_grid(output),
            format=output.choice("format", FORMATS, default="csv"),
            figure=output.truth("figure", default=True),
        )
    except kp.InvalidInput as error:
        raise error.at(f"{path}: ") from error


def _launch(table: Table, kind: str) -> kp.Launch:
    match kind:
        case "ellipse" | "apsides":
            start = kp.Launch.ellipse if kind == "ellipse" else kp.Launch.apsides
            return start(
                a=table.quantity("a", LENGTH),
                b=table.quantity("b", LENGTH),
                azimuth=table.quantity("azimuth", ANGLE, default=0.0),
            )
        case "plane":
            return kp.Launch.plane(
                x=table.quantity("x", LENGTH),
                y=table.quantity("y", LENGTH),
                vx=table.quantity("vx", SPEED),
                vy=table.quantity("vy", SPEED),
            )
        case "state":
            return kp.Launch.state(
                position=table.vector("position", LENGTH),
                velocity=table.vector("velocity", SPEED),
            )
        case "at_rest":
            return kp.Launch.at_rest(
                theta=table.quantity("theta", ANGLE),
                phi=table.quantity("phi", ANGLE, default=0.0),
            )
        case _:
            return kp.Launch.angles(
                theta=table.quantity("theta", ANGLE),
                phi=table.quantity("phi", ANGLE, default=0.0),
                theta_rate=table.quantity("theta_rate", RATE, default=0.0),
                phi_rate=table.quantity("phi_rate", RATE, default=0.0),
            )
