"""Formulas spoilt on purpose, one place at a time: the checker's own test.

Over the whole expression tree of both sides: every sign of a term, every factor (doubled, lost),
every number, every exponent (one more, one less), every letter (exchanged for its neighbour), every
sine for a cosine, every angle for another.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import SYMBOL
from kugelpendel.paper.algebra.sympy_names import Add, Expr, Integer, Mul, Pow, cos, nan, sin, zoo
from kugelpendel.paper.derivation.model import Formula

_CYCLES: tuple[tuple[Expr, ...], ...] = (
    (s.x, s.y),
    (s.xd, s.yd),
    (s.xdd, s.ydd),
    (s.xp, s.yp),
    (s.thetad, s.phid),
    (s.thetadd, s.phidd),
    (s.a, s.b),
    (s.omega, s.omega0, s.Omega),
    s.CARTESIAN,
    s.SPHERICAL,
    (SYMBOL["L_x"], SYMBOL["L_y"], SYMBOL["L_z"]),
    (s.rho, s.l),
    (s.m, s.g),
    (s.z, s.x),
    (s.zd, s.xd),
    (s.zdd, s.xdd),
    (s.r, s.rho),
    (s.T, s.m),
    (s.A_1, s.A_2),
    (s.omega_1, s.omega_2),
    (s.u, s.u_1, s.u_2, s.u_3),
    (s.alpha, s.beta),
    (s.J_1, s.J_2),
    (s.h, s.phid),
    (s.ud, s.h),
)
_NEIGHBOUR: dict[Expr, Expr] = {}
for _cycle in _CYCLES:
    for _k, _letter in enumerate(_cycle):
        _NEIGHBOUR.setdefault(_letter, _cycle[(_k + 1) % len(_cycle)])
_NEIGHBOUR[s.l] = s.rho
_ANGLE = {
    s.theta: s.phi,
    s.phi: s.theta,
    s.omega * s.t: s.Omega * s.t,
    s.Omega * s.t: s.omega * s.t,
    s.omega_1 * s.t: s.omega_2 * s.t,
    s.omega_2 * s.t: s.omega_1 * s.t,
    s.omega0 * s.t: 2 * s.omega0 * s.t,
}


@dataclass(frozen=True)
class Mutant:
    """A spoilt formula and what was done: "sign", "factor", "number", "exponent", "letter"."""

    change: str
    relation: Relation


def mutants(one: Formula, right: Relation) -> tuple[Mutant, ...]:
    """All different ones; the left side of a chain belongs to its first line."""
    return spoilt(right, keep_left=bool(one.head) and right.rhs != 0)


def spoilt(right: Relation, keep_left: bool = False) -> tuple[Mutant, ...]:
    """All different ways to spoil a relation in one place, on its right side only if told so."""
    found: dict[Relation, Mutant] = {}
    for name, side in (("lhs", right.lhs), ("rhs", right.rhs)):
        if name == "lhs" and keep_left:
            continue
        for change, wrong in chain(whole(side), _spoilt(side)):
            pair = (wrong, right.rhs) if name == "lhs" else (right.lhs, wrong)
            relation = Relation(pair[0], right.op, pair[1])
            if wrong.has(zoo, nan):  # a division by zero: no formula at all
                continue
            if (relation.lhs, relation.rhs) != (right.lhs, right.rhs):
                found.setdefault(relation, Mutant(f"{change}: {wrong}", relation))
    return tuple(found.values())


def _spoilt(e: Expr) -> Iterator[tuple[str, Expr]]:
    """Every change at the root, then every change below it."""
    if e.is_Symbol:
        if e in _NEIGHBOUR:
            yield "letter", _NEIGHBOUR[e]
        return
    if e == 0:
        return
    if e.is_Rational:
        yield "number", e + 1 if e.is_Integer else e + Integer(1) / e.q
        return
    if isinstance(e, (sin, cos)):
        yield "letter", (cos if isinstance(e, sin) else sin)(e.args[0])
        factor, angle = e.args[0].as_coeff_Mul()
        yield "letter", e.func(factor * _ANGLE[angle])
        yield "number", e.func((factor + 1) * angle)
        return
    if isinstance(e, Pow):
        yield "exponent", Pow(e.base, e.exp + 1)
        yield "exponent", Pow(e.base, e.exp - 1)
        for change, base in _spoilt(e.base):
            yield change, Pow(base, e.exp)
        return
    if isinstance(e, (Add, Mul)):
        for k, part in enumerate(e.args):
            others = [*e.args[:k], *e.args[k + 1 :]]
            if isinstance(e, Add):
                yield "sign", Add(*others, -part)
                yield "factor", Add(*others, 2 * part)
                yield "factor", Add(*others)
            else:
                yield "factor", Mul(*others)
            for change, spoilt in _spoilt(part):
                yield change, e.func(*others, spoilt)
        return
    for k, part in enumerate(e.args):
        for change, spoilt in _spoilt(part):
            yield change, e.func(*e.args[:k], spoilt, *e.args[k + 1 :])


def whole(side: Expr) -> Iterator[tuple[str, Expr]]:
    """The side itself with the other sign, and doubled."""
    yield "sign", -side
    yield "factor", 2 * side
