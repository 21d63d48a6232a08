"""The figures that words of the wording say, worked out, and which words say them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import SEMI_AXES, graded, is_zero, leading, small, taylor
from kugelpendel.paper.algebra.notation import read
from kugelpendel.paper.algebra.sympy_names import Add, Expr, fraction, sqrt, together
from kugelpendel.paper.checks.remainders import remainders, third_harmonic
from kugelpendel.paper.checks.wording.statements import statement
from kugelpendel.paper.derivation.graph import FORMULAS, right
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.proofs.numeric import TOLERANCE


def _remainder(label: str) -> tuple[int, int]:
    (one,) = (remainder for remainder in remainders() if remainder.label == label)
    return one.kept, one.order


def _found() -> dict[Expr, Expr]:
    return {s.Omega: right("25").rhs, s.omega: sqrt(right("26").rhs)}


def _order(expression: Expr) -> int:
    above, below = fraction(together(expression))
    orders = [leading(graded(part, SEMI_AXES))[0] for part in (above, below)]
    return orders[0] - orders[1]


def _share_order(expression: Expr) -> int:
    return leading(graded(expression.xreplace(_found()), {s.a: 1, s.b: 1}))[0]


def _error(label: str) -> int:
    """By which power of the amplitude the share grows by which (25) or (26) is off.

    What (13a) lacks changes Ω and ω² − ω0² by terms that are as much smaller than they are as it is
    smaller than the cubic terms; ω² itself is two orders larger than ω² − ω0².
    """
    kept, order = _remainder("13a")
    law = taylor(small(right("13a").difference), kept)
    linear = next(k for k, term in enumerate(law) if not is_zero(term))
    return order - kept if label == "25" else order - linear


def _second_term() -> int:
    """The order of the second term of (12)."""
    term = next(q for q in Add.make_args(right("12").lhs) if q.has(s.xd) and q.has(s.rho))
    return leading(small(term))[0]


def _cancelling() -> int:
    """How many of the terms of 6.1 are gone in its second line, whatever else happens to them."""
    terms = _summands("6.1:1")
    gone = [q for q in terms if q.has(s.phidd) or (q.has(s.thetad) and q.has(s.phid))]
    return len(gone) if is_zero(Add(*gone)) else 0


def _summands(label: str) -> list[Expr]:
    """The terms of a right-hand side as they are typeset, before like ones are added."""
    _, _, text = next(one for one in FORMULAS if one.label == label).right.partition("=")
    pieces = text.replace("- ", "+ -").split("+ ")
    return [read(piece).lhs for piece in pieces if piece.strip()]


def _counted(kind: str, **having: object) -> int:
    chosen = [one for one in MISPRINTS if one.kind == kind]
    return sum(all(bool(getattr(one, k)) == v for k, v in having.items()) for one in chosen)


def _loose(what: str) -> int:
    chosen = [one for one in MISPRINTS if one.kind == "loose"]
    if what == "products":
        return sum(one.known == "convention" for one in chosen)
    if what == "equals":
        return sum(one.printed == "=" for one in chosen)
    return sum(one.right.startswith("|") for one in chosen)


FIGURES: dict[str, Callable[[], int]] = {
    "displays-of-6": lambda: len({one.display for one in FORMULAS if one.number == "6"}),
    "digits": lambda: TOLERANCE,
    "order-of-shares": lambda: max(
        _share_order(q / s.omega0) for q in (s.Omega, s.omega - s.omega0)
    ),
    "error-25": lambda: _error("25"),
    "error-26": lambda: _error("26"),
    "false-formulas": lambda: _counted("formula"),
    "false-formulas-carried": lambda: _counted("formula", origin=True),
    "false-words": lambda: _counted("word"),
    "loose-signs": lambda: _counted("loose"),
    "loose-equals": lambda: _loose("equals"),
    "loose-bars": lambda: _loose("bars"),
    "loose-products": lambda: _loose("products"),
    "order-13a": lambda: _remainder("13a")[1],
    "order-16": lambda: _remainder("16:x")[1],
    "order-of-ratios": lambda: _share_order(statement("turning-per-minor-axis").lhs),
    "orders-below-23.4": lambda: _remainder("23.4")[1] - _remainder("23.4")[0],
    "order-third-harmonic": lambda: _order(third_harmonic()),
    "order-squared-share": lambda: _order(statement("squared-share").lhs),
    "cancelled-6.1": _cancelling,
    "terms-6.1": lambda: len(_summands("6.1:1")),
    "order-second-term": _second_term,
    "kept-13a": lambda: _remainder("13a")[0],
    "order-of-cubic-terms": lambda: _remainder("20.9:1")[0],
    "order-omega-squared": lambda: _share_order(s.Omega**2),
    "order-of-shift": lambda: _share_order(s.omega**2 - s.omega0**2),
    "components-of-L": lambda: sum(right("8.1:3").rhs.has(unit) for unit in s.CARTESIAN),
    "order-c12": lambda: _remainder("C12")[1],
    "order-d1": lambda: _remainder("D1")[0],
    "order-12.3": lambda: _remainder("12.3:1")[1],
}
_SAYING: dict[int, tuple[str, ...]] = {
    2: ("zwei", "zweite", "quadrat", "two", "second", "square"),
    3: ("drei", "dritte", "three", "third"),
    4: ("vier", "vierte", "four", "fourth"),
    5: ("fünf", "fünfte", "five", "fifth"),
    6: ("sechs", "sechste", "six", "sixth"),
    12: ("zwölf", "twelve"),
}


@cache
def figure(name: str) -> int:
    """Work out the figure of that name; KeyError for another one."""
    return FIGURES[name]()


def says(word: str, number: int) -> bool:
    """Whether a word of either language says the number, as a figure, a count or an order."""
    if word.isdecimal():
        return int(word) == number
    stem = word.lower()
    endings = ("", "r", "n", "s")
    return any(stem == known + ending for known in _SAYING.get(number, ()) for ending in endings)
