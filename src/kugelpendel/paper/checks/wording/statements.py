"""The formulas in the wording, read and proved; and the figures that its words say.

Each proof takes the relation that stands in the text and answers whether it is so; a spoilt one is
rejected by the same proof.
"""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import (
    EPS,
    carry_out,
    graded,
    is_zero,
    leading,
    taylor,
)
from kugelpendel.paper.algebra.notation import Relation, read
from kugelpendel.paper.algebra.requirement import quantity, required
from kugelpendel.paper.algebra.symbols import VECTORS
from kugelpendel.paper.algebra.sympy_names import (
    Add,
    Expr,
    Integer,
    cos,
    expand,
    sin,
    sqrt,
)
from kugelpendel.paper.checks.conditions_violated import cone, lengthening
from kugelpendel.paper.checks.remainders import remainders, third_harmonic
from kugelpendel.paper.checks.wording import chapters
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.graph import right
from kugelpendel.paper.derivation.statements import STATEMENTS

Judge = Callable[[Relation], bool]


def statement(name: str) -> Relation:
    """Read the statement of that name; a term has 0 on its right and no relation sign."""
    latex = STATEMENTS[name]
    if name in _CONDITIONS:
        first = required(latex)[0]
        return Relation(first.left, first.sign, first.right)
    if r"\dot{l}" in latex:
        return Relation(quantity(latex), "", Integer(0))
    return read(latex)


def holds(name: str, relation: Relation | None = None) -> bool:
    """Whether the statement of that name is so, or another relation in its place."""
    judge = _JUDGES.get(name)
    claimed = relation or statement(name)
    if name in _CONDITIONS:
        return (claimed.lhs, claimed.op, claimed.rhs) == _CONDITIONS[name]()
    return judge is not None and claimed.op == _SIGNS.get(name, "=") and judge(claimed)


def _same(wanted: Callable[[], Expr]) -> Judge:
    """A term, which must be this expression."""
    return lambda relation: is_zero(relation.lhs - wanted())


def _term(label: str) -> Expr:
    (one,) = (remainder for remainder in remainders() if remainder.label == label)
    return one.term.xreplace(_DISTANCE)


def _identity(relation: Relation) -> bool:
    return is_zero(relation.difference) and not _is_trivial(relation)


def _is_trivial(relation: Relation) -> bool:
    return bool(carry_out(relation.lhs) == carry_out(relation.rhs) == 0)


def _case(label: str, rules: dict[Expr, Expr], result: Callable[[], Expr]) -> Judge:
    """What a formula says at a special place: its difference there is that of the statement."""

    def judge(relation: Relation) -> bool:
        return is_zero(right(label).difference.xreplace(rules) - relation.difference - result())

    return judge


def _by_25(relation: Relation) -> bool:
    """What (25) says, in other words: it is so when Ω is put in, and not before."""
    return not is_zero(relation.difference) and is_zero(relation.difference.xreplace(_found()))


def _found() -> dict[Expr, Expr]:
    return {s.Omega: right("25").rhs, s.omega: sqrt(right("26").rhs)}


def _assignment(check: Callable[[dict[Expr, Expr]], bool]) -> Judge:
    """A case such as b = 0: what the words say of it must be so there."""
    return lambda relation: relation.lhs.is_Symbol and check({relation.lhs: relation.rhs})


def _is_straight(case: dict[Expr, Expr]) -> bool:
    """On a straight line the ellipse does not turn, and only its longer axis is left."""
    return (
        is_zero(right("25").rhs.subs(case))
        and not is_zero(right("26").rhs.subs(case) - s.omega0**2)
        and (not is_zero(right("16:x").rhs.subs(case)))
    )


def _is_level(case: dict[Expr, Expr]) -> bool:
    """There the denominator of (10) and (12) vanishes: 1 − ρ²/l²."""
    distance = case.get(s.rho, Integer(0))
    return bool(distance.is_positive) and is_zero((1 - s.rho**2 / s.l**2).subs(case))


def _stops_turning(case: dict[Expr, Expr]) -> bool:
    return is_zero((sin(s.omega * s.t) * sin(s.Omega * s.t)).subs(case)) and s.Omega in case


def _is_in_a_plane(relation: Relation) -> bool:
    """What one dot each would mean: no angular momentum, x ẏ − y ẋ = 0."""
    return is_zero(relation.difference - right("6.2:1").lhs)


def _is_natural(relation: Relation) -> bool:
    """The root of what the condition on ω0² says, and the positive one."""
    square = _first(c.OMEGA_ZERO.latex)[2]
    positive = bool(relation.rhs.is_positive)
    return relation.lhs == s.omega0 and positive and is_zero(relation.rhs**2 - square)


def _is_sideways(relation: Relation) -> bool:
    start = right("16:y").rhs.diff(s.t).subs(s.t, 0)
    return relation.lhs == s.yd and is_zero(relation.rhs - start)


def _is_near(relation: Relation) -> bool:
    """Z is l but for the second order in ρ, by (2) and (6)."""
    exact = s.l * sqrt(1 - s.rho**2 / s.l**2)
    rest = graded(exact - relation.rhs, {s.rho: 1})
    return relation.lhs == s.z and leading(rest)[0] == 2


def _period_factor() -> Expr:
    """(26) for a straight swing, turned into the period, to second order."""
    ratio = s.omega0 / sqrt(right("26").rhs.subs(s.b, 0))
    return Add(*taylor(graded(ratio, {s.a: 1}), 2)).subs(EPS, 1)


def _above() -> Expr:
    """The root with the sign that cos θ has there: minus the one that is right below."""
    return -sqrt(1 - s.rho**2 / s.l**2)


def _acceleration(relation: Relation) -> bool:
    return relation.lhs == VECTORS[r"\ddot{\vec{r}}"] and is_zero(relation.difference)


