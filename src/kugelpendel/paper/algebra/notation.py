"""What the paper's LaTeX says, as SymPy: the judge's reading of the tree that is typeset.

A formula is read once, by `kugelpendel.paper.typeset.tex`; every document is written from that
tree, and this module gives the same tree its meaning. So nothing can be shown and not be proved:
what has no meaning in the paper's notation is a NotationError, even where it could be typeset.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra.symbols import CARTESIAN, SPHERICAL, SYMBOL, VECTORS, Ddt, Integrated
from kugelpendel.paper.algebra.sympy_names import (
    Abs,
    Add,
    Expr,
    Integer,
    Mul,
    Pow,
    Rational,
    cos,
    pi,
    sin,
    sqrt,
)
from kugelpendel.paper.typeset import tex
from kugelpendel.paper.typeset.tex import (
    Accent,
    Atom,
    Fence,
    Fraction,
    MathList,
    Matrix,
    Node,
    Root,
    Script,
)

_RELATIONS = frozenset("=≈≪")
_PAIRS = {("(", ")"), ("[", "]"), ("{", "}")}
_DOTS = Atom("identifier", "…")
_TIMES, _SLASH, _DOT = (Atom("operator", sign) for sign in "×/·")
_TIME = Atom("identifier", "t")
_INTEGRAL = Atom("operator", "∫")
_DERIVATIVE = Fraction(Atom("identifier", "d"), MathList((Atom("identifier", "d"), _TIME)))
_FUNCTIONS: dict[str, Callable[[Expr], Expr]] = {"sin": sin, "cos": cos}


class NotationError(ValueError):
    """A formula that is not in the paper's notation."""


@dataclass(frozen=True)
class Relation:
    """`lhs op rhs`, op one of = ≈ ≪, or "" for a term that claims nothing by itself (rhs 0)."""

    lhs: Expr
    op: str
    rhs: Expr

    @property
    def difference(self) -> Expr:
        """Lhs − rhs: zero where the relation is an equation and holds."""
        return Add(self.lhs, Mul(-1, self.rhs))

    @property
    def integrals(self) -> tuple[Expr, ...]:
        """The different integrals on its right side."""
        return tuple(self.rhs.atoms(Integrated))

    def apply(self, change: Callable[[Expr], Expr]) -> Relation:
        """The same relation with both sides changed."""
        return Relation(change(self.lhs), self.op, change(self.rhs))


@cache
def read(latex: str, lhs: Expr | None = None) -> Relation:
    """Give the relation that the LaTeX says.

    Parameters
    ----------
    latex
        A formula in the paper's notation.
    lhs
        The left-hand side of a line that begins with its relation sign.

    Raises
    ------
    NotationError
        The formula cannot be read, or it means nothing in the paper's notation.
    """
    try:
        items = without_spaces(tex.read(latex).items)
    except tex.UnknownTeX as error:
        raise NotationError(str(error)) from error
    reading = Reading(latex)
    signs = [place for place, item in enumerate(items) if operator(item) in _RELATIONS]
    if not signs:
        return Relation(reading.expression(items), "", Integer(0))
    if len(signs) > 1:
        raise reading.refused("has two relations where there should be one")
    (at,) = signs
    left = reading.expression(items[:at]) if at else lhs
    if left is None:
        raise reading.refused("continues a line, but none comes before it")
    return Relation(left, operator(items[at]), reading.expression(items[at + 1 :]))


@cache
def denominators(latex: str) -> tuple[Expr, ...]:
    """Give everything that a formula divides by, as it stands there, before anything cancels.

    Raises
    ------
    NotationError
        As `read` does.
    """
    read(latex, Integer(0))
    reading = Reading(latex)
    found = (
        reading.expression(_items(node.below))
        for node in _inside(tex.read(latex))
        if isinstance(node, Fraction) and node != _DERIVATIVE
    )
    return tuple(found)


def _inside(node: Node) -> Iterator[Node]:
    """Go through a tree, the node itself first."""
    yield node
    match node:
        case MathList(items):
            inner: tuple[Node, ...] = items
        case Fraction(above, below):
            inner = (above, below)
        case Root(within) | Fence(_, _, within) | Accent(within, _):
            inner = (within,)
        case Script(base, below, above):
            inner = tuple(part for part in (base, below, above) if part is not None)
        case Matrix(rows):
            inner = tuple(cell for row in rows for cell in row)
        case _:
            inner = ()
    for part in inner:
        yield from _inside(part)


def operator(item: Node) -> str:
    """Give the sign of an operator, "" for anything else."""
    return item.text if isinstance(item, Atom) and item.kind == "operator" else ""


