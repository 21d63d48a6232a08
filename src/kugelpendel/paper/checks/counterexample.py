"""Small numbers at which a misprinted formula fails: the smallest of those that are tried."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import product

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import carry_out, is_zero
from kugelpendel.paper.algebra.notation import NotationError, Relation, read
from kugelpendel.paper.algebra.symbols import LATEX
from kugelpendel.paper.algebra.sympy_names import Expr, I, Rational, cos, expand, sin
from kugelpendel.paper.derivation.graph import formula, premises, printed, right
from kugelpendel.paper.derivation.misprints import MISPRINTS
from kugelpendel.paper.derivation.model import Formula, Misprint

_SINES = ((0, 1), (1, 0), (Rational(3, 5), Rational(4, 5)))  # (sin, cos), the simplest first
_IN_WORDS = {  # what the words claim, and the formula whose proof refutes it
    "one-dot-each": (r"x\dot{y} = y\dot{x}", "9:2"),
    "small-against-their-opposite": ("", "13a"),
    "cubic-terms-negative": ("", "23:1"),
}


@dataclass(frozen=True)
class Counterexample:
    """`values`: (LaTeX of a letter, or of its sine, its number); letters not named are 0.

    There, the left side minus the right one is too large by `excess` (LaTeX).
    """

    values: tuple[tuple[str, str], ...]
    excess: str


def counterexample(key: str) -> Counterexample | None:
    """For the misprint of that key; None where words alone are wrong. KeyError for another key."""
    misprint = {one.key: one for one in MISPRINTS}[key]
    if key in ("bars-missing", "bars-missing-again"):
        return _of_frequency()
    if key in ("bars-missing-turning", "bars-missing-slow"):
        return _of_turning()
    if key == "bars-missing-small":
        return Counterexample((("l", "1"), ("x", "-1")), "-1 < 0")
    if misprint.kind == "word" or key in _IN_WORDS:
        return _of_words(key)
    one = formula(misprint.where)
    return _smallest(_residuals(one, _alone(one, misprint)))


def _of_frequency() -> Counterexample:
    """By (26) the frequency falls."""
    numbers = {s.a: 1, s.b: 0, s.l: 1, s.omega0: 1}
    square = right("26").rhs.subs(numbers)
    values = (("a", "1"), ("l", "1"), (r"\omega_0", "1"))
    return Counterexample(values, rf"\sqrt{{{square}}} - 1 < 0")


def _of_turning() -> Counterexample:
    """By (25) the ellipse turns clockwise where the bob does."""
    turning = right("25").rhs.subs({s.a: 1, s.b: -1, s.l: 1, s.omega0: 1})
    values = (("a", "1"), ("b", "-1"), ("l", "1"), (r"\omega_0", "1"))
    return Counterexample(values, f"{turning} < 0")


def _of_words(key: str) -> Counterexample | None:
    claim, label = _IN_WORDS.get(key, ("", ""))
    if not claim:
        return None
    relation, one = read(claim), formula(label)
    return _smallest([*one.proof.symbolic(relation, premises(one))])


def _alone(one: Formula, misprint: Misprint) -> Relation:
    """The right formula with this misprint only, where the text tells them apart."""
    source = one.right.replace(misprint.right, misprint.alone or misprint.printed)
    if source == one.right:
        return printed(one.label)
    try:
        return read(source, right(one.head).lhs if one.head else None)
    except NotationError:
        return printed(one.label)


def _residuals(one: Formula, relation: Relation) -> list[Expr]:
    proof = one.proof
    if proof.if_equal is not None and relation.op == "=":
        return proof.if_equal.symbolic(relation, premises(one).unrestricted())
    return proof.symbolic(relation, premises(one))


def _smallest(residuals: list[Expr]) -> Counterexample | None:
    for residual in residuals:
        if not is_zero(residual):
            return _search(expand(carry_out(residual)))
    return None


def _search(residual: Expr) -> Counterexample | None:
    angles = sorted({f.args[0].as_coeff_Mul()[1] for f in residual.atoms(sin, cos)}, key=str)
    inner = {q for angle in angles for q in angle.free_symbols}
    bare = residual.xreplace(dict.fromkeys(residual.atoms(sin, cos), 1))
    letters = sorted((residual.free_symbols - inner) | (bare.free_symbols & inner), key=str)
    choices = [(1, 2) if q.is_positive else (0, 1, 2) for q in letters]
    sines = [_SINES for _ in angles]
    points = sorted(product(product(*choices), product(*sines)), key=_weight)
    for numbers, turns in points:
        value = _at(residual, letters, numbers, angles, turns)
        if value.is_finite and value != 0:
            named = [(LATEX[q], str(n)) for q, n in zip(letters, numbers, strict=True) if n]
            named += [(_sine(angle), str(t[0])) for angle, t in zip(angles, turns, strict=True)]
            return Counterexample(tuple(named), str(value))
    return None


def _weight(point: tuple[tuple[int, ...], tuple[tuple[Expr, Expr], ...]]) -> int:
    numbers, turns = point
    return sum(numbers) + sum(_SINES.index(turn) for turn in turns)


def _at(
    residual: Expr,
    letters: list[Expr],
    numbers: tuple[int, ...],
    angles: list[Expr],
    turns: tuple[tuple[Expr, Expr], ...],
) -> Expr:
    table = dict(_functions(residual, tuple(angles), turns))
    return residual.xreplace(table).subs(dict(zip(letters, numbers, strict=True)))


@cache
def _functions(
    residual: Expr, angles: tuple[Expr, ...], turns: tuple[tuple[Expr, Expr], ...]
) -> tuple[tuple[Expr, Expr], ...]:
    found: list[tuple[Expr, Expr]] = []
    for function in residual.atoms(sin, cos):
        factor, angle = function.args[0].as_coeff_Mul()
        s, c = turns[angles.index(angle)]
        power = expand((Rational(c) + s * I) ** int(factor))
        found.append((function, power.as_real_imag()[function.func == sin]))
    return tuple(found)


def _sine(angle: Expr) -> str:
    if angle.is_Symbol:
        return rf"\sin {LATEX[angle]}"
    return r"\sin " + " ".join(LATEX[q] for q in sorted(angle.args, key=lambda q: str(q) == "t"))
