"""The formulas in the wording of our own chapters, read and proved."""

from __future__ import annotations

from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.balance import rates
from kugelpendel.paper.algebra.calculus import (
    AXES,
    graded,
    harmonics,
    is_zero,
    leading,
    taylor,
)
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import (
    Add,
    Expr,
    Integer,
    Matrix,
    Rational,
    cos,
    diff,
    expand,
    pi,
    sin,
    sqrt,
)
from kugelpendel.paper.derivation.graph import right

_SMALL = {s.x: 1, s.y: 1, s.xd: 1, s.yd: 1}


def shares(relation: Relation) -> bool:
    """The coefficient of (25), and of the first term of (26), as a sum of two numbers."""
    turning = right("25").rhs * s.l**2 / (s.omega0 * s.a * s.b)
    falling = (right("26").rhs / s.omega0**2 - 1) * s.l**2 / (s.a**2 + s.b**2)
    return is_zero(relation.difference) and any(
        is_zero(relation.lhs - q) for q in (turning, falling)
    )


def is_action(relation: Relation) -> bool:
    """What a circle has of x ẏ − y ẋ when it is run through with ω0, without its sign."""
    sizes = {s.J_1: s.A_1, s.J_2: s.A_2}
    if relation.lhs not in sizes:
        return False
    size, angle = sizes[relation.lhs], s.omega0 * s.t
    x, y = size * cos(angle), size * sin(angle)
    return is_zero(relation.rhs - (x * diff(y, s.t) - y * diff(x, s.t)))


@cache
def normal_form() -> Expr:
    """The mean of the pendulum's Hamiltonian, to fourth order, over both circular motions.

    Legendre's transformation of T − V on the sphere, with x and y as coordinates, divided by m.
    """
    below = s.l**2 - s.x**2 - s.y**2
    place = Matrix([s.x, s.y])
    mass = Matrix.eye(2) + place * place.T / below
    momenta = Matrix([s.xd, s.yd])
    kinetic = (momenta.T * mass.inv() * momenta)[0] / 2
    potential = s.omega0**2 * s.l * (s.l - sqrt(below))
    orders = taylor(graded(kinetic + potential, _SMALL), 4)
    angle = s.omega0 * s.t
    motion = {s.x: (s.A_1 + s.A_2) * cos(angle), s.y: (s.A_1 - s.A_2) * sin(angle)}
    motion |= {dot: diff(motion[q], s.t) for q, dot in ((s.x, s.xd), (s.y, s.yd))}
    mean = expand(Add(orders[2], orders[4]).xreplace(motion))
    constant = harmonics(mean, angle).get(0, (Integer(0),))[0]
    return constant.xreplace({s.A_1: sqrt(s.J_1 / s.omega0), s.A_2: sqrt(s.J_2 / s.omega0)})


def is_normal_form(relation: Relation) -> bool:
    """Whether H is that mean, in the two actions."""
    return relation.lhs == s.H and is_zero(expand(relation.rhs - normal_form()))


def is_rate(relation: Relation) -> bool:
    """Whether ω1 is the derivative of the normal form by J1, and agrees with A12."""
    claimed = relation.rhs - diff(normal_form(), s.J_1)
    sizes = {s.J_1: s.omega0 * s.A_1**2, s.J_2: s.omega0 * s.A_2**2}
    square = graded(relation.rhs.xreplace(sizes) ** 2, {s.A_1: 1, s.A_2: 1})
    balance = right("A12:1").difference - s.omega_1**2
    agreed = graded(-balance, {s.A_1: 1, s.A_2: 1})
    return (
        relation.lhs == s.omega_1 and is_zero(expand(claimed)) and leading(square - agreed)[0] >= 4
    )


def area() -> Expr:
    """Half of x ẏ − y ẋ, which is the rate of the area, times the time of a swing."""
    x, y = right("16:x").rhs, right("16:y").rhs
    return (x * diff(y, s.t) - y * diff(x, s.t)) / 2 * (2 * pi / s.omega0)


def share_of_turning() -> Expr:
    """Ω over the rate at which a direction that is carried parallel turns, by B2 and B4."""
    return right("B2").rhs / right("B4:2").rhs


def is_energy(relation: Relation) -> bool:
    """Whether the energy of (20) begins so: all else is of fourth order."""
    return relation.lhs == s.E and leading(_energy() - graded(relation.rhs, AXES))[0] >= 4


def _energy() -> Expr:
    """½v² and the height, for the ellipse at rest, to second order."""
    x, y = right("16:x").rhs, right("16:y").rhs
    square = diff(x, s.t) ** 2 + diff(y, s.t) ** 2 + s.omega0**2 * (x**2 + y**2)
    return graded(square / 2, AXES)


def is_frequency(relation: Relation) -> bool:
    """Whether (26) says so, when the energy of the ellipse is put in."""
    energy = s.omega0**2 * (s.a**2 + s.b**2) / 2
    said = relation.rhs.xreplace({s.E: energy, s.g: s.omega0**2 * s.l})
    return relation.lhs == s.omega**2 and is_zero(said - right("26").rhs)


def share_of_25() -> Expr:
    """By what share (25) is low, to leading order, by D2."""
    return expand(right("D2").rhs / right("25").rhs) - 1


def cubic_alone() -> Expr:
    """Ω of (13a) as it stands, to fourth order."""
    _, turning = rates(right("13a").lhs)
    return s.omega0 * Add(*turning[:3])


def is_cubic_alone(relation: Relation) -> bool:
    """Whether that is what the relation says of Ω."""
    return relation.lhs == s.Omega and is_zero(relation.rhs - cubic_alone())


def is_twelfth(relation: Relation) -> bool:
    """Whether both sides are the coefficient of D2, which is a twelfth more than (13a) gives."""
    wanted = share_of_25() * s.l**2 / (s.a**2 + s.b**2)
    alone = (cubic_alone() / right("25").rhs - 1) * s.l**2 / (s.a**2 + s.b**2)
    twelfth = (wanted - alone).simplify()
    return all(is_zero(side - wanted) for side in (relation.lhs, relation.rhs)) and (
        twelfth == Rational(1, 12)
    )
