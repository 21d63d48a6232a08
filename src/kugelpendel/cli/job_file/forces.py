"""The tables of a file that say what swings and what acts on it.

``[pendulum]``
    length; gravity (that of the site where there is one, else 9.80665 m/s²); mass (that of the
    bob where there is one, else 1 kg)

``[site]``
    latitude; gravity (WGS84 normal gravity unless given); height (0 unless given)

``[drag]``
    linear (``"1e-5 1/s"``), or quality (a number), or half_life (``"2 h"``, of the amplitude), or
    from_bob = true, which needs ``[bob]`` and may have thread_diameter; quadratic (``"1e-3 1/m"``),
    which goes with all but from_bob

``[suspension]``
    anisotropy (``"1e-6 rad/s"``), or period_along and period_across; axis; damping_anisotropy
    (``"1e-6 1/s"``); damping_axis

``[bob]``
    radius or diameter; density; thread_mass; air_density (1.204 kg/m³ unless given)

``[drive]``
    push; phase or radius
"""

from __future__ import annotations

import math
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel.cli.job_file.quantity import (
    ACCELERATION,
    ANGLE,
    LENGTH,
    MASS,
    RATE,
    SPEED,
    TIME,
    Kind,
    show,
)

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from kugelpendel.cli.job_file.table import Table

DENSITY = Kind("a density", "kg/m^3", "8500 kg/m^3")
DECAY = Kind("a decay rate", "1/s", "1e-5 1/s")
QUADRATIC = Kind("a quadratic drag", "1/m", "1e-3 1/m")

FORCES = ("site", "drag", "suspension", "bob", "drive")
"""The tables that a file may have beside ``[pendulum]``."""


def read_forces(tables: Mapping[str, Table]) -> tuple[kp.Pendulum, bool, kp.Forces]:
    """The pendulum, whether a mass was given, and what acts, from those of `FORCES` that are there.

    Raises
    ------
    InvalidInput
        A sentence that names the key or the table, the value seen, and the way out.
    """
    site = _site(tables["site"]) if "site" in tables else None
    bob = _bob(tables["bob"]) if "bob" in tables else None
    pendulum = _pendulum(tables["pendulum"], site, bob)
    if bob is not None:
        with named(tables["bob"]):
            bob.gravity_factor(pendulum.length)
    forces = kp.Forces(
        site=site,
        drag=_drag(tables["drag"], pendulum, bob) if "drag" in tables else None,
        suspension=_suspension(tables["suspension"]) if "suspension" in tables else None,
        bob=bob,
        drive=_drive(tables["drive"]) if "drive" in tables else None,
    )
    return pendulum, "mass" in tables["pendulum"].entries or bob is not None, forces


def _pendulum(table: Table, site: kp.Site | None, bob: kp.Bob | None) -> kp.Pendulum:
    table.allow(("length", "gravity", "mass"))
    gravity = 9.80665 if site is None else float(site.gravity)
    mass = 1.0 if bob is None else float(bob.mass)
    return kp.Pendulum(
        length=table.quantity("length", LENGTH),
        gravity=table.quantity("gravity", ACCELERATION, default=gravity),
        mass=table.quantity("mass", MASS, default=mass),
    )


def _site(table: Table) -> kp.Site:
    table.allow(("latitude", "gravity", "height"))
    latitude = table.quantity("latitude", ANGLE)
    if abs(latitude) > math.pi / 2:
        seen = show(table.entries["latitude"])
        raise kp.InvalidInput(
            f"{table.where('latitude')} = {seen} lies beyond a pole; write a latitude from "
            '"-90 deg" to "90 deg", such as "48.85 deg", positive in the north.'
        )
    with named(table):
        return kp.Site(
            latitude=latitude,
            gravity=given(table, "gravity", ACCELERATION),
            height=table.quantity("height", LENGTH, default=0.0),
        )


