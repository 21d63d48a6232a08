"""Chapter 7: the exact solution in one page, and (25) and (26) as its beginning.

The integrals between the turning points are classical; their series are those of `algebra.swing`.
"""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import rate
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.swing import frequency, precession, product
from kugelpendel.paper.algebra.symbols import Integrated
from kugelpendel.paper.algebra.sympy_names import Add, Expr, expand, pi, sin, solve, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Step, StepKind, claim
from kugelpendel.paper.derivation.section1 import turned_plumb_line
from kugelpendel.paper.proofs.exact import swinging
from kugelpendel.paper.proofs.numeric import in_world, to_order
from kugelpendel.paper.proofs.symbolic import Premises, Proof, Symbolic, follows, given, identity

_SWINGING = in_world(swinging)


def _cosine(relation: Relation, _: Premises) -> list[Expr]:
    """The height below the support, over the length, of the turned plumb line."""
    return [relation.difference.xreplace({s.u: turned_plumb_line()[2] / s.l})]


def _moment(relation: Relation, _: Premises) -> list[Expr]:
    """The angular momentum about the vertical, over ml²."""
    x, y, _z = turned_plumb_line()
    return [relation.difference.xreplace({s.h: (x * rate(y) - y * rate(x)) / s.l**2})]


def _radius(relation: Relation, _: Premises) -> list[Expr]:
    """The square of sin θ at a turning point: the highest for α, the lowest for β."""
    (radius,) = relation.lhs.free_symbols
    turning = {s.alpha: s.u_2, s.beta: s.u_1}[radius]
    return [relation.lhs - radius**2, relation.rhs - (1 - turning**2)]


def _falling(p: Premises) -> dict[Expr, Expr]:
    return {s.ud: rate(p["C1"].rhs)}


def _zeros(relation: Relation, _: Premises) -> list[Expr]:
    """u1 and u2 are zeros of the left side, which tells E and h²; the third zero follows."""
    left = relation.lhs
    unknown = (s.E, s.h**2)
    (found,) = solve([left.subs(s.u, zero) for zero in (s.u_1, s.u_2)], unknown, dict=True)
    third = -(1 + s.u_1 * s.u_2) / (s.u_1 + s.u_2)
    there = {s.E: found[s.E], s.h: sqrt(found[s.h**2]), s.u_3: third}
    return [relation.difference.subs(there)]


def _linear(p: Premises) -> Expr:
    return expand(p["C5"].difference).coeff(s.u)


def _third(relation: Relation, p: Premises) -> list[Expr]:
    (root,) = solve(p["C6"].lhs, s.u_3)
    return [relation.difference - (s.u_3 - root)]


def _azimuth_rate(p: Premises) -> Expr:
    """φ̇ from (C3), with cos θ from (C1)."""
    (going,) = solve(p["C3"].difference, s.phid)
    return going.subs(sin(s.theta), sqrt(1 - p["C1"].lhs ** 2))


def _over_a_swing(change: Expr, rate_of: Callable[[Premises], Expr]) -> Symbolic:
    """From the lowest point to the highest and back: twice the integral of a rate over u̇."""

    def symbolic(relation: Relation, p: Premises) -> list[Expr]:
        same = p["C4"].rhs - p["C5"].lhs
        whole = 2 * Integrated(rate_of(p) / sqrt(p["C5"].rhs), s.u_2, s.u_1)
        return [same, relation.difference - (change - whole)]

    return symbolic


def _integrand(relation: Relation) -> Expr:
    (integral,) = relation.integrals
    return integral.args[0]


def _radii(p: Premises) -> list[Expr]:
    """What the series in the turning radii rest on."""
    return [p[f"C10:{k}"].difference - q for k, q in ((1, _HIGH), (2, _LOW))]


def _frequency(relation: Relation, p: Premises) -> list[Expr]:
    found = frequency(_integrand(p["C8"]), p["C7"].rhs)
    square = Add(*product(found, found)[:3])
    return [*_radii(p), _natural(relation.difference - (s.omega**2 - square))]


def _turning(relation: Relation, p: Premises) -> list[Expr]:
    moment = (-p["C5"].rhs).subs(s.u, 1)  # the left side is −h² there
    same = p["C5"].lhs.subs(s.u, 1) + s.h**2
    found = precession(_integrand(p["C8"]), _integrand(p["C9"]), p["C7"].rhs, moment)
    claimed = relation.difference - (s.Omega - Add(*found[:3]))
    return [*_radii(p), same, _natural(claimed)]


def _natural(expression: Expr) -> Expr:
    return expression.xreplace({s.g: s.omega0**2 * s.l})


