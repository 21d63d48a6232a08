"""Section 4, second half: the balance of the first harmonics, (25) and (26)."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import slow, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import Ddt
from kugelpendel.paper.algebra.sympy_names import Expr, cos, expand, sin, solve
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import first_harmonics, in_world, to_order
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    Symbolic,
    continued,
    follows,
    identity,
)
from kugelpendel.paper.proofs.worlds import balanced, ellipse

_ANSATZ = in_world(ellipse)
_LAW = (
    r"\ddot{x} + \omega_0^2 x - \frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) "
    r"+ \frac{x}{l^2} (\dot{x}^2 + \dot{y}^2)"
)
_HARMONICS_OF_LAW = first_harmonics(3, pure=False)
_BALANCED = to_order(3, balanced)
_RESULT = to_order(2, balanced)
_COS = cos(s.omega * s.t) * cos(s.Omega * s.t)
_SIN = sin(s.omega * s.t) * sin(s.Omega * s.t)


def _acceleration(p: Premises) -> dict[Expr, Expr]:
    return {s.xdd: Ddt(p["20.3:2"].rhs)}


def _left_side(p: Premises) -> dict[Expr, Expr]:
    return {s.xdd: p["23.1:3"].rhs, s.x: p["20:x"].rhs}


def _all_put_in(relation: Relation, p: Premises) -> list[Expr]:
    """(13a) is the left side of 23.2 minus the one of (23); their right sides take their places."""
    left = p["13a"].difference - (p["23.2"].lhs - p["23:1"].lhs)
    return [left, relation.difference - (p["23.2"].rhs - p["23:2"].rhs)]


def _leading(p: Premises) -> Expr:
    """Third order in ε: ω0 for ω in the small terms, no Ω²."""
    return truncated(slow(p["23.3"].difference), 3)


def _coefficient(function: Expr, sign: int) -> Symbolic:
    def derive(p: Premises) -> Expr:
        return sign * expand(p["23.5"].difference).coeff(function)

    return follows(derive)


def _sum(first: str, second: str, sign: int) -> Symbolic:
    return follows(lambda p: p[first].difference + sign * p[second].difference)


def _divided(label: str, divisor: Expr) -> Symbolic:
    return follows(lambda p: p[label].difference / divisor)


def _solved(relation: Relation, p: Premises) -> list[Expr]:
    (root,) = solve(p["23.9"].difference, s.Omega)
    return [relation.difference - (s.Omega - root)]


def _put_back(relation: Relation, p: Premises) -> list[Expr]:
    """(25) in both equations of 23.8: they give the same ω²."""
    residuals: list[Expr] = []
    for part in ("23.8:1", "23.8:2"):
        equation = p[part].difference.xreplace({s.Omega: p["25"].rhs})
        residuals.append(relation.difference - equation)
    return residuals


_AC = r"\cos \omega t \cos \Omega t"
_SS = r"\sin \omega t \sin \Omega t"
_XDDOT = r"-\left[ a(\omega^2 %s+ \Omega^2) + 2b\omega\Omega \right] " + _AC + " "
_D = r"(\omega^2 - \omega_0^2)"
_E = r"\frac{\omega_0^2"

FORMULAS: tuple[Formula, ...] = (
    claim(
        "23.1:1",
        r"\ddot{x} = \frac{d}{dt} \left[ -(a\omega + b\Omega) \sin \omega t \cos \Omega t "
        r"- (a\Omega + b\omega) \cos \omega t \sin \Omega t \right]",
        Step(Kind.DIFFERENTIATE, ("20.3:2",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(identity(_acceleration), _ANSATZ),
    ),
    claim(
        "23.1:2",
        rf"= -\omega(a\omega + b\Omega) {_AC} + \Omega(a\omega + b\Omega) {_SS} "
        rf"+ \omega(a\Omega + b\omega) {_SS} - \Omega(a\Omega + b\omega) {_AC}",
        Step(Kind.DIFFERENTIATE, ("23.1:1",)),
        Proof(continued("23.1:1"), _ANSATZ),
        head="23.1:1",
    ),
    claim(
        "23.1:3",
        rf"= -\left[ a(\omega^2 + \Omega^2) + 2b\omega\Omega \right] {_AC} "
        rf"+ \left[ 2a\omega\Omega + b(\omega^2 + \Omega^2) \right] {_SS}",
        Step(Kind.REARRANGE, ("23.1:2",)),
        Proof(continued("23.1:2"), _ANSATZ),
        head="23.1:1",
    ),
    claim(
        "23.2",
        rf"\ddot{{x}} + \omega_0^2 x = "
        rf"-\left[ a(\omega^2 - \omega_0^2 + \Omega^2) + 2b\omega\Omega \right] {_AC} "
        rf"+ \left[ 2a\omega\Omega + b(\omega^2 - \omega_0^2 + \Omega^2) \right] {_SS}",
        Step(Kind.SUBSTITUTE, ("20:x", "23.1:3")),
        Proof(identity(_left_side), _ANSATZ),
    ),
    claim(
        "23.3",
        r"\left[ -a(\omega^2 - \omega_0^2 + \Omega^2) - 2b\omega\Omega - \frac{1}{8l^2} "
        rf"\left\{{ -2\omega^2(a^3 + 3ab^2) + \omega_0^2(3a^3 + ab^2) \right\}} \right] {_AC} "
        r"+ \left[ 2a\omega\Omega + b(\omega^2 - \omega_0^2 + \Omega^2) - \frac{1}{8l^2} "
        rf"\left\{{ 2\omega^2(b^3 + 3a^2b) - \omega_0^2(3b^3 + a^2b) \right\}} \right] {_SS} = 0",
        Step(Kind.SUBSTITUTE, ("13a", "23", "23.2"), (c.THIRD,)),
        Proof(_all_put_in, _HARMONICS_OF_LAW, against=_LAW),
    ),
    claim(
        "23.4",
        rf"\left[ -a{_D} - 2b\omega_0\Omega - \frac{{1}}{{8l^2}} "
        rf"\{{ -2\omega_0^2(a^3 + 3ab^2) + \omega_0^2(3a^3 + ab^2) \}} \right] {_AC} "
        rf"+ \left[ b{_D} + 2a\omega_0\Omega - \frac{{1}}{{8l^2}} "
        rf"\{{ 2\omega_0^2(b^3 + 3a^2b) - \omega_0^2(3b^3 + a^2b) \}} \right] {_SS} = 0",
        Step(
            Kind.NEGLECT,
            ("23.3",),
            (c.NEAR, c.ALSO_PREFACTOR, c.OMEGA_SQUARED),
            neglected=(
                r"a\Omega^2, \frac{a^3}{l^2} (\omega^2 - \omega_0^2), "
                r"b\Omega(\omega - \omega_0)"
            ),
        ),
        Proof(follows(_leading), _HARMONICS_OF_LAW, against=_LAW),
    ),
    claim(
        "23.5",
        rf"\left[ -a{_D} - 2b\omega_0\Omega - {_E} a}}{{8l^2}} (a^2 - 5b^2) \right] {_AC} "
        rf"+ \left[ b{_D} + 2a\omega_0\Omega + {_E} b}}{{8l^2}} (b^2 - 5a^2) \right] {_SS} = 0",
        Step(Kind.REARRANGE, ("23.4",)),
        Proof(follows(lambda p: p["23.4"]), _HARMONICS_OF_LAW, against=_LAW),
    ),
    claim(
        "23.6:1",
        rf"a{_D} + 2b\omega_0\Omega + {_E} a}}{{8l^2}} (a^2 - 5b^2) = 0",
        Step(Kind.COMPARE, ("23.5",), (c.INDEPENDENT, c.OTHER_EQUATION), detail=_AC),
        Proof(_coefficient(_COS, -1), _BALANCED),
    ),
    claim(
        "23.6:2",
        rf"b{_D} + 2a\omega_0\Omega + {_E} b}}{{8l^2}} (b^2 - 5a^2) = 0",
        Step(Kind.COMPARE, ("23.5",), (c.INDEPENDENT, c.OTHER_EQUATION), detail=_SS),
        Proof(_coefficient(_SIN, 1), _BALANCED),
    ),
    claim(
        "23.7:1",
        rf"(a+b){_D} + 2(a+b)\omega_0\Omega + {_E}}}{{8l^2}} (a^3 - 5a^2b + b^3 - 5ab^2) = 0",
        Step(Kind.ADD, ("23.6",)),
        Proof(_sum("23.6:1", "23.6:2", 1), _BALANCED),
    ),
    claim(
        "23.7:2",
        rf"(a-b){_D} - 2(a-b)\omega_0\Omega + {_E}}}{{8l^2}} (a^3 - 5ab^2 - b^3 + 5a^2b) = 0",
        Step(Kind.SUBTRACT, ("23.6",)),
        Proof(_sum("23.6:1", "23.6:2", -1), _BALANCED),
    ),
    claim(
        "23.8:1",
        rf"\omega^2 - \omega_0^2 + 2\omega_0\Omega + {_E}}}{{8l^2}} (a^2 - 6ab + b^2) = 0",
        Step(Kind.DIVIDE, ("23.7:1",), (c.NOT_OPPOSITE,), detail="a + b"),
        Proof(_divided("23.7:1", s.a + s.b), _RESULT),
    ),
    claim(
        "23.8:2",
        rf"\omega^2 - \omega_0^2 - 2\omega_0\Omega + {_E}}}{{8l^2}} (a^2 + 6ab + b^2) = 0",
        Step(Kind.DIVIDE, ("23.7:2",), (c.NOT_CIRCLE,), detail="a - b"),
        Proof(_divided("23.7:2", s.a - s.b), _RESULT),
    ),
    claim(
        "23.9",
        rf"4\omega_0\Omega - {_E}}}{{8l^2}} \cdot 12ab = 0",
        Step(Kind.SUBTRACT, ("23.8",)),
        Proof(_sum("23.8:1", "23.8:2", -1), _RESULT),
    ),
    claim(
        "25",
        r"\Omega = \frac{3}{8} \omega_0 \frac{ab}{l^2}",
        Step(Kind.SOLVE, ("23.9",), detail=r"4\omega_0"),
        Proof(_solved, _RESULT),
        number="25",
    ),
    claim(
        "26",
        r"\omega^2 = \omega_0^2 \left(1 - \frac{a^2 + b^2}{8l^2}\right)",
        Step(Kind.SUBSTITUTE, ("23.8", "25")),
        Proof(_put_back, _RESULT),
        number="26",
    ),
)
