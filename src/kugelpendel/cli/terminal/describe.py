"""Numbers, pendulums and launches as a reader would say them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.plot import spell, unit_for

if TYPE_CHECKING:
    import kugelpendel as kp
    from kugelpendel.cli.job_file.job import Job


def describe_pendulum(pendulum: kp.Pendulum, has_mass: bool) -> str:
    """Length, mass and gravity."""
    mass = f", {given(float(pendulum.mass), 'kg')}" if has_mass else ""
    return f"{given(float(pendulum.length), 'm')}{mass}, g = {float(pendulum.gravity):.6g} m/s²"


def describe_launch(job: Job) -> str:
    """How the bob starts."""
    values = job.launch.values
    match job.launch.kind:
        case "ellipse" | "apsides":
            a, b, azimuth = (float(value) for value in values)
            start = f"{given(a, 'm')} out{_towards(azimuth)}"
            if job.launch.kind == "apsides":
                sense = ", clockwise" if b < 0 else ""
                return f"{start}, turning radii {given(a, 'm')} and {given(abs(b), 'm')}{sense}"
            if b == 0:
                return f"{start}, let go without a push"
            speed = spell(abs(b) * float(job.pendulum.angular_frequency), "m/s")
            return f"{start}, pushed sideways with {speed} (b = {given(b, 'm')})"
        case "plane":
            x, y, vx, vy = (float(value) for value in values)
            place = f"x = {given(x, 'm')}, y = {given(y, 'm')}"
            return f"from {place} with vx = {given(vx, 'm/s')}, vy = {given(vy, 'm/s')}"
        case "angles" | "at_rest":
            theta, phi, theta_rate, phi_rate = (float(value) for value in (*values, 0, 0)[:4])
            rates = [
                f"{minus(f'{math.degrees(rate):+.6g}')} °/s {way}"
                for rate, way in ((theta_rate, "outwards"), (phi_rate, "about the vertical"))
                if rate
            ]
            start = f"{degrees(theta)} from straight down{_towards(phi)}"
            return f"{start}, {', '.join(rates)}" if rates else f"let go {start}"
        case _:
            x, y, z = (given(float(value), "m") for value in values[:3])
            vx, vy, vz = (given(float(value), "m/s") for value in values[3:])
            return f"position ({x}, {y}, {z}), velocity ({vx}, {vy}, {vz})"


def given(value: float, si: str) -> str:
    """A number as it was given, without zeros that would claim digits."""
    unit = unit_for(value, si)
    return minus(f"{value / unit.size:.6g} {unit.symbol}")


def degrees(angle: float) -> str:
    """An angle in rad, shown in degrees."""
    return minus(f"{math.degrees(angle):.6g}°")


def minus(text: str) -> str:
    """The same text with minus signs in place of hyphens."""
    return text.replace("-", "−")


def _towards(azimuth: float) -> str:
    return f" at azimuth {degrees(azimuth)}" if azimuth else ""
