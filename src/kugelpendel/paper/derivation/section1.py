"""Section 1 of the paper: from Newton's law to (5a), (5b), (5c)."""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import rate
from kugelpendel.paper.algebra.notation import Relation, components
from kugelpendel.paper.algebra.symbols import VECTORS
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Matrix, Rational, cos, diff, sin, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import in_world
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    Rules,
    Symbolic,
    continued,
    follows,
    given,
    identity,
)
from kugelpendel.paper.proofs.worlds import dynamic, kinematic

_ANY = in_world(kinematic)
_MOVING = in_world(dynamic)


def _newton(relation: Relation, _: Premises) -> list[Expr]:
    """Lagrange's equations with the thread's pull along its own direction."""
    length = sqrt(s.x**2 + s.y**2 + s.z**2)
    energy = s.m * (s.xd**2 + s.yd**2 + s.zd**2) * Rational(1, 2) + s.m * s.g * s.z
    radial = (s.x * s.e_x + s.y * s.e_y + s.z * s.e_z) / s.l
    claimed = components(relation.difference.xreplace({s.e_r: radial}).expand(), s.CARTESIAN)
    residuals: list[Expr] = []
    for q, dot, part in zip((s.x, s.y, s.z), (s.xd, s.yd, s.zd), claimed, strict=True):
        pull = s.T * diff(length, q).subs(length, s.l)
        residuals.append(part - (rate(diff(energy, dot)) - diff(energy, q) + pull))
    return residuals


def turned_plumb_line() -> tuple[Expr, Expr, Expr]:
    """(0, 0, l) turned by θ from z towards x, then by φ about z: what the two angles mean."""
    tilt = Matrix([[cos(s.theta), 0, sin(s.theta)], [0, 1, 0], [-sin(s.theta), 0, cos(s.theta)]])
    turn = Matrix([[cos(s.phi), -sin(s.phi), 0], [sin(s.phi), cos(s.phi), 0], [0, 0, 1]])
    place = turn * tilt * Matrix([0, 0, s.l])
    return place[0], place[1], place[2]


def _angles(relation: Relation, _: Premises) -> list[Expr]:
    rules = dict(zip((s.x, s.y, s.z), turned_plumb_line(), strict=True))
    return [relation.difference.xreplace(rules)]


def _norm(p: Premises) -> Expr:
    square = Add(*(p[f"2:{q}"].rhs ** 2 for q in "xyz")).trigsimp()
    return s.r - sqrt(square)


def _rates(label: str) -> Callable[[Premises], Rules]:
    def rules(p: Premises) -> Rules:
        dots = {"2": (s.xd, s.yd, s.zd), "3.1": (s.xdd, s.ydd, s.zdd)}[label]
        return {dot: rate(p[f"{label}:{q}"].rhs) for dot, q in zip(dots, "xyz", strict=True)}

    return rules


def _triad(relation: Relation, p: Premises) -> list[Expr]:
    """e_r, e_θ, e_φ as directions in which r changes with r, θ, φ."""
    place = [p[f"2:{q}"].rhs for q in "xyz"]
    scales = {s.e_r: s.l, s.e_theta: s.l, s.e_phi: s.l * sin(s.theta)}
    changes = {
        s.e_r: place,
        s.e_theta: [diff(q, s.theta) for q in place],
        s.e_phi: [diff(q, s.phi) for q in place],
    }
    rules = {
        unit: sum(q * e for q, e in zip(changes[unit], s.CARTESIAN, strict=True)) / scales[unit]
        for unit in s.SPHERICAL
    }
    return list(components(relation.difference.xreplace(rules).expand(), s.CARTESIAN))


def _newton_in_components(p: Premises) -> Expr:
    law = p["1"].difference.subs(VECTORS[r"\ddot{\vec{r}}"], p["4.1:2"].rhs)
    return law.xreplace({s.e_z: p["4:z"].rhs})


def _project(unit: int, divisor: Expr) -> Symbolic:
    def derive(p: Premises) -> Expr:
        return components(p["4.2"].difference.expand(), s.SPHERICAL)[unit] / divisor

    return follows(derive)


