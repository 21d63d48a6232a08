"""Reads the paper's LaTeX into what the proofs judge.

Read, not retyped: the formula that a document shows and the one that is proved are the same text.
Only what the paper uses is understood; anything else is a NotationError.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from kugelpendel.paper.algebra.symbols import CARTESIAN, SPHERICAL, SYMBOL, VECTORS, Ddt
from kugelpendel.paper.algebra.sympy_names import (
    Abs,
    Add,
    Expr,
    Integer,
    Mul,
    Pow,
    Rational,
    cos,
    sin,
    sqrt,
)

_TOKEN = re.compile(
    r""
    r"\\begin\{pmatrix\}|\\end\{pmatrix\}|\\vec\{e\}_(?:\\?[a-z]+)|\\d?dot\{\\vec\{r\}\}|\\vec\{[a-zL]\}"
    r""
    r"|\\d?dot\{\\?[a-z]+\}|\\omega_0|L_[xyz]|[xy]'|\\[A-Za-z]+|\\[\\{}]|[0-9]+|[a-zA-Z]|[-+=^(){}\[\]/&|]"
)
_SKIPPED = {r"\left", r"\right", r"\quad", "&"}
_CLOSING = {"(": ")", "[": "]", r"\{": r"\}", "{": "}"}
_RELATIONS = {"=": "=", r"\approx": "≈", r"\ll": "≪"}


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

    def apply(self, change: Callable[[Expr], Expr]) -> Relation:
        """The same relation with both sides changed."""
        return Relation(change(self.lhs), self.op, change(self.rhs))


@cache
def read(latex: str, lhs: Expr | None = None) -> Relation:
    """The relation that the LaTeX says; `lhs` where it starts with "="."""
    reader = _Reader(latex)
    left = reader.expression() if reader.peek() not in _RELATIONS else lhs
    if left is None:
        raise NotationError(f"{latex!r} continues a line, but none comes before it.")
    if reader.peek() == "":
        return Relation(left, "", Integer(0))
    op = reader.take()
    if op not in _RELATIONS:
        raise NotationError(f"{latex!r} has {op!r} where a relation should stand.")
    right = reader.expression()
    if reader.peek() != "":
        raise NotationError(f"{latex!r} goes on with {reader.peek()!r} after its right-hand side.")
    return Relation(left, _RELATIONS[op], right)


class _Reader:
    """One formula, token by token."""

    def __init__(self, latex: str):
        self._latex = latex
        rest = _TOKEN.sub("", latex)
        if rest.strip():
            raise NotationError(f"{latex!r} has {rest.strip()[0]!r}, which the paper does not use.")
        self._tokens = [token for token in _TOKEN.findall(latex) if token not in _SKIPPED]
        self._basis = SPHERICAL if r"\theta" in latex else CARTESIAN

    def peek(self, ahead: int = 0) -> str:
        """The next token, "" at the end."""
        return self._tokens[ahead] if ahead < len(self._tokens) else ""

    def take(self, wanted: str = "") -> str:
        """The next token, which must be the wanted one."""
        if not self._tokens or (wanted and self._tokens[0] != wanted):
            raise NotationError(
                f"{self._latex!r}: {wanted or 'more'} expected, {self.peek()!r} found."
            )
        return self._tokens.pop(0)

    def expression(self) -> Expr:
        """A sum; "+ …" at its end stands for what the step says is neglected."""
        terms: list[Expr] = []
        sign = 1
        if self.peek() in ("+", "-"):
            sign = -1 if self.take() == "-" else 1
        while True:
            if self.peek() == r"\dots":
                self.take()
            else:
                terms.append(Mul(sign, self._product()))
            if self.peek() not in ("+", "-"):
                return Add(*terms)
            sign = -1 if self.take() == "-" else 1

    def _product(self) -> Expr:
        value = self._power()
        while True:
            token = self.peek()
            if token in (
                "",
                "+",
                "-",
                "&",
                "|",
                r"\\",
                r"\dots",
                *_RELATIONS,
                *_CLOSING.values(),
            ) or (token == r"\end{pmatrix}"):
                return value
            if token == "/":
                self.take()
                value = Mul(value, Pow(self._power(), -1))
            elif token == r"\times":
                self.take()
                value = _cross(value, self._power())
            elif token == r"\cdot":
                self.take()
            else:
                value = Mul(value, self._power())

    def _power(self) -> Expr:
        base = self._atom()
        if self.peek() != "^":
            return base
        self.take()
        return Pow(base, self._exponent())

    def _exponent(self) -> Expr:
        token = self.take()
        if token == "{":
            token = self.take()
            self.take("}")
        if not token.isdigit():
            raise NotationError(f"{self._latex!r} has the exponent {token!r}, not a number.")
        return Integer(int(token))

    def _atom(self) -> Expr:
        token = self.take()
        if token.isdigit():
            return Integer(int(token))
        if token in _CLOSING:
            value = self.expression()
            self.take(_CLOSING[token])
            return value
        if token == "|":
            value = self.expression()
            self.take("|")
            return Abs(value)
        if token in (r"\sin", r"\cos"):
            return self._angle_function(sin if token == r"\sin" else cos)
        if token == r"\sqrt":
            return sqrt(self._group())
        if token == r"\frac":
            return self._fraction()
        if token == r"\begin{pmatrix}":
            return self._column()
        if token in VECTORS:
            return VECTORS[token]
        if token in SYMBOL:
            return SYMBOL[token]
        raise NotationError(f"{self._latex!r} has {token!r} where a quantity should stand.")

    def _group(self) -> Expr:
        self.take("{")
        value = self.expression()
        self.take("}")
        return value

    def _fraction(self) -> Expr:
        if [self.peek(k) for k in range(7)] == ["{", "d", "}", "{", "d", "t", "}"]:
            del self._tokens[:7]
            return Ddt(self._atom())
        above = self._group()
        below = self._group()
        if above.is_Integer and below.is_Integer:
            return Rational(above, below)
        return Mul(above, Pow(below, -1))

    def _angle_function(self, function: Callable[[Expr], Expr]) -> Expr:
        exponent = Integer(1)
        if self.peek() == "^":
            self.take()
            exponent = self._exponent()
        factor = Integer(int(self.take())) if self.peek().isdigit() else Integer(1)
        angle = SYMBOL[self.take()]
        if self.peek() == "t":
            angle = Mul(angle, SYMBOL[self.take()])
        return Pow(function(Mul(factor, angle)), exponent)

    def _column(self) -> Expr:
        rows = [self.expression()]
        while self.peek() == r"\\":
            self.take()
            rows.append(self.expression())
        self.take(r"\end{pmatrix}")
        return Add(*(Mul(row, unit) for row, unit in zip(rows, self._basis, strict=True)))


def components(vector: Expr, basis: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """The vector's components: it must be a sum of multiples of the basis."""
    zero = dict.fromkeys(basis, 0)
    return tuple(vector.subs({**zero, unit: 1}) for unit in basis)


def _cross(u: Expr, v: Expr) -> Expr:
    (ux, uy, uz), (vx, vy, vz) = components(u, CARTESIAN), components(v, CARTESIAN)
    rows = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
    return Add(*(Mul(row, unit) for row, unit in zip(rows, CARTESIAN, strict=True)))
