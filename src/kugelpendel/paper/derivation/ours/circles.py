"""Chapter 5: the ellipse as two circular motions, and why 3/8 is 1/8 + 1/4.

The method is Lindstedt's and Poincaré's: each circular motion keeps its form, and its frequency is
corrected until what drives it at its own frequency has vanished.
"""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import harmonic, parted, rate, slow, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import Expr, cos, expand, solve
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Step, StepKind, claim
from kugelpendel.paper.proofs.numeric import first_harmonics, in_world, to_order
from kugelpendel.paper.proofs.symbolic import (
    Premises,
    Proof,
    Symbolic,
    continued,
    follows,
    given,
    identity,
    put,
)
from kugelpendel.paper.proofs.worlds import balanced, ellipse

_ANSATZ = in_world(ellipse)
_EXACTLY = Proof(given("A5", "A3", "A2"), _ANSATZ)
_HARMONICS_OF_LAW = first_harmonics(3, pure=False)
_BALANCED = to_order(3, balanced)
_RESULT = to_order(2, balanced)


def _named(relation: Relation, p: Premises) -> list[Expr]:
    """The four names mean what `symbols.CIRCLES` says, on which the numbers rest too."""
    return [relation.lhs.xreplace(s.CIRCLES) - relation.rhs]


def _in_time(expression: Expr, p: Premises) -> Expr:
    """The two angles as ωt and Ωt."""
    return parted(put(expression, p.rules("A2")))


def _averaged(label: str) -> Symbolic:
    """The first harmonics in ωt of the line before."""

    def symbolic(relation: Relation, p: Premises) -> list[Expr]:
        kept = harmonic(_in_time(p[label].rhs, p), 1)
        return [_in_time(relation.rhs, p) - kept]

    return symbolic


def _leading(relation: Relation, p: Premises) -> list[Expr]:
    """Third order in ε: ω0 for both frequencies, but not in the angles."""
    exact, claimed = (
        _in_time(put(side, p.rules("A1")), p) for side in (p["A8:2"].rhs, relation.rhs)
    )
    return [claimed - truncated(slow(exact), 3)]


def _all_put_in(p: Premises) -> Expr:
    place, speed = p["A7:2"], p["A8:3"]
    motion = {s.xdd: p["A9"].rhs, s.x: p["A3:x"].rhs}
    return put(p["13a"].difference, {place.lhs: place.rhs, speed.lhs: speed.rhs} | motion)


def _coefficient(function: Expr) -> Symbolic:
    return follows(lambda p: expand(p["A10"].difference).coeff(function))


def _divided(label: str, divisor: Expr) -> Symbolic:
    return follows(lambda p: p[label].difference / divisor)


def _sum(way: int) -> Symbolic:
    return follows(lambda p: p["A12:1"].difference + way * p["A12:2"].difference)


def _in_axes(label: str) -> Symbolic:
    return follows(lambda p: put(p[label].difference, p.rules("A1", "A2")))


def _kept(label: str, order: int) -> Symbolic:
    return follows(lambda p: truncated(slow(p[label].difference), order))


def _solved(relation: Relation, p: Premises) -> list[Expr]:
    (root,) = solve(p["A16"].difference, s.Omega)
    return [relation.difference - (s.Omega - root)]


def _squared(relation: Relation, p: Premises) -> list[Expr]:
    """(A18) without Ω², halved."""
    return [relation.difference - truncated(slow(p["A18"].difference), 3) / 2]


_A, _B, _W1, _W2 = "A_1", "A_2", r"\omega_1", r"\omega_2"
_C1, _C2 = r"\cos \omega_1 t", r"\cos \omega_2 t"
_PLACE, _SPEED = r"x(x^2 + y^2)", r"x(\dot{x}^2 + \dot{y}^2)"
_THIRD = (
    rf"{_A}{_B} [({_A} + {_B}) \cos 3\omega t \cos \Omega t "
    rf"- ({_A} - {_B}) \sin 3\omega t \sin \Omega t]"
)
_PLACES = rf"({_A}^3 + 2{_A}{_B}^2) {_C1} + ({_B}^3 + 2{_A}^2{_B}) {_C2}"
_SPEEDS = (
    rf"{_A} ({_A}^2\omega_1^2 + {_B}^2\omega_2^2 - {_B}^2\omega_1\omega_2) {_C1} "
    rf"+ {_B} ({_B}^2\omega_2^2 + {_A}^2\omega_1^2 - {_A}^2\omega_1\omega_2) {_C2}"
)
_FASTER = (
    rf"[{_A}^3 (\omega^2 - \omega_0^2 + 2\omega_0\Omega) - 2{_A}{_B}^2 \omega_0\Omega] {_C1} "
    rf"+ [{_B}^3 (\omega^2 - \omega_0^2 - 2\omega_0\Omega) + 2{_A}^2{_B} \omega_0\Omega] {_C2}"
)
_PULL, _RUSH = r"\frac{\omega_0^2}{2l^2}", r"\frac{\omega_0^2}{l^2}"
_SQUARES = r"\frac{a^2 + b^2}{l^2}"


