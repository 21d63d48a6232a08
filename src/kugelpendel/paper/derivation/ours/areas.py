"""Chapter 6: what the turning has to do with areas, and the law of the energy."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out, rate, slow, small, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import Ddt
from kugelpendel.paper.algebra.sympy_names import Add, Expr, cos, pi, sin, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Step, StepKind, claim
from kugelpendel.paper.derivation.section1 import turned_plumb_line
from kugelpendel.paper.proofs.numeric import in_world, to_order
from kugelpendel.paper.proofs.symbolic import Premises, Proof, follows, given, put
from kugelpendel.paper.proofs.worlds import balanced, dynamic, ellipse, kinematic

_ANSATZ = in_world(ellipse)
_MOVING = in_world(dynamic)


def _leading_moment(p: Premises) -> Expr:
    """Second order in ε: ω0 for ω, and nothing of Ω."""
    return p["B1:1"].lhs - truncated(slow(p["B1:1"].rhs), 2)


def _in_a_swing(p: Premises) -> Expr:
    turning = p["25"].rhs
    return 2 * pi * s.Omega / s.omega - 2 * pi * turning / s.omega0


def _carried(relation: Relation, p: Premises) -> list[Expr]:
    """1 − cos θ is sin²θ/(1 + cos θ), and sin²θ φ̇ is in (6.2)."""
    moment = p["6.2:2"]
    return [put(relation.difference, {moment.lhs: moment.rhs})]


def _carried_below(relation: Relation, p: Premises) -> list[Expr]:
    """Second order of the line before, with cos θ from (2) and (6)."""
    root = sqrt(1 - (s.x**2 + s.y**2) / s.l**2)
    exact = p["B4:1"].rhs.xreplace({cos(s.theta): root})
    return [relation.rhs - truncated(small(exact), 3)]


def _energy(relation: Relation, _: Premises) -> list[Expr]:
    """Half the square of the velocity, and g times the height above the lowest point."""
    place = turned_plumb_line()
    speeds = (rate(q) for q in place)
    energy = Add(*(speed**2 for speed in speeds)) / 2 + s.g * (s.l - place[2])
    return [relation.difference.xreplace({s.E: energy})]


def _changing(relation: Relation, p: Premises) -> list[Expr]:
    energy = p["B6"].rhs
    return [carry_out(relation.lhs - Ddt(energy)), relation.rhs - rate(energy)]


def _conserved(p: Premises) -> Expr:
    """The line before, with (5b) and (5c) in the places where they stand in it."""
    given_by = s.l**2 * (s.thetad * p["5b"].lhs + s.phid * sin(s.theta) * p["5c"].lhs)
    return p["B7:1"].difference + given_by


_MOMENT = r"x\dot{y} - y\dot{x}"
_SPREAD = r"a^2 \cos^2 \omega t + b^2 \sin^2 \omega t"
_ENERGY = r"\frac{1}{2} l^2 (\dot{\theta}^2 + \dot{\phi}^2 \sin^2 \theta) + gl (1 - \cos \theta)"

FORMULAS: tuple[Formula, ...] = (
    claim(
        "B1:1",
        rf"{_MOMENT} = ab\omega + \Omega ({_SPREAD})",
        Step(StepKind.SUBSTITUTE, ("20", "20.3:2", "20.4:2")),
        Proof(given("20", "20.3:2", "20.4:2"), _ANSATZ),
    ),
    claim(
        "B1:2",
        r"\approx ab\omega_0",
        Step(
            StepKind.NEGLECT,
            ("B1:1",),
            (c.NEAR, c.SLOW, c.SLOW_MINOR),
            neglected=rf"\frac{{ab}}{{2\omega_0}} (\omega^2 - \omega_0^2) + \Omega ({_SPREAD})",
        ),
        Proof(follows(_leading_moment), to_order(3, ellipse), if_equal=Proof(given(), _ANSATZ)),
        head="B1:1",
    ),
    claim(
        "B2",
        rf"\Omega = \frac{{3}}{{8l^2}} ({_MOMENT})",
        Step(StepKind.SUBSTITUTE, ("25", "B1:2")),
        Proof(given("B1:2", "25"), to_order(3, balanced)),
    ),
    claim(
        "B3",
        r"\frac{2\pi\Omega}{\omega} \approx \frac{3}{4} \frac{\pi ab}{l^2}",
        Step(
            StepKind.NEGLECT,
            ("25",),
            (c.NEAR, c.SLOW, c.SLOW_MINOR),
            neglected=r"-\frac{\pi\Omega}{\omega_0^3} (\omega^2 - \omega_0^2)",
        ),
        Proof(follows(_in_a_swing), to_order(3, balanced), if_equal=Proof(given(), _ANSATZ)),
    ),
    claim(
        "B4:1",
        rf"(1 - \cos \theta) \dot{{\phi}} = \frac{{{_MOMENT}}}{{l^2 (1 + \cos \theta)}}",
        Step(StepKind.SUBSTITUTE, ("6.2:2",)),
        Proof(_carried, _MOVING),
    ),
    claim(
        "B4:2",
        rf"\approx \frac{{1}}{{2l^2}} ({_MOMENT})",
        Step(
            StepKind.NEGLECT,
            ("B4:1",),
            (c.SMALL,),
            neglected=rf"\frac{{\rho^2}}{{8l^4}} ({_MOMENT})",
        ),
        Proof(_carried_below, to_order(3, dynamic), if_equal=Proof(given("6.2:2"), _MOVING)),
        head="B4:1",
    ),
    claim(
        "B5",
        rf"\Omega = \frac{{3}}{{4}} \cdot \frac{{1}}{{2l^2}} ({_MOMENT})",
        Step(StepKind.REARRANGE, ("B2",)),
        Proof(follows(lambda p: p["B2"]), to_order(3, balanced)),
    ),
    claim(
        "B6",
        rf"E = {_ENERGY}",
        Step(StepKind.DEFINE, (), (c.INEXTENSIBLE,)),
        Proof(_energy, _MOVING),
    ),
    claim(
        "B7:1",
        rf"\frac{{d}}{{dt}} \left[ {_ENERGY} \right] = l^2 \dot{{\theta}} \left( \ddot{{\theta}} "
        r"- \dot{\phi}^2 \sin \theta \cos \theta + \frac{g}{l} \sin \theta \right) "
        r"+ l^2 \dot{\phi} \sin \theta \left( \ddot{\phi} \sin \theta "
        r"+ 2\dot{\theta}\dot{\phi} \cos \theta \right)",
        Step(StepKind.DIFFERENTIATE, ("B6",), (c.INEXTENSIBLE,)),
        Proof(_changing, in_world(kinematic)),
    ),
    claim(
        "B7:2",
        "= 0",
        Step(StepKind.SUBSTITUTE, ("5b", "5c", "B7:1")),
        Proof(follows(_conserved), _MOVING),
        head="B7:1",
    ),
)