_XDDOT = (
    r"-l \sin \theta \cdot \dot{\theta}^2 \cos \phi + l \cos \theta \cdot \ddot{\theta} \cos \phi "
    r"- l \cos \theta \cdot \dot{\theta} \sin \phi \cdot \dot{\phi} "
    r"- l \cos \theta \cdot \dot{\theta} \sin \phi \cdot \dot{\phi} "
    r"- l \sin \theta \cos \phi \cdot \dot{\phi}^2 - l \sin \theta \sin \phi \cdot \ddot{\phi}"
)
_YDDOT = (
    r"-l \sin \theta \cdot \dot{\theta}^2 \sin \phi + l \cos \theta \cdot \ddot{\theta} \sin \phi "
    r"+ l \cos \theta \cdot \dot{\theta} \cos \phi \cdot \dot{\phi} "
    r"+ l \cos \theta \cdot \dot{\theta} \cos \phi \cdot \dot{\phi} "
    r"- l \sin \theta \sin \phi \cdot \dot{\phi}^2 + l \sin \theta \cos \phi \cdot \ddot{\phi}"
)
_ZDDOT = r"-l \cos \theta \cdot \dot{\theta}^2 - l \sin \theta \cdot \ddot{\theta}"
_EX = (
    r"\sin \theta \cos \phi \vec{e}_r + \cos \theta \cos \phi \vec{e}_\theta - \sin "
    r"\phi \vec{e}_\phi"
)
_EY = (
    r"\sin \theta \sin \phi \vec{e}_r + \cos \theta \sin \phi \vec{e}_\theta + \cos "
    r"\phi \vec{e}_\phi"
)
_EZ = r"\cos \theta \vec{e}_r - \sin \theta \vec{e}_\theta"
_RADIAL = r"\dot{\theta}^2 + \dot{\phi}^2 \sin^2 \theta"
_POLAR = r"\ddot{\theta} - \dot{\phi}^2 \sin \theta \cos \theta"
_AZIMUTHAL = r"\ddot{\phi} \sin \theta + 2\dot{\theta}\dot{\phi} \cos \theta"
_VECTORS = (
    r"ml \cdot \begin{{pmatrix}} {radial} \\ {polar} \\ {azimuthal} \end{{pmatrix}} "
    r"= mg \cdot \begin{{pmatrix}} \cos \theta \\ -\sin \theta \\ 0 \end{{pmatrix}} "
    r"- T \cdot \begin{{pmatrix}} 1 \\ 0 \\ 0 \end{{pmatrix}}"
)

_DIFFERENTIATE = Step(Kind.DIFFERENTIATE, ("2",), (c.INEXTENSIBLE,))
_AGAIN = Step(Kind.DIFFERENTIATE, ("3.1",), (c.INEXTENSIBLE,))
_SPHERE = Step(Kind.DEFINE, (), (c.DOWNWARD,))
_TRIAD = Step(Kind.PROJECT, ("2",), (c.OFF_AXIS,))
_FIRST = Proof(identity(_rates("2")), _ANY)
_SECOND = Proof(identity(_rates("3.1")), _ANY)

