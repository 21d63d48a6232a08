"""Where a long formula may be broken: before + − = outside brackets, inside wide ones, at dots."""

from __future__ import annotations

from typing import TYPE_CHECKING

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
)

if TYPE_CHECKING:
    from collections.abc import Sequence

_DOT = Atom("operator", "·")

Piece = tuple[Node, ...]
"""What stays on one line: things side by side."""

_LONG = 21
"""How wide a piece may be before its bracket is opened.

At 360 px nine formulas of 143 then are wider than the page, by 29 px at most, and scroll; with 26
they were 21, by up to 82 px (measured in Chromium).
"""


def pieces(items: Piece, room: float = _LONG) -> list[Piece]:
    """Cut a row into pieces; between two of them a line may end.

    A piece that is wider than `room` is cut within its widest bracket, where that is possible.
    """
    found: list[Piece] = []
    current: list[Node] = []
    for item in items:
        if is_break(item) and any(not is_break(other) for other in current):
            found.extend(_opened(tuple(current), room))
            current = []
        current.append(item)
    if found and _is_end(current):
        return [*found[:-1], (*found[-1], *current)]
    return [*found, *_opened(tuple(current), room)] if current else found


def lines(items: Piece, room: float) -> list[Piece]:
    """Fill lines with pieces; `room` is the most that `width` may count in a line.

    A piece that is wider than that stands alone on its line.
    """
    if width(MathList(items)) <= room:
        return [items]
    found: list[list[Node]] = [[]]
    used = 0.0
    for piece in pieces(items):
        needed = width(MathList(piece))
        if found[-1] and used + needed > room:
            found.append([])
            used = 0.0
        found[-1].extend(piece)
        used += needed
    return [tuple(line) for line in found]


def is_break(node: Node) -> bool:
    """Tell whether a line may end before this sign."""
    if isinstance(node, Marked):
        return is_break(node.inner)
    if not isinstance(node, Atom) or node.kind != "operator":
        return False
    return node.text in "+−" or node.text in RELATIONS


def width(node: Node) -> float:
    """Estimate how many signs wide something is: a letter counts 1, + counts 2 with its spaces."""
    match node:
        case Atom(kind="space"):
            return float(node.text)
        case Atom(kind="operator", text=text):
            return 2.0 if text in "+−" or text in RELATIONS else 1.0
        case Atom(text=text):
            return len(text)
        case MathList(items):
            return sum(width(item) for item in items)
        case Fraction(above, below):
            return max(width(above), width(below))
        case Root(inner):
            return 1 + width(inner)
        case Script(base, below, above):
            return width(base) + 0.7 * max(
                width(part) for part in (below, above) if part is not None
            )
        case Accent(base):
            return width(base)
        case Fence(inner=inner):
            return 1 + width(inner)
        case Matrix(rows):
            return 1 + max(sum(width(cell) + 1 for cell in row) for row in rows)
        case Marked(inner):
            return width(inner)
        case Bracket():
            return 0.5


def _opened(piece: Piece, room: float) -> list[Piece]:
    """Break a piece inside its widest bracket when it is too long for a narrow page.

    One without a bracket is broken before a dot between its factors.
    """
    if width(MathList(piece)) <= room:
        return [piece]
    fences = [item for item in piece if isinstance(item, Fence)]
    if not fences:
        at = next((n for n, item in enumerate(piece) if n and item == _DOT), 0)
        return [piece[:at], piece[at:]] if at else [piece]
    fence = max(fences, key=width)
    at = piece.index(fence)
    inner = pieces(fence.inner.items, room - width(MathList(piece[:at])))
    if len(inner) < 2:
        return [piece]
    is_high = _is_high(fence.inner)
    inner[0] = (*piece[:at], Bracket(fence.opening, is_high), *inner[0])
    *most, last = inner
    rest = piece[at + 1 :]
    last = (*last, Bracket(fence.closing, is_high))
    if _needs_own_line(rest):
        return [*most, last, *_opened(rest, room)]
    return [*most, (*last, *rest)]


def _is_end(piece: Sequence[Node]) -> bool:
    """Whether this is "= 0", which never stands alone on a line."""
    return len(piece) == 2 and is_break(piece[0]) and piece[1] == Atom("number", "0")


def _needs_own_line(rest: Sequence[Node]) -> bool:
    return width(MathList(tuple(rest))) > _LONG / 2


def _is_high(node: Node) -> bool:
    match node:
        case Fraction() | Matrix():
            return True
        case MathList(items):
            return any(_is_high(item) for item in items)
        case Fence(inner=inner) | Marked(inner=inner):
            return _is_high(inner)
        case _:
            return False
