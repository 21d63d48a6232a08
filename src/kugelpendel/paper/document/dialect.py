"""The Markdown that the derivation is written in, read into markdown-it's tokens.

It is CommonMark with tables and strikethrough, with formulas as GitHub writes them (a dollar and a
backtick on either side, or a fenced block of ``math``), and with HTML elements for what Markdown
has no word for: an equation with its anchor, a box, a fold. Every kind of document is made from
these tokens, so the elements become tokens as well instead of staying strings of HTML.
"""

from __future__ import annotations

from functools import cache
from html.parser import HTMLParser
from typing import TYPE_CHECKING

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token

from kugelpendel.paper.typeset.difference import difference

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from markdown_it.rules_core import StateCore
    from markdown_it.rules_inline import StateInline

BREAK = "<br>"
"""Parts the two things that share one cell of a table."""


def tokens(markdown: str) -> list[Token]:
    """Read Markdown; a formula that is printed wrongly has what differs marked in its ``meta``."""
    return parser().parse(markdown)


def is_math(token: Token) -> bool:
    """Tell whether a token is a formula on lines of its own."""
    return token.type == "fence" and token.info == "math"


def has_class(token: Token, name: str) -> bool:
    """Tell whether a token is an element of that class."""
    return name in str(token.attrGet("class") or "").split()


def without_tables(read: Sequence[Token]) -> list[Token]:
    """Turn tables into lists, for what has no room for columns of formulas.

    A row becomes a paragraph of its first cell and a list of the others, each after the name of its
    column. What one column holds two of, parted by `BREAK`, are two entries.
    """
    found: list[Token] = []
    heads: list[list[Token]] = []
    row: list[list[Token]] = []
    is_table = False
    for before, token in zip([None, *read], read, strict=False):
        if token.type == "table_open":
            is_table, heads, row = True, [], []
        elif token.type == "table_close":
            is_table = False
        elif not is_table:
            found.append(token)
        elif token.type == "inline" and before is not None:
            (heads if before.type == "th_open" else row).extend(_parted(token.children or []))
        elif token.type == "tr_close" and row:
            found.extend(_entry(heads, row))
            row = []
    return found


def _entry(heads: Sequence[list[Token]], cells: Sequence[list[Token]]) -> list[Token]:
    first, *others = cells
    found = [*_paragraph(first), Token("bullet_list_open", "ul", 1, block=True)]
    for head, cell in zip(heads[1:], others, strict=True):
        named = [*head, Token("text", "", 0, content=": "), *cell]
        found.append(Token("list_item_open", "li", 1, block=True))
        found.extend(_paragraph(named))
        found.append(Token("list_item_close", "li", -1, block=True))
    return [*found, Token("bullet_list_close", "ul", -1, block=True)]


def _paragraph(inline: list[Token]) -> list[Token]:
    return [
        Token("paragraph_open", "p", 1, block=True),
        Token("inline", "", 0, children=inline, block=True),
        Token("paragraph_close", "p", -1, block=True),
    ]


def _parted(inline: Iterable[Token]) -> list[list[Token]]:
    parts: list[list[Token]] = [[]]
    for token in inline:
        if token.type == "html_inline" and token.content == BREAK:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


@cache
def parser(renderer: type[RendererHTML] = RendererHTML) -> MarkdownIt:
    """Give the parser, with a class that renders its tokens."""
    made = MarkdownIt("commonmark", {"xhtmlOut": False}, renderer_cls=renderer)
    made.enable(["table", "strikethrough"])
    made.inline.ruler.before("backticks", "math", _math)
    made.core.ruler.push("elements", _elements)
    made.core.ruler.push("differences", _differences)
    return made


def _math(state: StateInline, silent: bool) -> bool:
    """Read a dollar, a backtick, LaTeX, a backtick, a dollar; no sign between means anything."""
    start = state.pos + 2
    if not state.src.startswith("$`", state.pos):
        return False
    end = state.src.find("`$", start)
    if end < 0:
        return False
    if not silent:
        state.push("math_inline", "math", 0).content = state.src[start:end]
    state.pos = end + 2
    return True


def _elements(state: StateCore) -> None:
    """Turn blocks of HTML into tokens, and links that are written in HTML as well."""
    found: list[Token] = []
    for token in state.tokens:
        if token.type == "html_block":
            found.extend(_Elements(token.content).found)
            continue
        if token.children:
            token.children = [made for child in token.children for made in _link(child)]
        found.append(token)
    state.tokens = found


def _link(token: Token) -> list[Token]:
    if token.type != "html_inline" or not token.content.startswith(("<a ", "</a>")):
        return [token]
    (made,) = _Elements(token.content).found
    made.type = made.type.replace("a_", "link_")
    made.block = False
    return [made]


class _Elements(HTMLParser):
    """The tags and the words of a piece of HTML, as tokens."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: list[Token] = []
        self.feed(html.strip())
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element's beginning with its attributes."""
        given: dict[str, str | int | float] = {name: value or "" for name, value in attrs}
        self.found.append(Token(f"{tag}_open", tag, 1, attrs=given, block=tag != "span"))

    def handle_endtag(self, tag: str) -> None:
        """Note an element's end."""
        self.found.append(Token(f"{tag}_close", tag, -1, block=tag != "span"))

    def handle_data(self, data: str) -> None:
        """Note words; the ends of lines between elements are none."""
        if data.strip():
            self.found.append(Token("text", "", 0, content=data.strip("\n")))


def _differences(state: StateCore) -> None:
    """Mark in the formula of a line, and in the printed one below it, where the two differ."""
    right: Token | None = None
    for token in state.tokens:
        if token.type == "div_open" and has_class(token, "line"):
            right = None
        elif is_math(token) and right is None:
            right = token
        elif is_math(token) and right is not None:
            token.meta["printed"], right.meta["right"] = difference(token.content, right.content)