def without_spaces(items: tuple[Node, ...]) -> tuple[Node, ...]:
    """Leave out what TeX only moves apart; nothing else is left out."""
    return tuple(item for item in items if not (isinstance(item, Atom) and item.kind == "space"))


def single(latex: str) -> Node:
    """Read LaTeX that is one thing, such as a letter with its marks."""
    (node,) = tex.read(latex).items
    return node


_QUANTITIES: dict[Node, Expr] = {
    single(latex): meaning for latex, meaning in {**SYMBOL, **VECTORS, r"\pi": pi}.items()
}
_MEASURE = [Atom("identifier", "d"), single("u")]
_ANGLES = tuple(single(latex) for latex in (r"\theta", r"\phi"))
_FREQUENCIES = tuple(
    single(latex) for latex in (r"\omega", r"\omega_0", r"\omega_1", r"\omega_2", r"\Omega")
)


class Reading:
    """The meaning of one formula's tree, part by part."""

    def __init__(self, latex: str, more: Mapping[Node, Expr] | None = None):
        self._latex = latex
        self._basis = SPHERICAL if r"\theta" in latex else CARTESIAN
        self._quantities = {**_QUANTITIES, **(more or {})}

    def refused(self, why: str) -> NotationError:
        """Give the error that says why the formula means nothing."""
        return NotationError(f"{self._latex!r} {why}.")

    def expression(self, items: tuple[Node, ...]) -> Expr:
        """A sum; "+ …" at its end stands for what the step says is neglected."""
        signed: list[tuple[int, list[Node]]] = [(1, [])]
        for at, item in enumerate(without_spaces(items)):
            sign = {"+": 1, "−": -1}.get(operator(item))
            if sign is None:
                signed[-1][1].append(item)
            elif at == 0:
                signed = [(sign, [])]
            else:
                signed.append((sign, []))
        if len(signed) > 1 and signed[-1] == (1, [_DOTS]):
            del signed[-1]
        return Add(*(Mul(sign, self._product(tuple(term))) for sign, term in signed))

    def _product(self, items: tuple[Node, ...]) -> Expr:
        """Factors side by side, or with one sign between two of them."""
        value, at = self._factor(items, 0)
        while at < len(items):
            sign = items[at]
            if sign == _TIMES:
                factor, at = self._factor(items, at + 1)
                value = _cross(value, factor)
            elif sign == _SLASH:
                factor, at = self._factor(items, at + 1)
                if at < len(items):
                    raise self.refused("does not tell how much of it stands below the /")
                value = Mul(value, Pow(factor, -1))
            elif sign == _DOT:
                factor, at = self._factor(items, at + 1)
                value = Mul(value, factor)
            else:
                if _is_number(items[at - 1]) and _is_numeric(sign):
                    raise self.refused("has two numbers side by side, which look like one")
                factor, at = self._factor(items, at)
                value = Mul(value, factor)
        return value

    def _factor(self, items: tuple[Node, ...], at: int) -> tuple[Expr, int]:
        """The factor that begins at a place, and the place after it."""
        if at >= len(items):
            raise self.refused("ends, or has a sign, where a quantity should stand")
        node = items[at]
        if node == _DERIVATIVE:
            operand = items[at + 1] if at + 1 < len(items) else None
            if isinstance(operand, Script) and operand.above is not None:
                raise self.refused("does not tell what of a power d/dt differentiates")
            value, after = self._factor(items, at + 1)
            return Ddt(value), after
        if isinstance(node, Script) and node.base == _INTEGRAL:
            return self._integral(node, items[at + 1 :]), len(items)
        base, exponent = self._power(node)
        if isinstance(base, Atom) and base.kind == "function":
            angle, after = self._angle(items, at + 1)
            if base.text not in _FUNCTIONS:
                raise self.refused(f"has {base.text}, which the paper does not use")
            return Pow(_FUNCTIONS[base.text](angle), exponent), after
        return Pow(self._quantity(base), exponent), at + 1

    def _integral(self, sign: Script, items: tuple[Node, ...]) -> Expr:
        """All that follows an integral sign is what it is taken of, over du in a numerator.

        It is one fraction, or two with a dot between them.
        """
        lower, upper = sign.below, sign.above
        first, last = Integer(1), items[-1] if items else None
        if len(items) == 3 and isinstance(items[0], Fraction) and items[1] == _DOT:
            first, items = self._quantity(items[0]), items[2:]
        if lower is None or upper is None or len(items) != 1 or not isinstance(last, Fraction):
            raise self.refused("has an integral without both bounds, or not of one fraction or two")
        over = list(without_spaces(_items(last.above)))
        if over[-2:] != _MEASURE:
            raise self.refused("has an integral that does not end, in its numerator, with du")
        above = self.expression(tuple(over[:-2])) if over[:-2] else Integer(1)
        integrand = Mul(first, above, Pow(self.expression(_items(last.below)), -1))
        return Integrated(integrand, self._quantity(lower), self._quantity(upper))

    def _power(self, node: Node) -> tuple[Node, Expr]:
        """A base and its exponent; an index and a prime belong to the base."""
        if not isinstance(node, Script) or node.above is None or node in _QUANTITIES:
            return node, Integer(1)
        base, above = node.base, node.above
        if isinstance(above, MathList) and len(above.items) == 2:
            mark, above = above.items
            base = Script(base, node.below, mark)
        elif node.below is not None:
            base = Script(base, node.below, None)
        if not isinstance(above, Atom) or not above.text.isdecimal() or above.text[0] == "0":
            raise self.refused("has an exponent that is not a whole number")
        if isinstance(base, Fraction):
            raise self.refused("has an exponent beside a fraction without brackets")
        return base, Integer(int(above.text))

    def _angle(self, items: tuple[Node, ...], at: int) -> tuple[Expr, int]:
        """What a sine or cosine is taken of: θ, φ, or a frequency times t, perhaps with a number.

        Nothing else, so that nobody has to guess where the angle ends.
        """
        factor = Integer(1)
        if at < len(items) and _is_number(items[at]):
            factor, at = self._quantity(items[at]), at + 1
        angle = items[at] if at < len(items) else None
        if angle in _ANGLES:
            return Mul(factor, _QUANTITIES[angle]), at + 1
        if angle in _FREQUENCIES and items[at + 1 : at + 2] == (_TIME,):
            return Mul(factor, _QUANTITIES[angle], _QUANTITIES[_TIME]), at + 2
        raise self.refused("has a sine or cosine of what is not a plain angle")

    def _quantity(self, node: Node) -> Expr:
        if node in self._quantities:
            return self._quantities[node]
        match node:
            case Atom(kind="number", text=text) if text.isdecimal() and str(int(text)) == text:
                return Integer(int(text))
            case Fence("|", "|", inner):
                return Abs(self.expression(inner.items))
            case Fence(opening, closing, inner) if (opening, closing) in _PAIRS:
                return self.expression(inner.items)
            case Root(inner):
                return sqrt(self.expression(_items(inner)))
            case Fraction(above, below):
                return self._fraction(above, below)
            case Matrix(rows):
                return self._column(rows)
            case Atom(text=text):
                raise self.refused(f"has {text} where a quantity of the paper should stand")
            case Accent() | Script():
                raise self.refused("has a letter with a mark or an index that the paper lacks")
            case _:
                raise self.refused("groups by braces, which cannot be seen, or by odd brackets")

    def _fraction(self, above: Node, below: Node) -> Expr:
        over, under = self.expression(_items(above)), self.expression(_items(below))
        if over.is_Integer and under.is_Integer and under != 0:
            return Rational(over, under)
        return Mul(over, Pow(under, -1))

    def _column(self, rows: tuple[tuple[Node, ...], ...]) -> Expr:
        if [len(row) for row in rows] != [1, 1, 1]:
            raise self.refused("has a matrix that is not a column of three")
        values = [self.expression(_items(cell)) for (cell,) in rows]
        return Add(*(Mul(value, unit) for value, unit in zip(values, self._basis, strict=True)))


def _is_number(node: Node) -> bool:
    return isinstance(node, Atom) and node.kind == "number"


def _is_numeric(node: Node) -> bool:
    """Whether this is a number, or a fraction of two that would look like part of a mixed one."""
    if isinstance(node, Fraction):
        return _is_number(node.above) and _is_number(node.below)
    return _is_number(node)


def _items(node: Node) -> tuple[Node, ...]:
    return node.items if isinstance(node, MathList) else (node,)


def components(vector: Expr, basis: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """The vector's components: it must be a sum of multiples of the basis."""
    zero = dict.fromkeys(basis, 0)
    return tuple(vector.subs({**zero, unit: 1}) for unit in basis)


def _cross(u: Expr, v: Expr) -> Expr:
    (ux, uy, uz), (vx, vy, vz) = components(u, CARTESIAN), components(v, CARTESIAN)
    rows = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
    return Add(*(Mul(row, unit) for row, unit in zip(rows, CARTESIAN, strict=True)))
