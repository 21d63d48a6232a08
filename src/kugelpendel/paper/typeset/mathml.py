"""Formulas as MathML, in pieces between which a browser may break the line."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from kugelpendel.paper.typeset.breaks import pieces, width
from kugelpendel.paper.typeset.tex import (
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

_THIN = "<mtext>\u2009</mtext>"
_SHORT = 14
"""Signs that a line of text always has room for."""
_WIDE = 20
"""Signs in a piece above which a page may set it smaller, where it has little room."""
_HAIR = '<mspace width="0.1em"/>'
_ACCENTS = {"\u0307": "˙", "\u0308": "¨", "\u20d7": "→"}


def inline(source: str) -> str:
    """Write a formula within a sentence, in pieces as well, since a line may end in it."""
    row = read(source)
    if width(row) < _SHORT:
        return _math(row.items)
    return _pieces(row)


def display(source: str) -> str:
    """Write a formula on lines of its own: `math` elements, cut before + − = outside brackets.

    The page's style sets them as displays, with ``math-style: normal``.
    Brackets that hold more than a browser fits on a narrow page are opened: their content is broken
    as well, and they are drawn as high as they would have been.
    """
    return written(read(source))


def written(row: MathList) -> str:
    """Write a formula that has been read, and perhaps marked, in the same way."""
    return _pieces(row)


def _pieces(row: MathList) -> str:
    if not row.items:
        return ""
    first, *others = pieces(row.items)
    continued = (_math(piece, continues=True) for piece in others)
    return "<wbr>".join([_math(first), *continued])


def _math(items: Piece, continues: bool = False) -> str:
    style = ' class="wide"' if width(MathList(items)) > _WIDE else ""
    return f"<math{style}>{_row(items, continues)}</math>"


def _row(items: Piece, continues: bool = False) -> str:
    """Write a row; one that continues a formula keeps the space around its first sign.

    A sign is a prefix at the beginning of a row, and infix within it, unless it says otherwise.
    """
    written: list[str] = []
    before: Node | None = None
    for item in items:
        if before is not None and _wants_space(before, item):
            written.append(_THIN)
        elif before is not None and _beside_fraction(before, item):
            written.append(_HAIR)
        if _is_sign(item):
            infix = continues if before is None else not _is_operator(before)
            is_usual = infix is (before is not None) and item is not items[-1]
            form = "" if is_usual else f' form="{"infix" if infix else "prefix"}"'
            written.append(_sign(item, form))
        else:
            written.append(_node(item))
        before = item
    return "".join(written)


def _is_operator(node: Node) -> bool:
    if isinstance(node, Marked):
        return _is_operator(node.inner)
    if isinstance(node, Bracket):
        return node.sign in "([{"
    return isinstance(node, Atom) and node.kind == "operator" and node.text not in ",;.′"


def _is_sign(node: Node) -> bool:
    if isinstance(node, Marked):
        return _is_sign(node.inner)
    return isinstance(node, Atom) and node.kind == "operator" and node.text in "+−"


def _sign(node: Node, form: str) -> str:
    if isinstance(node, Marked):
        return f'<mrow class="differs">{_sign(node.inner, form)}</mrow>'
    assert isinstance(node, Atom)
    return f"<mo{form}>{node.text}</mo>"


def _wants_space(before: Node, item: Node) -> bool:
    """TeX's thin space around sin and cos."""
    if _is_function(item):
        if isinstance(before, Bracket):
            return before.sign in ")]}"
        return not (isinstance(before, Atom) and before.kind in ("operator", "space"))
    return _is_function(before) and not isinstance(item, Fence)


def _beside_fraction(before: Node, item: Node) -> bool:
    """TeX's space beside a fraction, without which two bars would touch."""
    fractions = isinstance(before, Fraction) + isinstance(item, Fraction)
    return fractions > 0 and not any(
        isinstance(node, Atom) and node.kind == "operator" for node in (before, item)
    )


