"""A formula in LaTeX, read into a tree: every document is written from it, and the proofs judge it.

Only the commands that the derivation uses are known; any other one is refused, so that no document
can show half a formula. An own reader rather than a converter from LaTeX to MathML: the tree also
tells where a long line may be broken, gives the terminal its formulas, and is what
`kugelpendel.paper.algebra.notation` turns into SymPy.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

IDENTIFIERS = {
    "alpha": "α", "beta": "β", "delta": "δ", "varepsilon": "ε", "theta": "θ", "lambda": "λ",
    "pi": "π", "rho": "ρ", "phi": "φ", "psi": "ψ", "omega": "ω", "Omega": "Ω", "infty": "∞",
    "ldots": "…", "dots": "…",
}  # fmt: skip
OPERATORS = {
    "cdot": "·", "times": "×", "ll": "≪", "gg": "≫", "wedge": "∧", "neq": "≠", "ne": "≠",
    "approx": "≈", "leq": "≤", "le": "≤", "geq": "≥", "ge": "≥", "pm": "±", "to": "→", "sim": "∼",
    "Rightarrow": "⇒", "Leftrightarrow": "⇔", "lt": "<", "gt": ">", "equiv": "≡", "propto": "∝",
    "leftrightarrow": "↔", "in": "∈", "int": "∫",
}  # fmt: skip
RELATIONS = frozenset("=≪≫≠≈≤≥→∼⇒⇔<>≡∝↔∈∧")
FUNCTIONS = frozenset({"sin", "cos", "tan", "sgn", "min", "max"})
ACCENTS = {"dot": "\u0307", "ddot": "\u0308", "vec": "\u20d7"}
SPACES = {",": 0.17, ":": 0.22, ";": 0.28, " ": 0.25, "quad": 1.0, "qquad": 2.0}
DELIMITERS = {
    "\\{": "{",
    "\\}": "}",
    "\\langle": "⟨",
    "\\rangle": "⟩",
    "\\lvert": "|",
    "\\rvert": "|",
}

_TOKEN = re.compile(
    r"\\(?:text|mathrm|operatorname|mathcal|begin|end)\{[^{}]*\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.",
    re.DOTALL,
)


@dataclass(frozen=True)
class Atom:
    """One sign: kind is identifier, number, operator, function, space (text: its em) or text."""

    kind: str
    text: str


@dataclass(frozen=True)
class MathList:
    """Things side by side, for which TeX's own word is a math list."""

    items: tuple[Node, ...]


@dataclass(frozen=True)
class Fraction:
    """One thing over another."""

    above: Node
    below: Node


@dataclass(frozen=True)
class Root:
    """A square root."""

    inner: Node


@dataclass(frozen=True)
class Script:
    """A base with an index, an exponent or both; primes are exponents."""

    base: Node
    below: Node | None
    above: Node | None


@dataclass(frozen=True)
class Accent:
    """A base with a dot, two dots or an arrow: the combining character."""

    base: Node
    mark: str


@dataclass(frozen=True)
class Fence:
    """Something in brackets that grow with it; an empty string is no bracket."""

    opening: str
    closing: str
    inner: MathList


@dataclass(frozen=True)
class Matrix:
    """Rows of cells in round brackets."""

    rows: tuple[tuple[Node, ...], ...]


@dataclass(frozen=True)
class Marked:
    """Something to point at: it differs between what is printed and what is right."""

    inner: Node


@dataclass(frozen=True)
class Bracket:
    """One bracket of a pair that is broken over several lines."""

    sign: str
    is_high: bool


Node = Atom | MathList | Fraction | Root | Script | Accent | Fence | Matrix | Marked | Bracket


class UnknownTeX(ValueError):
    """A formula that this reader does not understand: a mistake in the derivation's data."""


def read(source: str) -> MathList:
    """Read a formula.

    Raises
    ------
    UnknownTeX
        Braces or brackets that do not match, or a command that is not known.
    """
    reader = _Reader(source)
    row = reader.row(frozenset())
    if reader.peek() is not None:
        raise reader.confused("ends too early")
    return row


