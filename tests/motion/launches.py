"""Launches of every kind: a gallery of named motions, all limits among them, and random ones.

What a launch means, and its images under the symmetries, are written out here once more in plain
formulas, as judges of the program's own.
"""

from __future__ import annotations

from math import acos, cos, hypot, nextafter, pi, sin, sqrt

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from kugelpendel import ExactMotion, Launch, Pendulum

ROD = Pendulum(1.7, 9.81, mass=2.5)
UNIT = Pendulum(1.0, 1.0)
SWIFT = sqrt(9.81 / 1.7)  # ω0 of the rod

Start = tuple[Pendulum, Launch]
Vector = NDArray[np.float64]
DOWN = np.array([0.0, 0.0, 1.0])


def cone(theta: float, factor: float = 1.0) -> Launch:
    """For the pendulum of unit length and gravity: on a cone, or beside it."""
    return Launch.angles(theta, 0.3, 0.0, factor / sqrt(cos(theta)))


def escape(theta: float, ulps: int, phi_rate: float = 0.0) -> Launch:
    """For the same: upwards with just enough to come to rest on top, and some ulps more or less."""
    rate = 2 * cos(theta / 2)
    for _ in range(abs(ulps)):
        rate = nextafter(rate, 9.0 if ulps > 0 else 0.0)
    return Launch.angles(theta, -0.4, rate, phi_rate)


GALLERY: dict[str, Start] = {
    "hanging": (ROD, Launch.at_rest(0.0)),
    "upright": (UNIT, Launch.state([0.0, 0.0, -1.0], [0.0, 0.0, 0.0])),
    "tiny ellipse": (ROD, Launch.ellipse(3e-12, -1e-12, 2.0)),
    "small ellipse": (ROD, Launch.ellipse(0.01, 0.004, 1.0)),
    "small circle": (ROD, Launch.apsides(1e-6, -1e-6, 1.0)),
    "ellipse": (ROD, Launch.apsides(0.5, 0.2, -2.0)),
    "clockwise ellipse": (ROD, Launch.apsides(0.5, -0.2, 0.4)),
    "narrow ellipse": (ROD, Launch.apsides(0.9, 1e-7)),
    "wide ellipse": (ROD, Launch.apsides(1.69, -1.1, 0.1)),
    "in the plan view": (ROD, Launch.plane(0.3, -1.2, 1.4, 0.9)),
    "libration": (ROD, Launch.at_rest(1.1, 0.7)),
    "quarter": (ROD, Launch.at_rest(pi / 2, 0.7)),
    "libration from above": (ROD, Launch.at_rest(3.0, -2.0)),
    "through the bottom": (ROD, Launch.plane(0.0, 0.0, 3.0, -4.0)),
    "rotation": (ROD, Launch.angles(0.4, 0.3, 3 * SWIFT)),
    "fast rotation": (ROD, Launch.angles(2.0, 0.3, -40 * SWIFT)),
    "over the top": (ROD, Launch.angles(1.0, 0.3, 2.1 * SWIFT, 0.02 * SWIFT)),
    "over the top, clockwise": (ROD, Launch.angles(1.0, 0.3, 2.1 * SWIFT, -0.4 * SWIFT)),
    "almost over the top": (ROD, Launch.angles(2.9, 0.3, 0.5 * SWIFT, 1e-9 * SWIFT)),
    "above the support": (ROD, Launch.angles(2.0, 0.3, 0.1, -3.0 * SWIFT)),
    "fast spin": (ROD, Launch.angles(1.5, 0.3, 0.2, 30 * SWIFT)),
    "cone": (UNIT, Launch.plane(0.6, 0.0, 0.0, 0.6708203932499369)),
    "clockwise cone": (ROD, Launch.apsides(0.8, -0.8, 1.0)),
    "steep cone": (UNIT, cone(1.55)),
    "near cone": (UNIT, cone(0.8, 1 + 1e-9)),
    "near cone below": (UNIT, cone(1.2, 1 - 1e-4)),
    "separatrix": (UNIT, Launch.plane(0.0, 0.0, 2.0, 0.0)),
    "separatrix downwards": (Pendulum(25.0, 10.0), Launch.plane(15.0, 0.0, -24.0, 0.0)),
    "below the separatrix": (UNIT, escape(0.5, -3)),
    "beyond the separatrix": (UNIT, escape(0.5, 3)),
    "beside the separatrix": (UNIT, escape(1.0, 0, 1e-8)),
    "near the separatrix": (UNIT, Launch.angles(1.0, 0.3, 1.7, 0.01)),
    "away from upright": (UNIT, Launch.at_rest(pi, 0.6)),
}


