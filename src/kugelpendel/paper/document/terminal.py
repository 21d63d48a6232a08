"""The derivation as text for a terminal: the Markdown through rich, with formulas in Unicode."""

from __future__ import annotations

import math
from io import StringIO
from typing import TYPE_CHECKING, ClassVar

from markdown_it.token import Token
from rich.console import Console
from rich.containers import Renderables
from rich.markdown import BlockQuote, Heading, Markdown, MarkdownElement
from rich.padding import Padding
from rich.text import Text

from kugelpendel.paper.document import markdown
from kugelpendel.paper.document.dialect import has_class, tokens, without_tables
from kugelpendel.paper.typeset import unicode

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from rich.console import ConsoleOptions, RenderResult
    from rich.markdown import MarkdownContext
    from rich.text import TextType

    from kugelpendel.paper.document.outline import Document


def write(document: Document, width: int = 80, coloured: bool = False) -> str:
    """Write the whole text.

    Parameters
    ----------
    document
        What to write.
    width
        The number of signs in a line.
    coloured
        Whether the text is for a terminal that shows colours, unless its environment forbids them.
    """
    return text(markdown.write(document, math.inf), width, coloured)


def text(source: str, width: int = 80, coloured: bool = False) -> str:
    """Write a piece of the document's Markdown as text."""
    out = StringIO()
    console = Console(
        file=out, width=width, force_terminal=coloured, highlight=False, legacy_windows=False
    )
    console.print(_Text(source))
    return "".join(f"{line.rstrip()}\n" for line in out.getvalue().splitlines())


class _Title(Heading):
    """A title with a line below it, at the left edge."""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        yield self.text
        rule = "=" if self.tag == "h1" else "-"
        yield Text(rule * min(self.text.cell_len, options.max_width), style=self.style_name)


class _Formula(MarkdownElement):
    """A formula on lines of its own."""

    _latex = ""

    def on_text(self, context: MarkdownContext, text: TextType) -> None:
        self._latex += str(text)

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        first, *others = unicode.broken(self._latex, options.max_width - 12)
        yield Padding(Text(first, style="bold"), (0, 0, 0, 6))
        for line in others:
            yield Padding(Text(line, style="bold"), (0, 0, 0, 10))


class _Group(MarkdownElement):
    """Things that stand together, without empty lines between them."""

    _indent, _style = 0, "none"

    def __init__(self) -> None:
        self._inner = Renderables()

    def on_child_close(self, context: MarkdownContext, child: MarkdownElement) -> bool:
        self._inner.append(child)
        return False

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        yield Padding(self._inner, (0, 0, 0, self._indent), style=self._style)


class _Step(_Group):
    """How a formula follows."""

    _indent, _style = 4, "dim"


class _Misprint(BlockQuote):
    """What is wrong in print, behind a bar."""

    style_name = "red"


class _Text(Markdown):
    """rich's Markdown, with what the document's Markdown has beyond it."""

    elements: ClassVar[dict[str, type[MarkdownElement]]] = {
        **Markdown.elements,
        "heading_open": _Title,
        "fence": _Formula,
        "blockquote_open": _Misprint,
        "line_open": _Group,
        "step_open": _Step,
    }

    def __init__(self, source: str) -> None:
        super().__init__("")
        self.parsed = list(_readable(without_tables(tokens(source))))


def _readable(read: Iterable[Token]) -> Iterator[Token]:
    """Leave out what only a page has (links, anchors, summaries), and write formulas as words."""
    kept: list[str] = []
    is_summary = False
    for token in read:
        if token.tag == "summary":
            is_summary = token.nesting > 0
        elif is_summary or token.type in ("link_open", "link_close"):
            pass
        elif token.tag in ("div", "details"):
            if token.nesting > 0:
                kept.append(next((one for one in ("line", "step") if has_class(token, one)), ""))
            name = kept[-1] if token.nesting > 0 else kept.pop()
            if name:
                kind = f"{name}_open" if token.nesting > 0 else f"{name}_close"
                yield Token(kind, token.tag, token.nesting, block=True)
        elif token.type == "math_inline":
            yield Token("text", "", 0, content=unicode.plain(token.content))
        elif token.children:
            yield from _readable(token.children)
        else:
            yield token
