"""Measure the numbers of a page and write them: ``python docs/scripts/real.py docs/real.md``.

Writes the tables of that page anew, and the picture of Guelph's pendulum beside it.
"""

import math
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

import kugelpendel as kp
from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.run.real import averaged_motion, real_motion
from kugelpendel.observables import osculating_ellipse
from kugelpendel.plot._ink import INNER, OUTER, QUIET, STYLE, TEXT
from kugelpendel.spelling import spell

HOUR = 3600.0
DAY = 86400.0
SOLAR = 2 * math.pi / DAY  # rad/s: the turning that two of the published figures are computed with

PANTHEON = math.radians(48 + 52 / 60)  # latitude, as published
PALLINI = math.radians(38.0)
GUELPH = math.radians(43.53)


def hourly(rate: float) -> float:
    """A rate in °/h."""
    return math.degrees(rate) * HOUR


def swing_period(pendulum: kp.Pendulum, amplitude: float) -> float:
    """Of one swing of the full equations from rest, there and back, s."""
    motion = kp.RealMotion(pendulum, kp.Launch.ellipse(amplitude, 0.0))
    outer = motion.events("outer", 0.1, 3 * 2 * math.pi / float(pendulum.angular_frequency))
    return float(outer[2] - outer[0])


def plane_rate(length: float, amplitude: float, latitude: float, duration: float) -> float:
    """Mean rate of the plane of a perfect pendulum that is let go, by the full equations, rad/s."""
    site = kp.Site(latitude)
    pendulum = kp.Pendulum(length, float(site.gravity))
    swings = duration * float(pendulum.angular_frequency) / (2 * math.pi)
    motion = kp.RealMotion(pendulum, kp.Launch.ellipse(amplitude, 0.0), site=site)
    times = motion.events("outer", 0.1, duration)
    assert len(times) > swings
    _, _, azimuth = kp.ellipse(motion, times)
    turned = np.unwrap(azimuth, period=math.pi)
    return float((turned[-1] - turned[0]) / (times[-1] - times[0]))


def published() -> list[tuple[str, str, str, str, str]]:
    """Pendulum, published figure, what this project finds, how, and what had to be assumed."""
    paris = kp.Site(PANTHEON)
    pantheon = kp.Pendulum(67.0, float(paris.gravity))
    rate = plane_rate(67.0, 3.0, PANTHEON, 6 * HOUR)
    turn = 2 * math.pi / abs(rate)
    period = swing_period(pantheon, 3.0)
    longer = 67.0 * (16.5 / period) ** 2
    solar_turn = DAY / math.sin(PANTHEON)
    greece = kp.Pendulum(7.8, float(kp.Site(PALLINI).gravity))
    daily = math.degrees(plane_rate(7.8, 0.4, PALLINI, 6 * HOUR)) * DAY
    crane = plane_rate(0.83, 0.01, GUELPH, 2 * HOUR)
    return [
        ("Panthéon", "16.5 s", spell(period, "s"), "full equations",
         f"67 m to the bob's centre, amplitude 3 m; 16.5 s would take {longer:.1f} m"),
        ("", "11.3 °/h", f"{abs(hourly(rate)):.2f} °/h", "full equations over 6 h",
         "48°52′, no drag, a perfect clamp, clockwise"),
        ("", "31.8 h", f"{turn / HOUR:.2f} h", "from that rate", "the same"),
        ("", "31 h 52 min", clock(solar_turn), "24 h/sin(latitude)",
         "the panel counts the Earth's turn as 24 h, not 23 h 56 min"),
        ("Ellinogermaniki Agogi", "5.6 s", spell(swing_period(greece, 0.4), "s"),
         "full equations", "7.8 m, amplitude 40 cm"),
        ("", "221.64° a day", f"{360 * math.sin(PALLINI):.2f}°", "360° sin(latitude)",
         "38.00°, and again a turn of the Earth in 24 h"),
        ("", "", f"{abs(daily):.2f}°", "full equations over 6 h", "a turn in 23 h 56 min"),
        ("Guelph (Crane)", "10.36 °/h predicted", f"{abs(hourly(crane)):.2f} °/h",
         "full equations over 2 h", "43.53°, 83 cm, amplitude 1 cm, no drag, a perfect clamp"),
    ]  # fmt: skip


