"""What swings and what acts on it, as a file says it; the tables are those of the schema."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import kugelpendel as kp
from kugelpendel.cli.job_file import schema
from kugelpendel.parameters import FORCE_PARTS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.cli.job_file.entries import Entries
    from kugelpendel.parameters import Given

FORCES = tuple(section.name for section in schema.FORCES)
"""The tables that a file may have beside ``[pendulum]``."""


def read_forces(
    tables: Mapping[str, Entries], present: Mapping[str, object]
) -> tuple[kp.Pendulum, bool, kp.Forces]:
    """Read the pendulum, whether a mass was given, and what acts.

    Parameters
    ----------
    tables
        All of the schema.
    present
        Those that the file has.

    Raises
    ------
    InvalidInput
        A sentence that names the key or the table, the value seen, and the way out.
    """
    site = _site(tables["site"]) if "site" in present else None
    bob = _bob(tables["bob"]) if "bob" in present else None
    pendulum = _pendulum(tables["pendulum"], site, bob)
    if bob is not None:
        with tables["bob"].at():
            bob.gravity_factor(pendulum.length)
    parts: dict[str, Any] = {"site": site, "bob": bob}
    if "drag" in present:
        parts["drag"] = _drag(tables["drag"], pendulum, bob)
    if "suspension" in present:
        parts["suspension"] = _suspension(tables["suspension"])
    for name in FORCES:
        if name in present and name not in parts:
            parts[name] = _by_its_keys(tables[name])
    return pendulum, "mass" in tables["pendulum"] or bob is not None, kp.Forces(**parts)


def _pendulum(table: Entries, site: kp.Site | None, bob: kp.Bob | None) -> kp.Pendulum:
    gravity = 9.80665 if site is None else float(site.gravity)
    mass = 1.0 if bob is None else float(bob.mass)
    with table.at():
        return kp.Pendulum(
            length=table.number("length"),
            gravity=table.number("gravity", default=gravity),
            mass=table.number("mass", default=mass),
        )


def _site(table: Entries) -> kp.Site:
    latitude = table.number("latitude")
    if abs(latitude) > math.pi / 2:
        table.refuse("file_beyond_pole", "latitude")
    with table.at():
        return kp.Site(
            latitude=latitude, gravity=table.given("gravity"), height=table.number("height")
        )


def _drag(table: Entries, pendulum: kp.Pendulum, bob: kp.Bob | None) -> kp.Drag:
    if table.truth("from_bob"):
        return _drag_from_bob(table, pendulum, bob)
    if "thread_diameter" in table:
        table.refuse("file_thread_alone", "thread_diameter")
    with table.at():
        if (quality := table.given("quality")) is not None:
            drag = kp.Drag.from_quality(quality, pendulum)
        elif (half_life := table.given("half_life")) is not None:
            drag = kp.Drag.from_half_life(half_life)
        else:
            drag = kp.Drag(table.number("linear"))
        return replace(drag, quadratic=table.number("quadratic"))


def _drag_from_bob(table: Entries, pendulum: kp.Pendulum, bob: kp.Bob | None) -> kp.Drag:
    if bob is None:
        table.refuse("file_no_bob", "from_bob")
    if "quadratic" in table:
        table.refuse("file_quadratic_twice", "quadratic")
    with table.at():
        return kp.Drag.from_bob(bob, pendulum, thread_diameter=table.number("thread_diameter"))


def _suspension(table: Entries) -> kp.Suspension:
    axis, damping = table.number("axis"), table.number("damping_anisotropy")
    damping_axis = table.number("damping_axis")
    with table.at():
        if "period_along" in table or "period_across" in table:
            along, across = table.number("period_along"), table.number("period_across")
            return kp.Suspension.from_periods(along, across, axis, damping, damping_axis)
        return kp.Suspension(table.number("anisotropy"), axis, damping, damping_axis)


def _bob(table: Entries) -> kp.Bob:
    diameter = table.given("diameter")
    radius = table.number("radius") if diameter is None else diameter / 2
    with table.at():
        return kp.Bob(
            radius=radius,
            density=table.number("density"),
            thread_mass=table.number("thread_mass"),
            air_density=table.number("air_density"),
        )


def _by_its_keys(table: Entries) -> Given:
    """Make a part whose keys are the arguments of its class."""
    make = FORCE_PARTS[table.section.name]
    keys = (key for key in table.section.keys if key.needed or key.name in table)
    with table.at():
        return make(**{key.name: table.number(key.name) for key in keys})
