"""Formulas in one line of Unicode, for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING
from unicodedata import normalize

from kugelpendel.paper.typeset.breaks import lines
from kugelpendel.paper.typeset.tex import (
    RELATIONS,
    Accent,
    Atom,
    Bracket,
    Fence,
    Fraction,
    Marked,
    MathList,
    Matrix,
    Node,
    Root,
    Script,
    read,
)

if TYPE_CHECKING:
    from kugelpendel.paper.typeset.breaks import Piece

_ABOVE = str.maketrans("0123456789+−n", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ")
_BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_SINGLE_BELOW = frozenset("0123456789")


def plain(source: str) -> str:
    """Write a formula as text: ``θ̈ − φ̇² sin θ cos θ + g/l sin θ = 0``."""
    return written(read(source).items)


def broken(source: str, room: float) -> list[str]:
    """Write a formula on several lines where it is wider than about `room` signs."""
    first, *others = lines(read(source).items, 0.75 * room)
    return [written(first), *(_continued(written(line)) for line in others)]


def _continued(line: str) -> str:
    """A line that begins with a sign between terms keeps the space after it."""
    return f"{line[0]} {line[1:].lstrip()}" if line[:1] in "+−" else line


def written(items: Piece) -> str:
    """Write things that have been read already."""
    return normalize("NFC", " ".join(_row(MathList(items)).split()))


def _row(row: MathList) -> str:
    written = ""
    before: Node | None = None
    for item in row.items:
        text = _node(item)
        if isinstance(item, Atom) and item.kind == "operator":
            text = _operator(item.text, before)
        elif before is not None and _stand_apart(before, item):
            text = f" {text}"
        written += text
        before = item
    return written


def _operator(sign: str, before: Node | None) -> str:
    if sign in "+−":
        return sign if before is None or _is_open(before) else f" {sign} "
    if sign in RELATIONS or sign in "×·":
        return f" {sign} "
    return f"{sign} " if sign in ",;" else sign


def _stand_apart(before: Node, item: Node) -> bool:
    """Whether a space keeps two things apart: around sin, fractions and vectors."""
    if isinstance(before, Atom) and before.kind in ("operator", "space"):
        return False
    if isinstance(before, Bracket):
        return before.sign in ")]}"
    if _is_function(before):
        return not isinstance(item, Fence)
    if isinstance(before, Script) and before.above is not None and _is_number(item):
        return True
    return _is_function(item) or _is_vector(item) or Fraction in (type(before), type(item))


def _is_open(before: Node) -> bool:
    if isinstance(before, Bracket):
        return before.sign in "([{"
    return isinstance(before, Atom) and before.kind == "operator" and before.text != "′"


def _is_vector(node: Node) -> bool:
    if isinstance(node, Script):
        return _is_vector(node.base)
    return isinstance(node, Accent) and (node.mark == "\u20d7" or _is_vector(node.base))


def _is_function(node: Node | None) -> bool:
    if isinstance(node, Script):
        return _is_function(node.base)
    return isinstance(node, Atom) and node.kind == "function"


def _is_number(node: Node) -> bool:
    return isinstance(node, Atom) and node.kind == "number"


def _node(node: Node) -> str:
    match node:
        case Atom(kind="space"):
            return " "
        case Atom(text=text):
            return text
        case MathList():
            return _row(node)
        case Fraction(above, below):
            return f"{_operand(above)}/{_divisor(below)}"
        case Root(inner):
            return f"√{_operand(inner)}"
        case Script():
            return _script(node)
        case Accent(base, mark):
            return _node(base) + mark
        case Fence(opening, closing, inner):
            return f"{opening}{_row(inner).strip()}{closing}"
        case Matrix(rows):
            lines = ", ".join(" ".join(_node(cell).strip() for cell in row) for row in rows)
            return f"({lines})"
        case Marked(inner):
            return _node(inner)
        case Bracket(sign):
            return sign


def _operand(node: Node) -> str:
    text = _node(node).strip()
    simple = isinstance(node, Atom | Script | Accent | Fence) or text.isalnum()
    return text if simple else f"({text})"


def _divisor(node: Node) -> str:
    """What is divided by: a product in brackets, but for the dt of d/dt."""
    text = _node(node).strip()
    is_product = isinstance(node, MathList) and len(node.items) > 1
    return f"({text})" if is_product and text != "dt" else text


def _script(node: Script) -> str:
    text = _node(node.base)
    if text == "∫" and node.below is not None and node.above is not None:
        return f"∫[{_node(node.below)} … {_node(node.above)}] "
    if node.below is not None:
        below = _node(node.below)
        small = below.translate(_BELOW)
        text += small if all(sign in _SINGLE_BELOW for sign in below) else f"_{below}"
    if node.above is not None:
        above = _node(node.above)
        if above.startswith("′"):
            return text + above
        small = above.translate(_ABOVE)
        fits = all(sign in "0123456789+−n" for sign in above)
        text += small if fits else f"^({above})"
    return text
