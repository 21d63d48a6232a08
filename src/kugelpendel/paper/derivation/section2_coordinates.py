"""Section 2, first half: (6) to (10), back and forth between angles and Cartesian coordinates."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out
from kugelpendel.paper.algebra.notation import Relation, components
from kugelpendel.paper.algebra.symbols import SYMBOL
from kugelpendel.paper.algebra.sympy_names import Expr, Matrix, cos, diff, sin, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import in_world
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    both,
    continued,
    follows,
    given,
    put,
)
from kugelpendel.paper.proofs.worlds import dynamic, kinematic

_ANY = in_world(kinematic)
_MOVING = in_world(dynamic)
_FROM_6 = ("5.1", "6:2", "6b:4", "6.1:3", "6.2:2")


def _from_6(p: Premises, expression: Expr) -> Expr:
    """The terms in x, y and their rates, copied from (6); ρ² too."""
    rules = p.rules("6.1:3", "6b:4", "6.2:2")
    rules |= p.rules("5.1", "6:2")
    return put(expression, rules)


def _axis_distance(relation: Relation, p: Premises) -> list[Expr]:
    """ρ is the distance from the axis: what is left of r when its part along z is taken away."""
    rest = Matrix([s.x, s.y, s.z]) - Matrix([0, 0, 1]) * s.z
    return [relation.difference.xreplace({s.rho: sqrt(rest.dot(rest))})]


def _meets_5c(relation: Relation, p: Premises) -> list[Expr]:
    """Besides being carried out: the right side is (5c)'s left side."""
    return [relation.rhs - p["5c"].lhs]


def _momentum_kept(p: Premises) -> Expr:
    """l² d/dt(φ̇ sin²θ) is l² sin θ times (5c)'s left side, by 6.3."""
    return s.l**2 * sin(s.theta) * (p["6.3"].lhs - p["6.3"].rhs + p["5c"].lhs)


def _generator(relation: Relation, _: Premises) -> list[Expr]:
    """L as what turning conserves: its part along an axis is m v·(change of r per angle)."""
    speed, place = Matrix([s.xd, s.yd, s.zd]), Matrix([s.x, s.y, s.z])
    rules: dict[Expr, Expr] = {}
    for axis, name in enumerate(("L_x", "L_y", "L_z")):
        angle = s.theta
        turn = Matrix.eye(3)
        j, k = (axis + 1) % 3, (axis + 2) % 3
        turn[j, j] = turn[k, k] = cos(angle)
        turn[j, k], turn[k, j] = -sin(angle), sin(angle)
        rules[SYMBOL[name]] = s.m * speed.dot(diff(turn * place, angle).subs(angle, 0))
    return list(components(relation.difference.xreplace(rules).expand(), s.CARTESIAN))


def _backwards(relation: Relation, p: Premises) -> list[Expr]:
    """(10) in angles is l² sin θ cos θ times (5b)'s left side."""
    frequency = {s.omega0: sqrt(s.g / s.l)}
    factor = s.l**2 * sin(s.theta) * cos(s.theta)
    return [_from_6(p, relation.difference).xreplace(frequency) - factor * p["5b"].lhs]


def _is_5b(relation: Relation, p: Premises) -> list[Expr]:
    return [relation.difference.xreplace({s.omega0: sqrt(s.g / s.l)}) - p["5b"].difference]


