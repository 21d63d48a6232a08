"""How good (25), (26) and C12 are at some amplitudes: compared with the integrals C8 and C9."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import Expr, mp, mpf
from kugelpendel.paper.derivation.graph import right
from kugelpendel.paper.proofs.exact import turning_points
from kugelpendel.paper.proofs.worlds import DIGITS, Number, World

ANGLES = (5, 10, 30)
"""The largest inclinations that are compared, in degrees."""

RATIO = 4
"""How many times the longer axis of the ellipse is as long as the shorter one."""


@dataclass(frozen=True)
class Accuracy:
    """What the formulas say at one amplitude, and by what share they are off.

    Attributes
    ----------
    degrees
        The largest inclination; the ellipse is `RATIO` times as long as it is wide, both measured
        as distances from the vertical at the turning points.
    turning, exact
        Ω/ω0 by (25), and by the integrals.
    error_25, error_c12
        The shares by which (25) and C12 are off; negative where they are low.
    error_26
        The share by which ω is off by (26).
    """

    degrees: int
    turning: Number
    exact: Number
    error_25: Number
    error_c12: Number
    error_26: Number


@cache
def accuracy(degrees: int) -> Accuracy:
    """Compare the formulas with the integrals, in more than 50 digits."""
    with mp.workdps(DIGITS):
        alpha = mp.sin(mp.radians(degrees))
        world = swing(alpha, alpha / RATIO)
        frequency, exact = measured(world)
        turning, better, square = (world.value(right(k).rhs) for k in ("25", "C12", "26"))
        return Accuracy(
            degrees,
            turning,
            exact,
            turning / exact - 1,
            better / exact - 1,
            mp.sqrt(square) / frequency - 1,
        )


def swing(alpha: Number, beta: Number) -> World:
    """The pendulum with l and g as units, between two turning radii."""
    roots = turning_points(alpha, beta)
    moment = 2 * (1 - roots[0]) * (1 - roots[1]) * (1 - roots[2])
    constants: dict[Expr, Number] = {
        s.l: mpf(1), s.g: mpf(1), s.omega0: mpf(1), s.a: alpha, s.b: beta,
        s.alpha: alpha, s.beta: beta, s.h: mp.sign(beta) * mp.sqrt(moment),
        s.u_1: roots[0], s.u_2: roots[1], s.u_3: roots[2],
    }  # fmt: skip
    return World(constants, {})


def measured(world: World) -> tuple[Number, Number]:
    """ω and Ω by the integrals of C8 and C9, a half swing and what is gone through in it."""
    (time,), (azimuth,) = (right(label).integrals for label in ("C8", "C9"))
    half, turned = 2 * world.value(time), 2 * world.value(azimuth)
    return mp.pi / half, mp.sign(turned) * (abs(turned) - mp.pi) / half
