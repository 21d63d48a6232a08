"""Site, drag, suspension, bob and drive as a reader would say them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.spelling import as_given, degrees, general, spell, unit_for

if TYPE_CHECKING:
    import kugelpendel as kp


def describe_forces(pendulum: kp.Pendulum, forces: kp.Forces) -> list[tuple[str, str]]:
    """A name and a phrase for each table that the job has."""
    frequency = float(pendulum.angular_frequency)
    lines: list[tuple[str, str]] = []
    if forces.site is not None:
        lines.append(("Site", _site(forces.site)))
    if forces.drag is not None:
        lines.append(("Drag", _drag(forces.drag, frequency)))
    if forces.suspension is not None:
        parts = _suspension(forces.suspension, frequency)
        lines += zip(("Suspension", ""), parts, strict=False)
    if forces.bob is not None:
        lines.append(("Bob", _bob(forces.bob)))
    if forces.drive is not None:
        lines.append(("Drive", _drive(forces.drive)))
    return lines


def _site(site: kp.Site) -> str:
    latitude = float(site.latitude)
    side = "N" if latitude >= 0 else "S"
    source = "as given" if site.gravity_given else "WGS84 normal gravity"
    return f"{degrees(abs(latitude))} {side}, g = {general(float(site.gravity))} m/s² ({source})"


def _drag(drag: kp.Drag, frequency: float) -> str:
    linear, quadratic = float(drag.linear), float(drag.quadratic)
    parts: list[str] = []
    if linear:
        half_life = spell(math.log(2) / linear, "s")
        parts.append(
            f"linear, amplitude halves in {half_life} "
            f"(γ = {general(linear, 4)} 1/s, Q = {general(frequency / (2 * linear), 4)})"
        )
    if quadratic:
        parts.append(f"quadratic, c = {general(quadratic, 4)} 1/m")
    return "; ".join(parts) or "none"


def _suspension(suspension: kp.Suspension, frequency: float) -> list[str]:
    stiffness, axis, damping, damping_axis = (float(value) for value in suspension.values)
    parts: list[str] = []
    if stiffness:
        way = "faster" if stiffness > 0 else "slower"
        share, delta = general(abs(stiffness) / frequency, 4), general(stiffness, 4)
        parts.append(f"{way} by {share} along {degrees(axis)} than across (δ = {delta} rad/s)")
    if damping:
        parts.append(f"decay {general(damping, 4)} 1/s faster along {degrees(damping_axis)}")
    return parts or ["alike in all directions"]


def _bob(bob: kp.Bob) -> str:
    thread = float(bob.thread_mass)
    on = f" on a thread of {as_given(thread, 'kg')}" if thread else ""
    radius, mass = spell(float(bob.radius), "m"), spell(float(bob.mass), "kg")
    return f"ball of {radius} radius, {general(float(bob.density))} kg/m³, {mass}{on}"


def _drive(drive: kp.Drive) -> str:
    push = float(drive.push)
    way = "outwards" if push > 0 else "inwards"
    unit = unit_for(push, "m/s")
    strength = f"{general(abs(push) / unit.size, 4)} {unit.symbol}"
    if drive.phase is not None:
        when = f"{degrees(float(drive.phase))} of phase after each closest approach"
    else:
        when = f"on the way out, {as_given(float(drive.radius or 0.0), 'm')} from the axis"
    return f"{strength} {way}, {when}"
