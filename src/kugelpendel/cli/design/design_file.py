"""The file that `kugelpendel design` reads; `schema` declares what it may say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.document import JobDocument, read_document
from kugelpendel.cli.job_file.entries import Entries, take_apart
from kugelpendel.cli.job_file.forces import read_forces

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class Questions:
    """What a file asks, checked key by key, in SI."""

    document: JobDocument
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

    @property
    def file(self) -> Path:
        """The name of the file."""
        return self.document.path


def read_questions(path: Path) -> Questions:
    """Read and check a file.

    Raises
    ------
    InvalidInput
        A sentence that names the file, the key, the value seen, and the way out.
    """
    document = read_document(path, schema.DESIGN)
    with document.named():
        tables = take_apart(document.tables, schema.DESIGN)
        swing, asked = tables["swing"], tables["questions"]
        pendulum, has_mass, forces = read_forces(tables, document.tables)
        return Questions(
            document=document,
            pendulum=pendulum,
            has_mass=has_mass,
            forces=forces,
            a=swing.number("a"),
            b=swing.number("b"),
            azimuth=swing.number("azimuth"),
            wire=_wire(tables["wire"]) if "wire" in document.tables else None,
            share=asked.number("share"),
            after=asked.number("after"),
            radius=asked.given("radius"),
            time=asked.given("time"),
        )


def _wire(table: Entries) -> kp.Wire:
    with table.at():
        return kp.Wire(
            diameter=table.number("diameter"),
            young=table.number("young"),
            expansion=table.number("expansion"),
        )
