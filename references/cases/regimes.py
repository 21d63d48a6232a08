"""Drawn cases, by regime, from a seeded generator of their own."""

from collections.abc import Iterator
from math import cos, pi, sin, sqrt
from random import Random

from references.launch import Case

SEED = 20261123
SHORT = (0.0, 0.17, 1.31, 4.9, 12.4)
LONG = (0.0, 0.17, 1.31, 5.3, 31.7, 173.0)


def times(length: float, gravity: float, periods: tuple[float, ...]) -> tuple[float, ...]:
    """Times in s, 6 significant digits, near the given numbers of small-oscillation periods."""
    period = 2 * pi * sqrt(length / gravity)
    return tuple(float(f"{period * n:.6g}") for n in periods)


def pendulum(rng: Random) -> tuple[float, float]:
    """Length 0.1 to 70 m, log-uniform; gravity on the Earth's surface, now and then elsewhere."""
    length = round(0.1 * 700 ** rng.random(), 4)
    elsewhere = rng.random() < 0.15
    return length, rng.choice((1.62, 3.71, 24.79, 274.0)) if elsewhere else round(
        rng.uniform(9.764, 9.834), 5
    )


def drawn() -> Iterator[Case]:
    """All drawn cases, always the same ones."""
    rng = Random(SEED)
    for regime, size, count in (
        ("tiny-1e-9", 1e-9, 10),
        ("tiny-1e-8", 1e-8, 10),
        ("tiny-1e-6", 1e-6, 10),
        ("tiny-1e-4", 1e-4, 10),
        ("small-ellipse", 1e-2, 12),
    ):
        yield from _ellipses(rng, regime, count, size, size)
    yield from _ellipses(rng, "ellipse", 16, 0.1, 0.5)
    yield from _foucault(rng)
    yield from _nearly_planar(rng)
    yield from _over_the_top(rng)
    yield from _spherical(rng, "large", 14, (0.4, 1.5), 1.0, LONG)
    yield from _spherical(rng, "above-equator", 12, (1.6, 2.9), 1.2, SHORT)
    yield from _fast_spin(rng)


def ellipse(
    length: float, gravity: float, a: float, b: float, phase: float, azimuth: float
) -> tuple[float, ...]:
    """Plane state (m, m/s) at a phase of the harmonic ellipse with half-axes a and b (signed)."""
    rate = sqrt(gravity / length)
    x, y, vx, vy = a * cos(phase), b * sin(phase), -a * rate * sin(phase), b * rate * cos(phase)
    c, s = cos(azimuth), sin(azimuth)
    return (x * c - y * s, x * s + y * c, vx * c - vy * s, vx * s + vy * c)


def _ellipses(rng: Random, regime: str, count: int, least: float, most: float) -> Iterator[Case]:
    ratios = (1.0, -1.0, 0.999999, -0.99, 0.5, -0.3, 0.1, -0.01, 1e-4, -1e-6, 1e-8, -1e-8)
    for n in range(count):
        length, gravity = pendulum(rng)
        a = length * least * (most / least) ** rng.random()
        b = a * ratios[n % len(ratios)]
        tilted = n % 3 != 0
        phase, azimuth = (rng.uniform(-pi, pi), rng.uniform(-pi, pi)) if tilted else (0.0, 0.0)
        state = ellipse(length, gravity, a, b, phase, azimuth)
        yield Case(regime, length, gravity, "plane", state, times(length, gravity, LONG))


def _foucault(rng: Random) -> Iterator[Case]:
    for n in range(12):
        length, gravity = round(rng.uniform(3, 70), 3), round(rng.uniform(9.78, 9.83), 5)
        a = length * rng.uniform(0.01, 0.1)
        sideways = (
            7.292115e-5 * sin(rng.uniform(-1.5, 1.5)) * a / sqrt(gravity / length) if n % 2 else 0.0
        )
        b = sideways or a * rng.choice((-1, 1)) * 10 ** rng.uniform(-5, -2)
        state = ellipse(
            length, gravity, a, b, 0.0 if n < 4 else rng.uniform(-pi, pi), rng.uniform(-pi, pi)
        )
        yield Case("foucault", length, gravity, "plane", state, times(length, gravity, LONG))


def _nearly_planar(rng: Random) -> Iterator[Case]:
    for n, phi_rate in enumerate(
        (1e-25, -1e-20, 1e-16, -1e-14, 1e-12, -1e-10, 1e-9, -1e-8, 1e-6, -1e-5, 1e-4, 1e-3)
    ):
        length, gravity = pendulum(rng)
        rate = sqrt(gravity / length)
        theta = rng.uniform(0.3, 1.4) if n % 3 else rng.uniform(1.7, 2.6)
        state = (
            theta,
            rng.uniform(-pi, pi),
            rate * rng.uniform(-0.4, 0.4),
            phi_rate * rng.uniform(1, 3),
        )
        yield Case(
            "nearly-planar",
            length,
            gravity,
            "angles",
            state,
            times(length, gravity, LONG if n % 3 else SHORT),
        )


def _over_the_top(rng: Random) -> Iterator[Case]:
    for n, phi_rate in enumerate(
        (1e-25, -1e-20, 1e-16, -1e-14, 1e-12, -1e-10, 1e-9, -1e-8, 1e-6, -1e-5, 1e-3, -1e-2)
    ):
        length, gravity = pendulum(rng)
        rate = sqrt(gravity / length)
        theta = rng.uniform(0.1, 0.6)
        state = (
            theta,
            rng.uniform(-pi, pi),
            rate * rng.uniform(2.1, 8) * (-1) ** n,
            phi_rate * rng.uniform(1, 3),
        )
        yield Case("over-the-top", length, gravity, "angles", state, times(length, gravity, SHORT))


def _spherical(
    rng: Random,
    regime: str,
    count: int,
    theta: tuple[float, float],
    speed: float,
    periods: tuple[float, ...],
) -> Iterator[Case]:
    for n in range(count):
        length, gravity = pendulum(rng)
        rate = speed * sqrt(gravity / length)
        state = (
            rng.uniform(*theta),
            rng.uniform(-pi, pi),
            rate * rng.uniform(-1, 1),
            rate * rng.uniform(0.05, 1) * (-1) ** n,
        )
        yield Case(regime, length, gravity, "angles", state, times(length, gravity, periods))


def _fast_spin(rng: Random) -> Iterator[Case]:
    for n in range(14):
        length, gravity = pendulum(rng)
        rate = sqrt(gravity / length)
        spin = rate * 10 ** rng.uniform(0.8, 2.2) * (-1) ** n
        state = (rng.uniform(1.2, 1.9), rng.uniform(-pi, pi), rate * rng.uniform(-1, 1), spin)
        yield Case(
            "fast-spin", length, gravity, "angles", state, times(length, gravity, SHORT), check=2
        )
