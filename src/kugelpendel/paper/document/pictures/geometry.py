"""The pendulum in space: angles, lengths, unit vectors and the two forces."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.paper.document.pictures.drawing import Drawing

if TYPE_CHECKING:
    from kugelpendel.paper.document.pictures.drawing import Point

Vector = tuple[float, float, float]

_SCALE = 245.0  # px for the length of the thread
_SUPPORT = (215.0, 58.0)
_TURNED, _RAISED = math.radians(28), math.radians(17)
"""From where one looks: turned from the x axis, and raised above the horizon."""

_THETA, _PHI = math.radians(40), math.radians(62)
_UNIT, _FORCE = 0.30, 0.42  # of the thread's length


def geometry(title: str, description: str) -> str:
    """Draw the pendulum with what (1) to (6) call by name."""
    sheet = Drawing("geometry", 480, 420)
    sine, cosine = math.sin(_THETA), math.cos(_THETA)
    outwards = (math.cos(_PHI), math.sin(_PHI), 0.0)
    bob = (sine * outwards[0], sine * outwards[1], cosine)
    below = (0.0, 0.0, cosine)
    level = [_around(angle, sine, cosine) for angle in range(0, 361, 4)]
    sheet.path([_seen(q) for q in level], "dashed")
    sheet.area([_seen(below), *(_seen(_around(q, sine, cosine)) for q in range(0, 63, 2))], "pale")
    sheet.arrow([_seen((0, 0, 0)), _seen((0, 0, 1.28))], "thin")
    sheet.arrow([_seen((0, 0, 0)), _seen((0.62, 0, 0))], "thin")
    sheet.arrow([_seen((0, 0, 0)), _seen((0, 0.62, 0))], "thin")
    sheet.path([_seen(below), _seen((sine, 0, cosine))], "dashed")
    sheet.path([_seen(below), _seen(bob)], "accent")
    sheet.arrow([_seen(_around(q, 0.55 * sine, cosine)) for q in range(0, 63, 2)], "accent")
    polar = [_leaning(math.radians(q), 0.36) for q in range(0, 41, 2)]
    sheet.arrow([_seen(q) for q in polar], "accent")
    sheet.path([_seen((0, 0, 0)), _seen(bob)], "thread")
    radial = bob
    polar_unit = (cosine * outwards[0], cosine * outwards[1], -sine)
    azimuthal = (-outwards[1], outwards[0], 0.0)
    for unit in (radial, polar_unit, azimuthal):
        sheet.arrow([_seen(bob), _seen(_plus(bob, unit, _UNIT))], "unit")
    sheet.arrow([_seen(bob), _seen(_plus(bob, radial, -_FORCE))], "force")
    sheet.arrow([_seen(bob), _seen(_plus(bob, (0, 0, 1), _FORCE))], "force")
    sheet.dot(_seen((0, 0, 0)), 4)
    sheet.dot(_seen(bob), 9)
    named: list[tuple[Vector, float, float, str, str]] = [
        ((0, 0, 1.28), -13, 4, "z", ""),
        ((0.62, 0, 0), -12, 10, "x", ""),
        ((0, 0.62, 0), 13, 6, "y", ""),
        (_plus((0, 0, 0), bob, 0.42), 12, -6, "l", ""),
        (_leaning(_THETA / 2, 0.36), 1, 20, r"\theta", "accent"),
        (_around(24, 0.55 * sine, cosine), -8, 19, r"\phi", "accent"),
        (_plus(below, outwards, 0.60 * sine), 4, -9, r"\rho", "accent"),
        (_plus(bob, radial, _UNIT), 20, 6, r"\vec{e}_r", "unit"),
        (_plus(bob, polar_unit, _UNIT), 20, 0, r"\vec{e}_\theta", "unit"),
        (_plus(bob, azimuthal, _UNIT), 18, -8, r"\vec{e}_\phi", "unit"),
        (_plus(bob, radial, -_FORCE), 14, -6, "T", "force"),
        (_plus(bob, (0, 0, 1), _FORCE), 20, 4, "mg", "force"),
    ]
    for place, right, down, latex, style in named:
        x, y = _seen(place)
        sheet.formula((x + right, y + down), latex, style)
    return sheet.written(title, description)


def _around(degrees: float, radius: float, depth: float) -> Vector:
    angle = math.radians(degrees)
    return (radius * math.cos(angle), radius * math.sin(angle), depth)


def _leaning(angle: float, radius: float) -> Vector:
    """Give a point of the plane through the vertical and the bob."""
    sine = radius * math.sin(angle)
    return (sine * math.cos(_PHI), sine * math.sin(_PHI), radius * math.cos(angle))


def _plus(start: Vector, step: Vector, length: float) -> Vector:
    x, y, z = (a + length * b for a, b in zip(start, step, strict=True))
    return (x, y, z)


def _seen(place: Vector) -> Point:
    """Look at a point from far away: x to the front left, y to the right, z down."""
    x, y, z = place
    right = y * math.cos(_TURNED) - x * math.sin(_TURNED)
    behind = -(x * math.cos(_TURNED) + y * math.sin(_TURNED))
    down = z * math.cos(_RAISED) - behind * math.sin(_RAISED)
    return (_SUPPORT[0] + _SCALE * right, _SUPPORT[1] + _SCALE * down)
