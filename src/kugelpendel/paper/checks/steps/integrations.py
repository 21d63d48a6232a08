"""The kind of step that goes through a swing from its lowest to its highest point and back."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import is_zero
from kugelpendel.paper.algebra.sympy_names import Expr, Integer, cos, pi, sin, solve, sqrt
from kugelpendel.paper.checks.steps.work import Work


def is_integration(work: Work) -> bool:
    """Twice the integral, between two zeros of u̇², of a rate over u̇: what comes of it in a swing.

    The rate is that of the time, 1, or that of the azimuth, from the premises.
    """
    integrals = work.relation.integrals
    if len(integrals) != 1 or work.relation.op != "=":
        return False
    (integral,) = integrals
    integrand, lower, upper = integral.args
    square = _square(work)
    if square is None or work.relation.rhs != 2 * integral:
        return False
    at_rest = all(is_zero(square.subs(s.u, bound)) for bound in (lower, upper))
    rate = _rate(work)
    return at_rest and rate is not None and is_zero(integrand * sqrt(square) - rate)


def _square(work: Work) -> Expr | None:
    """u̇² in the form that shows its zeros."""
    known = {p.lhs: p.rhs for p in work.premises if p.op == "="}
    return known.get(known.get(s.ud**2))


def _rate(work: Work) -> Expr | None:
    half, turned = pi / s.omega, pi * s.Omega / s.omega
    if is_zero(work.relation.lhs - half):
        return Integer(1)
    named = {p.rhs: p.lhs for p in work.premises if p.op == "="}
    moment = next((p for p in work.premises if p.difference.has(s.phid)), None)
    cosine = named.get(cos(s.theta))
    if moment is None or cosine is None or not is_zero(work.relation.lhs - pi - turned):
        return None
    (going,) = solve(moment.difference, s.phid)
    return going.xreplace({sin(s.theta): sqrt(1 - cosine**2)})