FORMULAS: tuple[Formula, ...] = (
    claim(
        "1",
        r"m\ddot{\vec{r}} = mg\vec{e}_z - T\vec{e}_r",
        Step(Kind.LAW, (), (c.INERTIAL, c.SPHERE)),
        Proof(_newton, _MOVING),
        number="1",
    ),
    claim("2:x", r"x = l \sin \theta \cos \phi", _SPHERE, Proof(_angles, _ANY), number="2"),
    claim("2:y", r"y = l \sin \theta \sin \phi", _SPHERE, Proof(_angles, _ANY), number="2"),
    claim("2:z", r"z = l \cos \theta", _SPHERE, Proof(_angles, _ANY), number="2"),
    claim(
        "3",
        r"r = l",
        Step(Kind.LAW, ("2",), (c.SPHERE, c.INEXTENSIBLE)),
        Proof(follows(_norm), _ANY),
        number="3",
    ),
    claim(
        "3.1:x",
        r"\dot{x} = l \cos \theta \cdot \dot{\theta} \cos \phi - l \sin \theta \sin "
        r"\phi \cdot \dot{\phi}",
        _DIFFERENTIATE,
        _FIRST,
    ),
    claim(
        "3.1:y",
        r"\dot{y} = l \cos \theta \cdot \dot{\theta} \sin \phi + l \sin \theta \cos "
        r"\phi \cdot \dot{\phi}",
        _DIFFERENTIATE,
        _FIRST,
    ),
    claim("3.1:z", r"\dot{z} = -l \sin \theta \cdot \dot{\theta}", _DIFFERENTIATE, _FIRST),
    claim("3.2:x", rf"\ddot{{x}} = {_XDDOT}", _AGAIN, _SECOND),
    claim(
        "3.2:y",
        rf"\ddot{{y}} = {_YDDOT}",
        _AGAIN,
        _SECOND,
        printed=rf"\ddot{{y}} = {_YDDOT}".replace(
            r"+ l \sin \theta \cos \phi \cdot \ddot{\phi}",
            r"- l \sin \theta \cos \phi \cdot \ddot{\phi}",
        ),
    ),
    claim("3.2:z", rf"\ddot{{z}} = {_ZDDOT}", _AGAIN, _SECOND),
    claim("4:x", rf"\vec{{e}}_x = {_EX}", _TRIAD, Proof(_triad, _ANY), number="4"),
    claim("4:y", rf"\vec{{e}}_y = {_EY}", _TRIAD, Proof(_triad, _ANY), number="4"),
    claim("4:z", rf"\vec{{e}}_z = {_EZ}", _TRIAD, Proof(_triad, _ANY), number="4"),
    claim(
        "4.1:1",
        rf"\ddot{{\vec{{r}}}} = ({_XDDOT}) \cdot ({_EX}) + ({_YDDOT}) \cdot ({_EY}) "
        rf"+ ({_ZDDOT}) \cdot ({_EZ})",
        Step(Kind.SUBSTITUTE, ("3.2", "4")),
        Proof(given("3.2", "4"), _ANY),
    ),
    claim(
        "4.1:2",
        rf"= l [-({_RADIAL}) \cdot \vec{{e}}_r + ({_POLAR}) \cdot \vec{{e}}_\theta "
        rf"+ ({_AZIMUTHAL}) \cdot \vec{{e}}_\phi]",
        Step(Kind.REARRANGE, ("4.1:1",)),
        Proof(continued("4.1:1"), _ANY),
        printed=rf"= -l [({_RADIAL}) \cdot \vec{{e}}_r + ({_POLAR}) \cdot \vec{{e}}_\theta "
        rf"+ ({_AZIMUTHAL}) \cdot \vec{{e}}_\phi]",
        head="4.1:1",
    ),
    claim(
        "4.2",
        _VECTORS.format(
            radial=r"-\dot{\theta}^2 - \dot{\phi}^2 \sin^2 \theta",
            polar=_POLAR,
            azimuthal=_AZIMUTHAL,
        ),
        Step(Kind.SUBSTITUTE, ("1", "4", "4.1:2")),
        Proof(follows(_newton_in_components), _MOVING),
        printed=_VECTORS.format(radial=_RADIAL, polar=_POLAR, azimuthal=_AZIMUTHAL),
    ),
    claim(
        "5a",
        rf"T = mg \cos \theta + ml({_RADIAL})",
        Step(Kind.PROJECT, ("4.2",), detail=r"\vec{e}_r"),
        Proof(_project(0, Rational(1)), _MOVING),
        number="5a",
    ),
    claim(
        "5b",
        rf"{_POLAR} + \frac{{g}}{{l}} \sin \theta = 0",
        Step(Kind.PROJECT, ("4.2",), detail=r"\vec{e}_\theta, \quad \frac{1}{ml}"),
        Proof(_project(1, s.m * s.l), _MOVING),
        number="5b",
    ),
    claim(
        "5c",
        rf"{_AZIMUTHAL} = 0",
        Step(Kind.PROJECT, ("4.2",), detail=r"\vec{e}_\phi, \quad \frac{1}{ml}"),
        Proof(_project(2, s.m * s.l), _MOVING),
        number="5c",
    ),
)
