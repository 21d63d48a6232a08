"""Compute stored cases again, and compare; also for other files of the same format."""

from typing import Any

from flint import arb

from references import fixed
from references.launch import Case, is_plane
from references.motion import Result, solve


def compare(stored: list[dict[str, Any]]) -> float:
    """Largest difference of stored cases from ones computed now; prints a line for each."""
    worst = 0.0
    for old in stored:
        found = difference(old, solve(case_of(old)))
        worst = max(worst, found)
        print(f"{old['id']:28} {found:.1e}")
    print(f"{len(stored)} cases, largest difference {worst:.1e}")
    return worst


def difference(old: dict[str, Any], new: Result) -> float:
    """Largest difference of one stored case from a result.

    Positions relative to the length, velocities to length·ω0 or the launch's speed where that is
    more, the other numbers relative to themselves.
    """
    length = new.start.length
    speed = length * new.start.angular_frequency
    speed = max(speed, sum((v * v for v in new.start.velocity), arb(0)).sqrt())
    worst = 0.0
    for key, unit, axes in (("position", length, slice(0, 3)), ("velocity", speed, slice(3, 6))):
        own = length if key == "position" else length * new.start.angular_frequency
        for texts, state in zip(old[key], new.states, strict=True):
            for text, number in zip(texts, state[axes], strict=True):
                gap = abs(arb(text) - fixed.to_arb(number, new.bits) * own)
                worst = max(worst, float(gap / unit))
    for key, value in (
        ("frequency", new.frequency),
        ("precession", new.precession),
        ("radial_period", new.radial_period),
        ("energy_above_bottom", new.start.energy),
        ("angular_momentum", new.start.angular_momentum),
    ):
        text = old[key]
        if (text is None) != (value is None):
            raise ValueError(f"{old['id']}: {key} is {text}, now {value}")
        if value is None or (text == "inf" and not value.is_finite()):
            continue
        scale = arb(1) if arb(text) == 0 else abs(arb(text))
        worst = max(worst, float(abs(arb(text) - value) / scale))
    return worst


def case_of(old: dict[str, Any]) -> Case:
    """The inputs of a stored case; ``motion`` is worked out where the file does not name it."""
    kind, state = old["kind"], tuple(old["state"])
    motion = old.get("motion") or ("plane" if is_plane(kind, state) else "general")
    return Case(
        old["regime"], old["length"], old["gravity"], kind, state, tuple(old["times"]), motion
    )
