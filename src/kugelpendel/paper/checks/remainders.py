"""What the approximations drop, worked out: leading neglected terms and their order."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out, harmonic, leading, slow, small
from kugelpendel.paper.algebra.sympy_names import Expr, diff, factor, sqrt
from kugelpendel.paper.derivation.graph import right
from kugelpendel.paper.proofs.symbolic import put


@dataclass(frozen=True)
class Remainder:
    """What is neglected in a formula: its leading term, of the given order in ε.

    `kept` is the order of the smallest terms that stay. Displacements count as ε; in section 4 a
    and b do, Ω and ω² − ω0² as ε².
    """

    label: str
    kept: int
    order: int
    term: Expr


def motion() -> dict[Expr, Expr]:
    """x, y and their first two rates from (20), exactly."""
    rules: dict[Expr, Expr] = {}
    pairs = (("20:x", (s.x, s.xd, s.xdd)), ("20:y", (s.y, s.yd, s.ydd)))
    for label, letters in pairs:
        value = right(label).rhs
        for letter in letters:
            rules[letter] = value
            value = diff(value, s.t)
    return rules


@cache
def remainders() -> tuple[Remainder, ...]:
    """Of every step that neglects something, in the paper's order."""
    rho = {s.rho: sqrt(s.x**2 + s.y**2)}
    found: list[Remainder] = []

    def note(label: str, kept: int, expression: Expr) -> None:
        order, term = leading(expression)  # of the claim: left side minus right side
        found.append(Remainder(label, kept, order, factor(term)))

    for label, kept in (("12.1", 2), ("12.2", 2), ("12.3:1", 3)):
        note(label, kept, small(right(label).difference))
    exact = right("12").difference
    note("13a", 3, small((exact - right("13a").difference).xreplace(rho)))
    swap = {s.x: s.y, s.y: s.x, s.xd: s.yd, s.yd: s.xd, s.xdd: s.ydd}
    note("13b", 3, small((exact.xreplace(swap) - right("13b").difference).xreplace(rho)))
    speeds = right("20.5:2").rhs - right("20.6").rhs
    note("20.6", 2, slow(speeds))
    note("20.9:1", 3, slow(right("20:x").rhs * speeds))
    note("23.4", 3, slow(right("23.3").difference - right("23.4").difference))
    return tuple(found)


def dropped_harmonics(label: str) -> Expr:
    """The third harmonics that the averaged formula drops: "20.8:1", "20.10:2"."""
    previous = {"20.8:1": "20.7:3", "20.10:2": "20.10:1"}[label]
    return factor(harmonic(right(previous).rhs, 3))


def third_harmonic() -> Expr:
    """What the dropped third harmonics would add to x, to leading order.

    The driven oscillator ẍ3 + ω0² x3 = −(third harmonics of (13a)'s cubic terms), at 3ω0.
    """
    cubic = right("13a").difference - (s.xdd + s.omega0**2 * s.x)
    place, speed = right("20.7:3"), right("20.10:1")
    terms = put(cubic, {place.lhs: place.rhs, speed.lhs: speed.rhs})
    drive = harmonic(terms.xreplace({s.omega**2: s.omega0**2}), 3)
    return factor(drive / (8 * s.omega0**2))


def imbalance(label: str) -> Expr:
    """First harmonics of (13a) or (13b) with (20) put in exactly: cubic terms, Ω² and all."""
    return harmonic(carry_out(put(right(label).difference, motion())), 1)