def clock(time: float) -> str:
    """Hours and minutes."""
    minutes = round(time / 60)
    return f"{minutes // 60} h {minutes % 60} min"


def published_table() -> str:
    """Published figures and what this project finds."""
    return table(["pendulum", "published", "found", "by", "assumed"], published())


def puiseux() -> tuple[float, float, float]:
    """3RV/(8l²) and (25), rad/s, and the exact precession, for R = 3 m, b = 1 cm on 67 m."""
    pendulum = kp.Pendulum(67.0, 9.81)
    sideways = 0.01 * float(pendulum.angular_frequency)
    exact = kp.ExactMotion(pendulum, kp.Launch.apsides(3.0, 0.01))
    by_25 = float(kp.olsson.precession(3.0, 0.01, 67.0, 9.81))
    return 3 * 3.0 * sideways / (8 * 67.0**2), by_25, float(exact.precession)


def plane_series(angle: float) -> tuple[float, float]:
    """1 + θ²/16 + 11θ⁴/3072 and the exact period over that of small swings."""
    pendulum = kp.Pendulum(1.0, 9.81)
    exact = kp.ExactMotion(pendulum, kp.Launch.at_rest(angle))
    ratio = float(pendulum.angular_frequency) / float(exact.frequency)
    return 1 + angle**2 / 16 + 11 * angle**4 / 3072, ratio


def formulas_table() -> str:
    """The two formulas of that list, in numbers."""
    by_puiseux, by_25, exact = puiseux()
    rows = [
        ("Puiseux, 3RV/(8l²)", f"{hourly(by_puiseux):.6f} °/h", f"(25): {hourly(by_25):.6f} °/h",
         f"exact: {hourly(exact):.6f} °/h"),
    ]  # fmt: skip
    for degrees in (10, 30, 60):
        series, exact = plane_series(math.radians(degrees))
        rows.append(
            (f"1 + θ²/16 + 11θ⁴/3072 at {degrees}°", f"{series:.8f}", "", f"exact: {exact:.8f}")
        )
    return table(["formula", "", "", ""], rows)


@dataclass(frozen=True)
class Modulation:
    """How fast a plane turns once it has settled, °/h, and how often it hurries."""

    least: float
    mean: float
    most: float
    between: tuple[float, ...]
    """Hours from one maximum of the speed to the next."""


SETTLING = 10 * HOUR  # until the way the pendulum started is forgotten
WATCHED = 26 * HOUR


@dataclass(frozen=True)
class Guelph:
    """A pendulum of 83 cm in Guelph, its clamp, and where it is pushed."""

    anisotropy: float  # rad/s
    damping_anisotropy: float = 0.0  # 1/s
    mistimed: float = 1.0  # phase of the push over that which cancels the intrinsic precession
    amplitude: float = 0.03  # m
    decay: float = 1e-3  # 1/s
    axis: float = 0.3  # rad

    @property
    def site(self) -> kp.Site:
        """Where."""
        return kp.Site(GUELPH)

    @property
    def pendulum(self) -> kp.Pendulum:
        """83 cm, 4.5 kg."""
        return kp.Pendulum(0.83, float(self.site.gravity), 4.5)

    @property
    def drive(self) -> kp.Drive:
        """Keeps the amplitude; physics of the phase: tan 2φ = 8l²/(3Qa²)."""
        quality = float(self.pendulum.angular_frequency) / (2 * self.decay)
        right = math.atan(8 * 0.83**2 / (3 * quality * self.amplitude**2)) / 2
        phase = self.mistimed * right
        return kp.Drive(math.pi * self.decay * self.amplitude / math.cos(phase), phase=phase)

    def motion(self, kind: type[kp.EnvelopeMotion] | type[kp.RealMotion]):
        """Averaged or in full."""
        clamp = kp.Suspension(self.anisotropy, self.axis, self.damping_anisotropy, self.axis)
        launch = kp.Launch.ellipse(self.amplitude, 0.0)
        return kind(
            self.pendulum, launch, site=self.site, drag=kp.Drag(self.decay), suspension=clamp,
            drive=self.drive,
        )  # fmt: skip

    def speed(self, times: np.ndarray) -> np.ndarray:
        """Of the plane, °/h, clockwise positive as in the northern hemisphere; averaged."""
        rates = self.motion(kp.EnvelopeMotion).rates(times)
        causes = (rates.earth, rates.intrinsic, rates.anisotropy, rates.damping, rates.drive)
        return -np.degrees(sum(causes)) * HOUR

    def modulation(self) -> Modulation:
        """What an observer would write down."""
        times = np.linspace(SETTLING, SETTLING + WATCHED, 2001)
        speed = self.speed(times)
        peaks = np.flatnonzero((speed[1:-1] > speed[:-2]) & (speed[1:-1] >= speed[2:])) + 1
        between = tuple(np.diff(times[peaks]) / HOUR)
        return Modulation(float(speed.min()), float(speed.mean()), float(speed.max()), between)


