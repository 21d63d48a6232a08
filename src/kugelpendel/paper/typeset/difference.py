"""What differs between a formula as printed and as it should be, marked in both."""

from __future__ import annotations

from dataclasses import fields
from difflib import SequenceMatcher
from typing import TYPE_CHECKING, cast

from kugelpendel.paper.typeset.tex import (
    Fence,
    Fraction,
    Marked,
    MathList,
    Matrix,
    Root,
    Script,
    read,
)

if TYPE_CHECKING:
    from kugelpendel.paper.typeset.tex import Node

_CONTAINERS = (MathList, Fraction, Root, Script, Fence)


def difference(printed: str, right: str) -> tuple[MathList, MathList]:
    """Read two versions of a formula and mark the smallest parts in which they differ."""
    return _rows(read(printed), read(right))


def _rows(old: MathList, new: MathList) -> tuple[MathList, MathList]:
    left: list[Node] = []
    right: list[Node] = []
    matcher = SequenceMatcher(a=old.items, b=new.items, autojunk=False)
    for what, a, b, c, d in matcher.get_opcodes():
        before, after = old.items[a:b], new.items[c:d]
        if what == "equal":
            left.extend(before)
            right.extend(after)
        elif len(before) == len(after):
            for one, other in zip(before, after, strict=True):
                first, second = _nodes(one, other)
                left.append(first)
                right.append(second)
        else:
            left.extend(Marked(item) for item in before)
            right.extend(Marked(item) for item in after)
    return MathList(tuple(left)), MathList(tuple(right))


def _nodes(old: Node, new: Node) -> tuple[Node, Node]:
    if old == new:
        return old, new
    if isinstance(old, MathList) and isinstance(new, MathList):
        return _rows(old, new)
    if isinstance(old, Matrix) and isinstance(new, Matrix):
        return _matrices(old, new)
    if type(old) is not type(new) or not isinstance(old, _CONTAINERS):
        return Marked(old), Marked(new)
    parts: dict[str, tuple[object, object]] = {}
    for field in fields(old):
        one, other = getattr(old, field.name), getattr(new, field.name)
        if one == other:
            parts[field.name] = (one, other)
        elif one is None or other is None or isinstance(one, str):
            return Marked(old), Marked(new)
        else:
            parts[field.name] = _nodes(cast("Node", one), cast("Node", other))
    kind = type(old)
    first = kind(**{name: pair[0] for name, pair in parts.items()})  # type: ignore[arg-type]
    second = kind(**{name: pair[1] for name, pair in parts.items()})  # type: ignore[arg-type]
    return first, second


def _matrices(old: Matrix, new: Matrix) -> tuple[Node, Node]:
    if [len(row) for row in old.rows] != [len(row) for row in new.rows]:
        return Marked(old), Marked(new)
    pairs = [
        [_nodes(one, other) for one, other in zip(before, after, strict=True)]
        for before, after in zip(old.rows, new.rows, strict=True)
    ]
    left = tuple(tuple(pair[0] for pair in row) for row in pairs)
    right = tuple(tuple(pair[1] for pair in row) for row in pairs)
    return Matrix(left), Matrix(right)
