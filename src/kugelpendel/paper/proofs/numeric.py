"""The second proof: true at random points, to 50 digits, in a world made without the algebra."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from kugelpendel.paper.algebra.dimensions import InhomogeneousError, dimension
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import mp, mpf
from kugelpendel.paper.proofs.worlds import DIGITS, Number, World, ellipse

POINTS = 3
TOLERANCE = 50  # digits
EXPONENT = 12  # the small sizes are 1e-12


@dataclass(frozen=True)
class Trial:
    """What a relation gives at one random point.

    Attributes
    ----------
    world
        The random point.
    rest
        By how much the relation fails there; infinite where it means nothing.
    allowed
        How much of that is rounding, or belongs to an order that is not kept.
    kept
        The highest order that is kept, None in an exact formula.
    """

    world: World
    rest: Number
    allowed: Number
    kept: int | None = None

    @property
    def holds(self) -> bool:
        """Whether the relation is true there."""
        return bool(self.rest <= self.allowed)


Numeric = Callable[[Relation], Iterator[Trial]]  # one answer per random point


def in_world(make: Callable[[int], World]) -> Numeric:
    """Exactly true."""

    def numeric(relation: Relation) -> Iterator[Trial]:
        with mp.workdps(DIGITS):
            for seed in range(POINTS):
                world = make(seed)
                left, right = world.value(relation.lhs), world.value(relation.rhs)
                scale = max(abs(left), abs(right), 1)
                yield Trial(world, abs(left - right), scale * mpf(10) ** (-TOLERANCE))

    return numeric


def to_order(kept: int, make: Callable[[int, int], World]) -> Numeric:
    """True up to and including the order `kept`: at sizes 1e-12, the rest is 1e-12 times less."""

    def numeric(relation: Relation) -> Iterator[Trial]:
        with mp.workdps(DIGITS + kept * EXPONENT):
            eps = mpf(10) ** (-EXPONENT)
            for seed in range(POINTS):
                world = make(seed, EXPONENT)
                rest = world.value(relation.lhs) - world.value(relation.rhs)
                yield Trial(world, abs(rest), eps**kept * eps / 2 * 100, kept)

    return numeric


def measured_order(relation: Relation, make: Callable[[int, int], World], seed: int = 0) -> Number:
    """The power of ε with which lhs − rhs falls, from two sizes."""
    with mp.workdps(DIGITS + 12 * EXPONENT):
        worlds = (make(seed, exponent) for exponent in (EXPONENT, EXPONENT + 2))
        larger, smaller = (abs(world.value(relation.difference)) for world in worlds)
        return mp.log10(larger / smaller) / 2


def first_harmonics(kept: int | None, pure: bool = True, beats: int = 8) -> Numeric:
    """First harmonics of both sides agree (to the order kept), and the right side has no others.

    The sides' harmonics are sums over equidistant phases of one swing, exact for the few that
    there are.
    """
    exponent = 0 if kept is None else EXPONENT

    def numeric(relation: Relation) -> Iterator[Trial]:
        with mp.workdps(DIGITS + (kept or 0) * EXPONENT):
            size = mpf(10) ** (-TOLERANCE)
            if kept is not None:
                size = mpf(10) ** (-EXPONENT * kept) * mpf(10) ** (-EXPONENT) * 100
            for seed in range(POINTS):
                worlds = [ellipse(seed, exponent, beat, beats) for beat in range(beats)]
                rest = [world.value(relation.lhs) - world.value(relation.rhs) for world in worlds]
                wrong = max(abs(_part(rest, 1, f)) for f in (mp.cos, mp.sin))
                if pure and wrong <= size:
                    right = [world.value(relation.rhs) for world in worlds]
                    others = ((k, f) for k in (0, 2, 3) for f in (mp.cos, mp.sin))
                    wrong = max(wrong, *(abs(_part(right, k, f)) for k, f in others))
                yield Trial(worlds[0], wrong, size, kept)

    return numeric


def _part(values: list[Number], order: int, function: Callable[[Number], Number]) -> Number:
    count = len(values)
    phases = (function(2 * mp.pi * order * k / count) for k in range(count))
    return 2 * mp.fsum(v * p for v, p in zip(values, phases, strict=True)) / count


def much_less(make: Callable[[int, int], World]) -> Numeric:
    """0 < lhs, of one dimension with rhs, and lhs/rhs of the order ε² at least."""

    def numeric(relation: Relation) -> Iterator[Trial]:
        try:
            alike = dimension(relation.lhs) == dimension(relation.rhs)
        except InhomogeneousError:
            alike = False
        with mp.workdps(DIGITS + 4 * EXPONENT):
            for seed in range(POINTS):
                world = make(seed, EXPONENT)
                left, right = world.value(relation.lhs), world.value(relation.rhs)
                is_size = alike and left > 0 and right > 0
                yield Trial(world, left / right if is_size else mp.inf, mpf(10) ** (-EXPONENT))

    return numeric
