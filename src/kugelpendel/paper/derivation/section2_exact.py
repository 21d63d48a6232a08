"""Section 2, second half: from (10) to the exact (12) and the cubic (13a), (13b)."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import small, taylor, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import Add, Expr, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import in_world, to_order
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    Rules,
    continued,
    follows,
    given,
    identity,
    put,
)
from kugelpendel.paper.proofs.worlds import dynamic, kinematic

_ANY = in_world(kinematic)
_MOVING = in_world(dynamic)


def _third_and_fourth(p: Premises) -> Expr:
    """The two terms of (10) with rates but without accelerations."""
    terms = Add.make_args(p["10"].lhs)
    return Add(*(q for q in terms if q.has(s.xd) and not q.has(s.xdd)))


def _rho(p: Premises) -> Rules:
    return {s.rho: sqrt(p["6:1"].rhs)}


def _completing(relation: Relation, p: Premises) -> list[Expr]:
    """Taking the term away from the third and fourth of (10) leaves (ρ²/l²)(ẋ² + ẏ²)."""
    left = s.rho**2 / s.l**2 * (s.xd**2 + s.yd**2)
    return [(_third_and_fourth(p) - relation.difference - left).xreplace(_rho(p))]


def _completed(relation: Relation, p: Premises) -> list[Expr]:
    term = p["10.6"].lhs
    terms = _third_and_fourth(p)
    return [relation.lhs - terms, relation.rhs - (terms + term - term)]


def _from_9(p: Premises) -> Rules:
    return {s.ydd: p["9:2"].rhs / (p["9:2"].lhs / s.ydd)}


def _without_y_acceleration(p: Premises) -> Expr:
    """(10) with its first two terms from 10.8 and its third and fourth from 10.7."""
    expression = p["10"].difference
    expression = expression.subs(p["10.8:1"].lhs, p["10.8:2"].rhs)
    return expression - _third_and_fourth(p) + p["10.7:9"].rhs


def _times_x(relation: Relation, p: Premises) -> list[Expr]:
    wanted = p["10.9"].difference * s.x / (s.x**2 + s.y**2)
    return [(relation.difference - wanted).xreplace(_rho(p))]


def _series(relation: Relation, _: Premises) -> list[Expr]:
    """Orders 0 to 3 of both sides in x, y agree; the right side has no others."""
    rest = taylor(small(relation.difference), 3)
    return [*rest, relation.rhs - Add(*taylor(small(relation.rhs), 3))]


def _root_expanded(p: Premises) -> Expr:
    return s.omega0**2 * s.x * p["12.2"].difference


def _cubic(p: Premises) -> Expr:
    """(12) with 12.3 put in, up to the third order."""
    exact = put(p["12"].difference, {p["12.3:1"].lhs: p["12.3:2"].rhs} | p.rules("12.1"))
    return truncated(small(exact.xreplace(_rho(p))), 3)


def _exchanged(p: Premises) -> Expr:
    """The same with x and y exchanged: nothing in (9), (10) tells them apart."""
    pairs = ((s.x, s.y), (s.xd, s.yd), (s.xdd, s.ydd))
    swap = {q: w for one, other in pairs for q, w in ((one, other), (other, one))}
    return _cubic(p).xreplace(swap)


_T = r"\frac{\rho^2}{l^4} (x\dot{x} + y\dot{y})^2 \frac{1}{1 - \frac{\rho^2}{l^2}}"
_34 = r"\frac{1}{l^2} \frac{(x\dot{x} + y\dot{y})^2}{1 - \frac{\rho^2}{l^2}}"
_ANGULAR = r"\frac{1}{l^2} (x\dot{y} - y\dot{x})^2"
_OPEN = r"\frac{\rho^2}{l^2} \left[ \frac{1}{\rho^2 l^2 (1 - \frac{\rho^2}{l^2})} \{ "
_MIDDLE = r"\frac{\rho^2}{l^2} \left[ \frac{1}{\rho^2 (l^2 - \rho^2)} \{ "
_SHORT = r"\frac{\rho^2}{l^2} \left[ \frac{1}{\rho^2} \{ "
_END = r" \} \right]"
_EXPANDED = (
    r"l^2 (x\dot{x})^2 + l^2 (y\dot{y})^2 - \rho^2 (x\dot{x})^2 - \rho^2 (y\dot{y})^2 "
    r"+ l^2 (x\dot{y})^2 %s l^2 (y\dot{x})^2 - \rho^2 (x\dot{y})^2 - \rho^2 (y\dot{x})^2"
)
_COLLECTED = (
    r"(x\dot{x})^2 (l^2 - \rho^2) + (y\dot{y})^2 (l^2 - \rho^2) %s "
    r"(x\dot{y})^2 (l^2 - \rho^2) %s (y\dot{x})^2 (l^2 - \rho^2)"
)
_CANCELLED = r"(x\dot{x})^2 + (y\dot{y})^2 %s (x\dot{y})^2 %s (y\dot{x})^2"
_SQUARES = r"(\dot{x}^2 + \dot{y}^2)"


def _line(part: int, kind: Kind, right: str, wrong: str = "", use_rho: bool = False) -> Formula:
    """One line of the long rearrangement 10.7."""
    previous = f"10.7:{part - 1}"
    premises = (previous, "6:1") if use_rho else (previous,)
    return claim(
        f"10.7:{part}",
        f"= {_T} + {right}",
        Step(kind, premises, (c.RHO_NOT_ZERO, c.NOT_EQUATOR)),
        Proof(continued(previous, rules=_rho if use_rho else None), _ANY),
        printed=f"= {_T} + {wrong}" if wrong else "",
        head="10.7:1",
    )


FORMULAS: tuple[Formula, ...] = (
    claim(
        "10.6",
        _T,
        Step(Kind.COMPLETE, ("6:1", "10"), (c.NOT_EQUATOR,)),
        Proof(
            _completing,
            _ANY,
            against=rf"{_34} + {_ANGULAR} - \frac{{\rho^2}}{{l^2}} {_SQUARES}",
        ),
    ),
    claim(
        "10.7:1",
        rf"{_34} + {_ANGULAR} = {_34} + {_T} - {_T} + {_ANGULAR}",
        Step(Kind.COMPLETE, ("10", "10.6"), (c.NOT_EQUATOR,), detail=rf"\pm {_T}"),
        Proof(_completed, _ANY),
    ),
    _line(
        2,
        Kind.REARRANGE,
        r"\frac{\rho^2}{l^2} \left[ \frac{1}{\rho^2} "
        r"\frac{(x\dot{x} + y\dot{y})^2}{1 - \frac{\rho^2}{l^2}} "
        r"- \frac{1}{l^2} \frac{(x\dot{x} + y\dot{y})^2}{1 - \frac{\rho^2}{l^2}} "
        r"+ \frac{(x\dot{y} - y\dot{x})^2}{\rho^2} \right]",
    ),
    _line(
        3,
        Kind.REARRANGE,
        _OPEN + r"l^2 (x\dot{x} + y\dot{y})^2 - \rho^2 (x\dot{x} + y\dot{y})^2 "
        r"+ l^2 (x\dot{y} - y\dot{x})^2 - \rho^2 (x\dot{y} - y\dot{x})^2" + _END,
    ),
    _line(4, Kind.REARRANGE, _OPEN + _EXPANDED % "+" + _END, _OPEN + _EXPANDED % "-" + _END),
    _line(
        5,
        Kind.REARRANGE,
        _MIDDLE + _COLLECTED % ("+", "+") + _END,
        _MIDDLE + _COLLECTED % ("+ y^2 +", "-") + _END,
    ),
    _line(
        6,
        Kind.REARRANGE,
        _SHORT + _CANCELLED % ("+", "+") + _END,
        _SHORT + _CANCELLED % ("+ y^2 +", "-") + _END,
    ),
    _line(
        7,
        Kind.REARRANGE,
        _SHORT + rf"x^2 {_SQUARES} + y^2 {_SQUARES}" + _END,
        _SHORT + rf"x^2 (\dot{{x}} + \dot{{y}})^2 + y^2 {_SQUARES}" + _END,
    ),
    _line(8, Kind.REARRANGE, _SHORT + rf"(x^2 + y^2) {_SQUARES}" + _END),
    _line(9, Kind.SUBSTITUTE, rf"\frac{{\rho^2}}{{l^2}} {_SQUARES}", use_rho=True),
    claim(
        "10.8:1",
        r"x\ddot{x} + y\ddot{y} = x\ddot{x} + \frac{y^2\ddot{x}}{x}",
        Step(Kind.SUBSTITUTE, ("9:2",), (c.X_NOT_ZERO,)),
        Proof(identity(_from_9), _MOVING),
    ),
    claim(
        "10.8:2",
        r"= \frac{1}{x}\ddot{x}(x^2 + y^2)",
        Step(Kind.REARRANGE, ("10.8:1",), (c.X_NOT_ZERO,)),
        Proof(continued("10.8:1"), _MOVING),
        head="10.8:1",
    ),
    claim(
        "10.9",
        r"\frac{1}{x}\ddot{x}(x^2 + y^2) + "
        + _T
        + rf" + \frac{{\rho^2}}{{l^2}}{_SQUARES} + "
        + r"\omega_0^2(x^2 + y^2)\sqrt{1 - \frac{\rho^2}{l^2}} = 0",
        Step(Kind.SUBSTITUTE, ("10", "10.7:9", "10.8"), (c.X_NOT_ZERO, c.LOWER_HALF)),
        Proof(follows(_without_y_acceleration), _MOVING),
    ),
    claim(
        "12",
        r"\ddot{x} + \frac{x}{l^4}(x\dot{x} + y\dot{y})^2 \frac{1}{1 - \frac{\rho^2}{l^2}} "
        rf"+ \frac{{x}}{{l^2}}{_SQUARES} + \omega_0^2 x \sqrt{{1 - \frac{{\rho^2}}{{l^2}}}} = 0",
        Step(
            Kind.MULTIPLY,
            ("6:1", "10.9"),
            (c.X_NOT_ZERO, c.LOWER_HALF, c.NOT_EQUATOR),
            detail=r"\frac{x}{x^2 + y^2} = \frac{x}{\rho^2}",
        ),
        Proof(_times_x, _MOVING),
        printed=r"\ddot{x} + \frac{x}{l^2}(x\dot{x} + y\dot{y})^2 \frac{1}{1 - \frac{\rho^2}{l^2}} "
        rf"+ \frac{{x}}{{l^2}}{_SQUARES} + \omega_0^2 x \sqrt{{1 - \frac{{\rho^2}}{{l^2}}}} = 0",
        number="12",
    ),
    claim(
        "12.1",
        r"\frac{1}{1 - \frac{\rho^2}{l^2}} = 1 + \frac{\rho^2}{l^2} + \dots",
        Step(Kind.EXPAND, (), (c.SMALL,), neglected=r"\frac{\rho^4}{l^4}"),
        Proof(_series, to_order(3, dynamic)),
    ),
    claim(
        "12.2",
        r"\sqrt{1 - \frac{\rho^2}{l^2}} = 1 - \frac{1}{2} \frac{\rho^2}{l^2} + \dots",
        Step(Kind.EXPAND, (), (c.SMALL,), neglected=r"\frac{\rho^4}{l^4}"),
        Proof(_series, to_order(3, dynamic)),
    ),
    claim(
        "12.3:1",
        r"\omega_0^2 x \sqrt{1 - \frac{\rho^2}{l^2}} "
        r"\approx \omega_0^2 x \left(1 - \frac{1}{2} \frac{\rho^2}{l^2}\right)",
        Step(Kind.NEGLECT, ("12.2",), (c.SMALL,), neglected=r"\omega_0^2 \frac{x\rho^4}{l^4}"),
        Proof(follows(_root_expanded), to_order(4, dynamic), if_equal=Proof(given(), _MOVING)),
        printed=r"\omega_0^2 x \sqrt{1 - \frac{\rho^2}{l^2}} "
        r"= \omega_0^2 x \left(1 - \frac{1}{2} \frac{\rho^2}{l^2}\right)",
    ),
    claim(
        "12.3:2",
        r"= \omega_0^2 x - \frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2)",
        Step(Kind.SUBSTITUTE, ("6:1", "12.3:1")),
        Proof(continued("12.3:1", rules=_rho), to_order(4, dynamic)),
        head="12.3:1",
    ),
    claim(
        "13a",
        r"\ddot{x} + \omega_0^2 x - \frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) "
        rf"+ \frac{{x}}{{l^2}} {_SQUARES} = 0",
        Step(
            Kind.NEGLECT,
            ("6:1", "12", "12.1", "12.3"),
            (c.SMALL, c.SMALL_RATES),
            neglected=r"\omega_0^2 \frac{x\rho^4}{l^4}",
        ),
        Proof(follows(_cubic), to_order(4, dynamic)),
        number="13a",
    ),
    claim(
        "13b",
        r"\ddot{y} + \omega_0^2 y - \frac{1}{2} \omega_0^2 \frac{y}{l^2} (x^2 + y^2) "
        rf"+ \frac{{y}}{{l^2}} {_SQUARES} = 0",
        Step(
            Kind.NEGLECT,
            ("6:1", "12", "12.1", "12.3"),
            (c.SMALL, c.SMALL_RATES, c.SAME_BY_SYMMETRY, c.Y_NOT_ZERO),
            neglected=r"\omega_0^2 \frac{y\rho^4}{l^4}",
        ),
        Proof(follows(_exchanged), to_order(4, dynamic)),
        number="13b",
    ),
)
