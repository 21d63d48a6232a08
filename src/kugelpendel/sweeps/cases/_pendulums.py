"""From the numbers of cases to the motions: what a job file's keys make, for ensembles."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import replace
from typing import TypeAlias, cast

import numpy as np

from kugelpendel.errors import InvalidInput
from kugelpendel.motion import EnvelopeMotion, ExactMotion, Motion, RealMotion
from kugelpendel.parameters import (
    Bob,
    Drag,
    Drive,
    Forces,
    Launch,
    Pendulum,
    Scalars,
    Site,
    Suspension,
)

Table: TypeAlias = Mapping[str, Scalars | str | bool]
"""The keys of one table of a job file, in SI; a number may be one or one for each case."""

UNITS: dict[str, dict[str, str]] = {
    "pendulum": {"length": "m", "gravity": "m/s²", "mass": "kg"},
    "launch": {name: unit for kind in Launch.kinds.values() for name, unit in kind.items()},
    "site": {"latitude": "rad", "gravity": "m/s²", "height": "m"},
    "drag": {
        "linear": "1/s",
        "quality": "1",
        "half_life": "s",
        "thread_diameter": "m",
        "quadratic": "1/m",
    },
    "suspension": {
        "anisotropy": "rad/s",
        "period_along": "s",
        "period_across": "s",
        "axis": "rad",
        "damping_anisotropy": "1/s",
        "damping_axis": "rad",
    },
    "bob": {
        "radius": "m",
        "diameter": "m",
        "density": "kg/m³",
        "thread_mass": "kg",
        "air_density": "kg/m³",
    },
    "drive": {"push": "m/s", "phase": "rad", "radius": "m"},
}
"""The numbers of each table that may vary, with their SI units."""

WORDS = {"launch.kind": tuple(Launch.kinds), "drag.from_bob": (False, True)}
"""What is no number, and may not vary."""


def assembled(tables: Mapping[str, Table]) -> tuple[Pendulum, Launch, Forces]:
    """The pendulum, its launch and what acts, as a job file with these keys says.

    Parameters
    ----------
    tables
        By the names of a job file; arrays of one length make ensembles.

    Raises
    ------
    InvalidInput
        For single numbers that make no sense; a bad case of an ensemble is found by its motion.
    """
    site = Site(**_numbers(tables["site"])) if "site" in tables else None
    bob = _bob(tables["bob"]) if "bob" in tables else None
    length, gravity, mass = (_number(tables["pendulum"], key) for key in UNITS["pendulum"])
    if gravity is None:
        gravity = 9.80665 if site is None else site.gravity
    if mass is None:
        mass = 1.0 if bob is None else bob.mass
    pendulum = Pendulum(cast("Scalars", length), gravity, mass)
    drag = _drag(tables["drag"], pendulum, bob) if "drag" in tables else None
    suspension = _suspension(tables["suspension"]) if "suspension" in tables else None
    drive = Drive(**_numbers(tables["drive"])) if "drive" in tables else None
    launch = dict(tables["launch"])
    kind = str(launch.pop("kind"))
    values = (_number(launch, name, 0.0) for name in Launch.kinds[kind])
    forces: Forces = Forces(site=site, drag=drag, suspension=suspension, bob=bob, drive=drive)
    return pendulum, Launch(kind, tuple(cast("Scalars", value) for value in values)), forces


def motions(word: str, tables: Mapping[str, Table]) -> Motion:
    """The ensemble of the cases, one axis of them, under the motion of that word.

    Parameters
    ----------
    word
        "exact", "averaged" or "real".
    tables
        As for `assembled`; at least one number is an array.
    """
    pendulum, launch, forces = assembled(tables)
    if word == "exact":
        return ExactMotion(forces.effective_pendulum(pendulum), launch)
    if word == "real":
        return RealMotion(pendulum, launch, forces)
    with warnings.catch_warnings():
        # How far the averaged motion is off is said once, of the whole sweep.
        warnings.simplefilter("ignore", UserWarning)
        return EnvelopeMotion(pendulum, launch, forces)


def _number(table: Table, key: str, default: float | None = None) -> Scalars | None:
    value = table.get(key, default)
    return cast("Scalars | None", value)


def _numbers(table: Table) -> dict[str, Scalars]:
    """The numbers of a table, the arguments of a class, by name."""
    return dict(cast("Mapping[str, Scalars]", table))


def _bob(table: Table) -> Bob:
    numbers = _numbers(table)
    if (diameter := numbers.pop("diameter", None)) is not None:
        numbers["radius"] = np.divide(diameter, 2)
    return Bob(**numbers)


def _drag(table: Table, pendulum: Pendulum, bob: Bob | None) -> Drag:
    if table.get("from_bob"):
        if bob is None:
            raise InvalidInput.of("sweep_no_bob", name="[drag] from_bob")
        return Drag.from_bob(
            bob, pendulum, thread_diameter=cast("Scalars", _number(table, "thread_diameter", 0.0))
        )
    quality, half_life = _number(table, "quality"), _number(table, "half_life")
    if quality is not None:
        drag = Drag.from_quality(quality, pendulum)
    elif half_life is not None:
        drag = Drag.from_half_life(half_life)
    else:
        drag = Drag(cast("Scalars", _number(table, "linear", 0.0)))
    quadratic = _number(table, "quadratic")
    return drag if quadratic is None else replace(drag, quadratic=quadratic)


def _suspension(table: Table) -> Suspension:
    numbers = _numbers(table)
    along, across = numbers.pop("period_along", None), numbers.pop("period_across", None)
    if along is None or across is None:
        return Suspension(**numbers)
    return Suspension.from_periods(along, across, **numbers)
