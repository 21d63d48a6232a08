"""How far averaged motions are off: a table, by ``python docs/scripts/averaging.py docs/real.md``.

For one force at a time, over amplitudes and strengths, the azimuth of the averaged motion beside
that of the full equations over a day, and the bound that `EnvelopeMotion.trust` says.
"""

import math
import re
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import kugelpendel as kp
from kugelpendel.observables import osculating_ellipse

DAY = 86400.0
AMPLITUDES = (0.05, 0.2, 0.5, 0.7, 0.9)  # of the length
SHARES = (0.1, 0.4)  # of b in a
PENDULUM = kp.Pendulum(20.0, 9.81)
OMEGA0 = float(PENDULUM.angular_frequency)
LENGTH = float(PENDULUM.length)


def cases(a: float) -> Iterator[tuple[str, dict[str, object]]]:
    """What acts, by its strength: the share of a swing that it changes while the phase grows by 1.

    Drag is such that a drive keeps the amplitude, and damping along no direction is negative.
    """
    for power in (-6, -5, -4):
        share, said = 10.0**power, f"1e−{-power}"
        rate = share * OMEGA0
        yield f"γ, {said}", {"drag": kp.Drag(rate)}
        yield f"c, {said}", {"drag": kp.Drag(0.0, share / (a * LENGTH))}
        yield f"δ, {said}", {"suspension": kp.Suspension(rate, 0.5)}
        yield (
            f"Δγ, {said}",
            {"suspension": kp.Suspension(0.0, 0.0, rate, 0.5), "drag": kp.Drag(rate)},
        )
        push, drag = share * a * LENGTH * OMEGA0, kp.Drag(rate * math.cos(0.3) / math.pi)
        yield f"push at a phase, {said}", {"drag": drag, "drive": kp.Drive(push, phase=0.3)}
        drag = kp.Drag(rate * math.sqrt(1 - 0.4**2) / math.pi)
        drive = kp.Drive(push, radius=0.4 * a * LENGTH + 0.1)
        yield f"push at a radius, {said}", {"drag": drag, "drive": drive}
    yield "site, 49° N", {"site": kp.Site(math.radians(49))}
    yield "site, 49° N, let go at rest", {"site": kp.Site(math.radians(49))}


def measured(launch: kp.Launch, around: dict) -> tuple[float, float]:
    """Largest difference of the azimuth within the day, and its bound, in degrees."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        mean = kp.EnvelopeMotion(PENDULUM, launch, **around)
    bound = float(re.search(r"within (\S+)°", mean.trust)[1])
    full = kp.RealMotion(PENDULUM, launch, thread="rod", **around)
    site = around.get("site")
    turn = 0.0 if site is None else site.vertical_rotation
    start = np.linspace(0.0, DAY - 200.0, 60)
    times = np.concatenate([full.events("outer", at, at + 20.0) for at in start])
    position = full.position(times)
    _, _, azimuth = osculating_ellipse(position, full.velocity(times), PENDULUM, turn, times)
    # The two ends of a swing are half a turn apart, and wide ellipses turn fast.
    off = np.angle(np.exp(2j * (azimuth - mean.azimuth(times)))) / 2
    return math.degrees(np.abs(np.unwrap(off, period=math.pi)).max()), bound


def rows() -> Iterator[tuple[str, ...]]:
    """One line for each force and strength: measured, and in brackets the bound."""
    count = sum(1 for _ in cases(1.0))
    for index in range(count):
        cells = []
        for a in AMPLITUDES:
            name, around = list(cases(a))[index]
            shares = (0.0,) if "rest" in name else SHARES
            found = [
                measured(kp.Launch.ellipse(a * LENGTH, share * a * LENGTH), around)
                for share in shares
            ]
            cells.append(f"{shown(max(found)[0])} ({shown(max(found)[1])})")
        yield (name, *cells)


def shown(value: float) -> str:
    """Two digits."""
    return f"{value:.1e}".replace("e-0", "e−") if value < 1e-3 else f"{value:.2g}"


def table() -> str:
    """In Markdown."""
    head = ["force, strength", *(f"{a:g} l" for a in AMPLITUDES)]
    lines = [head, ["---"] * len(head), *rows()]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


if __name__ == "__main__":
    page = Path(sys.argv[1])
    text = page.read_text(encoding="utf-8")
    head, rest = text.split("<!-- averaging -->")
    _, tail = rest.split("<!-- /averaging -->")
    made = f"<!-- averaging -->\n{table()}\n<!-- /averaging -->"
    page.write_text(head + made + tail, encoding="utf-8")
