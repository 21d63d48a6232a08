"""``kugelpendel derive``: the derivation as a document, its proofs, its misprints."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput, paper
from kugelpendel.cli.derive import as_json
from kugelpendel.cli.output import write_file
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.cli.terminal.streams import write_bytes, write_json

if TYPE_CHECKING:
    pass

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
    if out is None and kind == "html":
        name = f"derivation-{target.replace(':', '-')}" if target else "derivation"
        out = Path(f"{name}.{chosen}.html")
    is_coloured = out is None and sys.stdout.isatty()
    text = paper.write(chosen, kind, target, text_width(), is_coloured)
    if out is None:
        sys.stdout.write(text)
    elif out == _STDOUT:
        write_bytes(text.encode())
    else:
        write_file(out, text)
        print(_WRITTEN[chosen].format(out))


def refuse_mixture(
    is_check: bool,
    is_list: bool,
    is_json: bool,
    equation: str | None,
    document_format: str | None,
    out: Path | None,
) -> None:
    """Refuse options that say nothing together."""
    if is_check and is_list:
        raise InvalidInput("--check and --misprints are two commands; give one of them.")
    if is_json and not (is_check or is_list):
        raise InvalidInput(
            "--json prints what --check or --misprints finds; add one of them, or choose the form "
            "of the derivation by --format."
        )
    option = "--check" if is_check else "--misprints"
    others: dict[str, object] = {"--format": document_format, "--out": out}
    if is_list:
        others["the equation"] = equation
    given = [name for name, value in others.items() if value is not None]
    if (is_check or is_list) and given:
        raise InvalidInput(
            f"{option} prints one list to the terminal; leave out {' and '.join(given)}."
        )


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
            raise InvalidInput(
                f"The name {out} does not tell the format; end it in "
                f"{', '.join(by_suffix)}, or say --format."
            )
        return by_suffix[out.suffix]
    if document_format not in FORMATS:
        raise InvalidInput(
            f"The format {document_format!r} is not known; choose one of {', '.join(FORMATS)}."
        )
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
    raise InvalidInput(f"The derivation has no equation {equation!r}; near it are {near}.")


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