def _bracket(one: str, other: str, frequency: str) -> str:
    return (
        rf"{one} \left[ \omega_0^2 - {frequency}^2 - {_PULL} ({one}^2 + 2{other}^2) "
        rf"+ {_RUSH} {one}^2 \right]"
    )


def _balance(one: str, other: str, frequency: str) -> str:
    return rf"{frequency}^2 - \omega_0^2 + {_PULL} ({one}^2 + 2{other}^2) - {_RUSH} {one}^2 = 0"


FORMULAS: tuple[Formula, ...] = (
    claim("A1:1", r"A_1 = \frac{a + b}{2}", Step(StepKind.DEFINE), Proof(_named, _ANSATZ)),
    claim("A1:2", r"A_2 = \frac{a - b}{2}", Step(StepKind.DEFINE), Proof(_named, _ANSATZ)),
    claim("A2:1", r"\omega_1 = \omega + \Omega", Step(StepKind.DEFINE), Proof(_named, _ANSATZ)),
    claim("A2:2", r"\omega_2 = \omega - \Omega", Step(StepKind.DEFINE), Proof(_named, _ANSATZ)),
    claim(
        "A3:x",
        rf"x = {_A} {_C1} + {_B} {_C2}",
        Step(StepKind.SUBSTITUTE, ("20:x", "A1", "A2")),
        Proof(given("20:x", "A1", "A2"), _ANSATZ),
    ),
    claim(
        "A3:y",
        rf"y = {_A} \sin \omega_1 t - {_B} \sin \omega_2 t",
        Step(StepKind.SUBSTITUTE, ("20:y", "A1", "A2")),
        Proof(given("20:y", "A1", "A2"), _ANSATZ),
    ),
    claim(
        "A4",
        rf"x^2 + y^2 = {_A}^2 + {_B}^2 + 2{_A}{_B} \cos 2\omega t",
        Step(StepKind.SUBSTITUTE, ("A2", "A3")),
        Proof(given("A3", "A2"), _ANSATZ),
    ),
    claim(
        "A5:x",
        rf"\dot{{x}} = -{_A}\omega_1 \sin \omega_1 t - {_B}\omega_2 \sin \omega_2 t",
        Step(StepKind.DIFFERENTIATE, ("A3:x",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(identity(lambda p: {s.xd: rate(p["A3:x"].rhs)}), _ANSATZ),
    ),
    claim(
        "A5:y",
        rf"\dot{{y}} = {_A}\omega_1 {_C1} - {_B}\omega_2 {_C2}",
        Step(StepKind.DIFFERENTIATE, ("A3:y",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(identity(lambda p: {s.yd: rate(p["A3:y"].rhs)}), _ANSATZ),
    ),
    claim(
        "A6",
        rf"\dot{{x}}^2 + \dot{{y}}^2 = {_A}^2\omega_1^2 + {_B}^2\omega_2^2 "
        rf"- 2{_A}{_B}\omega_1\omega_2 \cos 2\omega t",
        Step(StepKind.SUBSTITUTE, ("A2", "A5")),
        Proof(given("A5", "A2"), _ANSATZ),
    ),
    claim(
        "A7:1",
        rf"{_PLACE} = {_PLACES} + {_THIRD}",
        Step(StepKind.SUBSTITUTE, ("A2", "A3:x", "A4")),
        Proof(given("A4", "A3:x", "A2"), _ANSATZ),
    ),
    claim(
        "A7:2",
        rf"\approx {_PLACES}",
        Step(StepKind.AVERAGE, ("A2", "A7:1"), (c.THIRD,), neglected=_THIRD),
        Proof(_averaged("A7:1"), first_harmonics(None), if_equal=_EXACTLY),
        head="A7:1",
    ),
    claim(
        "A8:1",
        rf"{_SPEED} = {_SPEEDS} - \omega_1\omega_2 {_THIRD}",
        Step(StepKind.SUBSTITUTE, ("A2", "A3:x", "A6")),
        Proof(given("A6", "A3:x", "A2"), _ANSATZ),
    ),
    claim(
        "A8:2",
        rf"\approx {_SPEEDS}",
        Step(
            StepKind.AVERAGE,
            ("A2", "A8:1"),
            (c.THIRD,),
            neglected=rf"-\omega_1\omega_2 {_THIRD}",
        ),
        Proof(_averaged("A8:1"), first_harmonics(None), if_equal=_EXACTLY),
        head="A8:1",
    ),
    claim(
        "A8:3",
        rf"\approx \omega_0^2 ({_A}^3 {_C1} + {_B}^3 {_C2})",
        Step(
            StepKind.NEGLECT,
            ("A1", "A2", "A8:2"),
            (c.NEAR, c.SLOW, c.SLOW_MINOR),
            neglected=_FASTER,
        ),
        Proof(_leading, first_harmonics(3), if_equal=_EXACTLY),
        head="A8:1",
    ),
    claim(
        "A9",
        rf"\ddot{{x}} = -{_A}\omega_1^2 {_C1} - {_B}\omega_2^2 {_C2}",
        Step(StepKind.DIFFERENTIATE, ("A5:x",), (c.UNIFORM, c.NO_GROWTH)),
        Proof(identity(lambda p: {s.xdd: rate(p["A5:x"].rhs)}), _ANSATZ),
    ),
    claim(
        "A10",
        rf"{_bracket(_A, _B, _W1)} {_C1} + {_bracket(_B, _A, _W2)} {_C2} = 0",
        Step(StepKind.SUBSTITUTE, ("13a", "A3:x", "A7:2", "A8:3", "A9")),
        Proof(
            follows(_all_put_in),
            _HARMONICS_OF_LAW,
            against=r"\ddot{x} + \omega_0^2 x - \frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) "
            r"+ \frac{x}{l^2} (\dot{x}^2 + \dot{y}^2)",
        ),
    ),
    claim(
        "A11:1",
        f"{_bracket(_A, _B, _W1)} = 0",
        Step(StepKind.COMPARE, ("A10",), (c.INDEPENDENT, c.OTHER_EQUATION), detail=_C1),
        Proof(_coefficient(cos(s.omega_1 * s.t)), _BALANCED),
    ),
    claim(
        "A11:2",
        f"{_bracket(_B, _A, _W2)} = 0",
        Step(StepKind.COMPARE, ("A10",), (c.INDEPENDENT, c.OTHER_EQUATION), detail=_C2),
        Proof(_coefficient(cos(s.omega_2 * s.t)), _BALANCED),
    ),
    claim(
        "A12:1",
        _balance(_A, _B, _W1),
        Step(StepKind.DIVIDE, ("A11:1",), (c.NOT_OPPOSITE,), detail="-A_1"),
        Proof(_divided("A11:1", -s.A_1), _RESULT),
    ),
    claim(
        "A12:2",
        _balance(_B, _A, _W2),
        Step(StepKind.DIVIDE, ("A11:2",), (c.NOT_CIRCLE,), detail="-A_2"),
        Proof(_divided("A11:2", -s.A_2), _RESULT),
    ),
    claim(
        "A13",
        rf"\omega_1^2 - \omega_2^2 - {_PULL} ({_A}^2 - {_B}^2) - {_RUSH} ({_A}^2 - {_B}^2) = 0",
        Step(StepKind.SUBTRACT, ("A12",)),
        Proof(_sum(-1), _RESULT),
    ),
    claim(
        "A14",
        rf"\omega_1^2 + \omega_2^2 - 2\omega_0^2 + 3{_PULL} ({_A}^2 + {_B}^2) "
        rf"- {_RUSH} ({_A}^2 + {_B}^2) = 0",
        Step(StepKind.ADD, ("A12",)),
        Proof(_sum(1), _RESULT),
    ),
    claim(
        "A15",
        rf"4\omega\Omega - {_PULL} ab - {_RUSH} ab = 0",
        Step(StepKind.SUBSTITUTE, ("A1", "A2", "A13")),
        Proof(_in_axes("A13"), _RESULT),
    ),
    claim(
        "A16",
        rf"4\omega_0\Omega - {_PULL} ab - {_RUSH} ab = 0",
        Step(
            StepKind.NEGLECT,
            ("A15",),
            (c.NEAR, c.SLOW, c.SLOW_MINOR),
            neglected=r"\frac{2\Omega}{\omega_0} (\omega^2 - \omega_0^2)",
        ),
        Proof(_kept("A15", 3), _RESULT),
    ),
    claim(
        "A17:1",
        r"\Omega = \frac{1}{8} \omega_0 \frac{ab}{l^2} + \frac{1}{4} \omega_0 \frac{ab}{l^2}",
        Step(StepKind.SOLVE, ("A16",), detail=r"4\omega_0"),
        Proof(_solved, _RESULT),
    ),
    claim(
        "A17:2",
        r"= \frac{3}{8} \omega_0 \frac{ab}{l^2}",
        Step(StepKind.REARRANGE, ("A17:1",)),
        Proof(continued("A17:1"), _RESULT),
        head="A17:1",
    ),
    claim(
        "A18",
        rf"2\omega^2 + 2\Omega^2 - 2\omega_0^2 + \frac{{3}}{{4}} \omega_0^2 {_SQUARES} "
        rf"- \frac{{1}}{{2}} \omega_0^2 {_SQUARES} = 0",
        Step(StepKind.SUBSTITUTE, ("A1", "A2", "A14")),
        Proof(_in_axes("A14"), _RESULT),
    ),
    claim(
        "A19:1",
        rf"\omega^2 = \omega_0^2 \left(1 - \frac{{3}}{{8}} {_SQUARES} "
        rf"+ \frac{{1}}{{4}} {_SQUARES}\right)",
        Step(StepKind.NEGLECT, ("A18",), (c.SLOW_MINOR, c.OMEGA_SQUARED), neglected=r"\Omega^2"),
        Proof(_squared, _RESULT),
    ),
    claim(
        "A19:2",
        r"= \omega_0^2 \left(1 - \frac{a^2 + b^2}{8l^2}\right)",
        Step(StepKind.REARRANGE, ("A19:1",)),
        Proof(continued("A19:1"), _RESULT),
        head="A19:1",
    ),
)
