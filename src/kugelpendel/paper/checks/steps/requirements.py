"""Which conditions each step needs, found by violating one after the other.

A probe is a place or a world in which some condition fails. The step breaks there if what it says,
its premises or what it is done with divides by zero, if the formula no longer follows from the
premises, or if what it drops is no longer small beside what it keeps. A step must name a condition
that excludes each probe at which it breaks, and none without which another one would exclude the
same. Only what the paper says itself may stand beside something stronger that it does not say.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import (
    DISPLACEMENTS,
    RADII,
    SEMI_AXES,
    SHIFT,
    is_zero,
    parted,
)
from kugelpendel.paper.algebra.notation import NotationError, read
from kugelpendel.paper.algebra.requirement import Requirement, required
from kugelpendel.paper.algebra.symbols import STILL
from kugelpendel.paper.algebra.sympy_names import Expr, Integer, cos, mp, pi, sin, sqrt
from kugelpendel.paper.checks.steps.probes import (
    Probe,
    at_place,
    fails_at,
    in_words,
    in_world,
    is_so,
    of_size,
    with_moving,
)
from kugelpendel.paper.derivation import conditions
from kugelpendel.paper.derivation.graph import FORMULAS, parts, rests_on, right
from kugelpendel.paper.derivation.model import Condition, Formula, StepKind
from kugelpendel.paper.proofs.exact import swinging
from kugelpendel.paper.proofs.numeric import EXPONENT
from kugelpendel.paper.proofs.violations import slack, turning_frame, upwards
from kugelpendel.paper.proofs.worlds import DIGITS, balanced, dynamic

_STATED = tuple(
    condition
    for condition in vars(conditions).values()
    if isinstance(condition, Condition) and not condition.silent
)


def faults(one: Formula) -> tuple[str, ...]:
    """Say which conditions a step lacks, which it does not need, and which do not hold at all."""
    found: list[str] = []
    needless = list(one.step.conditions)
    for probe in PROBES:
        if not _broken(probe.name, one.label):
            continue
        excluding = [condition for condition in one.step.conditions if probe.fails(condition)]
        if not excluding:
            found.append(f"needs a condition against: {probe.name}")
        elif probe.is_size and all(condition.silent for condition in excluding):
            if_stated = any(probe.fails(condition) for condition in _STATED)
            said = f"does not name what the paper states against: {probe.name}"
            found.extend([said] if if_stated else [])
        for condition in excluding:
            others = [other for other in excluding if other is not condition]
            stated = not condition.silent and all(other.silent for other in others)
            if condition in needless and (not others or stated):
                needless.remove(condition)
    found.extend(f"does not need the condition {condition.key}" for condition in needless)
    found.extend(
        f"names the condition {condition.key}, which is not met"
        for condition in one.step.conditions
        if not is_met(condition)
    )
    return tuple(found)


@cache
def _broken(name: str, label: str) -> bool:
    """Whether the step breaks at a probe; it does not depend on the conditions it names."""
    probe = next(one for one in PROBES if one.name == name)
    return probe.breaks(next(one for one in FORMULAS if one.label == label))


def is_met(condition: Condition) -> bool:
    """Whether a condition can be read, and holds in motions that the paper is about."""
    if not condition.latex:
        return True
    try:
        demanded = required(condition.latex)
    except NotationError:
        return False
    still = dict.fromkeys(STILL.values(), Integer(0))
    demanded = tuple(Requirement(r.left.xreplace(still), r.sign, r.right) for r in demanded)
    letters = {q for one in demanded for q in one.left.free_symbols | one.right.free_symbols}
    make = balanced if letters & {s.a, s.b, s.omega, s.Omega} else dynamic
    make = swinging if letters & {s.u_1, s.u_2, s.alpha, s.beta} else make
    with mp.workdps(DIGITS + 4 * EXPONENT):
        return all(is_so(one, make(seed, EXPONENT)) for one in demanded for seed in range(3))


def _exchanges_gravity(one: Formula) -> bool:
    """Whether g stands in what the step is from, and ω0 in what it leads to."""
    before = {q for name in one.step.premises for part in parts(name) for q in _all(part.label)}
    return s.g in before and s.omega0 in _all(one.label) and s.g not in _all(one.label)


def _all(label: str) -> set[Expr]:
    relation = right(label)
    return {*relation.lhs.free_symbols, *relation.rhs.free_symbols}


def _is_exchanged(one: Formula) -> bool:
    """Whether ÿ comes out although no premise has it, and nothing is differentiated for it."""
    known = {q for name in one.step.premises for part in parts(name) for q in _all(part.label)}
    return one.step.kind == StepKind.NEGLECT and s.ydd in _all(one.label) - known


def _leaves_an_equation_out(one: Formula) -> bool:
    """Whether the bracket that is set to zero comes from (13a) alone: (16) only lends its form."""
    before = set(rests_on(one.label))
    sources = (f for f in FORMULAS if f.label in before and f.section != 3)
    named = {name for f in sources for name in f.step.premises}
    return one.step.kind == StepKind.COMPARE and "13a" in named and "13b" not in named


def _compares_dependent(one: Formula, values: Mapping[Expr, Expr]) -> bool:
    """Whether one of the functions that are compared is then no function of its own."""
    if one.step.kind != StepKind.COMPARE:
        return False
    details = [read(part.step.detail).lhs for part in parts(one.display)]
    first, *others = (parted(detail.xreplace(s.CIRCLES)).subs(values) for detail in details)
    return any(is_zero(detail) or is_zero(detail - first) for detail in others) or is_zero(first)


def _leaves_harmonics_out(one: Formula) -> bool:
    return one.step.kind in (StepKind.AVERAGE, StepKind.ANSATZ)


def _no_function(name: str, values: Mapping[Expr, Expr]) -> Probe:
    return Probe(name, fails_at(values), lambda one: _compares_dependent(one, values))


_AXIS: dict[Expr, Expr] = {
    sin(s.theta): 0, cos(s.theta): 1, s.x: 0, s.y: 0, s.rho: 0,
}  # fmt: skip
_EQUATOR: dict[Expr, Expr] = {
    sin(s.theta): 1, cos(s.theta): 0, s.rho: s.l,
    s.x: 3 * s.l / 5, s.y: 4 * s.l / 5,
}  # fmt: skip
_ABOVE: dict[Expr, Expr] = {
    sin(s.theta): sin(2 * pi / 3), cos(s.theta): cos(2 * pi / 3), s.rho: sqrt(3) / 2 * s.l,
    s.x: s.l / 2, s.y: sqrt(2) / 2 * s.l,
}  # fmt: skip
_SMALL_PLACE = {**DISPLACEMENTS, s.x: 0, s.y: 0, s.rho: 0, s.xdd: 0, s.ydd: 0}
PROBES: tuple[Probe, ...] = (
    in_world("a slack thread", slack),
    in_world("a frame that turns", turning_frame, "inertial-frame"),
    in_world("z counted upwards", upwards),
    with_moving("a length that changes", s.l),
    with_moving("a turning that changes", s.Omega),
    with_moving("semi-axes that change", s.a, s.b),
    at_place("on the vertical", _AXIS),
    at_place("on the equator", _EQUATOR),
    at_place("above the support", _ABOVE, above=True),
    at_place("in the plane x = 0", {s.x: 0}),
    at_place("turning points as far above as below", {s.u_1: -s.u_2}),
    at_place("a circle, a = b", {s.a: s.b, s.A_2: 0}),
    at_place("a circle, a = −b", {s.a: -s.b, s.A_1: 0}),
    in_words("ω0² other than g/l", "omega-zero", _exchanges_gravity),
    of_size("a large displacement", DISPLACEMENTS, _SMALL_PLACE),
    of_size("a large velocity", DISPLACEMENTS, {**DISPLACEMENTS, s.xd: 0, s.yd: 0}),
    of_size("an ellipse not so small", SEMI_AXES, {**SEMI_AXES, s.a: 0, s.b: 0}, at_rest=True),
    of_size("turning radii that are not small", RADII, {s.alpha: 0, s.beta: 0}),
    of_size("a fast turning", SEMI_AXES, {**SEMI_AXES, s.Omega: 0}),
    of_size("a narrow ellipse", SEMI_AXES, {**SEMI_AXES, s.b: 3}),
    of_size("another frequency", SEMI_AXES, {**SEMI_AXES, SHIFT: 0}),
    of_size("a turning as fast as the frequency shifts", SEMI_AXES, {**SEMI_AXES, s.Omega: 1}),
    _no_function("no turning", {s.Omega: 0}),
    in_words("third harmonics", "third-harmonics", _leaves_harmonics_out),
    in_words("an equation for y of its own", "y-equation", _leaves_an_equation_out),
    in_words("a direction that differs", "symmetry", _is_exchanged),
)
