"""Hand-picked cases at the cone and at the separatrix, from far off to exactly on them."""

from collections.abc import Iterator
from math import cos, nextafter, pi, sqrt

from references.cases.regimes import LONG, SHORT, times
from references.launch import Case

G = 9.80665


def edges() -> Iterator[Case]:
    """All cases of this module."""
    yield from _cones()
    yield from _exact_cones()
    yield from _near_cones()
    yield from _near_separatrix()
    yield from _separatrix()


def _cones() -> Iterator[Case]:
    for n, theta in enumerate(
        (1e-6, 1e-4, 1e-3, 0.01, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.5, 1.55, 1.57)
    ):
        length = 0.6 + 0.7 * n
        state = (theta, 0.5 * n - 3, 0.0, sqrt(G / length / cos(theta)) * (-1) ** n)
        yield Case("conical", length, G, "angles", state, times(length, G, LONG))


def _exact_cones() -> Iterator[Case]:
    """Cones exact in binary64: whole x² + y² + z² = l², gravity z, velocity (−y, x)."""
    for n, (x, y, z) in enumerate(
        (
            (3, 0, 4),
            (4, 0, 3),
            (12, 0, 5),
            (7, 0, 24),
            (1, 2, 2),
            (2, 3, 6),
            (6, 3, 2),
            (1, -4, 8),
            (7, 4, 4),
        )
    ):
        yield _exact_cone(x, y, z, 1.0, (-1) ** n)
    for power, scale in ((10, 17), (20, 37)):
        yield _exact_cone(2 ** (power + 1), 0, 4**power - 1, 2.0**-scale, 1)
    yield _exact_cone(4**6 - 1, 0, 2**7, 2.0**-7, -1)


def _exact_cone(x: int, y: int, z: int, scale: float, sense: int) -> Case:
    length, gravity = sqrt(x * x + y * y + z * z) * scale, z * scale
    state = (x * scale, y * scale, -y * scale * sense + 0.0, x * scale * sense)
    return Case(
        "cone-exact", length, gravity, "plane", state, times(length, gravity, LONG), motion="cone"
    )


def _near_cones() -> Iterator[Case]:
    for n, off in enumerate(
        (1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1)
    ):
        theta, length = (0.02, 0.3, 0.7, 1.1, 1.45)[n % 5], 0.8 + 1.1 * n
        spin = sqrt(G / length / cos(theta)) * (-1) ** n
        state = (
            (theta, 1.0, off * spin, spin)
            if n % 2
            else (theta, 1.0, 0.0, spin * (1 + off * (-1) ** (n // 2)))
        )
        yield Case("near-conical", length, G, "angles", state, times(length, G, SHORT))


def _near_separatrix() -> Iterator[Case]:
    for n, off in enumerate((0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)):
        length = 0.9 + 0.8 * n
        rate = sqrt(G / length)
        yield _near((pi - off, 1.0, 0.0, 0.0), length, G, "plane")
        yield _near(
            (pi - 0.7 * off, -2.0, 0.0, rate * (0.3, -1.0, 5.0)[n % 3]), length, G, "general"
        )
        if n % 2:
            yield _near((0.0, 0.4, 2 * rate * (1 + off), 0.0), length, G, "plane")
            yield _near((1.0, 0.4, 2 * rate * cos(0.5) * (1 - off), 1e-7 * n), length, G, "general")
    for rate in (2 - 1e-12, 2 + 1e-14, nextafter(2, 0), nextafter(2, 3)):
        yield _near((0.0, 0.4, rate, 0.0), 9.75, 9.75, "plane")
    yield _near((0.25, 0.4, 2 * cos(0.125), 1e-12), 9.75, 9.75, "general")


def _near(state: tuple[float, ...], length: float, gravity: float, motion: str) -> Case:
    when = times(length, gravity, (0.0, 0.19, 1.17, 3.4, 12.2))
    return Case("near-separatrix", length, gravity, "angles", state, when, motion=motion)


def _separatrix() -> Iterator[Case]:
    for length, gravity, kind, state in (
        (1.0, 1.0, "plane", (0.0, 0.0, 2.0, 0.0)),
        (9.80665, 9.80665, "angles", (0.0, 0.4, 2.0, 0.0)),
        (0.25, 0.25, "angles", (0.0, -1.0, -2.0, 0.0)),
        (2.5, 2.5, "plane", (0.0, 0.0, 3.0, -4.0)),
        (25.0, 10.0, "plane", (15.0, 0.0, 24.0, 0.0)),
        (25.0, 10.0, "plane", (15.0, 0.0, -24.0, 0.0)),
        (125.0, 50.0, "plane", (45.0, 60.0, 72.0, 96.0)),
        (125.0, 50.0, "plane", (-45.0, 60.0, 72.0, -96.0)),
        (25.0, 10.0, "state", (15.0, 0.0, -20.0, 8.0, 0.0, 6.0)),
        (125.0, 50.0, "state", (45.0, 60.0, -100.0, -24.0, -32.0, -30.0)),
    ):
        when = times(length, gravity, (0.0, 0.11, 0.5, 1.3, 2.7, 4.4))
        yield Case("separatrix", length, gravity, kind, state, when, motion="separatrix")
