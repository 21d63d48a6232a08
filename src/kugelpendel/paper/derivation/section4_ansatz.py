"""Section 4, first half: the turning ellipse (17) to (20) put into the cubic terms, up to (23)."""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import EPS, SHIFT, harmonic, is_zero, rate, slow, taylor
from kugelpendel.paper.algebra.dimensions import is_homogeneous
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import Abs, Add, Expr, I, cos, expand, sin
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import first_harmonics, in_world, much_less, to_order
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    Rules,
    Symbolic,
    both,
    continued,
    follows,
    given,
    identity,
    put,
)
from kugelpendel.paper.proofs.worlds import balanced, ellipse

_ANSATZ = in_world(ellipse)
_AVERAGED = first_harmonics(None)
_AVERAGED_SMALL = first_harmonics(3)


def _turning(relation: Relation, _: Premises) -> list[Expr]:
    """X + iy is x' + iy' turned by Ωt."""
    wheel = cos(s.Omega * s.t) + I * sin(s.Omega * s.t)
    plan, mirrored = (expand((s.xp + j * I * s.yp) * wheel.subs(I, j * I)) for j in (1, -1))
    rules = {s.x: expand((plan + mirrored) / 2), s.y: expand((plan - mirrored) / (2 * I))}
    return [relation.difference.xreplace(rules)]


def _same_ellipse(relation: Relation, p: Premises) -> list[Expr]:
    """(16) in the turning system, with ω for ω0."""
    rules = {left: right.xreplace({s.omega0: s.omega}) for left, right in p.rules("16").items()}
    there = {s.xp: rules[s.x], s.yp: rules[s.y]}
    return [relation.difference.xreplace(there)]


def _much_less(relation: Relation, _: Premises) -> list[Expr]:
    """Of one dimension; the left side of second order in ε and positive for a, b > 0.

    An assumption that (25) and (26) confirm afterwards: they are put in.
    """
    if relation.op != "≪" or not is_homogeneous(relation):
        return [relation.lhs]
    found = {s.Omega: 3 * s.omega0 * s.a * s.b / (8 * s.l**2)}
    shift = -(s.omega0**2) * (s.a**2 + s.b**2) / (8 * s.l**2)
    bars = relation.lhs.has(Abs)
    inner = relation.lhs.xreplace({bar: bar.args[0] for bar in relation.lhs.atoms(Abs)})
    left, right = (
        taylor(slow(side).xreplace({SHIFT: shift}).xreplace(found), 2)
        for side in (inner, relation.rhs)
    )
    positive = {s.a: 2 * s.a**2, s.b: s.b**2}  # any semi-axes, a > b > 0 among them
    sign = left[2].xreplace(positive).subs({s.a: 1, s.b: 1, s.l: 1, s.omega0: 1})
    allowed = bars or sign > 0
    right_stays = not is_zero(right[0])
    return [left[0], left[1]] if allowed and right_stays else [relation.rhs]


def _squares_added(relation: Relation, p: Premises) -> list[Expr]:
    total = Add(*(right for right in p.rules("20.1").values()))
    return [put(relation.difference, {s.x**2 + s.y**2: total})]


def _velocity(q: str) -> Symbolic:
    dot = {"x": s.xd, "y": s.yd}[q]
    return identity(lambda p: {dot: rate(p[f"20:{q}"].rhs)})


def _speeds(p: Premises) -> Rules:
    return {s.xd: p["20.3:2"].rhs, s.yd: p["20.4:2"].rhs}


def _motion(p: Premises) -> Rules:
    """x, y and their rates from (20): what an exact equation would have to stand."""
    return _speeds(p) | p.rules("20")


def _no_turning(relation: Relation, p: Premises) -> list[Expr]:
    """Ω dropped beside ω; the angle Ωt stays."""
    exact = p["20.5:2"]
    angles = {f: f.xreplace({s.Omega: EPS}) for f in exact.rhs.atoms(cos, sin)}
    kept = exact.rhs.xreplace(angles).xreplace({s.Omega: 0}).xreplace({EPS: s.Omega})
    return [relation.lhs - p["20.5:1"].lhs, relation.rhs - kept]