_ROOT = r"\omega_0^2 l^2 \sin^2 \theta \sqrt{1 - \frac{l^2 \sin^2 \theta}{l^2}}"
_YY_OLD = r"- l^2 \sin \theta \sin \phi \cos \phi \cdot \ddot{\phi}"
_YY_NEW = r"+ l^2 \sin^2 \theta \sin \phi \cos \phi \cdot \ddot{\phi}"
_XX_YY = (
    r"x\ddot{x} + y\ddot{y} = -l^2 \sin^2 \theta \cdot \dot{\theta}^2 \cos^2 \phi "
    r"+ l^2 \sin \theta \cos \theta \cdot \ddot{\theta} \cos^2 \phi "
    r"- l^2 \sin \theta \cos \theta \cdot \dot{\theta} \sin \phi \cos \phi \cdot \dot{\phi} "
    r"- l^2 \sin \theta \cos \theta \cdot \dot{\theta} \sin \phi \cos \phi \cdot \dot{\phi} "
    r"- l^2 \sin^2 \theta \cos^2 \phi \cdot \dot{\phi}^2 "
    r"- l^2 \sin^2 \theta \sin \phi \cos \phi \cdot \ddot{\phi} "
    r"- l^2 \sin^2 \theta \cdot \dot{\theta}^2 \sin^2 \phi "
    r"+ l^2 \sin \theta \cos \theta \cdot \ddot{\theta} \sin^2 \phi "
    r"+ l^2 \sin \theta \cos \theta \cdot \dot{\theta} \sin \phi \cos \phi \cdot \dot{\phi} "
    r"+ l^2 \sin \theta \cos \theta \cdot \dot{\theta} \sin \phi \cos \phi \cdot \dot{\phi} "
    r"- l^2 \sin^2 \theta \sin^2 \phi \cdot \dot{\phi}^2 "
)
_SPEEDS_X = (
    r"\dot{x}^2 + \dot{y}^2 = l^2 \cos^2 \theta \cdot \dot{\theta}^2 \cos^2 \phi "
    r"- 2l^2 \cos \theta \sin \theta \cos \phi \sin \phi \cdot \dot{\theta} \dot{\phi} "
    r"+ l^2 \sin^2 \theta \sin^2 \phi \cdot \dot{\phi}^2 "
    r"+ l^2 \cos^2 \theta \cdot \dot{\theta}^2 \sin^2 \phi "
)
_SPEEDS_Y = (
    r" 2l^2 \cos \theta \sin \theta \sin \phi \cos \phi \cdot \dot{\theta} \dot{\phi} "
    r"+ l^2 \sin^2 \theta \cos^2 \phi \cdot \dot{\phi}^2"
)
_RADIAL_X = (
    r"\dot{x}x + \dot{y}y = (l \cos \theta \cdot \dot{\theta} \cos \phi "
    r"- l \sin \theta \sin \phi \cdot \dot{\phi})l \sin \theta \cos \phi "
)
_RADIAL_Y = (
    r"+ (l \cos \theta \cdot \dot{\theta} \sin \phi "
    r"%s l \sin \theta \cos \phi \cdot \dot{\phi})l \sin \theta \sin \phi"
)
_IN_ANGLES = (
    r"l^2 \sin \theta (\ddot{\theta} \cos \theta - \dot{\theta}^2 \sin \theta "
    r"- \dot{\phi}^2 \sin \theta) + \frac{1}{l^2} "
    r"\frac{%s \dot{\theta}^2 \sin^2 \theta \cos^2 \theta}{1 - \frac{l^2 \sin^2 \theta}{l^2}} + "
    r"\frac{1}{l^2} l^4 \dot{\phi}^2 \sin^4 \theta + "
)
_POSITION = r"\begin{pmatrix} x \\ y \\ z \end{pmatrix}"
_SPEED = r"\begin{pmatrix} \dot{x} \\ \dot{y} \\ \dot{z} \end{pmatrix}"


