"""The document's Markdown says what the wording says, and every form says the same."""

import re
from functools import cache
from typing import Any

import pytest
from markdown_it.token import Token
from rich.cells import cell_len
from rich.text import Text

from kugelpendel import paper
from kugelpendel.paper.document import html, terminal
from kugelpendel.paper.document.dialect import is_math, tokens, without_tables
from kugelpendel.paper.document.markdown import Writer
from kugelpendel.paper.document.prose import spans
from kugelpendel.paper.rendering import composed
from kugelpendel.paper.typeset.tex import Marked

LANGUAGES = ("de", "en")
FORMS = ("html", "md", "latex", "text")


@cache
def writer(language: str, target: str = "") -> Writer:
    return Writer(composed(language, target))


def texts(table: Any) -> list[str]:
    if isinstance(table, dict):
        return [text for value in table.values() for text in texts(value)]
    return [one for value in table for one in texts(value)] if isinstance(table, list) else [table]


def flat(read: list[Token]) -> str:
    """The words and the LaTeX, without what Markdown adds."""
    inline = [child for token in read for child in token.children or []]
    assert "html_inline" not in {token.type for token in inline}
    return "".join(" " if token.type == "softbreak" else token.content for token in inline)


@pytest.mark.parametrize("language", LANGUAGES)
def test_sentences_come_through_markdown_unchanged(language: str) -> None:
    document, words = composed(language), paper.words(language)
    sentences = texts({key: value for key, value in words.tables.items() if key != "ui"})
    sentences += [words.printed(one) for one in paper.MISPRINTS]
    for sentence in sentences:
        meant = "".join(
            document.name(span.text) if span.kind == "link" else span.text
            for span in spans(sentence)
        )
        assert flat(tokens(writer(language).say(sentence))) == meant.strip()


@pytest.mark.parametrize(
    "words", ["a_b_c", "<b>a</b>", "[a](b)", "![a](b)", "a | b", "~~a~~", r"\a \* b", "&amp;"]
)
def test_no_sign_of_a_sentence_means_anything_to_markdown(words: str) -> None:
    written = writer("en").say(words)
    assert flat(tokens(written)) == words
    row = tokens(f"| a |\n| --- |\n| {written} |")
    assert [token.content for token in row if token.type == "td_open"] == [""]
    assert words in flat(row)


def test_math_is_read_whatever_stands_in_it() -> None:
    (_, inline, _) = tokens(r"so $`a_*b* \dot{x}^2`$, and `$`a`$`")
    kinds = [(child.type, child.content) for child in inline.children or []]
    assert ("math_inline", r"a_*b* \dot{x}^2") in kinds
    (_, inline, _) = tokens("no $`end")
    assert [child.type for child in inline.children or []] == ["text"]


def test_elements_become_tokens_with_their_attributes() -> None:
    read = tokens('<div class="line" id="a">\n\n**b**\n\n</div>')
    assert [token.type for token in read][::4] == ["div_open", "div_close"]
    assert read[0].attrs == {"class": "line", "id": "a"}
    (_, inline, _) = tokens('<a class="tag" href="#b">c</a> d')
    assert [child.type for child in inline.children or []] == [
        "link_open",
        "text",
        "link_close",
        "text",
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_tables_have_a_row_for_each_misprint_and_condition(language: str) -> None:
    read = tokens(writer(language).misprints())
    cells = [token for token in read if token.type == "td_open"]
    assert len(cells) == 4 * len(paper.MISPRINTS)
    listed = without_tables(read)
    items = [token for token in listed if token.type == "list_item_open"]
    assert len(items) == 5 * len(paper.MISPRINTS)
    assert "table_open" not in {token.type for token in listed}
    # a bar within a formula does not end its cell
    math = [child.content for token in read for child in token.children or []]
    assert r"|\omega - \omega_0| \ll \omega_0" in math


@pytest.mark.parametrize("language", LANGUAGES)
def test_how_one_knows_a_misprint_stands_in_the_table_or_in_a_note_that_always_shows(
    language: str,
) -> None:
    page = paper.write(language, "html")
    linked = re.findall(r'<td><a href="#misprint-([^"]+)">', page)
    assert 10 < len(linked) == len(set(linked)) < len(paper.MISPRINTS)
    for key in linked:
        before, _, _ = page.partition(f'<div id="misprint-{key}">')
        assert before.rpartition('class="display ')[2].startswith('numbered"')
        assert before.count("<details") == before.count("</details>")
    assert "#misprint-" not in writer(language).misprints()


def test_every_printed_formula_is_marked_against_the_right_one() -> None:
    read = [token for part in writer("de").parts() for token in tokens(part.text)]
    printed = [token for token in read if is_math(token) and "printed" in token.meta]
    wrong = [one for one in paper.FORMULAS if one.is_misprinted]
    assert len(printed) == len(wrong)
    assert sum("right" in token.meta for token in read) == len(wrong)
    marks = [repr(token.meta["printed"]).count(Marked.__name__) for token in printed]
    assert all(count + 1 for count in marks)
    assert sum(count > 0 for count in marks) > len(wrong) / 2


@pytest.mark.parametrize("target", ["", "25", "13a"])
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("form", FORMS)
def test_one_legend_says_what_the_paper_leaves_out(language: str, form: str, target: str) -> None:
    text = paper.write(language, form, target)
    legend = paper.words(language).ui("silent_legend").removeprefix("† ")
    assert text.count(legend) == 1
    silent = [one for one, _ in composed(language, target).conditions if one.silent]
    sign = r"\textdagger{}" if form == "latex" else "†"
    assert text.count(sign) > 2 * len(silent)


def test_the_legend_stands_where_the_sign_stands() -> None:
    displays = dict.fromkeys(one.display for one in paper.FORMULAS)
    signs = {label: writer("en", label) for label in displays}
    for one in signs.values():
        shown = "".join(part.text for part in one.parts() if part.key != "conditions")
        assert ("†" in one.head()) == ("†" in shown)
    assert any("†" not in one.head() for one in signs.values())


@pytest.mark.parametrize("width", [60, 80, 100])
@pytest.mark.parametrize("language", LANGUAGES)
def test_no_line_of_text_is_wider_than_asked(language: str, width: int) -> None:
    for text in (paper.write(language, "text", "", width), paper.misprint_list(language, width)):
        assert max(cell_len(line) for line in text.splitlines()) <= width


def test_colours_change_no_word(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    plain, coloured = (paper.write("en", "text", "12", 80, shown) for shown in (False, True))
    assert "\x1b[" in coloured
    assert "\x1b[" not in plain
    shown = Text.from_ansi(coloured).plain
    assert [line.rstrip() for line in shown.splitlines()] == plain.splitlines()
    monkeypatch.setenv("NO_COLOR", "1")
    red = re.compile(r"\x1b\[(?:\d+;)*31m")
    assert red.search(coloured)
    assert not red.search(paper.write("en", "text", "12", 80, coloured=True))


def test_code_that_is_no_formula_stays_code() -> None:
    assert html.rendered("```\na < b\n```") == "<pre><code>a &lt; b\n</code></pre>\n"
    assert terminal.text("# *a* b", 20) == "a b\n===\n"


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_anchor_of_the_latex_is_there(language: str) -> None:
    text = paper.write(language, "latex")
    anchors = re.findall(r"\\(?:hypertarget|heading)\{([^}]*)\}", text)
    linked = set(re.findall(r"\\hyperlink\{([^}]*)\}", text))
    assert linked <= set(anchors)
    assert len(linked) > 50
    assert len(set(anchors)) == len(anchors)