def _product(first: str, second: str) -> Callable[[Premises], Expr]:
    """X from one formula times the sum of squares from another."""

    def derive(p: Premises) -> Expr:
        return s.x * p[second].lhs - p[first].rhs * p[second].rhs

    return derive


def _left_of(label: str) -> Symbolic:
    def symbolic(relation: Relation, p: Premises) -> list[Expr]:
        return [relation.lhs - p[label].lhs]

    return symbolic


def _averaged(expression: Expr) -> Expr:
    return harmonic(expression, 1)


def _cubic_terms(relation: Relation, p: Premises) -> list[Expr]:
    """The left side is minus the two last terms of (13a); the right one their first harmonics."""
    cubic = s.xdd + s.omega0**2 * s.x - p["13a"].difference
    averages = {p[f"{label}:1"].lhs: p[f"{label}:2"].rhs for label in ("20.8", "20.10")}
    return [relation.lhs - cubic, relation.rhs - put(cubic, averages)]


_AC = r"\cos \omega t \cos \Omega t"
_SS = r"\sin \omega t \sin \Omega t"
_P = r"(a\omega + b\Omega)"
_Q = r"(a\Omega + b\omega)"
_SPEEDS = (
    rf"\dot{{x}}^2 + \dot{{y}}^2 = {_P}^2 \sin^2 \omega t \cos^2 \Omega t "
    rf"+ 2{_P}{_Q} \sin \omega t \cos \Omega t \cos \omega t \sin \Omega t "
    rf"%s {_Q}^2 \cos^2 \omega t \sin^2 \Omega t + {_P}^2 \sin^2 \omega t \sin^2 \Omega t "
    rf"- 2{_P}{_Q} \sin \omega t \cos \Omega t \cos \omega t \sin \Omega t "
    rf"+ {_Q}^2 \cos^2 \omega t \cos^2 \Omega t"
)
_YY = (
    r"y^2 = a^2 \cos^2 \omega t \sin^2 \Omega t "
    r"%s 2ab \cos \omega t \sin \Omega t \sin \omega t \cos \Omega t + b^2 \sin^2 "
    r"\omega t \cos^2 \Omega t"
)
_PLACE = r"x(x^2 + y^2)"
_SPEED = r"x(\dot{x}^2 + \dot{y}^2)"
_AVERAGE_PLACE = (
    r"\frac{1}{4} \left[ 3a^3 \cos \omega t \cos \Omega t + ab^2 \cos \omega t \cos \Omega t "
    r"- a^2 b \sin \omega t \sin \Omega t - 3b^3 \sin \omega t \sin \Omega t \right]"
)
_FIRST_SPEED = (
    r"\omega^2 (a \cos \omega t \cos \Omega t - b \sin \omega t \sin \Omega t)"
    r"(a^2 \sin^2 \omega t + b^2 \cos^2 \omega t)"
)
_AVERAGE_SPEED = rf"\frac{{\omega^2}}{{4}} \left[ (a^3 + 3ab^2) {_AC} - (b^3 + 3a^2b) {_SS} \right]"
_SLOW_SPEED = r"\dot{x}^2 + \dot{y}^2 %s \omega^2 (a^2 \sin^2 \omega t + b^2 \cos^2 \omega t)"
_CUBIC_AVERAGED = (
    rf"\frac{{\omega_0^2}}{{8l^2}} \left[ (3a^3 + ab^2) {_AC} - (3b^3 + a^2b) {_SS} \right] "
    rf"- \frac{{\omega^2}}{{4l^2}} \left[ (a^3 + 3ab^2) {_AC} - (b^3 + 3a^2b) {_SS} \right]"
)
_CUBIC_LEFT = (
    r"\frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) %s \frac{x}{l^2} (\dot{x}^2 + \dot{y}^2) "
)
_EXACTLY = Proof(identity(_motion), _ANSATZ)
_TURN = Step(Kind.DEFINE, (), (c.UNIFORM,))
_REST = Step(Kind.DEFINE, ("16",), (c.THIRD, c.NO_GROWTH))
_SMALL_TERMS = (c.SLOW, c.SLOW_MINOR)