FORMULAS: tuple[Formula, ...] = (
    claim(
        "5.1",
        r"x^2 + y^2 = l^2 \sin^2 \theta",
        Step(Kind.SUBSTITUTE, ("2",)),
        Proof(given("2"), _ANY),
    ),
    claim(
        "6:1",
        r"\rho^2 = x^2 + y^2",
        Step(Kind.DEFINE),
        Proof(_axis_distance, _ANY),
        number="6",
    ),
    claim(
        "6:2",
        r"= l^2 \sin^2 \theta",
        Step(Kind.SUBSTITUTE, ("5.1", "6:1")),
        Proof(follows(lambda p: p["6:1"].difference + p["5.1"].difference), _ANY),
        number="6",
        head="6:1",
    ),
    claim(
        "6b:1",
        _RADIAL_X + _RADIAL_Y % "+",
        Step(Kind.SUBSTITUTE, ("2", "3.1")),
        Proof(given("3.1", "2"), _ANY),
        printed=_RADIAL_X + _RADIAL_Y % "-",
        number="6",
    ),
    claim(
        "6b:2",
        r"= l \cos \theta \cdot \dot{\theta} \cos \phi l \sin \theta \cos \phi "
        r"+ l \cos \theta \cdot \dot{\theta} \sin \phi l \sin \theta \sin \phi",
        Step(Kind.REARRANGE, ("6b:1",)),
        Proof(continued("6b:1"), _ANY),
        number="6",
        head="6b:1",
    ),
    claim(
        "6b:3",
        r"= l^2 \cos \theta \sin \theta \cdot \dot{\theta} \cdot (\cos^2 \phi + \sin^2 \phi)",
        Step(Kind.REARRANGE, ("6b:2",)),
        Proof(continued("6b:2"), _ANY),
        number="6",
        head="6b:1",
    ),
    claim(
        "6b:4",
        r"= l^2 \dot{\theta} \sin \theta \cos \theta",
        Step(Kind.REARRANGE, ("6b:3",)),
        Proof(continued("6b:3"), _ANY),
        number="6",
        head="6b:1",
    ),
    claim(
        "6c:1",
        _SPEEDS_X + "+" + _SPEEDS_Y,
        Step(Kind.SUBSTITUTE, ("3.1",)),
        Proof(given("3.1"), _ANY),
        printed=_SPEEDS_X + "-" + _SPEEDS_Y,
        number="6",
    ),
    claim(
        "6c:2",
        r"= l^2 \cos^2 \theta \cdot \dot{\theta}^2 (\cos^2 \phi + \sin^2 \phi) "
        r"+ l^2 \sin^2 \theta \cdot \dot{\phi}^2 (\sin^2 \phi + \cos^2 \phi)",
        Step(Kind.REARRANGE, ("6c:1",)),
        Proof(continued("6c:1"), _ANY),
        printed=r"= l^2 \cos^2 \theta \cdot \dot{\theta}^2 (\cos^2 \phi + \sin^2 \phi) "
        r"+ l^2 \sin^2 \theta \cdot \dot{\theta}^2 (\sin^2 \phi + \cos^2 \phi)",
        number="6",
        head="6c:1",
    ),
    claim(
        "6c:3",
        r"= l^2 (\dot{\theta}^2 \cos^2 \theta + \dot{\phi}^2 \sin^2 \theta)",
        Step(Kind.REARRANGE, ("6c:2",)),
        Proof(continued("6c:2"), _ANY),
        number="6",
        head="6c:1",
    ),
    claim(
        "6.1:1",
        _XX_YY + _YY_NEW,
        Step(Kind.SUBSTITUTE, ("2", "3.2")),
        Proof(given("3.2", "2"), _ANY),
        printed=_XX_YY + _YY_OLD,
    ),
    claim(
        "6.1:2",
        r"= -l^2 \sin^2 \theta \cdot \dot{\theta}^2 + l^2 \sin \theta \cos \theta "
        r"\cdot \ddot{\theta} "
        r"- l^2 \sin^2 \theta \cdot \dot{\phi}^2",
        Step(Kind.REARRANGE, ("6.1:1",)),
        Proof(continued("6.1:1"), _ANY),
        head="6.1:1",
    ),
    claim(
        "6.1:3",
        r"= l^2 \sin \theta (\ddot{\theta} \cos \theta - \dot{\theta}^2 \sin \theta "
        r"- \dot{\phi}^2 \sin \theta)",
        Step(Kind.REARRANGE, ("6.1:2",)),
        Proof(continued("6.1:2"), _ANY),
        head="6.1:1",
    ),
    claim(
        "6.2:1",
        r"x\dot{y} - y\dot{x} = l^2 \sin^2 \theta \cos^2 \phi \cdot \dot{\phi} "
        r"+ l^2 \sin^2 \theta \sin^2 \phi \cdot \dot{\phi}",
        Step(Kind.SUBSTITUTE, ("2", "3.1")),
        Proof(given("3.1", "2"), _ANY),
    ),
    claim(
        "6.2:2",
        r"= l^2 \sin^2 \theta \cdot \dot{\phi}",
        Step(Kind.REARRANGE, ("6.2:1",)),
        Proof(continued("6.2:1"), _ANY),
        head="6.2:1",
    ),
    claim(
        "6.3",
        r"\frac{1}{\sin \theta} \frac{d}{dt} (\dot{\phi} \sin^2 \theta) = "
        r"\ddot{\phi} \sin \theta + \dot{\phi} 2 \cos \theta \cdot \dot{\theta}",
        Step(Kind.DIFFERENTIATE, ("5c",), (c.OFF_AXIS,)),
        Proof(both(given(), _meets_5c), _ANY),
    ),
    claim(
        "8:1",
        r"l^2 \frac{d}{dt} (\dot{\phi} \sin^2 \theta) = \frac{d}{dt} (x\dot{y} - y\dot{x})",
        Step(Kind.SUBSTITUTE, ("6.2:2",)),
        Proof(given("6.2:2"), _ANY),
        printed=r"\frac{1}{l^2} \frac{d}{dt} (\dot{\phi} \sin^2 \theta) = "
        r"\frac{d}{dt} (x\dot{y} - y\dot{x})",
        number="8",
    ),
    claim(
        "8:2",
        r"= 0",
        Step(Kind.MULTIPLY, ("5c", "6.3"), (c.OFF_AXIS,), detail=r"l^2 \sin \theta"),
        Proof(follows(_momentum_kept), _MOVING),
        number="8",
        head="8:1",
    ),
    claim(
        "8.1:1",
        r"\vec{L} = m\vec{r} \times \vec{v}",
        Step(Kind.DEFINE),
        Proof(_generator, _ANY),
        printed=r"\vec{L} = m\vec{v} \times \vec{r}",
    ),
    claim(
        "8.1:2",
        rf"= m {_POSITION} \times {_SPEED}",
        Step(Kind.SUBSTITUTE, ("8.1:1",)),
        Proof(continued("8.1:1"), _ANY),
        printed=rf"= m {_SPEED} \times {_POSITION}",
        head="8.1:1",
    ),
    claim(
        "8.1:3",
        r"= m \begin{pmatrix} y\dot{z} - z\dot{y} \\ z\dot{x} - x\dot{z} \\ "
        r"x\dot{y} - y\dot{x} \end{pmatrix}",
        Step(Kind.REARRANGE, ("8.1:2",)),
        Proof(continued("8.1:2"), _ANY),
        printed=r"= m \begin{pmatrix} \dot{y}z - \dot{z}y \\ -\dot{x}z + \dot{z}x \\ "
        r"\dot{x}y - \dot{y}x \end{pmatrix}",
        head="8.1:1",
    ),
    claim(
        "9:1",
        r"\dot{x}\dot{y} + x\ddot{y} - \dot{y}\dot{x} - y\ddot{x} = 0",
        Step(Kind.DIFFERENTIATE, ("8",)),
        Proof(follows(lambda p: carry_out(p["8:1"].rhs) - p["8:2"].rhs), _MOVING),
        number="9",
    ),
    claim(
        "9:2",
        r"x\ddot{y} = y\ddot{x}",
        Step(Kind.REARRANGE, ("9:1",)),
        Proof(follows(lambda p: p["9:1"]), _MOVING),
        number="9",
    ),
    claim(
        "10",
        r"x\ddot{x} + y\ddot{y} + \frac{1}{l^2} \frac{(x\dot{x} + y\dot{y})^2}{1 - "
        r"\frac{\rho^2}{l^2}} "
        r"+ \frac{1}{l^2} (x\dot{y} - y\dot{x})^2 "
        r"+ \omega_0^2 (x^2 + y^2) \sqrt{1 - \frac{\rho^2}{l^2}} = 0",
        Step(
            Kind.MULTIPLY,
            ("5b", *_FROM_6),
            (c.OMEGA_ZERO, c.LOWER_HALF, c.NOT_EQUATOR),
            detail=r"l^2 \sin \theta \cos \theta",
        ),
        Proof(_backwards, _MOVING),
        number="10",
    ),
    claim(
        "10.1",
        _IN_ANGLES % "l^4" + _ROOT + " = 0",
        Step(Kind.SUBSTITUTE, ("10", *_FROM_6), (c.NOT_EQUATOR,)),
        Proof(follows(lambda p: _from_6(p, p["10"].difference)), _MOVING),
        printed=_IN_ANGLES % "l^2" + _ROOT + " = 0",
    ),
    claim(
        "10.2",
        r"l^2 \ddot{\theta} \cos \theta \sin \theta - l^2 \dot{\theta}^2 \sin^2 \theta "
        r"- l^2 \dot{\phi}^2 \sin^2 \theta + l^2 \dot{\theta}^2 \sin^2 \theta "
        r"+ l^2 \dot{\phi}^2 \sin^4 \theta + \omega_0^2 l^2 \sin^2 \theta \cos \theta = 0",
        Step(Kind.REARRANGE, ("10.1",), (c.LOWER_HALF, c.NOT_EQUATOR)),
        Proof(follows(lambda p: p["10.1"]), _MOVING),
    ),
    claim(
        "10.3",
        r"l^2 \ddot{\theta} \cos \theta \sin \theta - l^2 \dot{\phi}^2 \sin^2 \theta "
        r"(1 - \sin^2 \theta) "
        r"+ \omega_0^2 l^2 \sin^2 \theta \cos \theta = 0",
        Step(Kind.REARRANGE, ("10.2",)),
        Proof(follows(lambda p: p["10.2"]), _MOVING),
    ),
    claim(
        "10.4",
        r"\ddot{\theta} - \dot{\phi}^2 \frac{\sin^2 \theta \cos^2 \theta}{\sin \theta \cos \theta} "
        r"+ \omega_0^2 \frac{\sin^2 \theta \cos \theta}{\sin \theta \cos \theta} = 0",
        Step(
            Kind.DIVIDE,
            ("10.3",),
            (c.OFF_AXIS, c.NOT_EQUATOR),
            detail=r"l^2 \cos \theta \sin \theta",
        ),
        Proof(
            follows(lambda p: p["10.3"].difference / (s.l**2 * cos(s.theta) * sin(s.theta))),
            _MOVING,
        ),
    ),
    claim(
        "10.5",
        r"\ddot{\theta} - \dot{\phi}^2 \sin \theta \cos \theta + \omega_0^2 \sin \theta = 0",
        Step(Kind.REARRANGE, ("5b", "10.4"), (c.OMEGA_ZERO,)),
        Proof(both(follows(lambda p: p["10.4"]), _is_5b), _MOVING),
    ),
)
