"""What acts on a pendulum, as a reader would say it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.spelling import as_given, degrees, general, spell, unit_for

if TYPE_CHECKING:
    from collections.abc import Callable

    import kugelpendel as kp
    from kugelpendel.parameters import Given


def describe_forces(pendulum: kp.Pendulum, forces: kp.Forces) -> list[tuple[str, str]]:
    """A name and a phrase for each table that the job has; a second phrase has no name."""
    frequency = float(pendulum.angular_frequency)
    lines: list[tuple[str, str]] = []
    for name, part in forces.parts.items():
        phrases = _PHRASES.get(name, _by_its_numbers)(part, frequency)
        lines += zip((name.capitalize(), *[""] * len(phrases)), phrases, strict=False)
    return lines


def _by_its_numbers(part: Given, frequency: float) -> list[str]:
    """Of what has no phrase of its own: its numbers."""
    said = (
        f"{name.replace('_', ' ')} "
        + (
            degrees(float(value))
            if (unit := part.units[name]) == "rad"
            else f"{general(float(value), 4)} {unit}".rstrip()
        )
        for name, value in part.named.items()
    )
    return [", ".join(said)]


def _site(site: kp.Site, frequency: float) -> list[str]:
    latitude = float(site.latitude)
    side = "N" if latitude >= 0 else "S"
    source = "as given" if site.gravity_given else "WGS84 normal gravity"
    gravity = general(float(site.gravity))
    return [f"{degrees(abs(latitude))} {side}, g = {gravity} m/s² ({source})"]


def _drag(drag: kp.Drag, frequency: float) -> list[str]:
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
    return ["; ".join(parts) or "none"]


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


def _bob(bob: kp.Bob, frequency: float) -> list[str]:
    thread = float(bob.thread_mass)
    on = f" on a thread of {as_given(thread, 'kg')}" if thread else ""
    radius, mass = spell(float(bob.radius), "m"), spell(float(bob.mass), "kg")
    return [f"ball of {radius} radius, {general(float(bob.density))} kg/m³, {mass}{on}"]


def _drive(drive: kp.Drive, frequency: float) -> list[str]:
    push = float(drive.push)
    way = "outwards" if push > 0 else "inwards"
    unit = unit_for(push, "m/s")
    strength = f"{general(abs(push) / unit.size, 4)} {unit.symbol}"
    if drive.phase is not None:
        when = f"{degrees(float(drive.phase))} of phase after each closest approach"
    else:
        when = f"on the way out, {as_given(float(drive.radius or 0.0), 'm')} from the axis"
    return [f"{strength} {way}, {when}"]


_PHRASES: dict[str, Callable[..., list[str]]] = {
    "site": _site,
    "drag": _drag,
    "suspension": _suspension,
    "bob": _bob,
    "drive": _drive,
}
"""How each part is told, beside the frequency of small swings, rad/s."""
