"""The exact motion between its turning points, as numbers: rates by Carlson's elliptic integrals.

The formulas for them are integrals over u; here the same rates come from Legendre's forms, which
mpmath computes by Carlson's duplication and not by quadrature. tests/paper compares them with the
library's exact motion.
"""

from __future__ import annotations

from functools import cache
from random import Random

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import Expr, mp, mpf
from kugelpendel.paper.proofs.worlds import DIGITS, Number, Path, World, circles, common, draw


def rates(alpha: Number, beta: Number) -> tuple[Number, Number]:
    """ω/ω0 and Ω/ω0 between the turning radii α, β, over the length; β has the sign of the sense.

    With the heights s = 1 − u of the turning points, s_b ≤ s_a ≤ s_c, T the time from one highest
    point to the next and ΔΦ the azimuth gone through in it: ω = π/T and Ω = (ΔΦ − π)/T.
    """
    roots = turning_points(alpha, beta)
    low, high, third = (1 - root for root in roots)
    width = mp.sqrt((third - low) / 2)
    m = (high - low) / (third - low)
    momentum = abs(alpha * beta) * mp.sqrt(2 / (roots[0] + roots[1]))
    time = 2 * mp.ellipk(m) / width
    parts = (
        mp.ellippi(-(high - low) / low, m) / low,
        mp.ellippi((high - low) / (2 - low), m) / (2 - low),
    )
    angle = momentum / width * mp.fsum(parts)
    return mp.pi / time, mp.sign(beta) * (angle - mp.pi) / time


def turning_points(alpha: Number, beta: Number) -> tuple[Number, Number, Number]:
    """u1, u2 of the lowest and highest points, and the third zero u3, for the turning radii."""
    lowest, highest = mp.sqrt(1 - beta**2), mp.sqrt(1 - alpha**2)
    return lowest, highest, -(1 + lowest * highest) / (lowest + highest)


@cache
def swinging(seed: int, exponent: int = 0) -> World:
    """A moment of the exact motion between two turning radii, scaled by ε = 10^−exponent."""
    with mp.workdps(DIGITS + 8 * exponent):  # as many as any order asks for
        return _swinging(Random(f"swinging {seed}"), exponent)


def _swinging(rng: Random, exponent: int) -> World:
    constants = common(rng)
    eps = mpf(10) ** (-exponent)
    alpha = eps * draw(rng, 0.6, 0.8)
    beta = eps * draw(rng, 0.25, 0.45) * rng.choice((1, -1))
    length = constants[s.l]
    constants[s.omega0] = rate = mp.sqrt(constants[s.g] / length)
    roots = turning_points(alpha, beta)
    swing, turning = rates(alpha, beta)
    momentum = rate * alpha * beta * mp.sqrt(2 / (roots[0] + roots[1]))
    constants |= {
        s.alpha: alpha, s.beta: beta, s.omega: rate * swing, s.Omega: rate * turning,
        s.u_1: roots[0], s.u_2: roots[1], s.u_3: roots[2], s.h: momentum,
        s.E: constants[s.g] * length * (1 - mp.fsum(roots)),
        s.a: length * alpha, s.b: length * beta,
    }  # fmt: skip
    constants |= circles(constants)
    here = (roots[0] + roots[1]) / 2 + (roots[0] - roots[1]) / 2 * mp.cos(draw(rng, 0.4, 2.6))
    across = (roots[0] - here) * (here - roots[1]) * (here - roots[2])
    rise = -rate * mp.sqrt(2 * across)
    return World(constants, _paths(here, rise, momentum, length))


def _paths(here: Number, rise: Number, momentum: Number, length: Number) -> dict[Expr, Path]:
    """A motion that has the height and the two rates of the exact one at τ = 0."""
    theta, sine = mp.acos(here), mp.sqrt(1 - here**2)
    falling, going = -rise / sine, momentum / sine**2
    return {
        s.theta: lambda tau: theta + falling * tau,
        s.phi: lambda tau: mpf(1) / 2 + going * tau,
        s.u: lambda tau: mp.cos(theta + falling * tau),
        s.rho: lambda tau: length * mp.sin(theta + falling * tau),
    }
