"""Frequency and precession of a million launches beside SciPy's elliprf and elliprj, and digits."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from contenders import reference
from contenders.carlson import Roots, rates
from report import Ratio, Section, Table
from scipy.special import elliprf, elliprj
from timing import paired

import kugelpendel as kp

COUNT = 1_000_000
PER_DECADE = 25
ROUNDS = 5
Rates = tuple[np.ndarray, np.ndarray]


def launches(seed: int = 1) -> dict[str, tuple[np.ndarray, ...]]:
    """The same million ellipses three ways; a uniform up to 0.95, b/a to both sides, l = g = 1."""
    draw = np.random.default_rng(seed)
    a = draw.uniform(0.01, 0.95, COUNT)
    b = a * draw.uniform(-0.98, 0.98, COUNT)
    # A state on the way: a stretch of the harmonic ellipse, turned at random.
    phase, turned = draw.uniform(0, 2 * np.pi, (2, COUNT))
    x, y, vx, vy = a * np.cos(phase), b * np.sin(phase), -a * np.sin(phase), b * np.cos(phase)
    c, s = np.cos(turned), np.sin(turned)
    slow = np.sqrt((1 - a) * (1 + a))  # keeps the energy below the support's height
    x, y, vx, vy = c * x - s * y, s * x + c * y, slow * (c * vx - s * vy), slow * (s * vx + c * vy)
    return {"apsides": (a, b), "ellipse": (a, b), "plane": (x, y, vx, vy)}


def ours(kind: str, values: tuple[np.ndarray, ...]) -> Rates:
    motion = kp.ExactMotion(kp.Pendulum(1.0, 1.0), getattr(kp.Launch, kind)(*values))
    return motion.frequency, motion.precession


def theirs(kind: str, values: tuple[np.ndarray, ...]) -> Rates:
    return rates(getattr(Roots, kind)(*values))


def integrals(kind: str, values: tuple[np.ndarray, ...]) -> Callable[[], object]:
    """The special functions alone, their arguments ready."""
    roots = getattr(Roots, kind)(*values)
    m1 = (roots.top - roots.high) / (roots.top - roots.low)
    p1, p2 = m1 * roots.low / roots.high, (2 - roots.high) / (2 - roots.low)
    return lambda: (
        elliprf(0.0, m1, 1.0),
        elliprj(0.0, m1, 1.0, p1),
        elliprj(0.0, m1, 1.0, p2),
    )


def measure() -> Section:
    ratios, notes = [], []
    for kind, values in launches().items():
        contenders = {
            "ours": lambda kind=kind, values=values: ours(kind, values),
            "theirs": lambda kind=kind, values=values: theirs(kind, values),
            "integrals": integrals(kind, values),
        }
        timings = paired(contenders, ROUNDS)
        work = f"frequency and precession of 1e6 launches, Launch.{kind}"
        seconds = {name: timings.seconds(name) for name in contenders}
        for name, peer, limit in (
            ("theirs", "NumPy roots, elliprf, 2 elliprj", 1.0),
            ("integrals", "elliprf and 2 elliprj alone", None),
        ):
            value = timings.ratio("ours", name)
            ratios.append(Ratio(work, peer, seconds["ours"], seconds[name], value, limit))
        apart = (ours(kind, values)[0] / theirs(kind, values)[0] - 1).__abs__()
        notes.append(f"{kind}: largest relative difference of the frequencies {apart.max():.1e}.")
    notes += [
        "Launches: a uniform in 0.01 l … 0.95 l, b/a uniform in ±0.98. Ours includes building the "
        "launch and the motion with everything it keeps for positions.",
        "Digits: -log10 of the relative error, at most 17; the reference has 40 digits.",
    ]
    return Section("Ensembles", ratios, (digits(),), notes)


def digits() -> Table:
    """Digits kept by both, per decade of the amplitude: the fewest and the median."""
    draw = np.random.default_rng(2)
    rows = []
    for decade in range(-8, 0):
        a = 10.0 ** draw.uniform(decade, decade + 1, PER_DECADE)
        a = np.minimum(a, 0.999)
        b = a * 10.0 ** draw.uniform(-2, math.log10(0.98), PER_DECADE)
        exact = [reference.Apsides.radii(*pair, 1.0) for pair in zip(a, b, strict=True)]
        cells = [f"1e{decade} … 1e{decade + 1}"]
        for index, name in enumerate(("frequency", "precession")):
            for rates_of in (ours, theirs):
                found = rates_of("apsides", (a, b))[index]
                kept = sorted(
                    kept_digits(f, getattr(e, name)) for f, e in zip(found, exact, strict=True)
                )
                cells.append(f"{kept[0]:.1f} ({kept[len(kept) // 2]:.1f})")
        rows.append(cells)
    head = ("a / l", "ω ours", "ω elliprf", "Ω ours", "Ω elliprj")
    caption = (
        f"Digits kept, the fewest of {PER_DECADE} launches per decade (and their median), "
        "Launch.apsides, b/a from 0.01 to 0.98:"
    )
    return Table(caption, head, rows)


def kept_digits(found: float, exact: reference.arb) -> float:
    error = float(abs(reference.arb(float(found)) / exact - 1).mid())
    return min(17.0, max(0.0, -math.log10(error))) if error else 17.0
