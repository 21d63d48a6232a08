"""Hand-picked cases: the limits of the motion, many of them exact in binary64."""

from collections.abc import Iterator
from math import nextafter, pi, sqrt

from references.cases.regimes import LONG, SHORT, ellipse, times
from references.launch import Case

G = 9.80665


def picked() -> Iterator[Case]:
    """All hand-picked cases."""
    yield from _from_rest()
    yield from _through_bottom()
    yield from _rotation()
    yield from _at_turning_points()
    yield from _exact_points()
    yield from _still()
    yield from _long()


def _case(
    regime: str,
    length: float,
    kind: str,
    state: tuple[float, ...],
    gravity: float = G,
    motion: str = "general",
    periods: tuple[float, ...] = SHORT,
    check: float = 6.0,
) -> Case:
    when = times(length, gravity, periods)
    return Case(regime, length, gravity, kind, state, when, motion, check)


def _from_rest() -> Iterator[Case]:
    for n, theta in enumerate(
        (1e-6, 1e-4, 1e-3, 0.01, 0.1, -0.3, 0.7, 1.0, 1.4, pi / 2, 1.8, 2.3, 2.8, 3.0, 3.1)
    ):
        yield _case(
            "from-rest",
            0.5 + 1.3 * n,
            "angles",
            (theta, 0.4 * n - 2, 0.0, 0.0),
            motion="plane",
            periods=LONG,
        )


def _through_bottom() -> Iterator[Case]:
    for n, fraction in enumerate((1e-9, 1e-6, 1e-3, 0.1, 0.7, 1.2, 1.6, 1.9)):
        length = 0.3 + 2.1 * n
        speed = fraction * sqrt(G * length)
        state = (0.0, 0.0, speed, 0.0) if n % 2 else (0.0, 0.0, -0.75 * speed, 0.5 * speed)
        yield _case("planar-through-bottom", length, "plane", state, motion="plane", periods=LONG)
        if n >= 4:
            state = (0.0, 0.3 * n, fraction * sqrt(G / length), 0.0)
            yield _case("planar-through-bottom", length, "angles", state, motion="plane")
    for scale in (1.0, -2.0):
        state = (0.375, 0.5, 0.75 * scale, 1.0 * scale)
        yield _case("planar-through-bottom", 2.0, "plane", state, motion="plane")


def _rotation() -> Iterator[Case]:
    for n, fraction in enumerate((2.01, 2.1, -2.5, 3.0, -5.0, 12.0, 40.0)):
        length = 0.4 + 0.9 * n
        state = (0.0, 0.5 * n, fraction * sqrt(G / length), 0.0)
        yield _case("planar-rotation", length, "angles", state, motion="plane")
    for n, theta in enumerate((0.3, 1.5, 2.5, 3.1)):
        state = (theta, 2.0 - n, -1.5 - n, 0.0) if theta > 1 else (theta, 2.0, 7.0, 0.0)
        yield _case("planar-rotation", 5.0, "angles", state, gravity=2.0, motion="plane")
    for velocity in ((1.0, 0.0, 0.0), (-0.001, 0.0, 0.0), (0.0, 8.0, 0.0), (3.0, -4.0, 0.0)):
        yield _case("planar-rotation", 2.0, "state", (0.0, 0.0, -2.0, *velocity), motion="plane")


def _at_turning_points() -> Iterator[Case]:
    for n, (theta, fraction) in enumerate(
        (
            (1e-3, 0.5),
            (0.3, 0.9),
            (1.2, -0.2),
            (1.2, 1.7),
            (1.5, -3.0),
            (2.0, 0.4),
            (2.9, -1.0),
            (0.01, -2.0),
        )
    ):
        length = 0.7 + n
        state = (theta, 0.3 * n - 1, 0.0, fraction * sqrt(G / length))
        yield _case("turning-point", length, "angles", state)
    for n, (a, b) in enumerate(((0.3, 0.01), (0.01, -0.3), (0.6, 0.6), (0.05, 0.005))):
        length = 1.0 + n
        state = ellipse(length, G, a * length, b * length, 0.0, 0.0)
        yield _case("turning-point", length, "plane", state, periods=LONG)


def _exact_points() -> Iterator[Case]:
    for x, y, z in ((2, 3, -6), (6, -2, -3), (4, 4, -7), (-1, 8, -4)):
        length = sqrt(x * x + y * y + z * z)
        velocity = (-y + 0.0, x - z * 0.5, 0.5 * y)
        yield _case("above-equator", length, "state", (float(x), float(y), float(z), *velocity))
    for x, y, z in ((2, 3, 6), (0, 4, -3)):
        length = sqrt(x * x + y * y + z * z)
        state = (float(x), float(y), float(z), 0.25 * z, 0.0, -0.25 * x)
        yield _case("large", length, "state", state, periods=LONG)


def _still() -> Iterator[Case]:
    yield _case("rest", 1.0, "angles", (0.0, 0.7, 0.0, 0.0), motion="rest")
    yield _case("rest", 67.0, "plane", (0.0, 0.0, 0.0, 0.0), motion="rest")
    yield _case("rest", 0.1, "state", (0.0, 0.0, 0.1, 0.0, 0.0, 0.0), motion="rest")
    yield _case("upright", 1.0, "state", (0.0, 0.0, -1.0, 0.0, 0.0, 0.0), motion="upright")
    yield _case(
        "upright", 67.3, "state", (0.0, 0.0, -67.3, 0.0, 0.0, 0.0), gravity=1.62, motion="upright"
    )
    falling = (0.0, 0.05, 0.5, 2.0, 4.0)
    yield _case("near-upright", 1.0, "angles", (pi, 0.0, 0.0, 0.0), motion="plane", periods=falling)
    yield _case(
        "near-upright",
        3.0,
        "angles",
        (nextafter(pi, 4), 1.0, 0.0, 0.0),
        motion="plane",
        periods=falling,
    )
    yield _case("near-upright", 3.0, "angles", (pi, 1.0, 0.0, 0.3), periods=falling)


def _long() -> Iterator[Case]:
    far = (0.0, 97.3, 1500.0, 1e4, 1e6, 1e9)
    for n, (a, b, check) in enumerate(
        (
            (1e-8, 1e-8, 1e4),
            (1e-8, -1e-9, 100),
            (1e-5, 3e-6, 1e4),
            (0.01, -0.002, 2e3),
            (0.3, 0.1, 300),
        )
    ):
        length = 2.0 + 7 * n
        state = ellipse(length, G, a * length, b * length, 0.1 * n, 0.5 * n)
        yield _case("long", length, "plane", state, periods=far, check=check)
    yield _case(
        "long", 67.0, "plane", (3.0, 0.0, 0.0, 0.01), gravity=9.8094, periods=far, check=100
    )
    yield _case("long", 1.0, "angles", (2.2, 0.3, 0.4, -0.9), periods=far, check=100)
    yield _case("long", 1.0, "angles", (1.0, 0.3, 0.0, 0.0), periods=far, motion="plane", check=100)
    yield _case("long", 1.0, "angles", (0.0, 0.3, 9.0, 0.0), periods=far, motion="plane", check=100)
    yield _case("long", 1.5, "angles", (1.3, 0.3, 0.1, 21.0), periods=far, check=100)
