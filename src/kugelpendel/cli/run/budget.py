"""Why a plane hurries, lags or stalls: the share of each cause in its rate, in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.terminal.tables import numbers
from kugelpendel.motion import CAUSES
from kugelpendel.spelling import minus, rate_unit, significant, spell

if TYPE_CHECKING:
    from kugelpendel.motion import PrecessionBudget, Stretch

_NAMES = {
    "earth": "the Earth",
    "intrinsic": "the ellipse itself",
    "anisotropy": "the anisotropy",
    "damping": "the damping",
    "drive": "the drive",
}
"""How a sentence calls a cause; "intrinsic" is what any ellipse does, Olsson's (25)."""

_LISTED = 4
"""Stretches that are told one by one."""


def shares_table(shares: PrecessionBudget) -> str:
    """Set mean, least and most of each share, and its values where the plane is slow and fast."""
    total = shares.total
    unit = rate_unit(float(np.abs(total).max()))
    way = math.copysign(1.0, float(shares.earth.mean()) or float(total.mean()) or 1.0)
    slow, fast = int(np.argmin(way * total)), int(np.argmax(way * total))
    rows: list[tuple[str, ...]] = []
    for name, share in (*((cause, getattr(shares, cause)) for cause in CAUSES), ("sum", total)):
        if name != "earth" and not np.any(share):
            continue
        values = (share.mean(), share.min(), share.max(), share[slow], share[fast])
        rows.append((name, *(_fixed(float(value) / unit.size) for value in values)))
    when = (spell(float(shares.times[at]), "s", 3) for at in (slow, fast))
    where = (f"{_folded(float(shares.azimuth[at])):.0f}°" for at in (slow, fast))
    rows.append(("  at the time", "", "", "", *when))
    rows.append(("  at the azimuth", "", "", "", *map(minus, where)))
    head = (f"Rate, {unit.symbol}", "mean", "least", "most", "slowest", "fastest")
    return numbers(head, rows)


def describe_pace(shares: PrecessionBudget, ideal: float) -> list[str]:
    """Where the plane hurries, lags and stalls against the Earth, and by what."""
    stretches = shares.stretches()
    if not ideal:
        return []
    odd = [stretch for stretch in stretches if stretch.cause]
    if not odd:
        return ["The plane turns as the Earth alone would turn it, within 1 % all the time."]
    if len(odd) <= _LISTED:
        return [_sentence(stretch) for stretch in odd]
    whole = float(np.ptp(shares.times))
    lines: list[str] = []
    for pace in ("hurries", "lags", "stalls"):
        same = [stretch for stretch in odd if stretch.pace == pace]
        if same:
            time = sum(stretch.stop - stretch.start for stretch in same)
            longest = max(same, key=lambda stretch: stretch.stop - stretch.start)
            share = f"{100 * time / whole:.0f} %" if time > whole / 100 else "less than 1 %"
            times = "once" if len(same) == 1 else f"{len(same)} times"
            lines.append(
                f"The plane {pace} {times}, {share} of the time; longest "
                f"{_when(longest)}, {_by(longest)}."
            )
    return lines


def _sentence(stretch: Stretch) -> str:
    return f"The plane {stretch.pace} {_when(stretch)}, {_by(stretch)}."


def _by(stretch: Stretch) -> str:
    against = f", against {_NAMES[stretch.against]}" if stretch.against else ""
    return f"mostly by {_NAMES[stretch.cause]}{against}"


def _when(stretch: Stretch) -> str:
    return f"from {spell(stretch.start, 's', 3)} to {spell(stretch.stop, 's', 3)}"


def _fixed(value: float) -> str:
    if abs(value) < 5e-4:
        return "0.000" if value else "0"
    text = f"{value:+.3f}" if abs(value) < 1000 else significant(value, 4)
    return minus(text)


def _folded(azimuth: float) -> float:
    """Of an axis, in degrees from −90 to 90."""
    return math.degrees(math.remainder(azimuth, math.pi))
