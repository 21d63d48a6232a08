"""Pendulums and launches as a reader would say them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.spelling import as_given, degrees, general, spell

if TYPE_CHECKING:
    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job


def describe_pendulum(pendulum: kp.Pendulum, has_mass: bool) -> str:
    """Length, mass and gravity."""
    mass = f", {as_given(float(pendulum.mass), 'kg')}" if has_mass else ""
    gravity = general(float(pendulum.gravity))
    return f"{as_given(float(pendulum.length), 'm')}{mass}, g = {gravity} m/s²"


def describe_launch(job: Job) -> str:
    """How the bob starts."""
    values = job.launch.values
    match job.launch.kind:
        case "ellipse" | "apsides":
            a, b, azimuth = (float(value) for value in values)
            start = f"{as_given(a, 'm')} out{_towards(azimuth)}"
            if job.launch.kind == "apsides":
                sense = ", clockwise" if b < 0 else ""
                return (
                    f"{start}, turning radii {as_given(a, 'm')} and {as_given(abs(b), 'm')}{sense}"
                )
            if b == 0:
                return f"{start}, let go without a push"
            speed = spell(abs(b) * float(job.pendulum.angular_frequency), "m/s")
            return f"{start}, pushed sideways with {speed} (b = {as_given(b, 'm')})"
        case "plane":
            x, y, vx, vy = (float(value) for value in values)
            place = f"x = {as_given(x, 'm')}, y = {as_given(y, 'm')}"
            return f"from {place} with vx = {as_given(vx, 'm/s')}, vy = {as_given(vy, 'm/s')}"
        case "angles" | "at_rest":
            theta, phi, theta_rate, phi_rate = (float(value) for value in (*values, 0, 0)[:4])
            rates = [
                f"{'+' if rate > 0 else ''}{general(math.degrees(rate))} °/s {way}"
                for rate, way in ((theta_rate, "outwards"), (phi_rate, "about the vertical"))
                if rate
            ]
            start = f"{degrees(theta)} from straight down{_towards(phi)}"
            return f"{start}, {', '.join(rates)}" if rates else f"let go {start}"
        case _:
            x, y, z = (as_given(float(value), "m") for value in values[:3])
            vx, vy, vz = (as_given(float(value), "m/s") for value in values[3:])
            return f"position ({x}, {y}, {z}), velocity ({vx}, {vy}, {vz})"


def _towards(azimuth: float) -> str:
    return f" at azimuth {degrees(azimuth)}" if azimuth else ""