FORMULAS: tuple[Formula, ...] = (
    claim(
        "17:x",
        r"x = x' \cos \Omega t - y' \sin \Omega t",
        _TURN,
        Proof(_turning, _ANSATZ),
        number="17",
    ),
    claim(
        "17:y",
        r"y = x' \sin \Omega t + y' \cos \Omega t",
        _TURN,
        Proof(_turning, _ANSATZ),
        number="17",
    ),
    claim("18:x", r"x' = a \cos \omega t", _REST, Proof(_same_ellipse, _ANSATZ), number="18"),
    claim("18:y", r"y' = b \sin \omega t", _REST, Proof(_same_ellipse, _ANSATZ), number="18"),
    claim(
        "19:1",
        r"|\omega - \omega_0| \ll \omega_0",
        Step(Kind.DEFINE, (), (c.NEAR,)),
        Proof(_much_less, much_less(balanced)),
        printed=r"\omega - \omega_0 \ll \omega_0",
        number="19",
    ),
    claim(
        "19:2",
        r"\Omega \ll \omega_0",
        Step(Kind.DEFINE, (), (c.SLOW,)),
        Proof(_much_less, much_less(balanced)),
        number="19",
    ),
    claim(
        "20:x",
        r"x = a \cos \omega t \cos \Omega t - b \sin \omega t \sin \Omega t",
        Step(Kind.SUBSTITUTE, ("17", "18")),
        Proof(given("17", "18"), _ANSATZ),
        number="20",
    ),
    claim(
        "20:y",
        r"y = a \cos \omega t \sin \Omega t + b \sin \omega t \cos \Omega t",
        Step(Kind.SUBSTITUTE, ("17", "18")),
        Proof(given("17", "18"), _ANSATZ),
        number="20",
    ),
    claim(
        "20.1:x",
        r"x^2 = a^2 \cos^2 \omega t \cos^2 \Omega t "
        r"- 2ab \cos \omega t \cos \Omega t \sin \omega t \sin \Omega t "
        r"+ b^2 \sin^2 \omega t \sin^2 \Omega t",
        Step(Kind.SUBSTITUTE, ("20",)),
        Proof(given("20"), _ANSATZ),
    ),
    claim(
        "20.1:y",
        _YY % "+",
        Step(Kind.SUBSTITUTE, ("20",)),
        Proof(given("20"), _ANSATZ),
        printed=_YY % "-",
    ),
    claim(
        "20.2",
        r"x^2 + y^2 = a^2 \cos^2 \omega t + b^2 \sin^2 \omega t",
        Step(Kind.ADD, ("20.1",)),
        Proof(_squares_added, _ANSATZ),
    ),
    claim(
        "20.3:1",
        r"\dot{x} = -a\omega \sin \omega t \cos \Omega t - a\Omega \cos \omega t \sin \Omega t "
        r"- b\omega \cos \omega t \sin \Omega t - b\Omega \sin \omega t \cos \Omega t",
        Step(Kind.DIFFERENTIATE, ("20:x",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(_velocity("x"), _ANSATZ),
    ),
    claim(
        "20.3:2",
        rf"= -{_P} \sin \omega t \cos \Omega t - {_Q} \cos \omega t \sin \Omega t",
        Step(Kind.REARRANGE, ("20.3:1",)),
        Proof(continued("20.3:1"), _ANSATZ),
        head="20.3:1",
    ),
    claim(
        "20.4:1",
        r"\dot{y} = -a\omega \sin \omega t \sin \Omega t + a\Omega \cos \omega t \cos \Omega t "
        r"+ b\omega \cos \omega t \cos \Omega t - b\Omega \sin \omega t \sin \Omega t",
        Step(Kind.DIFFERENTIATE, ("20:y",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(_velocity("y"), _ANSATZ),
    ),
    claim(
        "20.4:2",
        rf"= -{_P} \sin \omega t \sin \Omega t + {_Q} \cos \omega t \cos \Omega t",
        Step(Kind.REARRANGE, ("20.4:1",)),
        Proof(continued("20.4:1"), _ANSATZ),
        head="20.4:1",
    ),
    claim(
        "20.5:1",
        _SPEEDS % "+",
        Step(Kind.SUBSTITUTE, ("20.3:2", "20.4:2")),
        Proof(identity(_speeds), _ANSATZ),
        printed=_SPEEDS % "-",
    ),
    claim(
        "20.5:2",
        rf"= {_P}^2 \sin^2 \omega t + {_Q}^2 \cos^2 \omega t",
        Step(Kind.REARRANGE, ("20.5:1",)),
        Proof(continued("20.5:1"), _ANSATZ),
        head="20.5:1",
    ),
    claim(
        "20.6",
        _SLOW_SPEED % r"\approx",
        Step(Kind.NEGLECT, ("20.5",), _SMALL_TERMS, neglected=r"ab\omega\Omega"),
        Proof(_no_turning, to_order(2, ellipse), if_equal=_EXACTLY),
        printed=_SLOW_SPEED % "=",
    ),
    claim(
        "20.7:1",
        _PLACE + r" = (a \cos \omega t \cos \Omega t - b \sin \omega t \sin \Omega t)"
        r"(a^2 \cos^2 \omega t + b^2 \sin^2 \omega t)",
        Step(Kind.SUBSTITUTE, ("20:x", "20.2")),
        Proof(follows(_product("20:x", "20.2")), _ANSATZ),
    ),
    claim(
        "20.7:2",
        r"= a^3 \cos^3 \omega t \cos \Omega t + ab^2 \cos \omega t \cos \Omega t \sin^2 \omega t "
        r"- a^2 b \sin \omega t \sin \Omega t \cos^2 \omega t - b^3 \sin^3 \omega t \sin \Omega t",
        Step(Kind.REARRANGE, ("20.7:1",)),
        Proof(continued("20.7:1"), _ANSATZ),
        head="20.7:1",
    ),
    claim(
        "20.7:3",
        r"= \frac{1}{4} \left[ a^3 (3 \cos \omega t + \cos 3\omega t) \cos \Omega t "
        r"+ ab^2 (\cos \omega t - \cos 3\omega t) \cos \Omega t \right] "
        r"+ \frac{1}{4} \left[ -a^2 b (\sin \omega t + \sin 3\omega t) \sin \Omega t "
        r"- b^3 (3 \sin \omega t - \sin 3\omega t) \sin \Omega t \right]",
        Step(Kind.REARRANGE, ("20.7:2",)),
        Proof(continued("20.7:2"), _ANSATZ),
        head="20.7:1",
    ),
    claim(
        "20.8:1",
        rf"{_PLACE} \approx {_AVERAGE_PLACE}",
        Step(
            Kind.AVERAGE,
            ("20.7",),
            (c.THIRD,),
            neglected=r"\cos 3\omega t, \sin 3\omega t",
        ),
        Proof(
            both(_left_of("20.7:1"), continued("20.7:3", change=_averaged)),
            _AVERAGED,
            if_equal=_EXACTLY,
        ),
        printed=f"{_PLACE} = {_AVERAGE_PLACE}",
    ),
    claim(
        "20.8:2",
        rf"= \frac{{1}}{{4}} \left[ (3a^3 + ab^2) {_AC} - (3b^3 + a^2b) {_SS} \right]",
        Step(Kind.REARRANGE, ("20.8:1",)),
        Proof(continued("20.8:1"), _AVERAGED),
        head="20.8:1",
    ),
    claim(
        "20.9:1",
        rf"{_SPEED} \approx {_FIRST_SPEED}",
        Step(Kind.SUBSTITUTE, ("20:x", "20.6"), _SMALL_TERMS, neglected=r"a^2b\omega\Omega"),
        Proof(follows(_product("20:x", "20.6")), to_order(3, ellipse), if_equal=_EXACTLY),
        printed=rf"{_SPEED} = {_FIRST_SPEED}",
    ),
    claim(
        "20.9:2",
        r"= \omega^2 (a^3 \cos \omega t \sin^2 \omega t \cos \Omega t + ab^2 \cos^3 "
        r"\omega t \cos \Omega t "
        r"- a^2 b \sin^3 \omega t \sin \Omega t - b^3 \sin \omega t \cos^2 \omega t \sin \Omega t)",
        Step(Kind.REARRANGE, ("20.9:1",)),
        Proof(continued("20.9:1"), to_order(3, ellipse)),
        head="20.9:1",
    ),
    claim(
        "20.10:1",
        rf"{_SPEED} \approx "
        r"\frac{\omega^2}{4} \left[ a^3(\cos \omega t - \cos 3\omega t) \cos \Omega t "
        r"+ ab^2(3 \cos \omega t + \cos 3\omega t) \cos \Omega t \right] "
        r"- \frac{\omega^2}{4} \left[ a^2b(3 \sin \omega t - \sin 3\omega t) \sin \Omega t "
        r"+ b^3(\sin \omega t + \sin 3\omega t) \sin \Omega t \right]",
        Step(Kind.REARRANGE, ("20.9",)),
        Proof(
            both(_left_of("20.9:1"), continued("20.9:2")), to_order(3, ellipse), if_equal=_EXACTLY
        ),
        printed=rf"{_SPEED} = "
        r"\frac{\omega^2}{4} \left[ a^3(\cos \omega t - \cos 3\omega t) \cos \Omega t "
        r"+ ab^2(3 \cos \omega t + \cos 3\omega t) \cos \Omega t \right] "
        r"- \frac{\omega^2}{4} \left[ a^2b(3 \sin \omega t - \sin 3\omega t) \sin \Omega t "
        r"+ b^3(\sin \omega t + \sin 3\omega t) \sin \Omega t \right]",
    ),
    claim(
        "20.10:2",
        rf"\approx {_AVERAGE_SPEED}",
        Step(
            Kind.AVERAGE,
            ("20.10:1",),
            (c.THIRD,),
            neglected=r"\cos 3\omega t, \sin 3\omega t",
        ),
        Proof(continued("20.10:1", change=_averaged), _AVERAGED_SMALL, if_equal=_EXACTLY),
        printed=f"= {_AVERAGE_SPEED}",
        head="20.10:1",
    ),
    claim(
        "23:1",
        _CUBIC_LEFT % "-" + r"\approx " + _CUBIC_AVERAGED,
        Step(Kind.SUBSTITUTE, ("13a", "20.8", "20.10"), (c.THIRD, *_SMALL_TERMS)),
        Proof(_cubic_terms, _AVERAGED_SMALL, if_equal=_EXACTLY),
        printed=_CUBIC_LEFT % "+" + "= " + _CUBIC_AVERAGED,
        number="23",
    ),
    claim(
        "23:2",
        rf"= \frac{{1}}{{8l^2}} \left[ -2\omega^2(a^3 + 3ab^2) + \omega_0^2(3a^3 + "
        rf"ab^2) \right] {_AC} "
        rf"+ \frac{{1}}{{8l^2}} \left[ 2\omega^2(b^3 + 3a^2b) - \omega_0^2(3b^3 + a^2b) "
        rf"\right] {_SS}",
        Step(Kind.REARRANGE, ("23:1",)),
        Proof(continued("23:1"), _AVERAGED_SMALL),
        number="23",
        head="23:1",
    ),
)
