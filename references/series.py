"""Write the table of the series: ``python -m references.series``, from the repository's root.

The coefficients are those of `kugelpendel.series`, exact. The radii of convergence in the first
harmonics are the largest semi-axis a that the first harmonics of any motion with that b/a have: the
exact motion's, sought by golden section over the highest angle. Beyond it there is no motion to
expand, and at it a(θ) turns round, a branch point.
"""

import json
import math
from pathlib import Path

import kugelpendel as kp
from kugelpendel.series._table import FILE, SHIPPED, derived

PATH = Path(kp.series.__file__).with_name(FILE)
STEPS = 32
PENDULUM = kp.Pendulum(length=1.0, gravity=1.0)


def axes(theta: float, rate: float) -> tuple[float, float]:
    """Semi-axes of the first harmonics, from a turning point with an azimuthal rate."""
    launch = kp.Launch.angles(theta, phi_rate=rate)
    amplitude = abs(kp.ExactMotion(PENDULUM, launch).spectrum(1).amplitude)
    return float(amplitude[1] + amplitude[0]), float(amplitude[1] - amplitude[0])


def axis(theta: float, ratio: float) -> float:
    """The semi-axis a of the motion that starts at a turning point and has b = ratio · a."""
    low, high = 0.0, 1 / math.sqrt(max(math.cos(theta), 1e-4))
    for _ in range(60):
        middle = (low + high) / 2
        a, b = axes(theta, middle)
        low, high = (middle, high) if b < ratio * a else (low, middle)
    return axes(theta, low)[0]


def largest(ratio: float) -> float:
    """The maximum over theta, to the nine digits or so that are left of a flat one."""
    if ratio == 1:
        return 1.0  # cones: the semi-axes are the radius
    golden = (math.sqrt(5) - 1) / 2
    low, high = math.radians(85), math.radians(110)
    while high - low > 1e-5:
        left, right = high - golden * (high - low), low + golden * (high - low)
        low, high = (left, high) if axis(left, ratio) < axis(right, ratio) else (low, right)
    return round(axis((low + high) / 2, ratio), 7)


def text() -> str:
    """The file: one series a line."""
    parts: list[str] = []
    for variables in ("radii", "harmonics"):
        lines = (
            f"   {json.dumps(name)}: {json.dumps(terms, separators=(',', ':'))}"
            for name, terms in derived(SHIPPED, variables).items()
        )
        parts.append(f'  "{variables}": {{\n' + ",\n".join(lines) + "\n  }")
    radius = json.dumps([largest(n / STEPS) for n in range(STEPS + 1)])
    return '{\n "series": {\n' + ",\n".join(parts) + f'\n }},\n "radius": {radius}\n}}\n'


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")
