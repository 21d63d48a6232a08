"""The series of the motion to a given order."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from kugelpendel.series._orders import Variables, checked_order, checked_variables
from kugelpendel.series._polynomial import Polynomial
from kugelpendel.series._table import names, polynomial


@dataclass(frozen=True)
class Harmonics:
    """The motion as a sum of harmonics whose amplitudes are polynomials.

    With α, β the turning radii over l, and from a highest point on the x axis on (x = αl at t = 0),

        (x + iy)/l = e^{iΩt} Σ plan[n](α, β) e^{inωt},    z/l = 1 − Σ height[n](α, β) cos nωt.

    Attributes
    ----------
    plan
        By n = …, −3, −1, 1, 3, …, to total degree order + 1: n = ±1 is the ellipse of the paper's
        ansatz (20).
    height
        By n = 0, 2, 4, …, to total degree order + 2.

    What is left out is of relative order α^(order+2).
    """

    plan: dict[int, Polynomial]
    height: dict[int, Polynomial]


def frequency(order: int, variables: Variables = "radii") -> Polynomial:
    """ω/ω0, the frequency of the swing, to an even order in the amplitudes.

    Parameters
    ----------
    order
        2, 4, …, 40: the highest total degree. Order 2 is 1 − (α² + β²)/16, the root of the paper's
        (26), ω² = ω0² [1 − (α² + β²)/8], to second order.
    variables
        "radii": the turning radii over l, α and β; "harmonics": a and b of the ellipse that the
        first harmonics make, over l. They differ in third order. β, b < 0 for clockwise motion.

    Raises
    ------
    InvalidInput
        An order that is odd, below 2 or above the limit; other variables.

    Notes
    -----
    Error: that of the terms left out, see `trusted` and docs/series.md; the coefficients are exact.
    """
    order, variables = checked_order(order), checked_variables(variables)
    return polynomial(order, variables, "frequency", order)


def precession(order: int, variables: Variables = "radii") -> Polynomial:
    """Ω/ω0, the turning of the ellipse, to an even order; order 2 is (3/8)αβ, the paper's (25).

    Positive counter-clockwise seen from above; parameters and errors as in `frequency`.
    """
    order, variables = checked_order(order), checked_variables(variables)
    return polynomial(order, variables, "precession", order)


def harmonics(order: int, variables: Variables = "radii") -> Harmonics:
    """The amplitudes of all harmonics over l, to an even order beyond the leading one.

    Parameters and errors as in `frequency`.
    """
    found = all_harmonics(checked_order(order), checked_variables(variables))
    return Harmonics(dict(found.plan), dict(found.height))  # the caller's own


@cache
def all_harmonics(order: int, variables: Variables) -> Harmonics:
    """As `harmonics`, of any even order; not to be changed."""

    def kind(which: str, degree: int) -> dict[int, Polynomial]:
        found = {
            n: polynomial(order, variables, name, degree)
            for n, name in names(order, variables, which).items()
        }
        return {n: amplitude for n, amplitude in found.items() if amplitude.terms}

    return Harmonics(kind("plan", order + 1), kind("height", order + 2))