def _cone(way: int) -> Judge:
    def judge(relation: Relation) -> bool:
        circle = {s.b: way * s.a}
        if not relation.rhs.subs(s.theta, 0).is_positive:
            return False
        return cone(relation, circle) and is_zero(relation.lhs - s.omega - way * s.Omega)

    return judge


def _half_the_change(relation: Relation) -> bool:
    """It stands for 6b: the same left side, and half the derivative of ρ² on the right."""
    return is_zero(relation.lhs - right("6b:1").lhs) and is_zero(relation.difference)


def _tripled(relation: Relation) -> bool:
    """The multiple of ω with which the dropped terms oscillate."""
    angles = {f.args[0] for f in third_harmonic().atoms(sin, cos) if f.has(s.omega)}
    return angles in ({relation.lhs * s.t}, {relation.lhs})


def _squared_share() -> Expr:
    """Ω²/(ω0² − ω²), by (25) and (26)."""
    return right("25").rhs ** 2 / (s.omega0**2 - right("26").rhs)


def _slow_lacks() -> Expr:
    """What 20.6 drops that is largest: of first order in Ω."""
    lacking = expand(right("20.5:2").rhs - right("20.6").rhs)
    return lacking.coeff(s.Omega, 1) * s.Omega


def _third_component(relation: Relation) -> bool:
    return is_zero(relation.lhs - right("8.1:3").rhs.subs({s.e_x: 0, s.e_y: 0, s.e_z: 1}))


_SIGNS = {
    "near-the-bottom": "≈",
    "cone": "≈",
    "opposite-cone": "≈",
    "normal-form": "≈",
    "rate-of-normal-form": "≈",
    "energy-of-ellipse": "≈",
    "frequency-by-energy": "≈",
    **dict.fromkeys(
        (
            "period-factor", "tripled", "tripled-phase",
            "pumping-term", "root-above", "missing-in-13a", "third-harmonic", "squared-share",
            "omega-beside-omega", "third-component", "area", "three-quarters", "low-of-25",
        ),
        "",
    ),
}  # fmt: skip


def _first(condition: str) -> tuple[Expr, str, Expr]:
    one = required(condition)[0]
    return one.left, one.sign, one.right


# Statements that are, or are the opposite of, what a condition demands.
_CONDITIONS: dict[str, Callable[[], tuple[Expr, str, Expr]]] = {
    "pushing": lambda: (s.T, "<", Integer(0)),
    "small": lambda: _first(c.SMALL.latex),
    "gravity": lambda: _first(c.OMEGA_ZERO.latex),
}
_DISTANCE = {s.rho: sqrt(s.x**2 + s.y**2)}
_EQUATOR = {sin(s.theta): Integer(1), cos(s.theta): Integer(0)}

_JUDGES: dict[str, Judge] = {
    "at-rest": _case("2:z", {cos(s.theta): Integer(1)}, lambda: Integer(0)),
    "natural-frequency": _is_natural,
    "near-the-bottom": _is_near,
    "straight": _assignment(_is_straight),
    "period-factor": _same(_period_factor),
    "x-vanishes": _assignment(lambda case: is_zero(s.x.subs(case))),
    "tripled": lambda r: not r.lhs.has(s.t) and _tripled(r),
    "tripled-phase": lambda r: r.lhs.has(s.t) and _tripled(r),
    "pumping-term": _same(lambda: lengthening(Integer(0))[1] / s.l),
    "root-above": _same(_above),
    "level": _assignment(_is_level),
    "nothing": lambda r: _is_trivial(r) and is_zero(right("10.3").lhs.xreplace(_EQUATOR)),
    "falling": _case("5b", _EQUATOR, lambda: Integer(0)),
    "missing-in-13a": lambda r: is_zero(r.lhs.xreplace(_DISTANCE) - _term("13a")),
    "no-turning": _assignment(_stops_turning),
    "circle": _assignment(lambda case: is_zero((s.a - s.b).subs(case)) and s.a in case),
    "opposite-circle": _assignment(lambda case: is_zero((s.a + s.b).subs(case)) and s.a in case),
    "cone": _cone(1),
    "opposite-cone": _cone(-1),
    "turning-per-swing": _by_25,
    "turning-per-minor-axis": _by_25,
    "third-harmonic": _same(third_harmonic),
    "squared-share": _same(_squared_share),
    "acceleration": _acceleration,
    "one": _identity,
    "one-again": _identity,
    "half-the-change": _half_the_change,
    "root-below": _identity,
    "lagrange": lambda r: _identity(r.apply(lambda e: e.xreplace({s.rho: sqrt(right("6:1").rhs)}))),
    "other-acceleration": lambda r: is_zero(s.x * r.difference - right("9:2").difference),
    "sideways": _is_sideways,
    "cosine-cubed": _identity,
    "sine-cubed": _identity,
    "cosine-squared": _identity,
    "sine-squared": _identity,
    "omega-beside-omega": _same(_slow_lacks),
    "third-component": _third_component,
    "in-a-plane": _is_in_a_plane,
    "two-shares": chapters.shares,
    "two-shares-of-frequency": chapters.shares,
    "action": chapters.is_action,
    "other-action": chapters.is_action,
    "normal-form": chapters.is_normal_form,
    "rate-of-normal-form": chapters.is_rate,
    "area": _same(chapters.area),
    "three-quarters": _same(chapters.share_of_turning),
    "energy-of-ellipse": chapters.is_energy,
    "frequency-by-energy": chapters.is_frequency,
    "low-of-25": _same(chapters.share_of_25),
    "cubic-alone": chapters.is_cubic_alone,
    "missing-twelfth": chapters.is_twelfth,
}