CANDIDATES = (
    Guelph(1e-4),
    Guelph(1.3e-4),
    Guelph(1.6e-4),
    Guelph(2e-4),
    Guelph(1.6e-4, mistimed=0.95),
    Guelph(1.6e-4, mistimed=1.05),
    Guelph(0.0, damping_anisotropy=7.3e-6),
    Guelph(1.5e-4, damping_anisotropy=3e-6),
)
"""Of the search: a clamp uneven in stiffness, in damping or both, pushed well or not."""

FOUND = CANDIDATES[-1]


def search_table() -> str:
    """What the candidates do."""
    rows = []
    for pendulum in CANDIDATES:
        seen = pendulum.modulation()
        rows.append(
            (
                f"{pendulum.anisotropy:.1e}".replace("e-0", "e−") if pendulum.anisotropy else "0",
                f"{pendulum.damping_anisotropy:.1e}".replace("e-0", "e−")
                if pendulum.damping_anisotropy
                else "0",
                f"{100 * (pendulum.mistimed - 1):+.0f} %".replace("-", "−")
                if pendulum.mistimed != 1
                else "right",
                f"{seen.least:.2f} … {seen.most:.2f}",
                f"{seen.mean:.2f}",
                ", ".join(f"{hours:.1f}" for hours in seen.between[:2]) or "longer",
            )
        )
    head = ["δ, rad/s", "Δγ, 1/s", "phase of the push", "speed, °/h", "mean", "h between maxima"]
    return table(head, rows)


def measured_speed(pendulum: Guelph, duration: float, window: float) -> tuple[np.ndarray, ...]:
    """Times, h, and speeds, °/h, by the full equations, each over a window in s."""
    times = pendulum.motion(kp.RealMotion).events("outer", 0.1, duration)
    x, y, _ = pendulum.motion(kp.RealMotion).position(times).T
    azimuth = np.unwrap(np.arctan2(y, x), period=math.pi)
    edges = np.arange(0.0, times[-1], window)
    turned = np.interp(edges, times, azimuth)
    return (edges[1:] + edges[:-1]) / 2 / HOUR, -np.degrees(np.diff(turned)) / window * HOUR


def draw(path: Path) -> None:
    """The speed of the plane of that pendulum over a day and a half, averaged and in full."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(8.5, 3.8), layout="constrained")
        axes = figure.subplots()
        end = SETTLING + WATCHED
        times = np.linspace(0.0, end, 600)
        axes.plot(times / HOUR, FOUND.speed(times), color=INNER, linewidth=1.6, label="averaged")
        hours, speed = measured_speed(FOUND, end, HOUR)
        axes.plot(
            hours, speed, "o", color=TEXT, markersize=3.5, label="full equations, hour by hour"
        )
        ideal = abs(hourly(float(FOUND.site.vertical_rotation)))
        axes.axhline(
            ideal, color=OUTER, linestyle="--", linewidth=1.3, label=r"$Ω_\mathrm{E}$ sin(latitude)"
        )
        for level in (9.5, 11.0):
            axes.axhline(level, color=QUIET, linestyle=":", linewidth=1.2)
        axes.plot([], [], ":", color=QUIET, label="range published for Guelph")
        axes.set(
            xlim=(0, end / HOUR), xlabel="time (h)", ylabel="speed of the plane, clockwise (°/h)",
            title="A pendulum of 83 cm, modulated like Guelph's",
        )  # fmt: skip
        axes.legend(ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.2), frameon=False)
        figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    text = re.sub(r"\n +", "\n", path.read_text(encoding="utf-8"))
    path.write_text(text, encoding="utf-8")


def table(head: list[str], rows: list[tuple[str, ...]]) -> str:
    """In Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


