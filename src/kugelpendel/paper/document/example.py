"""Numbers for the derivation: a pendulum to build, the Panthéon's, and a swing wide enough to draw.

What follows from a formula is computed from that formula, and what is exact as the proofs compute
it; a test compares it with the core.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import mp, mpf
from kugelpendel.paper.derivation.graph import right
from kugelpendel.paper.proofs.exact import rates, turning_points
from kugelpendel.spelling import degrees, general, significant, spell_rate

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.errors import Language
    from kugelpendel.paper.algebra.sympy_names import Expr
    from kugelpendel.paper.proofs.worlds import Number

_DIGITS = 25
_STARS = 86164.0905
"""Seconds in which the Earth turns once against the stars."""

_DAY = 86400.0


@dataclass(frozen=True)
class Example:
    """An ellipse of a pendulum: how fast it turns by the formulas, and how fast it does exactly.

    Attributes
    ----------
    length, gravity
        In m and m/s².
    a, b
        The largest and the smallest distance from the vertical in m, 0 < b < a < length; the bob
        goes round counter-clockwise.
    """

    length: float
    gravity: float
    a: float
    b: float

    @property
    def natural_frequency(self) -> float:
        """The angular frequency of the smallest swings in rad/s."""
        return math.sqrt(self.gravity / self.length)

    @property
    def turning(self) -> float:
        """The rate of turning by (25) in rad/s."""
        return self._put(right("25").rhs)

    @property
    def frequency(self) -> float:
        """The frequency by (26) in rad/s."""
        return math.sqrt(self._put(right("26").rhs))

    @property
    def exact_turning(self) -> float:
        """The exact rate of turning in rad/s, to the last digit but a few."""
        return self.natural_frequency * float(self._exact_rates[1])

    @property
    def exact_frequency(self) -> float:
        """The exact frequency in rad/s, beside the turning: a quarter period from a to b."""
        return self.natural_frequency * float(self._exact_rates[0])

    def height(self, phase: float) -> Number:
        """Give z/l at a phase: 0 at the largest distance, π at the smallest."""
        low, high, _ = self._turning_points
        return (high + low) / 2 - (low - high) / 2 * mp.cos(phase)

    def azimuth_rate(self, phase: float) -> Number:
        """Give dφ/dphase.

        With u = z/l, energy and angular momentum give u̇² = 2ω0² (u1 − u)(u − u2)(u − u3), and
        u = (u1 + u2)/2 − (u1 − u2)/2 cos(phase) takes the two turning points out of the root.
        """
        low, high, third = self._turning_points
        spin = mp.sqrt(2 * (1 - high) * (1 - low) * (1 - third))
        height = self.height(phase)
        return spin / (mp.sqrt(2 * (height - third)) * (1 - height**2))

    @cached_property
    def _exact_rates(self) -> tuple[Number, Number]:
        """ω and Ω over ω0."""
        with mp.workdps(_DIGITS):
            return rates(*self._radii())

    @cached_property
    def _turning_points(self) -> tuple[Number, Number, Number]:
        return turning_points(*self._radii())

    def _radii(self) -> tuple[Number, Number]:
        return mpf(self.a) / mpf(self.length), mpf(self.b) / mpf(self.length)

    def _put(self, expression: Expr) -> float:
        values = {
            s.a: self.a,
            s.b: self.b,
            s.l: self.length,
            s.omega0: self.natural_frequency,
        }
        return float(expression.evalf(subs=values))


TO_BUILD = Example(2.0, 9.81, 0.20, 0.05)
PANTHEON = Example(67.0, 9.8094, 3.0, 0.01)
LATITUDE = 48.846
"""Of the Panthéon, in degrees."""

WIDE = Example(2.0, 9.81, 1.0, 0.4)


def sky_rate() -> float:
    """Give how fast the Earth turns below the Panthéon's pendulum, in rad/s."""
    return 2 * math.pi / _STARS * math.sin(math.radians(LATITUDE))


@cache
def values(language: Language) -> Mapping[str, str]:
    """Spell every number that the wording may ask for, each under its name, in "de" or "en"."""

    def number(value: float, digits: int = 3) -> str:
        return significant(value, digits, language=language)

    def given(value: float) -> str:
        return general(value, language=language)

    one, paris, wide = TO_BUILD, PANTHEON, WIDE
    minute = math.degrees(1.0) * 60
    period = 2 * math.pi / one.natural_frequency
    ratio = one.exact_turning / one.turning - 1
    slower = 1 - one.frequency / one.natural_frequency
    per_width = paris.turning / paris.b
    return {
        "length": given(one.length),
        "gravity": given(one.gravity),
        "a": given(100 * one.a),
        "b": given(100 * one.b),
        "angle": number(math.degrees(math.asin(one.a / one.length)), 2),
        "frequency": number(one.natural_frequency),
        "period": number(period),
        "push": number(100 * one.b * one.natural_frequency, 2),
        "square": number(100 * (one.a / one.length) ** 2, 1),
        "turning": number(one.turning * minute, 4),
        "turning-share": number(1000 * one.turning / one.natural_frequency, 2),
        "exact-turning": number(one.exact_turning * minute, 4),
        "turning-error": number(100 * ratio, 2),
        "turn-per-swing": number(360 * one.turning / one.frequency, 2),
        "round": number(2 * math.pi / one.turning / 60, 3),
        "slower": number(100 * slower, 2),
        "slower-a-day": number(_DAY * slower, 2),
        "after-four-minutes": number(4 * one.exact_turning * minute, 2),
        "earth-at-most": number(2 * math.pi / _STARS * minute, 2),
        "paris-length": given(paris.length),
        "paris-a": given(paris.a),
        "paris-b": given(100 * paris.b),
        "paris-sky": spell_rate(sky_rate(), 3, language=language).lstrip("+"),
        "paris-turning": spell_rate(paris.turning, 2, language=language).lstrip("+"),
        "paris-exact": spell_rate(paris.exact_turning, 2, language=language).lstrip("+"),
        "paris-alike": number(100 * sky_rate() / per_width, 2),
        "wide-a": given(100 * wide.a),
        "wide-b": given(100 * wide.b),
        "wide-angle": degrees(math.asin(wide.a / wide.length), language=language),
        "wide-turn": number(360 * wide.exact_turning / wide.exact_frequency, 3),
        "wide-turn-25": number(360 * wide.turning / wide.frequency, 3),
    }
