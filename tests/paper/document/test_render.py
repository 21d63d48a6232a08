"""Every formula stands in every document, in both languages; a page needs nothing else."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest
from matplotlib import rc_context
from matplotlib.font_manager import FontProperties
from matplotlib.mathtext import MathTextParser

from kugelpendel import paper
from kugelpendel.paper.typeset import latex, mathml, unicode
from kugelpendel.paper.typeset.breaks import lines, pieces, width
from kugelpendel.paper.typeset.difference import difference
from kugelpendel.paper.typeset.tex import Atom, Marked, MathList, UnknownTeX, read

LANGUAGES = ("de", "en")
FORMS = ("html", "md", "latex", "text")
VOID = {"meta", "link", "br", "wbr", "input"}


@cache
def document(language: str, form: str, target: str = "") -> str:
    return paper.write(language, form, target)


def squeezed(text: str) -> str:
    """Without what breaks a formula over lines."""
    return re.sub(r"\s+|^> ?", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("form", FORMS)
def test_every_formula_stands_in_every_document(language: str, form: str) -> None:
    text = squeezed(document(language, form))
    writes = {
        "html": lambda tex: mathml.written(difference(tex, tex)[1]),
        "md": lambda tex: latex.display(tex, 70),
        "latex": lambda tex: latex.display(tex, 62),
        "text": lambda tex: "\n".join(unicode.broken(tex, 68)),
    }
    for formula in paper.FORMULAS:
        if form == "html" and formula.is_misprinted:
            printed, right = difference(formula.printed, formula.right)
            assert squeezed(mathml.written(printed)) in text, formula.label
            assert squeezed(mathml.written(right)) in text, formula.label
        else:
            assert squeezed(writes[form](formula.right)) in text, formula.label
            if formula.is_misprinted and form == "md":
                assert squeezed(writes[form](formula.printed)) in text, formula.label


@pytest.mark.parametrize("language", LANGUAGES)
def test_misprints_are_marked_in_place(language: str) -> None:
    page = document(language, "html")
    for misprint in paper.MISPRINTS:
        (before,) = [
            label
            for label, content in re.findall(
                r'data-label="([^"]*)">(.*?)(?=data-label=|</main>)', page, flags=re.DOTALL
            )
            if f'<div id="misprint-{misprint.key}">' in content
        ]
        assert before.partition(":")[0] == misprint.where.partition(":")[0]
    for formula in paper.FORMULAS:
        if formula.is_misprinted:
            _, right = difference(formula.printed, formula.right)
            assert 'class="differs"' in page
            assert _marks(right) or _marks(difference(formula.printed, formula.right)[0])


def _marks(row: MathList) -> int:
    return repr(row).count(Marked.__name__)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_reasons_and_counterexamples_are_given(language: str, form: str) -> None:
    text = squeezed(document(language, form))
    word = {"de": "Gegenbeispiel", "en": "counterexample"}[language]
    shown = {one.key for one in paper.MISPRINTS if paper.counterexample(one.key) is not None}
    # Each is told at its equation and in the table, which for some only leads to the equation.
    linked = set(re.findall(r'<td><a href="#misprint-([^"]+)">', document(language, "html")))
    assert text.count(word) >= len(shown) + len(shown - linked)


class _Balance(HTMLParser):
    """Checks that every element is closed where it should be, and collects ids and links."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.outside: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in VOID:
            self.open.append(tag)
        for name, value in attrs:
            if name == "id":
                self.ids.append(value or "")
            if name in ("href", "src", "xlink:href", "action", "srcset", "data"):
                (self.links if (value or "").startswith("#") else self.outside).append(value or "")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag, f"</{tag}> closes another element"