EXAMPLES = ("pantheon-day", "museum", "short", "short-remedy", "guelph")
AMPLITUDES = (0.05, 0.1, 0.2, 0.4, 0.6, 0.8)  # of the length


def apart(
    averaged: kp.EnvelopeMotion, full: Callable[[], kp.RealMotion], duration: float
) -> tuple[float, float, float, float]:
    """Largest differences of azimuth, °, and of a and b over a; and half of the last swing, m."""
    times = full().events("outer", 0.0, duration)
    position, velocity = full().position(times), full().velocity(times)
    site = averaged.site
    turn = 0.0 if site is None else site.vertical_rotation
    seen = osculating_ellipse(position, velocity, averaged.effective_pendulum, turn, times)
    a, b, azimuth = seen
    mean_a, mean_b = averaged.semi_axes(times).T
    off = np.degrees(azimuth - averaged.azimuth(times))
    off -= 180 * np.round(off[0] / 180)
    return (
        float(np.abs(off).max()), float(np.abs(a / mean_a - 1).max()),
        float((np.abs(b - mean_b) / mean_a).max()), float(a[-1]),
    )  # fmt: skip


def examples_table() -> str:
    """How far the averaged equations are from the full ones in the examples."""
    rows = []
    for name in EXAMPLES:
        job = read_job(Path(__file__).parents[2] / "examples" / f"{name}.toml")
        found = apart(averaged_motion(job), lambda job=job: real_motion(job), job.grid.duration)
        hours = f"{job.grid.duration / HOUR:g} h"
        rows.append((f"`{name}.toml`", hours, *(shown(value) for value in found[:3])))
    return table(["example", "over", "azimuth, °", "a, of a", "b, of a"], rows)


def amplitudes_table() -> str:
    """The same for a pendulum of 1 m of any amplitude: free, then with a drive that keeps it."""
    rows = []
    site, clamp = kp.Site(math.radians(48)), kp.Suspension(3e-5, 0.5, 2e-5, 0.9)
    pendulum = kp.Pendulum(1.0, float(site.gravity))
    for amplitude in AMPLITUDES:
        cells: list[str] = []
        for decay, push in ((1e-4, 0.0), (1e-4, math.pi * 1e-4 * amplitude / math.cos(0.3))):
            forces = {
                "site": site,
                "suspension": clamp,
                "drag": kp.Drag(decay),
                "drive": kp.Drive(push, phase=0.3) if push else None,
            }
            launch = kp.Launch.ellipse(amplitude, 0.1 * amplitude)

            def full(launch: kp.Launch = launch, forces: dict = forces) -> kp.RealMotion:
                return kp.RealMotion(pendulum, launch, **forces)

            found = apart(kp.EnvelopeMotion(pendulum, launch, **forces), full, HOUR)
            cells += [shown(value) for value in found[:3]]
        rows.append((f"{amplitude:g} l", *cells))
    head = ["amplitude", "azimuth, °", "a, of a", "b, of a"]
    return table([*head, "driven: azimuth, °", "a, of a", "b, of a"], rows)


def shown(value: float) -> str:
    """Two digits, or all before the point."""
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.1e}".replace("e-0", "e−") if value < 1e-3 else f"{value:.2g}"


PARTS = {
    "examples": examples_table,
    "amplitudes": amplitudes_table,
    "published": published_table,
    "formulas": formulas_table,
    "search": search_table,
}


def written(page: str) -> str:
    """The page with its tables made anew."""
    for name, part in PARTS.items():
        page = re.sub(
            rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
            lambda found, part=part: f"{found[1]}{part()}\n{found[2]}",
            page,
            flags=re.DOTALL,
        )
    return page


if __name__ == "__main__":
    page = Path(sys.argv[1])
    page.write_text(written(page.read_text(encoding="utf-8")), encoding="utf-8")
    draw(page.with_name("guelph.svg"))