def _drag(table: Table, pendulum: kp.Pendulum, bob: kp.Bob | None) -> kp.Drag:
    ways = ("linear", "quality", "half_life", "from_bob")
    table.allow((*ways, "quadratic", "thread_diameter"))
    way = _one_of(table, ways)
    if table.truth("from_bob", default=False):
        return _drag_from_bob(table, pendulum, bob)
    if "thread_diameter" in table.entries:
        raise kp.InvalidInput(f"{table.where('thread_diameter')} goes with from_bob = true only.")
    with named(table):
        match way:
            case "quality":
                drag = kp.Drag.from_quality(plain_number(table, "quality", 800), pendulum)
            case "half_life":
                drag = kp.Drag.from_half_life(table.quantity("half_life", TIME))
            case _:
                drag = kp.Drag(table.quantity("linear", DECAY, default=0.0))
        return replace(drag, quadratic=table.quantity("quadratic", QUADRATIC, default=0.0))


def _drag_from_bob(table: Table, pendulum: kp.Pendulum, bob: kp.Bob | None) -> kp.Drag:
    if bob is None:
        raise kp.InvalidInput(
            f"{table.where('from_bob')} = true needs a table [bob] with radius and density."
        )
    if "quadratic" in table.entries:
        raise kp.InvalidInput(
            f"{table.where('quadratic')} does not go with from_bob = true, which says both the "
            "linear and the quadratic drag; leave one of them out."
        )
    with named(table):
        diameter = table.quantity("thread_diameter", LENGTH, default=0.0)
        return kp.Drag.from_bob(bob, pendulum, thread_diameter=diameter)


def _suspension(table: Table) -> kp.Suspension:
    periods = ("period_along", "period_across")
    table.allow(("anisotropy", *periods, "axis", "damping_anisotropy", "damping_axis"))
    axis = table.quantity("axis", ANGLE, default=0.0)
    damping = table.quantity("damping_anisotropy", DECAY, default=0.0)
    damping_axis = table.quantity("damping_axis", ANGLE, default=0.0)
    with named(table):
        if _one_of(table, ("anisotropy", "period_along", "period_across"), periods) in periods:
            along, across = (table.quantity(key, TIME) for key in periods)
            return kp.Suspension.from_periods(along, across, axis, damping, damping_axis)
        stiffness = table.quantity("anisotropy", RATE, default=0.0)
        return kp.Suspension(stiffness, axis, damping, damping_axis)


def _bob(table: Table) -> kp.Bob:
    table.allow(("radius", "diameter", "density", "thread_mass", "air_density"))
    if _one_of(table, ("radius", "diameter")) == "diameter":
        radius = table.quantity("diameter", LENGTH) / 2
    else:
        radius = table.quantity("radius", LENGTH)
    with named(table):
        return kp.Bob(
            radius=radius,
            density=table.quantity("density", DENSITY),
            thread_mass=table.quantity("thread_mass", MASS, default=0.0),
            air_density=table.quantity("air_density", DENSITY, default=1.204),
        )


def _drive(table: Table) -> kp.Drive:
    table.allow(("push", "phase", "radius"))
    with named(table):
        return kp.Drive(
            push=table.quantity("push", SPEED),
            phase=given(table, "phase", ANGLE),
            radius=given(table, "radius", LENGTH),
        )


def given(table: Table, key: str, kind: Kind) -> float | None:
    """A number in the SI unit of its kind, or None where the file has none."""
    return table.quantity(key, kind) if key in table.entries else None


def plain_number(table: Table, key: str, example: float) -> float:
    """A number without a unit."""
    value = table.entries[key]
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        raise kp.InvalidInput(
            f"{table.where(key)} = {show(value)} is not a plain number; write {key} = {example}."
        )
    return float(value)


def _one_of(table: Table, keys: tuple[str, ...], together: tuple[str, ...] = ()) -> str:
    """The one of several keys that is there, or ""; more than one exclude each other."""
    present = tuple(key for key in keys if key in table.entries)
    if len(present) > 1 and present != together:
        raise kp.InvalidInput(
            f"[{table.name}] has both {' and '.join(present)}, which say the same thing; give one "
            f"of {', '.join(keys)}."
        )
    return present[0] if present else ""


@contextmanager
def named(table: Table) -> Generator[None]:
    """Name the table in what the parameter itself refuses."""
    try:
        yield
    except kp.InvalidInput as error:
        if not error.kind:
            raise  # it was the file's own value, which is named already
        raise error.at(f"[{table.name}] ") from error
