"""The file that `kugelpendel design` reads.

``[pendulum]``, ``[site]``, ``[drag]``, ``[suspension]``, ``[bob]``, ``[drive]``
    as in `kugelpendel.cli.job_file.forces`; only the first must be there

``[swing]``
    a, b (0 unless given), azimuth (0 unless given): turning radii as seen from a frame that does
    not turn

``[wire]``
    diameter; young (200 GPa unless given); expansion (``"1.2e-5 1/K"`` unless given)

``[questions]``
    share, a plain number (0.01 unless given), after (1 h unless given), radius, time: the arguments
    of `kugelpendel.design` of these names
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.job_file import toml_text
from kugelpendel.cli.job_file.forces import (
    FORCES,
    given,
    named,
    plain_number,
    read_forces,
)
from kugelpendel.cli.job_file.quantity import ANGLE, LENGTH, TIME, Kind
from kugelpendel.cli.job_file.table import Table, split

if TYPE_CHECKING:
    from pathlib import Path

EXAMPLE = """\
[pendulum]
length = "20 m"
mass = "60 kg"

[swing]
a = "1 m"

[site]
latitude = "50 deg"

[drag]
half_life = "3 h"
"""
"""A file that answers most questions, to paste."""

_PRESSURE = Kind("a pressure", "Pa", "200 GPa")
_EXPANSION = Kind("an expansion", "1/K", "1.2e-5 1/K")


@dataclass(frozen=True)
class Questions:
    """What a file asks, checked key by key, in SI."""

    file: Path
    pendulum: kp.Pendulum
    has_mass: bool
    forces: kp.Forces
    a: float
    b: float
    azimuth: float
    wire: kp.Wire | None
    share: float
    after: float
    radius: float | None
    time: float | None


def read_questions(path: Path) -> Questions:
    """Read and check a file.

    Raises
    ------
    InvalidInput
        A sentence that names the file, the key, the value seen, and the way out.
    """
    tables = toml_text.read_file(path)
    try:
        optional = (*FORCES, "wire", "questions")
        found = {table.name: table for table in split(tables, ("pendulum", "swing"), optional)}
        swing = found["swing"]
        swing.allow(("a", "b", "azimuth"))
        asked = found.get("questions", Table("questions", {}))
        asked.allow(("share", "after", "radius", "time"))
        pendulum, has_mass, forces = read_forces(found)
        return Questions(
            file=path,
            pendulum=pendulum,
            has_mass=has_mass,
            forces=forces,
            a=swing.quantity("a", LENGTH),
            b=swing.quantity("b", LENGTH, default=0.0),
            azimuth=swing.quantity("azimuth", ANGLE, default=0.0),
            wire=_wire(found["wire"]) if "wire" in found else None,
            share=plain_number(asked, "share", 0.01) if "share" in asked.entries else 0.01,
            after=asked.quantity("after", TIME, default=3600.0),
            radius=given(asked, "radius", LENGTH),
            time=given(asked, "time", TIME),
        )
    except kp.InvalidInput as error:
        raise error.at(f"{path}: ") from error


def _wire(table: Table) -> kp.Wire:
    table.allow(("diameter", "young", "expansion"))
    with named(table):
        return kp.Wire(
            diameter=table.quantity("diameter", LENGTH),
            young=table.quantity("young", _PRESSURE, default=2.0e11),
            expansion=table.quantity("expansion", _EXPANSION, default=1.2e-5),
        )