def named(*without: str) -> dict[str, Start]:
    """The gallery without those whose name contains one of the words."""
    return {k: v for k, v in GALLERY.items() if not any(word in k for word in without)}


def launched(pendulum: Pendulum, launch: Launch) -> tuple[Vector, Vector]:
    """Position and velocity at t = 0, m and m/s, by elementary formulas.

    The velocity of "apsides" is NaN: it takes a root of the cubic.
    """
    length, unit = float(pendulum.length), float(pendulum.angular_frequency)
    values = [float(value) for value in launch.values]
    match launch.kind:
        case "ellipse" | "apsides":
            a, b, azimuth = values
            along = np.array([cos(azimuth), sin(azimuth), 0.0])
            across = np.array([-sin(azimuth), cos(azimuth), 0.0])
            speed = b * unit if launch.kind == "ellipse" else float("nan")
            depth = sqrt((length - a) * (length + a))
            return a * along + depth * DOWN, speed * across
        case "plane":
            x, y, vx, vy = values
            radius = hypot(x, y)
            depth = sqrt((length - radius) * (length + radius))
            return np.array([x, y, depth]), np.array([vx, vy, -(x * vx + y * vy) / depth])
        case "angles" | "at_rest":
            theta, phi, theta_rate, phi_rate = (*values, 0.0, 0.0)[:4]
            outward = np.array([cos(phi), sin(phi), 0.0])
            sideways = np.array([-sin(phi), cos(phi), 0.0])
            position = sin(theta) * outward + cos(theta) * DOWN
            polar = cos(theta) * outward - sin(theta) * DOWN
            velocity = theta_rate * polar + sin(theta) * phi_rate * sideways
            return length * position, length * velocity
        case _:
            return np.array(values[:3]), np.array(values[3:])


def _changed(launch: Launch, **signs: str) -> Launch:
    flips = signs[launch.kind]
    values = [-v if flip == "-" else v for v, flip in zip(launch.values, flips, strict=True)]
    return Launch(launch.kind, tuple(values))


def backwards(launch: Launch) -> Launch:
    """The same place, the opposite velocity."""
    return _changed(
        launch,
        ellipse="+-+",
        apsides="+-+",
        plane="++--",
        angles="++--",
        state="+++---",
        at_rest="++",
    )


def mirrored(launch: Launch) -> Launch:
    """y for −y."""
    return _changed(
        launch,
        ellipse="+--",
        apsides="+--",
        plane="+-+-",
        angles="+-+-",
        state="+-++-+",
        at_rest="+-",
    )


def largest_speed(motion: ExactMotion) -> float:
    """m/s, on the whole path."""
    lowest = float(motion.turning_heights[1])
    gravity = float(motion.pendulum.gravity)
    return sqrt(max(2 * (float(motion.energy) - gravity * lowest), 0.0))


def speed_unit(motion: ExactMotion) -> float:
    """m/s: the largest speed, or that of a small swing through the length where this is more."""
    scale = float(motion.pendulum.length) * float(motion.pendulum.angular_frequency)
    return max(largest_speed(motion), scale)


