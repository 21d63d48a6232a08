"""What a condition of a step demands, read from its LaTeX: relations that formulas do not have."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra.notation import NotationError, Reading, operator, single
from kugelpendel.paper.algebra.symbols import STILL_RATE
from kugelpendel.paper.algebra.sympy_names import Expr
from kugelpendel.paper.typeset import tex
from kugelpendel.paper.typeset.tex import Atom, Node

SIGNS = frozenset("=≠<>≤≥≪")
_COMMA = Atom("operator", ",")


@dataclass(frozen=True)
class Requirement:
    """One relation that must hold; `sign` is one of `SIGNS`."""

    left: Expr
    sign: str
    right: Expr


@cache
def required(latex: str) -> tuple[Requirement, ...]:
    r"""Give the relations of a condition such as "x, y \ll l", one for each thing on the left.

    Raises
    ------
    NotationError
        The condition cannot be read, or it is not one relation.
    """
    try:
        items = tex.read(latex).items
    except tex.UnknownTeX as error:
        raise NotationError(str(error)) from error
    reading = _reading(latex)
    signs = [place for place, item in enumerate(items) if operator(item) in SIGNS]
    if len(signs) != 1:
        raise NotationError(f"{latex!r} is not one relation.")
    (at,) = signs
    right = reading.expression(items[at + 1 :])
    lefts = (reading.expression(part) for part in _parted(items[:at]))
    return tuple(Requirement(left, operator(items[at]), right) for left in lefts)


def quantity(latex: str) -> Expr:
    """Give a single quantity, in which the constants' rates may stand.

    Raises
    ------
    NotationError
        It cannot be read.
    """
    return _reading(latex).expression(tex.read(latex).items)


def _reading(latex: str) -> Reading:
    return Reading(latex, {single(rate): symbol for rate, symbol in STILL_RATE.items()})


def _parted(items: tuple[Node, ...]) -> list[tuple[Node, ...]]:
    parts: list[list[Node]] = [[]]
    for item in items:
        if item == _COMMA:
            parts.append([])
        else:
            parts[-1].append(item)
    return [tuple(part) for part in parts]
