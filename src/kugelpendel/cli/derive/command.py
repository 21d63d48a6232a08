"""``kugelpendel derive``: the derivation as a document, its proofs, its misprints."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput, paper
from kugelpendel.cli.output import write_file
from kugelpendel.paper import LANGUAGES

if TYPE_CHECKING:
    from collections.abc import Mapping

FORMATS = {"html": ".html", "md": ".md", "latex": ".tex", "text": ".txt"}
_WIDEST = 100  # signs; longer lines are hard to read


def derive(
    equation: str | None, language: str | None, document_format: str | None, out: Path | None
) -> None:
    """Write the derivation, or what leads to one equation.

    Parameters
    ----------
    equation : str or None
        A label, such as "25" or "(10.7)"; the whole derivation unless given.
    language : str or None
        "de" or "en"; that of the locale unless given.
    document_format : str or None
        One of `FORMATS`; unless given that of the file's name, and text without a file.
    out : Path or None
        The file; the terminal unless given, and ``derivation.LANGUAGE.html`` for HTML.

    Raises
    ------
    InvalidInput
        An equation, a language or a format that is not known, or a file that cannot be written.
    """
    target = known_label(equation) if equation is not None else ""
    chosen = known_language(language)
    kind = _known_format(document_format, out)
    width = min(shutil.get_terminal_size().columns, _WIDEST)
    text = paper.write(chosen, kind, target, width)
    if out is None and kind == "html":
        name = f"derivation-{target.replace(':', '-')}" if target else "derivation"
        out = Path(f"{name}.{chosen}.html")
    if out is not None:
        write_file(out, text)
        print(_WRITTEN[chosen].format(out))
    elif kind == "text" and sys.stdout.isatty():
        _print_coloured(text)
    else:
        sys.stdout.write(text)


def refuse_mixture(
    is_check: bool,
    is_list: bool,
    equation: str | None,
    document_format: str | None,
    out: Path | None,
) -> None:
    """Refuse options that say nothing together."""
    if is_check and is_list:
        raise InvalidInput("--check and --misprints are two commands; give one of them.")
    option = "--check" if is_check else "--misprints"
    others: dict[str, object] = {"--format": document_format, "--out": out}
    if is_list:
        others["the equation"] = equation
    given = [name for name, value in others.items() if value is not None]
    if (is_check or is_list) and given:
        raise InvalidInput(
            f"{option} prints one list to the terminal; leave out {' and '.join(given)}."
        )


def list_misprints(language: str | None) -> None:
    """Print the misprints."""
    width = min(shutil.get_terminal_size().columns, _WIDEST)
    sys.stdout.write(paper.misprint_list(known_language(language), width))


def known_language(language: str | None, environment: Mapping[str, str] = os.environ) -> str:
    """The language to write in: the one given, or that of the locale, or English."""
    if language is None:
        variables = ("LC_ALL", "LC_MESSAGES", "LANG")
        locale = next((environment[name] for name in variables if environment.get(name)), "")
        return "de" if locale.lower().startswith("de") else "en"
    if language not in LANGUAGES:
        raise InvalidInput(
            f"The derivation is not written in the language {language!r}; choose "
            f"{' or '.join(f'--lang {known}' for known in LANGUAGES)}."
        )
    return language


def _known_format(document_format: str | None, out: Path | None) -> str:
    if document_format is None:
        if out is None:
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
    """The label that a user means; brackets around it may stay."""
    label = equation.strip().removeprefix("(").removesuffix(")")
    labels = [formula.label for formula in paper.FORMULAS]
    displays = list(dict.fromkeys(formula.display for formula in paper.FORMULAS))
    if label in labels or label in displays:
        return label
    near = ", ".join(f"({name})" for name in nearest(label, displays))
    raise InvalidInput(f"The derivation has no equation {equation!r}; near it are {near}.")


def nearest(label: str, displays: list[str]) -> list[str]:
    """The displays that may have been meant, in the paper's order."""
    stem = label.partition(":")[0]
    wanted = _number(label)
    near = sorted(
        displays,
        key=lambda name: (
            not (_number(name) == wanted and stem.startswith(name)),
            abs(_number(name) - wanted),
            "." in name,
        ),
    )
    chosen = set(near[:4])
    return [name for name in displays if name in chosen]


def _number(label: str) -> int:
    """The number that a label begins with; 1 when it has none."""
    digits = "".join(sign if sign.isascii() and sign.isdigit() else " " for sign in label).split()
    return int(digits[0]) if digits else 1


def _print_coloured(text: str) -> None:
    from rich.console import Console
    from rich.text import Text

    console = Console(highlight=False, soft_wrap=True)
    for line in text.splitlines():
        style = ""
        if line.lstrip().startswith("!"):
            style = "red"
        elif line.startswith("      ") and not line.startswith("       "):
            style = "bold"
        elif line.startswith("    "):
            style = "dim" if line.lstrip().startswith("–") else ""
        console.print(Text(line, style=style))


_WRITTEN = {"de": "Geschrieben: {}", "en": "Written: {}"}
