"""Formulas as LaTeX again, broken into lines that fit on paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.paper.typeset.breaks import is_break, lines, pieces, width
from kugelpendel.paper.typeset.tex import (
    FUNCTIONS,
    IDENTIFIERS,
    OPERATORS,
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

_LINE = 60
"""How wide a formula within a sentence may be before TeX has to break it."""

_NAMES = {sign: f"\\{name}" for name, sign in {**OPERATORS, **IDENTIFIERS}.items()} | {"−": "-"}
_ACCENTS = {"\u0307": "\\dot", "\u0308": "\\ddot", "\u20d7": "\\vec"}
_DELIMITERS = {"{": "\\{", "}": "\\}", "|": "|", "": "."}


def display(source: str, room: float) -> str:
    """Write a displayed formula, as ``aligned`` lines where it is wider than `room` signs."""
    return written(read(source), room)


def inline(source: str) -> str:
    """Write a formula within a sentence; one that is wider than a line may be broken in it.

    TeX does not break within brackets that grow with what they hold, so wide ones are opened.
    """
    row = read(source)
    return (
        source if width(row) < _LINE else _row(tuple(q for part in pieces(row.items) for q in part))
    )


def written(row: MathList, room: float) -> str:
    """Write a formula that has been read, and perhaps marked, in the same way."""
    broken = lines(row.items, room)
    if len(broken) == 1:
        return _row(broken[0])
    first, *others = broken
    # A line that begins with + or = is set as if something stood before it.
    continued = [f"&\\quad {'{}' if is_break(line[0]) else ''}{_row(line)}" for line in others]
    body = " \\\\\n".join([f"&{_row(first)}", *continued])
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _row(items: Piece) -> str:
    text = ""
    for item in items:
        part = _node(item)
        text += (
            f" {part}"
            if text and text[-1].isalpha() and part[:1].isalpha() and "\\" in text
            else part
        )
    return text


def _node(node: Node) -> str:
    match node:
        case Atom():
            return _atom(node)
        case MathList(items):
            return _row(items)
        case Fraction(above, below):
            return f"\\frac{{{_node(above)}}}{{{_node(below)}}}"
        case Root(inner):
            return f"\\sqrt{{{_node(inner)}}}"
        case Script():
            return _script(node)
        case Accent(base, mark):
            return f"{_ACCENTS[mark]}{{{_node(base)}}}"
        case Fence(opening, closing, inner):
            left, right = _DELIMITERS.get(opening, opening), _DELIMITERS.get(closing, closing)
            return f"\\left{left} {_row(inner.items)} \\right{right}"
        case Matrix(rows):
            body = " \\\\ ".join(" & ".join(_node(cell) for cell in row) for row in rows)
            return f"\\begin{{pmatrix}} {body} \\end{{pmatrix}}"
        case Marked(inner):
            return f"\\boxed{{{_node(inner)}}}"
        case Bracket(sign, is_high):
            side = "l" if sign in "([{" else "r"
            return f"\\{'Bigg' if is_high else 'big'}{side}{_DELIMITERS.get(sign, sign)} "


def _atom(atom: Atom) -> str:
    match atom.kind:
        case "function":
            known = atom.text in FUNCTIONS
            return f"\\{atom.text} " if known else f"\\operatorname{{{atom.text}}}"
        case "space":
            return "\\quad " if float(atom.text) >= 1 else "\\, "
        case "text":
            return f"\\text{{{atom.text}}}"
        case _:
            name = _NAMES.get(atom.text, atom.text)
            return f"{name} " if name.startswith("\\") else name


def _script(node: Script) -> str:
    text = _node(node.base).rstrip()
    if isinstance(node.base, MathList):
        text = f"{{{text}}}"
    if node.below is not None:
        text += f"_{{{_node(node.below).strip()}}}"
    if node.above is not None:
        above = _node(node.above).strip()
        text += above.replace("′", "'") if set(above) == {"′"} else f"^{{{above}}}"
    return f"{text} " if isinstance(node.base, Atom) and node.base.kind == "function" else text
