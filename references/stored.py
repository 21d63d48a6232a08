"""The format of the stored file."""

import json
from pathlib import Path

from flint import arb

from references import fixed
from references.launch import Case
from references.motion import Result
from references.spread import Spread

ABOUT = (
    "Ideal spherical pendulum, written by references/generate.py. SI units; z is measured down "
    "from the support. Inputs are binary64 numbers taken exactly. State: kind 'angles' = theta, "
    "phi, theta rate, phi rate; kind 'plane' = x, y, vx, vy on the lower hemisphere; kind 'state'"
    " = x, y, z, vx, vy, vz, exactly on the sphere and tangent to it. position, velocity: Taylor "
    "integration in 256-bit fixed point, every number to 25 significant digits, or to 1e-26 of "
    "its largest size in the case where it passes through 0. energy (above the lowest point) and "
    "angular momentum are per unit mass. spread: sum over the inputs of |derivative of position| "
    "times half a unit in the last place of the input, as a fraction of the length; "
    "frequency_spread and precession_spread: the same, relative. Inputs equal to 0 do not move. "
    "frequency, precession in rad/s; radial_period in s: time between two successive highest "
    "points. motion 'plane' (angular momentum exactly 0): precession 0; frequency "
    "pi/radial_period for libration, 2 pi/radial_period for rotation over the top, where "
    "radial_period is one revolution. 'cone' (height exactly constant): limits of the near cones."
    " 'separatrix': frequency 0, radial_period inf. 'rest': small-oscillation limit. 'upright' "
    "(balanced on the top): frequency, precession and radial_period have no meaning and are null."
    " Spreads that have no meaning are null. checked_periods: how far, in small-oscillation "
    "periods 2 pi sqrt(length/gravity), straight integration confirmed the states; those after it"
    " follow from one integrated radial period by symmetry."
)


def entry(
    name: str, case: Case, result: Result, spread: Spread, reached: float
) -> dict[str, object]:
    """One case as it is stored."""
    noise = arb(2) ** (40 - result.bits)
    length, speed = result.start.length, result.start.length * result.start.angular_frequency

    def row(numbers: tuple[int, ...], unit: arb) -> list[str]:
        return [fixed.decimal(fixed.to_arb(n, result.bits) * unit, noise * unit) for n in numbers]

    def one(value: arb | None) -> str | None:
        return None if value is None else fixed.decimal(value) if value.is_finite() else "inf"

    planar = case.motion in ("plane", "separatrix", "rest", "upright")
    momentum = arb(0) if planar else result.start.angular_momentum
    energy = arb(0) if case.motion == "rest" else result.start.energy
    return {
        "id": name,
        "regime": case.regime,
        "motion": case.motion,
        "length": case.length,
        "gravity": case.gravity,
        "kind": case.kind,
        "state": list(case.state),
        "times": list(case.times),
        "position": [row(s[:3], length) for s in result.states],
        "velocity": [row(s[3:], speed) for s in result.states],
        "spread": [float(f"{v:.3g}") for v in spread.position],
        "energy_above_bottom": one(energy),
        "angular_momentum": one(momentum),
        "frequency": one(result.frequency),
        "frequency_spread": None if spread.frequency is None else float(f"{spread.frequency:.3g}"),
        "precession": one(result.precession),
        "precession_spread": None
        if spread.precession is None
        else float(f"{spread.precession:.3g}"),
        "radial_period": one(result.radial_period),
        "checked_periods": float(f"{reached:.3g}"),
    }


def write(file: Path, about: str, entries: list[dict[str, object]]) -> None:
    """Write all entries, one key a line."""
    blocks = []
    for item in entries:
        lines = [
            f"{json.dumps(key)}: {json.dumps(value, separators=(',', ':'))}"
            for key, value in item.items()
        ]
        blocks.append("{\n" + ",\n".join(lines) + "\n}")
    text = '{\n"about": ' + json.dumps(about) + ',\n"cases": [\n' + ",\n".join(blocks) + "\n]\n}\n"
    partial = file.with_suffix(".partial")
    partial.write_text(text)
    partial.replace(file)