@pytest.mark.parametrize("target", ["", "25", "5a", "10.7"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_page_is_well_formed_and_needs_nothing_else(language: str, target: str) -> None:
    page = document(language, "html", target)
    reader = _Balance()
    reader.feed(page)
    reader.close()
    assert reader.open == []
    assert len(set(reader.ids)) == len(reader.ids)
    assert {link.removeprefix("#") for link in reader.links} <= set(reader.ids)
    assert reader.outside == ["data:,"]
    without_names = page.replace("http://www.w3.org/1998/Math/MathML", "")
    assert not re.search(r"https?://|url\(|@import|fetch\(", without_names)
    assert f'<html lang="{language}">' in page


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_number_and_its_unit_stand_on_one_line(language: str) -> None:
    page = document(language, "html")
    sentences = re.sub(r"<(svg|script|style|math).*?</\1>", "", page, flags=re.DOTALL)
    assert len(re.findall(r"\d\N{NO-BREAK SPACE}(?:cm|m|%|°)", sentences)) > 20
    assert re.findall(r"\d (?:mm|cm|m|s|min|h|kg|g|N|%|°)(?!\w).{9}", sentences) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_mathml_is_well_formed(language: str) -> None:
    formulas = re.findall(r"<math.*?</math>", document(language, "html"), flags=re.DOTALL)
    assert len(formulas) > 500
    counts = {"mfrac": 2, "msup": 2, "msub": 2, "msubsup": 3, "mover": 2}
    for formula in formulas:
        for element in ElementTree.fromstring(formula).iter():
            if element.tag in counts:
                assert len(element) == counts[element.tag], formula


def test_formulas_are_written_as_they_were_read() -> None:
    for formula in paper.FORMULAS:
        for text in (formula.printed, formula.right):
            assert read(latex.display(text, 1e9)) == read(text), formula.label


def test_what_is_not_known_is_refused() -> None:
    unknown = (r"\frac{a}{b", r"a}", r"\unknown{a}", r"(a", r"\begin{cases}a\end{cases}")
    ambiguous = ("a^12", r"\frac12", r"\sqrt12", "a^2^3", "a_1_2")
    for text in (*unknown, *ambiguous):
        with pytest.raises(UnknownTeX):
            read(text)


def test_plain_formulas() -> None:
    assert unicode.plain(r"\Omega = \frac{3}{8} \omega_0 \frac{ab}{l^2}") == "Ω = 3/8 ω₀ ab/l²"
    assert unicode.plain(r"\ddot{\theta} - \dot{\phi}^2 \sin \theta") == "θ̈ − φ̇² sin θ"
    assert unicode.plain(r"\frac{1}{8l^2} \frac{d}{dt} \dot{x}") == "1/(8l²) d/dt ẋ"
    assert unicode.plain(r"-\sqrt{1 - \frac{\rho^2}{l^2}}") == "−√(1 − ρ²/l²)"


def test_an_exponent_stands_beside_a_dot_marked_or_not() -> None:
    printed, _ = difference(r"\dot{\theta}^2", r"\dot{\phi}^2")
    for formula in (mathml.written(printed), mathml.display(r"\dot{\theta}^2")):
        assert formula.count("<mpadded") == formula.count("<msup>") == 1


def test_a_bracket_within_a_bracket_is_opened_on_a_narrow_page() -> None:
    row = read(r"\frac{a}{b} [\frac{1}{a} \{aaaaaaaaa + bbbbbbbbb\}]")
    assert len(pieces(row.items)) == 2
    assert len(pieces(row.items, 99)) == 1
    assert all(width(MathList(line)) < 16 for line in lines(row.items, 16))


def test_a_wide_product_without_brackets_breaks_before_its_dot() -> None:
    row = read(r"\frac{aaaaaaaaaa}{b} \cdot \frac{c}{dddddddddd}")
    first, second = pieces(row.items, 16)
    assert second[0] == row.items[len(first)] == Atom("operator", "·")
    assert len(pieces(row.items, 99)) == 1


def test_differences_are_small() -> None:
    printed, right = difference(r"\frac{x}{l^2}(a + b)", r"\frac{x}{l^4}(a - b)")
    assert _marks(printed) == _marks(right) == 2
    same = difference("a = b", "a = b")
    assert _marks(same[0]) == _marks(same[1]) == 0


@pytest.mark.parametrize("language", LANGUAGES)
def test_latex_is_sound(language: str, tmp_path: Path) -> None:
    text = document(language, "latex")
    opened: list[str] = []
    for what, name in re.findall(r"\\(begin|end)\{(\w+\*?)\}", text):
        if what == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert opened == []
    plain = re.sub(r"\\[{}]", "", text)
    assert plain.count("{") == plain.count("}")
    # T1 has these; a Greek letter or a raised number would stop LaTeX
    assert {sign for sign in text if ord(sign) > 255} <= set("–—‘’‚“”„")
    (tmp_path / "derivation.tex").write_text(text, encoding="utf-8")
    program = shutil.which("pdflatex")
    if program is not None:  # a TeX installation is too large to ask for
        command = [program, "-interaction=nonstopmode", "-halt-on-error", "derivation.tex"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=100, check=False)
        assert done.returncode == 0, done.stdout.decode("latin-1")[-2000:]


PAGE, MARGIN = 455.2, 27.4  # pt: a line of A4 less 2.5 cm on either side, and that of a quotation


@cache
def set_width(source: str) -> float:
    """Width in pt as TeX sets it in Computer Modern at 11 pt, a little over where it is not known.

    matplotlib knows TeX's fonts and spaces, but neither boxes nor columns.
    """
    for column in re.findall(r"\\begin\{pmatrix\}(.*?)\\end\{pmatrix\}", source):
        widest = max(column.split(r"\\"), key=set_width)
        source = source.replace(
            rf"\begin{{pmatrix}}{column}\end{{pmatrix}}", rf"\quad ({widest}) \quad", 1
        )
    boxes = source.count(r"\boxed")
    plain = source.replace(r"\boxed", "").replace(r"\frac", r"\dfrac")
    plain = re.sub(r"\\(left|right|(big|Bigg)[lr])(?![a-z])", " ", plain)
    with rc_context({"mathtext.fontset": "cm"}):
        box = MathTextParser("path").parse(f"${plain}$", 72, FontProperties(size=10.95))
    brackets = source.count(r"\left") + source.count(r"\Bigg")  # wider, or with space around them
    return float(box[0]) + 6.8 * boxes + 4 * brackets


def unbreakable(formula: str) -> list[str]:
    """What TeX cannot break within a sentence: it ends a line after a sign outside of braces."""
    parts, depth = [""], 0
    for token in re.findall(r"\\[A-Za-z]+|\\.|.", formula):
        depth += (token == "{") - (token == "}")
        parts[-1] += token
        if depth == 0 and token in ("+", "-", "=", r"\cdot", r"\approx", r"\ll", r"\times"):
            parts.append("")
    return [part.strip() for part in parts if part.strip()]


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_line_of_latex_is_wider_than_the_page(language: str) -> None:
    text = document(language, "latex")
    shown = re.findall(r"\\begin\{equation\*\}\n(.*?)\n\\end\{equation\*\}", text, re.DOTALL)
    assert len(shown) > len(paper.FORMULAS)
    boxed = re.findall(r"\\begin\{misprint\}(.*?)\\end\{misprint\}", text, re.DOTALL)
    for formula in shown:
        room = PAGE - 2 * MARGIN if any(formula in one for one in boxed) else PAGE
        bare = re.sub(r"\\tag\{[^}]*\}|\\(begin|end)\{aligned\}|&|\{\}", "", formula)
        for line in bare.split("\\\\\n"):
            assert set_width(line.strip()) < room, line
    for formula in set(re.findall(r"(?<!\\)\$(\\?[A-Za-z(|=+\-][^$]*)\$", text)):
        for part in [formula] if "pmatrix" in formula else unbreakable(formula):
            assert set_width(part) < PAGE / 2, part


def test_markdown_opens_and_closes() -> None:
    text = document("en", "md")
    assert text.count("```") % 2 == 0
    for element in ("details", "div", "blockquote"):
        assert text.count(f"<{element} ") == text.count(f"</{element}>") > 20
    linked = set(re.findall(r"\]\(#([^)]+)\)", text))
    assert linked <= set(re.findall(r'<div [^>]*id="([^"]+)"', text))


@pytest.mark.parametrize("form", FORMS)
def test_one_equation_with_what_it_rests_on(form: str) -> None:
    text = document("en", form, "5b")
    assert "(5b)" in text
    assert "(25)" not in text
    whole = document("en", form)
    assert len(text) < len(whole)


def test_picture_has_every_equation_and_every_arrow() -> None:
    page = document("en", "html")
    pictures = re.findall(r'<svg class="graph".*?</svg>', page, flags=re.DOTALL)
    assert len(pictures) == 2
    displays = {formula.display for formula in paper.FORMULAS}
    numbered = {formula.display for formula in paper.FORMULAS if formula.number}
    for picture, shown in zip(pictures, (numbered, displays), strict=True):
        assert set(re.findall(r"<text [^>]*>([^<]*)</text>", picture)) == shown
    arrows = {
        (before.partition(":")[0], after.partition(":")[0]) for before, after in paper.edges()
    }
    arrows = {(before, after) for before, after in arrows if before != after}
    assert pictures[1].count("<path") >= len(arrows)
