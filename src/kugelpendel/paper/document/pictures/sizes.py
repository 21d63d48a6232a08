"""How large each term is that the derivation neglects, beside the pull back to the middle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.notation import read
from kugelpendel.paper.algebra.sympy_names import Expr, diff, sqrt
from kugelpendel.paper.derivation.graph import formula, right
from kugelpendel.paper.document.pictures.drawing import Drawing
from kugelpendel.spelling import general

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.errors import Language
    from kugelpendel.paper.document.example import Example

_PHASES = 24
"""Points of a quarter swing among which the largest value is sought; the others repeat it."""

_FACTORS: dict[str, str] = {
    "16:x": "1",
    "20.8:1": r"\frac{1}{2} \frac{\omega_0^2}{l^2}",
    "20.10:2": r"\frac{1}{l^2}",
    "13a": "1",
    "20.6": r"\frac{x}{l^2}",
    "23.4": "1",
}
"""What each neglected expression is multiplied by where it stands in (13a)."""

_ROOM, _LEFT, _TOP, _DOWN = 300.0, 178.0, 30.0, 34.0


@dataclass(frozen=True)
class Size:
    """The largest value of a term during a swing, divided by that of ω0²x.

    Attributes
    ----------
    label
        The formula whose step neglects it; "" for what makes the ellipse turn.
    ratio
        The share, such as 0.01.
    """

    label: str
    ratio: float


@cache
def sizes(swing: Example) -> tuple[Size, ...]:
    """Work out, for one swing, what (13a) loses on the way, and the term that turns the ellipse."""
    motion = _motion()
    turning = Size("", _largest(-2 * s.b * s.omega0 * s.Omega * _cosine(), swing, motion))
    neglected = (Size(label, _largest(_whole(label), swing, motion)) for label in _FACTORS)
    return tuple(sorted((turning, *neglected), key=lambda one: -one.ratio))


def _whole(label: str) -> Expr:
    return read(_FACTORS[label]).lhs * read(formula(label).step.neglected).lhs


def _cosine() -> Expr:
    return right("18:x").rhs / s.a


def _motion() -> Mapping[Expr, Expr]:
    """Give x, y, ρ and their rates from (16), which is enough for the size of what is small."""
    rules: dict[Expr, Expr] = {}
    for label, letters in (("16:x", (s.x, s.xd)), ("16:y", (s.y, s.yd))):
        value = right(label).rhs
        for letter in letters:
            rules[letter] = value
            value = diff(value, s.t)
    rules[s.rho] = sqrt(rules[s.x] ** 2 + rules[s.y] ** 2)
    return rules


def _largest(term: Expr, swing: Example, motion: Mapping[Expr, Expr]) -> float:
    frequency = swing.natural_frequency
    known = {
        s.a: swing.a,
        s.b: swing.b,
        s.l: swing.length,
        s.omega0: frequency,
        s.omega: swing.frequency,
        s.Omega: swing.turning,
    }
    moving = term.xreplace(motion)
    quarter = math.pi / (2 * frequency)
    values = (
        abs(float(moving.evalf(subs={**known, s.t: quarter * number / _PHASES})))
        for number in range(_PHASES + 1)
    )
    return max(values) / (frequency**2 * swing.a)


def sizes_drawn(
    swing: Example, title: str, description: str, words: Mapping[str, str], language: Language
) -> str:
    """Draw the sizes as bars on a logarithmic scale.

    Parameters
    ----------
    swing
        The motion.
    title, description
        The picture's name and its description.
    words
        What stands before the bars: "pull" for ω0²x, "turning" for what turns the ellipse, and
        "neglected" for the others, after which their number follows.
    language
        German has a decimal comma.
    """
    rows = _rows(swing, words)
    lowest = math.floor(math.log10(min(ratio for _, _, ratio in rows)))
    sheet = Drawing("sizes", 560, _TOP + _DOWN * len(rows) + 12)

    def along(ratio: float) -> float:
        return _ROOM * (1 - math.log10(ratio) / lowest)

    for power in range(lowest, 1):
        x = _LEFT + along(10.0**power)
        sheet.path([(x, _TOP - 6), (x, _TOP + _DOWN * len(rows))], "grid")
        if power % 2 == 0:  # beside each other the longest would touch
            sheet.words((x, _TOP - 12), _share(10.0**power, language), "scale")
    for number, (style, name, ratio) in enumerate(rows):
        y = _TOP + _DOWN * number
        sheet.words((_LEFT - 8, y + 17), name, "row")
        sheet.bar((_LEFT, y + 4), max(along(ratio), 1.5), 18, style)
        sheet.words((_LEFT + along(ratio) + 6, y + 17), _share(ratio, language))
    return sheet.written(title, description)


def sizes_told(swing: Example, words: Mapping[str, str], language: Language) -> str:
    """Say in a sentence what the bars show, for those who do not see them."""
    told = (f"{name} {_share(ratio, language)}" for _, name, ratio in _rows(swing, words))
    return f"{', '.join(told)}."


def _rows(swing: Example, words: Mapping[str, str]) -> list[tuple[str, str, float]]:
    """Give style, name and share of each bar."""
    rows = [("pull", words["pull"], 1.0)]
    for one in sizes(swing):
        if one.label:
            name = f"{words['neglected']} ({one.label.partition(':')[0]})"
            rows.append(("drop", name, one.ratio))
        else:
            rows.append(("kept", words["turning"], one.ratio))
    return rows


def _share(ratio: float, language: Language) -> str:
    """Say a share in per cent to two digits."""
    rounded = float(f"{100 * ratio:.1e}")
    return f"{general(rounded, language=language)} %"
