"""Launches of all kinds, as the page's engine takes them and as Python does."""

from typing import Any

import numpy as np

import kugelpendel as kp

COUNT = 216
SEED = 20261126

Given = dict[str, dict[str, Any]]


def drawn() -> list[Given]:
    """Launches by every kind, small and large, slow and fast, on many pendulums."""
    random = np.random.default_rng(SEED)
    kinds = (ellipse, apsides, plane, angles, at_rest, state)
    return [kinds[index % len(kinds)](random) for index in range(COUNT)]


def given(random: np.random.Generator, kind: str, **values: Any) -> Given:
    length = values.pop("length")
    gravity = values.pop("gravity")
    return {
        "pendulum": {"length": length, "gravity": gravity, "mass": random.uniform(0.1, 30.0)},
        "launch": {"kind": kind, **values},
    }


def pendulum(random: np.random.Generator) -> tuple[float, float, float]:
    length = 10 ** random.uniform(-1.0, 2.0)
    gravity = float(random.choice([1.62, 3.71, 9.80665, 24.79]))
    return length, gravity, (gravity / length) ** 0.5


def ellipse(random: np.random.Generator) -> Given:
    length, gravity, _ = pendulum(random)
    a = length * 10 ** random.uniform(-4.0, -0.1)
    b = a * random.uniform(-1.5, 1.5)
    azimuth = random.uniform(-3.0, 3.0)
    return given(random, "ellipse", length=length, gravity=gravity, a=a, b=b, azimuth=azimuth)


def apsides(random: np.random.Generator) -> Given:
    length, gravity, _ = pendulum(random)
    a = length * 10 ** random.uniform(-4.0, -0.02)
    b = a * random.uniform(-1.0, 1.0) * random.choice([1.0, 1e-3])
    return given(random, "apsides", length=length, gravity=gravity, a=a, b=b, azimuth=0.5)


def plane(random: np.random.Generator) -> Given:
    length, gravity, omega = pendulum(random)
    x, y = length * random.uniform(-0.6, 0.6, 2)
    vx, vy = length * omega * random.uniform(-1.0, 1.0, 2)
    return given(random, "plane", length=length, gravity=gravity, x=x, y=y, vx=vx, vy=vy)


def angles(random: np.random.Generator) -> Given:
    length, gravity, omega = pendulum(random)
    theta, phi = random.uniform(0.01, 3.1), random.uniform(-3.0, 3.0)
    rates = omega * random.uniform(-3.0, 3.0, 2)
    return given(
        random, "angles", length=length, gravity=gravity, theta=theta, phi=phi,
        theta_rate=rates[0], phi_rate=rates[1],
    )  # fmt: skip


def at_rest(random: np.random.Generator) -> Given:
    length, gravity, _ = pendulum(random)
    theta, phi = random.uniform(0.01, 3.1), random.uniform(-3.0, 3.0)
    return given(random, "at_rest", length=length, gravity=gravity, theta=theta, phi=phi)


def state(random: np.random.Generator) -> Given:
    length, gravity, omega = pendulum(random)
    place = random.normal(size=3)
    place *= length / np.linalg.norm(place)
    speed = random.normal(size=3)
    speed -= place * (place @ speed) / (place @ place)
    speed *= length * omega * random.uniform(0.1, 2.0)
    return given(
        random, "state", length=length, gravity=gravity,
        position=place.tolist(), velocity=speed.tolist(),
    )  # fmt: skip


def under_forces(cases: list[Given]) -> list[Given]:
    """The same launches, with all that acts on a real pendulum."""
    random = np.random.default_rng(SEED + 1)
    found: list[Given] = []
    for case in cases:
        length = case["pendulum"]["length"]
        omega = (case["pendulum"]["gravity"] / length) ** 0.5
        forces: Given = {
            "site": {"latitude": random.uniform(-1.5, 1.5)},
            "drag": {
                "linear": omega * 10 ** random.uniform(-5.0, -3.0),
                "quadratic": 1e-4 / length,
            },
            "suspension": {
                "anisotropy": omega * 10 ** random.uniform(-6.0, -4.0),
                "axis": random.uniform(-1.5, 1.5),
                "damping_anisotropy": omega * 1e-6,
                "damping_axis": 0.3,
            },
        }
        found.append(case | forces)
    return found


def spoken(case: Given) -> tuple[kp.Pendulum, kp.Launch, kp.Forces]:
    """A case in Python."""
    kinds: dict[str, Any] = {"site": kp.Site, "drag": kp.Drag, "suspension": kp.Suspension}
    parts = {name: kind(**case[name]) for name, kind in kinds.items() if name in case}
    values = dict(case["launch"])
    launch = getattr(kp.Launch, values.pop("kind"))(**values)
    return kp.Pendulum(**case["pendulum"]), launch, kp.Forces(**parts)