def time_unit(motion: ExactMotion) -> float:
    """s: the time to travel one length, or one radian of a small swing."""
    return float(motion.pendulum.length) / speed_unit(motion)


def powers_of_ten(lowest: float, highest: float) -> st.SearchStrategy[float]:
    """Any magnitude as likely as any other."""
    return st.floats(lowest, highest).map(lambda exponent: 10.0**exponent)


signs = st.sampled_from([-1.0, 1.0])
azimuths = st.floats(-6.28, 6.28)
pendulums = st.builds(Pendulum, powers_of_ten(-3, 4), powers_of_ten(-1, 2), powers_of_ten(-3, 3))
# Of the length, or of a speed or rate: zero, tiny and ordinary ones.
fractions = st.one_of(st.just(0.0), powers_of_ten(-12, -1), st.floats(1e-3, 0.999))
rates = st.builds(float.__mul__, signs, st.one_of(st.just(0.0), powers_of_ten(-12, 0.7)))
# From the downward vertical: small, ordinary, and next to upright.
angles = st.one_of(
    st.just(0.0),
    powers_of_ten(-12, 0),
    st.floats(0.1, pi),
    powers_of_ten(-9, 0).map(lambda rest: pi - rest),
)


@st.composite
def ellipses(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    length = float(pendulum.length)
    return Launch.ellipse(draw(fractions) * length, draw(rates) * length, draw(azimuths))


@st.composite
def apsides(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    outer = draw(fractions) * float(pendulum.length)
    inner = outer * draw(st.one_of(st.sampled_from([0.0, 1.0]), fractions))
    return Launch.apsides(outer, draw(signs) * inner, draw(azimuths))


@st.composite
def plans(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    radius, azimuth = draw(fractions) * float(pendulum.length), draw(azimuths)
    speed = float(pendulum.length) * float(pendulum.angular_frequency)
    velocity = draw(rates) * speed, draw(rates) * speed
    return Launch.plane(radius * cos(azimuth), radius * sin(azimuth), *velocity)


@st.composite
def spherical(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    unit = float(pendulum.angular_frequency)
    return Launch.angles(draw(angles), draw(azimuths), draw(rates) * unit, draw(rates) * unit)


@st.composite
def states(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    height = st.floats(-1.0, 1.0).map(acos)
    theta, phi, course = draw(height), draw(azimuths), draw(azimuths)
    speed = draw(rates) * float(pendulum.length) * float(pendulum.angular_frequency)
    outward = np.array([cos(theta) * cos(phi), cos(theta) * sin(phi), -sin(theta)])
    sideways = np.array([-sin(phi), cos(phi), 0.0])
    position = np.array([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])
    velocity = speed * (cos(course) * outward + sin(course) * sideways)
    return Launch.state(float(pendulum.length) * position, velocity)


@st.composite
def rests(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    return Launch.at_rest(draw(angles), draw(azimuths))


@st.composite
def beside_cones(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    theta = draw(st.floats(1e-3, 1.57))
    rate = float(pendulum.angular_frequency) / sqrt(cos(theta))
    return Launch.angles(theta, draw(azimuths), 0.0, rate * (1 + draw(rates) / 100))


@st.composite
def beside_separatrix(draw: st.DrawFn, pendulum: Pendulum) -> Launch:
    theta, unit = draw(angles), float(pendulum.angular_frequency)
    rate = 2 * unit * cos(theta / 2) * (1 + draw(rates) / 100)
    return Launch.angles(theta, draw(azimuths), rate, unit * draw(rates) / 100)


KINDS = (
    ellipses, apsides, plans, spherical, states, rests, beside_cones, beside_separatrix
)  # fmt: skip


@st.composite
def starts(draw: st.DrawFn) -> Start:
    """A pendulum and a launch of any kind that fits it."""
    pendulum = draw(pendulums)
    return pendulum, draw(draw(st.sampled_from(KINDS))(pendulum))
