"""A day of the Panthéon's pendulum, averaged, beside the full equations: speed and error."""

from __future__ import annotations

import math
import warnings

import numpy as np
from report import Ratio, Section, Table
from timing import paired

import kugelpendel as kp

DAY = 86400.0
ROUNDS = 15
SWINGS = 100
MANY = 100_000
PANTHEON = kp.Pendulum(67.0, 9.8094)
LAUNCH = kp.Launch.ellipse(3.0, 0.01)
AROUND = {
    "site": kp.Site(math.radians(48.85)),
    "drag": kp.Drag(math.log(2) / (3 * 3600), 1e-5),
    "suspension": kp.Suspension(1e-6, 0.5),
}
LABORATORY = kp.Pendulum(1.0, 9.81)
OMEGA0 = float(LABORATORY.angular_frequency)


def averaged() -> np.ndarray:
    return kp.EnvelopeMotion(PANTHEON, LAUNCH, **AROUND).azimuth(DAY)


def full() -> np.ndarray:
    return kp.RealMotion(PANTHEON, LAUNCH, **AROUND).position(DAY)


def positions() -> np.ndarray:
    motion = kp.EnvelopeMotion(PANTHEON, LAUNCH, **AROUND)
    return motion.position(np.linspace(0.0, DAY, MANY))


def wide() -> np.ndarray:
    motion = kp.EnvelopeMotion(PANTHEON, kp.Launch.apsides(0.9 * 67.0, 5.0))
    return motion.position(np.linspace(0.0, DAY, MANY))


def measure() -> Section:
    timings = paired({"averaged": averaged, "full": full}, ROUNDS)
    seconds = timings.seconds("averaged"), timings.seconds("full")
    value = timings.ratio("full", "averaged")
    work = "24 h of the Panthéon, averaged"
    ratios = [
        Ratio(work, "full equations", *seconds, value, 200.0, at_least=True),
        Ratio(work, "1 ms", seconds[0], 1e-3, seconds[0] / 1e-3, 1.0),
    ]
    for work, read in (("that day", positions), ("an ideal day at 0.9 l", wide)):
        each = paired({"positions": read}, 3).seconds("positions") / MANY
        work = f"a position of {work}, of {MANY}"
        ratios.append(Ratio(work, "1 µs", each, 1e-6, each / 1e-6, 1.0))
    notes = [
        "The Panthéon: 67 m, a = 3 m, b = 1 cm, half-life 3 h, 1e-5/m of quadratic drag, a "
        "suspension with δ = 1e-6 rad/s. Every call starts from the launch.",
    ]
    return Section("The averaged motion", ratios, (day(), strong()), notes)


def day() -> Table:
    """Largest differences over the day."""
    times = np.linspace(0.0, DAY, 1001)
    mean = kp.EnvelopeMotion(PANTHEON, LAUNCH, **AROUND)
    a, b, azimuth = kp.ellipse(kp.RealMotion(PANTHEON, LAUNCH, **AROUND), times)
    semi_axes, turned = mean.semi_axes(times), mean.azimuth(times) - azimuth
    turned = np.degrees(np.abs((turned + np.pi / 2) % np.pi - np.pi / 2).max())
    rows = [
        ("a, of a", f"{np.abs(semi_axes[:, 0] / a - 1).max():.1e}"),
        ("b, of a", f"{(np.abs(semi_axes[:, 1] - b) / a).max():.1e}"),
        ("azimuth of the plane", f"{turned:.1e}°"),
    ]
    return Table("Largest difference from the full equations in these 24 h:", ("", ""), rows)


def strong() -> Table:
    """Where averaging stops being good."""
    rows = []
    for size in (0.05, 0.3):
        for share in (1e-4, 1e-3, 1e-2, 3e-2, 1e-1):
            rate = share * OMEGA0
            kinds = (
                {"suspension": kp.Suspension(rate, 0.5)},
                {"suspension": kp.Suspension(0.0, 0.0, rate, 0.5), "drag": kp.Drag(rate)},
                {"drag": kp.Drag(0.0, share / size)},
                {
                    "drag": kp.Drag(rate / math.pi),
                    "drive": kp.Drive(share * size * OMEGA0, phase=0.2),
                },
                {"drag": kp.Drag(rate)},
            )
            errors = (f"{apart(size, around):.0e}" for around in kinds)
            rows.append((f"{size:g}", f"{share:g}", *errors))
    head = ("a/l", "share", "δ/ω0", "Δγ/ω0", "c·a", "push/aω0", "γ/ω0")
    caption = (
        f"Largest distance of the bob from the full equations within {SWINGS} swings, as a share "
        f"of a, for one force at a time that changes a swing by this share of itself:"
    )
    return Table(caption, head, rows)


def apart(size: float, around: dict[str, object]) -> float:
    launch = kp.Launch.apsides(size, 0.1 * size)
    times = np.linspace(0.0, SWINGS * 2 * math.pi / OMEGA0, 20 * SWINGS + 1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that they are strong is the point
        mean = kp.EnvelopeMotion(LABORATORY, launch, **around)
    real = kp.RealMotion(LABORATORY, launch, thread="rod", **around)
    distance = np.linalg.norm(mean.position(times) - real.position(times), axis=-1)
    return float((distance / mean.semi_axes(times)[:, 0]).max())
