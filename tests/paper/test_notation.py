"""What is typeset is what is proved: one tree, and nothing in it that the proofs pass over."""

import pytest

from kugelpendel import paper
from kugelpendel.paper.algebra.notation import NotationError, Relation, read
from kugelpendel.paper.algebra.symbols import LATEX, SYMBOL, Ddt, a, l, omega, rho, t, theta, x, xd
from kugelpendel.paper.algebra.sympy_names import Abs, Integer, Rational, cos, sin, sqrt
from kugelpendel.paper.typeset import latex


@pytest.mark.parametrize(
    ("source", "meaning"),
    [
        (r"-\frac{3}{8} a l^2", -Rational(3, 8) * a * l**2),
        (r"2 \{ [a (x - l)] \}", 2 * a * (x - l)),
        (r"\sin^2 \theta \cos 3\omega t", sin(theta) ** 2 * cos(3 * omega * t)),
        (r"\left( a \right)^3 / l", a**3 / l),
        (r"x'^2 + \omega_0^2", SYMBOL["x'"] ** 2 + SYMBOL[r"\omega_0"] ** 2),
        (r"\sqrt{1 - \frac{\rho^2}{l^2}}^2 \, x", x * sqrt(1 - rho**2 / l**2) ** 2),
        (r"|a - l| \quad", Abs(a - l)),
        (r"\frac{d}{dt} (x^2) \cdot \dot{x}", Ddt(x**2) * xd),
        (r"l^{12} + \dots", l**12),
        ("+ a", a),
    ],
)
def test_meaning(source: str, meaning: object) -> None:
    assert read(source).lhs == meaning
    assert read(f"{source} = 0") == Relation(meaning, "=", Integer(0))


@pytest.mark.parametrize(
    "source",
    [
        r"\sin^2 \theta^2",  # a second exponent, on the angle
        r"\sin \theta^2",
        r"\cos (\omega t)",
        r"\sin \omega",
        r"\sin \theta t \sin",
        "l^04",  # TeX sets l⁰4
        "l^12",
        "l^{04}",
        "l^{-1}",
        "l^{2a}",
        "x^y",
        r"\frac12 x",
        r"\frac{a}{l}^2",
        "a . l",  # stray dots
        "a, l",
        r"\cdot a",
        r"a \cdot",
        r"a \cdot \cdot l",
        r"a \dots l",
        r"\dots + a",
        r"a - \dots",
        r"\dots",
        "2 3 a",  # looks like 23
        r"2 \frac{1}{3} a",  # two and a third?
        "a / l a",  # what stands below?
        r"\frac{d}{dt} x^2",
        "{a + l} x",  # braces that nobody sees
        "{a x}^2",
        r"\left( a \right]",
        "x_1",
        "x''",
        r"\dot{a}",
        r"\omega_{00}",
        "a^2^3",
        r"\tan \theta",
        r"x \text{ and } a",
        r"\begin{pmatrix} x & a \\ x & a \\ x & a \end{pmatrix}",
        r"\begin{pmatrix} x \\ a \end{pmatrix}",
        "1.5 a",
        "a +",
        "a + - l",
        "",
        "a = ",
        "a = x = l",
        "(a = x)",
        "a < x",
        "= a",
        "c",
    ],
)
def test_what_is_typeset_but_means_nothing_is_refused(source: str) -> None:
    with pytest.raises(NotationError):
        read(source)


def test_every_letter_is_read_as_itself() -> None:
    for symbol, source in LATEX.items():
        assert read(source).lhs == symbol
        assert read(f"{source} {source}").lhs == symbol**2


@pytest.mark.parametrize("formula", paper.FORMULAS, ids=lambda one: one.label)
def test_formula_means_the_same_as_any_document_writes_it(formula: paper.Formula) -> None:
    for source in (formula.printed, formula.right):
        left = SYMBOL["x"] if formula.head else None
        assert read(latex.display(source, 1e9), left) == read(source, left)
