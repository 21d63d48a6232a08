"""What one sees from above: the ellipse that turns, and the path of the exact motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from kugelpendel.paper.document.pictures.drawing import Drawing, arc

if TYPE_CHECKING:
    from kugelpendel.paper.document.example import Example
    from kugelpendel.paper.document.pictures.drawing import Point

_TURNED = math.radians(27)
_SHOWN = 7
"""Swings of the path that are drawn."""

_PHASES = 20
"""Points from one turning point to the next."""


def ellipse(title: str, description: str) -> str:
    """Draw the ellipse of (16) at rest, and that of (20) when it has turned by Ωt."""
    sheet = Drawing("ellipse", 480, 300)
    centre, a, flat = (235.0, 158.0), 165.0, 0.42

    def along(angle: float, radius: float) -> Point:
        return (centre[0] + radius * math.cos(angle), centre[1] - radius * math.sin(angle))

    sheet.arrow([along(math.pi, 190), along(0, 222)], "thin")
    sheet.arrow([along(-math.pi / 2, 128), along(math.pi / 2, 140)], "thin")
    sheet.path(arc(centre, a, 0, 2 * math.pi, flat), "dashed")
    sheet.path(arc(centre, a, 0, 2 * math.pi, flat, _TURNED), "strong")
    sheet.path([along(_TURNED + math.pi, a), centre], "accent")
    sheet.path([centre, along(_TURNED, a)], "accent")
    sheet.path([centre, along(_TURNED + math.pi / 2, a * flat)], "accent")
    for start in (0.95, 0.95 + math.pi):
        sheet.arrow(arc(centre, a, start, start + 0.2, flat, _TURNED), "strong")
    sheet.arrow(arc(centre, 0.62 * a, 0, _TURNED), "accent")
    sheet.dot(centre, 2.5)
    sheet.dot(along(_TURNED, a), 6)
    named = [
        (along(0, 232), "x", ""),
        (along(math.pi / 2, 138), "y", ""),
        (along(_TURNED + 0.16, 0.66 * a), "a", "accent"),
        (along(_TURNED + math.pi / 2 + 0.35, 0.7 * a * flat), "b", "accent"),
        (along(_TURNED / 2 - 0.02, 0.62 * a + 20), r"\Omega t", "accent"),
    ]
    for (x, y), latex, style in named:
        right = 12 if latex == "y" else 0
        sheet.formula((x + right, y + 5), latex, style)
    return sheet.written(title, description)


def path(swing: Example, title: str, description: str, words: tuple[str, str]) -> str:
    """Draw the path of an exact motion, with its major axis at the beginning and at the end.

    Parameters
    ----------
    swing
        The motion, from its largest distance on, which is at the right.
    title, description
        The picture's name and its description.
    words
        What stands at the beginning and at the end.
    """
    sheet = Drawing("path", 520, 400)
    centre, scale = (240.0, 200.0), 185.0 / swing.a

    def placed(distance: float, azimuth: float) -> Point:
        return (
            centre[0] + scale * distance * math.cos(azimuth),
            centre[1] - scale * distance * math.sin(azimuth),
        )

    way, end = _way(swing)
    points = [placed(distance, azimuth) for distance, azimuth in way]
    turns = [way[number * 4 * _PHASES] for number in range(_SHOWN + 1)]
    sheet.path(points, "way")
    sheet.arrow(points[8:15], "way")
    sheet.path([placed(swing.a, math.pi), placed(swing.a, 0)], "dashed")
    sheet.path([placed(swing.a, end + math.pi), placed(swing.a, end)], "accent")
    for distance, azimuth in turns:
        sheet.dot(placed(distance, azimuth), 3.5)
    sheet.arrow(arc(centre, scale * swing.a * 1.08, 0.03, end - 0.03), "accent")
    x, y = placed(swing.a, 0)
    sheet.words((x + 8, y + 16), words[0])
    x, y = placed(swing.a, end)
    sheet.words((x - 10, y), words[1], "row accent")
    return sheet.written(title, description)


def _way(swing: Example) -> tuple[list[tuple[float, float]], float]:
    """Give distance and azimuth on the whole path, and the azimuth at its end.

    Simpson's rule from point to point: the error of the whole way is far below the line's width.
    """
    step = math.pi / _PHASES
    rates = [float(swing.azimuth_rate(step * number / 2)) for number in range(2 * _PHASES + 1)]
    quarter = [0.0]
    for number in range(_PHASES):
        first, middle, last = rates[2 * number : 2 * number + 3]
        quarter.append(quarter[-1] + step / 6 * (first + 4 * middle + last))
    distances = [
        swing.length * math.sqrt(1 - float(swing.height(step * number)) ** 2)
        for number in range(_PHASES + 1)
    ]
    way: list[tuple[float, float]] = [(distances[0], 0.0)]
    for number in range(4 * _SHOWN):
        # from the largest distance to the smallest and back, with the same steps in reverse
        is_back = number % 2 == 1
        before = way[-1][1]
        for at in range(1, _PHASES + 1):
            if is_back:
                way.append((distances[-1 - at], before + quarter[-1] - quarter[-1 - at]))
            else:
                way.append((distances[at], before + quarter[at]))
    return way, math.remainder(way[-1][1], 2 * math.pi)
