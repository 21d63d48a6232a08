"""The derivation as a LaTeX document, from the tokens of its Markdown."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from kugelpendel.paper.document.dialect import has_class, is_math, tokens, without_tables
from kugelpendel.paper.document.markdown import Writer
from kugelpendel.paper.typeset import latex
from kugelpendel.paper.typeset.tex import IDENTIFIERS

if TYPE_CHECKING:
    from collections.abc import Iterable

    from markdown_it.token import Token

    from kugelpendel.paper.document.outline import Document

_ROOM = 62
"""Signs in a line of a formula."""

_ESCAPES = {
    "\\": "\\textbackslash{}", "&": "\\&", "%": "\\%", "$": "\\$", "#": "\\#", "_": "\\_",
    "{": "\\{", "}": "\\}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}", "×": "$\\times$",
    "…": "\\dots{}", "−": "$-$", "†": "\\textdagger{}",
}  # fmt: skip
_GREEK = {sign: f"$\\{name}$" for name, sign in IDENTIFIERS.items() if sign.isalpha()}
_DIGITS = {"₀": "$_0$", "²": "$^2$"}
_TRANSLATED = str.maketrans(_ESCAPES | _GREEK | _DIGITS)
_BABEL = {"de": "ngerman", "en": "english"}

_PREAMBLE = """\
\\documentclass[11pt,a4paper]{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\usepackage{lmodern,textcomp}
\\usepackage[%s]{babel}
\\usepackage[margin=2.5cm]{geometry}
\\usepackage{amsmath}
\\usepackage[hidelinks]{hyperref}
\\setlength{\\parindent}{0pt}
\\setlength{\\parskip}{0.5em plus 0.2em}
%% A line before a formula that cannot be broken may be loose, rather than too wide.
\\sloppy
\\allowdisplaybreaks
\\newenvironment{misprint}{\\begin{quote}\\small}{\\end{quote}}
\\newenvironment{steps}{\\begin{quote}\\footnotesize}{\\end{quote}}
\\newcommand{\\heading}[2]{\\section*{\\hypertarget{#1}{}#2}\\addcontentsline{toc}{section}{#2}}
\\title{%s}
\\author{}
\\date{}

\\begin{document}
\\maketitle
"""

_PAIRS = {
    "strong": ("\\textbf{", "}"),
    "em": ("\\emph{", "}"),
    "s": ("\\emph{", "}"),
    "paragraph": ("", "\n\n"),
    "bullet_list": ("\\begin{itemize}\n", "\\end{itemize}\n\n"),
    "list_item": ("\\item ", ""),
    "blockquote": ("\\begin{misprint}\n", "\\end{misprint}\n\n"),
}
"""What stands before and after an element."""


def write(document: Document) -> str:
    """Write the whole document."""
    writer = Writer(document)
    contents = "" if document.target else "\\tableofcontents\n\n"
    parts = "".join(
        f"\\heading{{{part.key}}}{{{escape(part.title)}}}\n\n{_Latex().rendered(part.text)}"
        for part in writer.parts()
    )
    title = _PREAMBLE % (_BABEL[document.words.language], escape(document.title()))
    return f"{title}\n{_Latex().rendered(writer.head())}{contents}{parts}\\end{{document}}\n"


def escape(text: str) -> str:
    """Make harmless what LaTeX would take for commands."""
    return text.translate(_TRANSLATED)


def _target(name: str) -> str:
    return f"\\hypertarget{{{name}}}{{}}"


class _Latex:
    """Goes through tokens and writes them, with the number of an equation at its first formula."""

    def __init__(self) -> None:
        self._tag = ""
        self._is_skipped = False
        self._closings: list[str] = []

    def rendered(self, markdown: str) -> str:
        written = self._written(without_tables(tokens(markdown)))
        without_gap = re.sub(r"^(\\hypertarget\{[^}]*\}\{\}) +", r"\1", written, flags=re.MULTILINE)
        return re.sub(r"\n{3,}", "\n\n", without_gap)

    def _written(self, read: Iterable[Token]) -> str:
        return "".join(self._token(token) for token in read)

    def _token(self, token: Token) -> str:
        """Write one; what begins an element notes what will end it."""
        if token.type in ("summary_close", "link_close") and self._is_skipped:
            self._is_skipped = False
            return self._closings.pop()
        if self._is_skipped:
            return ""
        if token.nesting > 0:
            opening, closing = self._element(token)
            self._closings.append(closing)
            return opening
        if token.nesting < 0:
            return self._closings.pop()
        match token.type:
            case "inline":
                return self._written(token.children or [])
            case "math_inline":
                return f"${latex.inline(token.content)}$"
            case "code_inline":
                return f"\\texttt{{{escape(token.content).replace('--', '-{}-')}}}"
            case "softbreak":
                return "\n"
            case "hardbreak":
                return "\\\\\n"
            case "fence" if is_math(token):
                return self._formula(token)
            case _:
                return escape(token.content)

    def _element(self, token: Token) -> tuple[str, str]:
        name = token.type.removesuffix("_open")
        if name in _PAIRS:
            return _PAIRS[name]
        if name == "summary" or has_class(token, "tag"):
            self._is_skipped = True
        elif name == "link":
            return f"\\hyperlink{{{str(token.attrGet('href')).removeprefix('#')}}}{{", "}"
        elif name == "details" and has_class(token, "step"):
            return "\\begin{steps}\n", "\\end{steps}\n\n"
        elif token.attrGet("id"):
            identity = str(token.attrGet("id"))
            if has_class(token, "display"):
                self._tag = identity.removeprefix("eq-")
            return _target(identity), ""
        return "", ""

    def _formula(self, token: Token) -> str:
        if "printed" in token.meta:
            # narrower, since it is set within a quotation
            return _equation(latex.written(token.meta["printed"], _ROOM - 10))
        tag, self._tag = f" \\tag{{{self._tag}}}" if self._tag else "", ""
        return _equation(latex.display(token.content, _ROOM) + tag)


def _equation(source: str) -> str:
    return f"\\begin{{equation*}}\n{source}\n\\end{{equation*}}\n\n"
