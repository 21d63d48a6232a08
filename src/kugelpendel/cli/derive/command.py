"""``kugelpendel derive``: the derivation as a document, its proofs, its misprints."""

from __future__ import annotations

import shutil
import sys
from datetime import date
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput, paper
from kugelpendel.cli.derive import as_json
from kugelpendel.cli.output import one_file
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_bytes, write_json

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from kugelpendel.errors import Language

FORMATS = {"html": ".html", "md": ".md", "latex": ".tex", "text": ".txt"}
_STDOUT = Path("-")
_WIDEST = 100  # signs; longer lines are hard to read


def derive(
    equation: str | None, language: str | None, document_format: str | None, out: Path | None
) -> None:
    """Write the derivation, or what leads to one equation.

    Parameters
    ----------
    equation
        A label, such as "25" or "(10.7)"; None writes the whole derivation.
    language
        "de" or "en"; None takes that of the locale.
    document_format
        One of `FORMATS`; None takes that of the file's name, and text without a file.
    out
        The file; ``-`` writes the bytes of one, in UTF-8, to standard output; None writes to the
        terminal, and HTML to ``derivation.LANGUAGE.html``.

    Raises
    ------
    InvalidInput
        An equation, a language or a format that is not known, or a file that cannot be written.
    """
    target = known_label(equation) if equation is not None else ""
    chosen = known_language(language)
    kind = _known_format(document_format, out)
    if kind == "html":
        write_page(target, chosen, out)
        return
    is_coloured = out is None and sys.stdout.isatty()
    text = paper.write(chosen, kind, target, text_width(), is_coloured)
    if out is None:
        sys.stdout.write(text)
    else:
        _put(lambda _: text, chosen, out)


def handout(language: str | None, out: Path | None) -> None:
    """Write the handout, to ``handout.LANGUAGE.html`` unless a file is given.

    Raises
    ------
    InvalidInput
        A language that is not known, or a file that cannot be written.
    """
    chosen = known_language(language)
    _put(paper.handout, chosen, out or Path(f"handout.{chosen}.html"))


def write_page(
    target: str, language: Language, out: Path | None, rows: Sequence[paper.Row] | None = None
) -> None:
    """Prove what a page shows, and write the page.

    Parameters
    ----------
    target
        The label that the page leads to, "" for the whole derivation.
    language
        "de" or "en".
    out
        The file; None writes to ``derivation.LANGUAGE.html``, with the target in the name where
        there is one.
    rows
        What a check found for each formula; None where none has been made.
    """
    name = f"derivation-{target.replace(':', '-')}" if target else "derivation"

    def written(chosen: Language) -> str:
        found = _proved(target, chosen) if rows is None else [one.evidence for one in rows]
        when = f"{date.today().isoformat()}, kugelpendel {version('kugelpendel')}"
        proofs = paper.Proofs(
            {one.label: one for one in found if one is not None},
            {row.label: row for row in rows or () if row.evidence is not None},
            when,
        )
        return paper.write(chosen, "html", target, proofs=proofs)

    _put(written, language, out or Path(f"{name}.{language}.html"))


def _proved(target: str, language: Language) -> list[paper.Evidence]:
    """Prove every formula that a page shows, under a bar that tells how long it takes."""
    labels = paper.leading_to(target)
    title = paper.words(language).ui("check_proving")
    with Progress(title, len(labels), language=language) as progress:
        return paper.proved(labels, lambda done, total, one: progress.advance(1))


def _put(written: Callable[[Language], str], language: Language, out: Path) -> None:
    """Write a page, once it is certain that the file can be written, and say where it is."""
    if out == _STDOUT:
        write_bytes(written(language).encode())
        return
    with one_file(out) as temporary:
        temporary.write_text(written(language), encoding="utf-8", newline="\n")
    print(_WRITTEN[language].format(out))


def list_misprints(language: str | None, is_json: bool) -> None:
    """Print the misprints, as text or as JSON."""
    chosen = known_language(language)
    if is_json:
        write_json(as_json.misprints(chosen))
    else:
        sys.stdout.write(paper.misprint_list(chosen, text_width(), sys.stdout.isatty()))


def _known_format(document_format: str | None, out: Path | None) -> str:
    if document_format is None:
        if out is None or out == _STDOUT:
            return "text"
        by_suffix = {suffix: name for name, suffix in FORMATS.items()}
        if out.suffix not in by_suffix:
            endings = ", ".join(by_suffix)
            raise InvalidInput.of("derive_format_untold", file=str(out), endings=endings)
        return by_suffix[out.suffix]
    if document_format not in FORMATS:
        known = ", ".join(FORMATS)
        raise InvalidInput.of("derive_format", seen=repr(document_format), known=known)
    return document_format


def known_label(equation: str) -> str:
    """Find the label that a user means; brackets around it may stay."""
    label = equation.strip().removeprefix("(").removesuffix(")")
    label = label[:1].upper() + label[1:]  # chapters of our own begin with a letter
    labels = [formula.label for formula in paper.FORMULAS]
    displays = list(dict.fromkeys(formula.display for formula in paper.FORMULAS))
    if label in labels or label in displays:
        return label
    near = ", ".join(f"({name})" for name in nearest(label, displays))
    raise InvalidInput.of("derive_equation", seen=repr(equation), near=near)


def nearest(label: str, displays: list[str]) -> list[str]:
    """Find the displays that may have been meant, in the paper's order."""
    stem = label.partition(":")[0]
    wanted = _number(label)
    near = sorted(
        displays,
        key=lambda name: (
            _chapter(name) != _chapter(label),
            not (_number(name) == wanted and stem.startswith(name)),
            abs(_number(name) - wanted),
            "." in name,
        ),
    )
    chosen = set(near[:4])
    return [name for name in displays if name in chosen]


def _chapter(label: str) -> str:
    """Give the letter that a formula of our own begins with, "" for one of the paper."""
    return label[:1] if label[:1].isalpha() else ""


def _number(label: str) -> int:
    """Read the number that a label begins with; 1 where it has none."""
    digits = "".join(sign if sign.isascii() and sign.isdigit() else " " for sign in label).split()
    return int(digits[0]) if digits else 1


def text_width() -> int:
    """Give the number of signs in a line: the terminal's, unless that is too wide to read."""
    return min(shutil.get_terminal_size().columns, _WIDEST)


_WRITTEN = {"de": "Geschrieben: {}", "en": "Written: {}"}
