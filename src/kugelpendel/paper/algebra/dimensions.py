"""Dimensions: the quickest way to find a misprint."""

from __future__ import annotations

from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.symbols import DIMENSION, Ddt, Integrated
from kugelpendel.paper.algebra.sympy_names import Abs, Add, Expr, Mul, Pow, Rational, cos, sin

Powers = tuple[Expr, Expr, Expr]  # of mass, length, time


class InhomogeneousError(ValueError):
    """A sum of terms that cannot be added, or a sine of something that is not a number."""


def dimension(expression: Expr) -> Powers | None:
    """Powers of mass, length and time; None for 0, which fits everywhere."""
    if expression == 0:
        return None
    if expression.is_Symbol:
        mass, length, time = DIMENSION[expression]
        return Rational(mass), Rational(length), Rational(time)
    if expression.is_number:
        return Rational(0), Rational(0), Rational(0)
    if isinstance(expression, Add):
        return _common(*(dimension(term) for term in expression.args))
    if isinstance(expression, Mul):
        factors = [dimension(factor) for factor in expression.args]
        mass, length, time = (sum(f[k] for f in factors if f is not None) for k in range(3))
        return Rational(mass), Rational(length), Rational(time)
    if isinstance(expression, Pow):
        mass, length, time = dimension(expression.base) or (Rational(0),) * 3
        return mass * expression.exp, length * expression.exp, time * expression.exp
    if isinstance(expression, (sin, cos)):
        _common(dimension(expression.args[0]), (Rational(0),) * 3)
        return Rational(0), Rational(0), Rational(0)
    if isinstance(expression, Abs):
        return dimension(expression.args[0])
    if isinstance(expression, Integrated):  # over u, a number
        return dimension(expression.args[0])
    if isinstance(expression, Ddt):
        inner = dimension(expression.args[0])
        return None if inner is None else (inner[0], inner[1], inner[2] - 1)
    raise TypeError(f"{expression} is not an expression of the paper.")


def _common(*dimensions: Powers | None) -> Powers | None:
    found = {d for d in dimensions if d is not None}
    if len(found) > 1:
        raise InhomogeneousError(f"terms of the dimensions {sorted(found, key=str)} are added")
    return found.pop() if found else None


def is_homogeneous(relation: Relation) -> bool:
    """Whether all terms and both sides have one dimension."""
    try:
        _common(dimension(relation.lhs), dimension(relation.rhs))
    except InhomogeneousError:
        return False
    return True