def _is_function(node: Node) -> bool:
    if isinstance(node, Script):
        return _is_function(node.base)
    if isinstance(node, Marked):
        return _is_function(node.inner)
    return isinstance(node, Atom) and node.kind == "function"


def _node(node: Node) -> str:
    match node:
        case Atom():
            return _atom(node)
        case MathList(items):
            return f"<mrow>{_row(items)}</mrow>"
        case Fraction(above, below):
            return f"<mfrac>{_group(above)}{_group(below)}</mfrac>"
        case Root(inner):
            return f"<msqrt>{_node(inner)}</msqrt>"
        case Script():
            return _script(node)
        case Accent(base, mark):
            style = ' stretchy="false" mathsize="60%"' if mark == "\u20d7" else ""
            accent = f"<mo{style}>{_ACCENTS[mark]}</mo>"
            return f'<mover accent="true">{_group(base)}{accent}</mover>'
        case Fence(opening, closing, inner):
            # At the ends of a row of their own they are fences that stretch.
            left = f"<mo>{opening}</mo>" if opening else ""
            right = f"<mo>{closing}</mo>" if closing else ""
            return f"<mrow>{left}{_row(inner.items)}{right}</mrow>"
        case Matrix(rows):
            cells = "".join(
                f"<mtr>{''.join(f'<mtd>{_node(cell)}</mtd>' for cell in row)}</mtr>" for row in rows
            )
            return f"<mrow><mo>(</mo><mtable>{cells}</mtable><mo>)</mo></mrow>"
        case Marked(inner):
            return f'<mrow class="differs">{_node(inner)}</mrow>'
        case Bracket():
            return _bracket(node)


def _atom(atom: Atom) -> str:
    match atom.kind:
        case "identifier":
            upright = ' mathvariant="normal"' if atom.text in "∞…" or atom.text == "Ω" else ""
            return f"<mi{upright}>{escape(atom.text)}</mi>"
        case "number":
            return f"<mn>{atom.text}</mn>"
        case "function":
            return f"<mi>{atom.text}</mi><mo>\u2061</mo>"
        case "space":
            return f'<mspace width="{atom.text}em"/>'
        case "text":
            return f"<mtext>{escape(atom.text)}</mtext>"
        case _:
            return f"<mo>{escape(atom.text)}</mo>"


def _bracket(bracket: Bracket) -> str:
    height = ' minsize="2.4em" maxsize="2.4em"' if bracket.is_high else ' stretchy="false"'
    form = "prefix" if bracket.sign in "([{" else "postfix"
    return f'<mo fence="true" form="{form}"{height}>{bracket.sign}</mo>'


def _script(node: Script) -> str:
    base = _group(node.base)
    after = "<mo>\u2061</mo>" if _is_function(node.base) else ""
    if node.below is not None and node.above is not None:
        return f"<msubsup>{base}{_group(node.below)}{_group(node.above)}</msubsup>{after}"
    if node.below is not None:
        return f"<msub>{base}{_group(node.below)}</msub>{after}"
    assert node.above is not None
    if isinstance(node.base.inner if isinstance(node.base, Marked) else node.base, Accent):
        # Otherwise the exponent would be set above the dot.
        base = f'<mpadded height="0.62em">{base}</mpadded>'
    return f"<msup>{base}{_group(node.above)}</msup>{after}"


def _group(node: Node) -> str:
    """Exactly one element, as `mfrac` and its like count their children."""
    if isinstance(node, Atom):
        return f"<mi>{node.text}</mi>" if node.kind == "function" else _atom(node)
    if isinstance(node, MathList) and len(node.items) == 1 and not _is_sign_like(node.items[0]):
        return _group(node.items[0])
    is_several = isinstance(node, Script) and _is_function(node.base)
    return f"<mrow>{_node(node)}</mrow>" if is_several else _node(node)


def _is_sign_like(node: Node) -> bool:
    """Whether it is an operator, which alone in a group has no space around it."""
    return isinstance(node, Atom) and node.kind == "operator"