class _Reader:
    def __init__(self, source: str) -> None:
        self._source = source
        self._tokens = [token for token in _TOKEN.findall(source) if not token.isspace()]
        self._at = 0

    def confused(self, why: str) -> UnknownTeX:
        return UnknownTeX(f"{why}, at token {self._at} of {self._source!r}")

    def peek(self) -> str | None:
        return self._tokens[self._at] if self._at < len(self._tokens) else None

    def take(self, expected: str | None = None) -> str:
        token = self.peek()
        if token is None or (expected is not None and token != expected):
            raise self.confused(f"expected {expected or 'more'}, found {token}")
        self._at += 1
        return token

    def row(self, ends: frozenset[str]) -> MathList:
        items: list[Node] = []
        while (token := self.peek()) is not None and token not in ends:
            if token == "}":
                raise self.confused("a brace too many")
            items.append(self.scripted())
        return MathList(tuple(items))

    def scripted(self) -> Node:
        base = self.single()
        below: Node | None = None
        above: Node | None = None
        primes = 0
        while (token := self.peek()) in ("_", "^", "'"):
            self.take()
            if token == "'":
                primes += 1
            elif (below if token == "_" else above) is not None:
                raise self.confused(f"a second {token} at one base")
            elif token == "_":
                below = self.argument()
            else:
                above = self.argument()
        if primes:
            mark = Atom("operator", "′" * primes)
            above = mark if above is None else MathList((mark, above))
        return base if below is None and above is None else Script(base, below, above)

    def argument(self) -> Node:
        """What a command is applied to: without braces that is one digit to TeX, not a number."""
        token = self.peek()
        if token is not None and token[0].isdigit() and len(token) > 1:
            raise self.confused(f"{token} needs braces")
        return self.single()

    def single(self) -> Node:
        token = self.take()
        if token == "{":
            row = self.row(frozenset({"}"}))
            self.take("}")
            return row.items[0] if len(row.items) == 1 else row
        if token in ("(", "["):
            closing = ")" if token == "(" else "]"
            row = self.row(frozenset({closing}))
            self.take(closing)
            return Fence(token, closing, row)
        if token == "|":
            row = self.row(frozenset({"|"}))
            self.take("|")
            return Fence("|", "|", row)
        if token == "\\{":
            row = self.row(frozenset({"\\}"}))
            self.take("\\}")
            return Fence("{", "}", row)
        if token.startswith("\\"):
            return self.command(token[1:])
        if token[0].isdigit():
            return Atom("number", token)
        if token.isalpha():
            return Atom("identifier", token)
        if token in "+-=<>,.;:/!*":
            return Atom("operator", "−" if token == "-" else token)
        raise self.confused(f"{token} is not known")

    def command(self, name: str) -> Node:
        if name in IDENTIFIERS:
            return Atom("identifier", IDENTIFIERS[name])
        if name in OPERATORS:
            return Atom("operator", OPERATORS[name])
        if name in FUNCTIONS:
            return Atom("function", name)
        if name in SPACES:
            return Atom("space", str(SPACES[name]))
        if name in ACCENTS:
            return Accent(self.argument(), ACCENTS[name])
        if name == "frac":
            above = self.argument()
            return Fraction(above, self.argument())
        if name == "sqrt":
            return Root(self.argument())
        if name == "left":
            return self.fence()
        name, _, words = name.rstrip("}").partition("{")
        if name in ("mathrm", "text", "operatorname"):
            return Atom("text", words)
        if name == "mathcal" and words == "O":
            return Atom("identifier", "𝒪")
        if (name, words) == ("begin", "pmatrix"):
            return self.matrix()
        raise self.confused(f"\\{name} {words} is not known")

    def fence(self) -> Fence:
        opening = self.delimiter()
        row = self.row(frozenset({"\\right"}))
        self.take("\\right")
        return Fence(opening, self.delimiter(), row)

    def delimiter(self) -> str:
        token = self.take()
        return "" if token == "." else DELIMITERS.get(token, token)

    def matrix(self) -> Matrix:
        rows: list[tuple[Node, ...]] = []
        cells: list[Node] = []
        ends = frozenset({"&", "\\\\", "\\end{pmatrix}"})
        while True:
            cells.append(self.row(ends))
            token = self.take()
            if token == "&":
                continue
            rows.append(tuple(cells))
            cells = []
            if token != "\\\\":
                return Matrix(tuple(rows))
            if self.peek() == "\\end{pmatrix}":
                self.take()
                return Matrix(tuple(rows))
