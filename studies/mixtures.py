"""How far averaged motions are off for random mixtures of all that acts, beside their own bound.

python -m studies.mixtures [--count N] [--seed N] [--write FILE]: full equations over 24 h for each,
some seconds; the table goes between two marks of FILE.
"""

from __future__ import annotations

import argparse
import math
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import kugelpendel as kp
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.observables import osculating_ellipse

BEGIN, END = "<!-- mixtures -->", "<!-- /mixtures -->"
DAY = 86400.0
COUNT, SEED = 300, 1000
LOOKS = 60
"""Moments of the duration at which the azimuth is looked at."""

SIZES = (0.05, 0.2, 0.5, 0.7, 0.9)
"""a/l, of which each pendulum has one, less up to a tenth."""

ROUND = 0.6
"""Of b in a: beyond, an ellipse is next to a circle, and its azimuth means little."""

ROUNDING = 1e-8
"""rad: what the azimuths of the full equations may be off by themselves."""


@dataclass(frozen=True)
class Mixture:
    """One pendulum, its launch, and up to four of what can act."""

    size: float
    pendulum: kp.Pendulum
    launch: kp.Launch
    forces: kp.Forces

    def averaged(self) -> kp.EnvelopeMotion:
        """The averaged motion; that it warns is part of what is measured."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return kp.EnvelopeMotion(self.pendulum, self.launch, self.forces)


def drawn(seed: int) -> Mixture:
    """Each force by the share of a swing that it changes, from 1e-7 to 3e-4."""
    random = np.random.default_rng(seed)
    pendulum = kp.Pendulum(random.uniform(0.5, 30.0), 9.81)
    omega0 = float(pendulum.angular_frequency)
    size = float(random.choice(SIZES))
    a = size * random.uniform(0.9, 1.0) * float(pendulum.length)
    names = ["site", "linear", "quadratic", "stiff", "lossy", "drive"]
    acting = set(random.choice(names, size=random.integers(1, 5), replace=False))
    share = {name: 10.0 ** random.uniform(-7.0, -3.5) * (name in acting) for name in names}
    lossy = share["lossy"] * omega0
    # Drag enough that no direction gains energy.
    linear, quadratic = share["linear"] * omega0 + lossy / 2, share["quadratic"] / a
    stiff = share["stiff"] * omega0 * random.choice([-1.0, 1.0])
    axes = random.uniform(-1.5, 1.5, 2)
    phase = random.uniform(0.05, 1.2)
    decay = linear + 4 / (3 * math.pi) * quadratic * omega0 * a
    push = math.pi * a * decay / math.cos(phase)
    forces = kp.Forces(
        site=kp.Site(random.uniform(-1.5, 1.5)) if "site" in acting else None,
        drag=kp.Drag(linear, quadratic) if decay else None,
        suspension=kp.Suspension(stiff, axes[0], lossy, axes[1]) if stiff or lossy else None,
        drive=kp.Drive(push, phase=phase) if "drive" in acting and decay else None,
    )
    b = a * random.uniform(-0.4, 0.4)
    return Mixture(size, pendulum, kp.Launch.ellipse(a, b, random.uniform(-1.5, 1.5)), forces)


def azimuth_off(
    mixture: Mixture, duration: float, looks: int = LOOKS
) -> tuple[float, float] | None:
    """Largest error of the azimuth and its bound, rad; None for what comes next to a circle."""
    mean = mixture.averaged()
    full = kp.RealMotion(mixture.pendulum, mixture.launch, mixture.forces, thread="rod")
    swing = 2 * math.pi / float(mixture.pendulum.angular_frequency)
    starts = np.linspace(0.0, duration - 2 * swing, looks)
    times = np.concatenate([full.events("outer", at, at + 1.2 * swing) for at in starts])
    a, b = mean.semi_axes(times).T
    if (np.abs(b) > ROUND * a).any():
        return None
    position, velocity = full.position(times), full.velocity(times)
    _, _, azimuth = osculating_ellipse(position, velocity, mixture.pendulum, full.rotation, times)
    # The two ends of a swing are half a turn apart.
    off = np.angle(np.exp(2j * (azimuth - mean.azimuth(times)))) / 2
    largest = float(np.abs(np.unwrap(off, period=math.pi)).max())
    return largest, mean._motions.azimuth_error(duration) + ROUNDING


def table(count: int, seed: int) -> str:
    """In Markdown: for each size how many there were, and measured over bound."""
    found: dict[float, list[tuple[float, float]]] = {size: [] for size in SIZES}
    round_ones = dict.fromkeys(SIZES, 0)
    with Progress("Following mixtures for a day", count) as progress:
        for index in range(count):
            mixture = drawn(seed + index)
            measured = azimuth_off(mixture, DAY)
            if measured is None:
                round_ones[mixture.size] += 1
            else:
                found[mixture.size].append(measured)
                if measured[0] > measured[1]:
                    print(
                        f"seed {seed + index}: {measured[0]:.3g} rad, bound {measured[1]:.3g} rad"
                    )
            progress.advance(1)
    lines = [
        "| a/l up to | mixtures | beyond the bound | measured, median | over the bound, median | "
        "over the bound, largest | next to a circle, left out |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for size in SIZES:
        off, bound = np.array(found[size]).reshape(-1, 2).T
        share = off / bound
        lines.append(
            f"| {size} | {len(off)} | {int((share > 1).sum())} "
            f"| {math.degrees(np.median(off)):.1g}° | {np.median(share):.2g} "
            f"| {share.max():.2g} | {round_ones[size]} |"
        )
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--write", type=Path, help="a file with the marks to write between")
    options = parser.parse_args()
    count, seed = options.count, options.seed
    body = f"{count} mixtures, seeds from {seed} on:\n\n{table(count, seed)}"
    print(body)
    if options.write:
        before, rest = options.write.read_text(encoding="utf-8").split(BEGIN)
        _, after = rest.split(END)
        options.write.write_text(f"{before}{BEGIN}\n{body}\n{END}{after}", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
