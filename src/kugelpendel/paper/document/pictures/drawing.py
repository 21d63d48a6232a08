"""The sheet that pictures are drawn on: lines, arrows and formulas as SVG in CSS pixels.

Colours and widths are classes of page.css, so that a picture follows the page into the dark and
onto paper. What a picture tells apart by colour it also tells apart by dashes, width or a word.
"""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.typeset.tex import Accent, Atom, MathList, Script, read

if TYPE_CHECKING:
    from collections.abc import Iterable

    from kugelpendel.paper.typeset.tex import Node

Point = tuple[float, float]

_HEAD = 9.0
"""Length of an arrow's head, px."""

_ARROW = 9
"""How far the arrow of a vector stands back over its letter, px."""


class Drawing:
    """One picture with its name and its description.

    Parameters
    ----------
    key
        What the ids of title and description begin with; unique on the page.
    width, height
        The sheet in px; x goes to the right and y downwards.
    """

    def __init__(self, key: str, width: float, height: float) -> None:
        self._key, self._width, self._height = key, width, height
        self._drawn: list[str] = []

    def path(self, points: Iterable[Point], style: str = "thin") -> None:
        """Draw a line through points."""
        steps = " ".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self._drawn.append(f'<path class="{style}" d="M{steps}"/>')

    def area(self, points: Iterable[Point], style: str) -> None:
        """Fill what points enclose."""
        steps = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self._drawn.append(f'<polygon class="{style}" points="{steps}"/>')

    def arrow(self, points: Iterable[Point], style: str = "thin") -> None:
        """Draw a line through points, with a head at the last."""
        way = list(points)
        tip = way[-1]
        # the head follows the line's direction over its own length, which a bent line changes
        back = next((q for q in reversed(way) if math.dist(q, tip) >= _HEAD * 0.7), way[0])
        angle = math.atan2(tip[1] - back[1], tip[0] - back[0])
        base = (tip[0] - _HEAD * 0.8 * math.cos(angle), tip[1] - _HEAD * 0.8 * math.sin(angle))
        kept = [q for q in way[:-1] if math.dist(q, tip) > _HEAD * 0.8]
        self.path([*kept, base], style)
        sides = (
            (tip[0] - _HEAD * math.cos(angle + turn), tip[1] - _HEAD * math.sin(angle + turn))
            for turn in (0.42, -0.42)
        )
        self.area([tip, *sides], f"head {style}")

    def dot(self, at: Point, radius: float, style: str = "dot") -> None:
        """Draw a filled circle."""
        self._drawn.append(
            f'<circle class="{style}" cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}"/>'
        )

    def bar(self, at: Point, width: float, height: float, style: str) -> None:
        """Draw a filled rectangle from its upper left corner."""
        self._drawn.append(
            f'<rect class="{style}" x="{at[0]:.1f}" y="{at[1]:.1f}" width="{width:.1f}"'
            f' height="{height:.1f}"/>'
        )

    def formula(self, at: Point, latex: str, style: str = "") -> None:
        """Write a short formula with its middle at a point; see `_spans` for what it may hold."""
        self._text(at, "".join(_spans(read(latex))), f"formula-label {style}".strip())

    def words(self, at: Point, text: str, style: str = "") -> None:
        """Write words from a point on."""
        self._text(at, escape(text), f"words {style}".strip())

    def _text(self, at: Point, content: str, style: str) -> None:
        self._drawn.append(
            f'<text class="{style}" x="{at[0]:.1f}" y="{at[1]:.1f}">{content}</text>'
        )

    def written(self, title: str, description: str) -> str:
        """Give the ``svg`` element: an image with a name and a description."""
        key = self._key
        return (
            f'<svg class="drawing" viewBox="0 0 {self._width:g} {self._height:g}"'
            f' width="{self._width:g}" height="{self._height:g}" role="img"'
            f' aria-labelledby="{key}-title" aria-describedby="{key}-desc">'
            f'<title id="{key}-title">{escape(title)}</title>'
            f'<desc id="{key}-desc">{escape(description)}</desc>{"".join(self._drawn)}</svg>'
        )


def arc(
    centre: Point, radius: float, start: float, end: float, flat: float = 1.0, tilt: float = 0.0
) -> list[Point]:
    """Give points on an arc, or on that of an ellipse.

    Parameters
    ----------
    centre, radius
        In px; `radius` is that along the tilted first axis.
    start, end
        The parameter of the ellipse in rad, counter-clockwise as the reader sees it.
    flat
        The second semi-axis divided by the first.
    tilt
        The angle of the first axis in rad, counter-clockwise.
    """
    count = max(int(abs(end - start) / math.radians(4)), 2)
    found: list[Point] = []
    for number in range(count + 1):
        angle = start + (end - start) * number / count
        x, y = radius * math.cos(angle), radius * flat * math.sin(angle)
        found.append(
            (
                centre[0] + x * math.cos(tilt) - y * math.sin(tilt),
                centre[1] - x * math.sin(tilt) - y * math.cos(tilt),
            )
        )
    return found


def _spans(node: Node) -> list[str]:
    """Write a formula of letters, signs, vectors and indices as spans of text."""
    match node:
        case MathList(items):
            return [span for item in items for span in _spans(item)]
        case Atom(kind="identifier", text=text):
            style = "" if text == "Ω" else ' class="letter"'
            return [f"<tspan{style}>{escape(text)}</tspan>"]
        case Atom(text=text):
            return [f"<tspan>{escape(text)}</tspan>"]
        case Accent(base, "\u20d7"):
            # few fonts place the combining arrow, so one is set above the letter
            above = f'<tspan class="vector" dx="-{_ARROW}" dy="-11">→</tspan>'
            return [*_spans(base), above, '<tspan dy="11">\u200b</tspan>']
        case Script(base, below, None) if below is not None:
            low = "".join(_spans(below))
            return [*_spans(base), _shifted(low, 4), '<tspan dy="-4">\u200b</tspan>']
        case _:
            raise ValueError(f"A picture writes letters with arrows and indices only, not {node}.")


def _shifted(spans: str, down: int) -> str:
    return f'<tspan class="low" dy="{down}">{spans}</tspan>'