_LOW, _HIGH = s.beta**2 - 1 + s.u_1**2, s.alpha**2 - 1 + s.u_2**2
_LEFT = r"\frac{2}{l^2} [E - gl (1 - u)] (1 - u^2) - h^2"
_RIGHT = r"\frac{2g}{l} (u_1 - u)(u - u_2)(u - u_3)"

FORMULAS: tuple[Formula, ...] = (
    claim("C1", r"u = \cos \theta", Step(StepKind.DEFINE), Proof(_cosine, _SWINGING)),
    claim(
        "C2",
        r"\dot{u} = -\sin \theta \cdot \dot{\theta}",
        Step(StepKind.DIFFERENTIATE, ("C1",)),
        Proof(identity(_falling), _SWINGING),
    ),
    claim(
        "C3",
        r"h = \dot{\phi} \sin^2 \theta",
        Step(StepKind.DEFINE),
        Proof(_moment, _SWINGING),
    ),
    claim(
        "C4",
        rf"\dot{{u}}^2 = {_LEFT}",
        Step(StepKind.SUBSTITUTE, ("B6", "C1", "C2", "C3")),
        Proof(given("B6", "C1", "C2", "C3"), _SWINGING),
    ),
    claim("C5", rf"{_LEFT} = {_RIGHT}", Step(StepKind.DEFINE), Proof(_zeros, _SWINGING)),
    claim(
        "C6",
        r"\frac{2g}{l} (1 + u_1u_2 + u_1u_3 + u_2u_3) = 0",
        Step(StepKind.COMPARE, ("C5",), detail="u"),
        Proof(follows(_linear), _SWINGING),
    ),
    claim(
        "C7",
        r"u_3 = -\frac{1 + u_1u_2}{u_1 + u_2}",
        Step(StepKind.SOLVE, ("C6",), (c.MEAN_BELOW,), detail=r"\frac{2g}{l} (u_1 + u_2)"),
        Proof(_third, _SWINGING),
    ),
    claim(
        "C8",
        rf"\frac{{\pi}}{{\omega}} = 2 \int_{{u_2}}^{{u_1}} \frac{{du}}{{\sqrt{{{_RIGHT}}}}}",
        Step(StepKind.INTEGRATE, ("C4", "C5")),
        Proof(_over_a_swing(pi / s.omega, lambda _: s.u**0), _SWINGING),
    ),
    claim(
        "C9",
        r"\pi + \frac{\pi\Omega}{\omega} = 2 \int_{u_2}^{u_1} "
        rf"\frac{{h}}{{1 - u^2}} \cdot \frac{{du}}{{\sqrt{{{_RIGHT}}}}}",
        Step(StepKind.INTEGRATE, ("C1", "C3", "C4", "C5")),
        Proof(_over_a_swing(pi + pi * s.Omega / s.omega, _azimuth_rate), _SWINGING),
    ),
    claim("C10:1", r"\alpha^2 = 1 - u_2^2", Step(StepKind.DEFINE), Proof(_radius, _SWINGING)),
    claim("C10:2", r"\beta^2 = 1 - u_1^2", Step(StepKind.DEFINE), Proof(_radius, _SWINGING)),
    claim(
        "C11",
        r"\omega^2 = \omega_0^2 \left[ 1 - \frac{1}{8} (\alpha^2 + \beta^2) "
        r"- \frac{19}{512} (\alpha^2 - \beta^2)^2 \right]",
        Step(
            StepKind.NEGLECT,
            ("C7", "C8", "C10"),
            (c.OMEGA_ZERO, c.MEAN_BELOW, c.SMALL_RADII),
            neglected=r"-\omega_0^2 \left[ \frac{79}{4096} (\alpha^6 + \beta^6) "
            r"- \frac{143}{4096} \alpha^2\beta^2 (\alpha^2 + \beta^2) \right]",
        ),
        Proof(_frequency, to_order(5, swinging)),
    ),
    claim(
        "C12",
        r"\Omega = \frac{3}{8} \omega_0 \alpha\beta "
        r"\left[ 1 + \frac{7}{32} (\alpha^2 + \beta^2) \right]",
        Step(
            StepKind.NEGLECT,
            ("C5", "C7", "C8", "C9", "C10"),
            (c.OMEGA_ZERO, c.MEAN_BELOW, c.SMALL_RADII),
            neglected=r"\omega_0 \left[ \frac{21}{512} \alpha\beta (\alpha^4 + \beta^4) "
            r"+ \frac{21}{1024} \alpha^3\beta^3 \right]",
        ),
        Proof(_turning, to_order(5, swinging)),
    ),
)
