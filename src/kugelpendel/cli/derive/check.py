"""``kugelpendel derive --check``: all proofs, as a table."""

from __future__ import annotations

from collections import Counter
from io import StringIO
from typing import TYPE_CHECKING

from rich import box
from rich.console import Console
from rich.table import Table

from kugelpendel import paper
from kugelpendel.cli.derive import as_json
from kugelpendel.cli.derive.command import known_label, text_width, write_page
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_json

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

_FAILED = 1


def check(
    equation: str | None,
    language: str | None,
    is_json: bool,
    document_format: str | None = None,
    out: Path | None = None,
) -> int:
    """Prove everything, or what leads to one equation, and print a table or JSON of it.

    Where a format or a file is given, the page is written as well, with what was found in it.

    Returns
    -------
    The exit code, which is 1 if anything fails.
    """
    chosen = known_language(language)
    words = paper.words(chosen)
    target = "" if equation is None else known_label(equation)
    labels = paper.leading_to(target) if target else paper.subjects()
    with Progress(words.ui("check_proving"), len(labels), language=chosen) as progress:
        rows = paper.check(progress=lambda done, total, row: progress.advance(1), labels=labels)
    if is_json:
        write_json(as_json.proofs(rows))
    else:
        print("\n".join(table(rows, words, text_width())))
    if document_format is not None or out is not None:
        write_page(target, chosen, out, rows)
    return 0 if rows and all(row.holds for row in rows) else _FAILED


def table(rows: Sequence[paper.Row], words: paper.Words, width: int = 80) -> list[str]:
    """Give the lines of a table: label, step, both proofs and the mutants; then the sums.

    What is said of the formulas, the formulas of the wording and the sabotages are summed up; what
    is at fault in them is listed at the end.
    """
    heads = ("label", "step", "symbolic", "numeric", "mutants")
    drawn = Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, header_style="")
    for head in heads:
        drawn.add_column(words.ui(f"check_{head}"))
    formulas = [row for row in rows if row.step != paper.StepKind.STATE]
    for row in formulas:
        marks = (_mark(row.symbolic, words), _mark(row.numeric, words))
        drawn.add_row(f"({row.label})", words.kind(row.step), *marks, _mutants(row, words))
    console = Console(file=StringIO(), width=width, highlight=False, markup=False)
    with console.capture() as captured:
        console.print(drawn)
    proved = sum(row.symbolic and row.numeric for row in formulas)
    killed, equal = sum(row.killed for row in rows), sum(row.equal for row in rows)
    mutants = sum(row.mutants for row in rows)
    survivors = [f"({row.label}) {text}" for row in rows for text in row.survivors]
    return [
        *(line.rstrip() for line in captured.get().splitlines()),
        "",
        *_said(rows, words),
        *_sabotages(rows, words),
        words.ui("check_proved", proved, len(formulas)),
        words.ui("check_sums", mutants, killed, equal, len(survivors)),
        *survivors,
        *(f"({row.label}) {text}" for row in rows for text in (*row.faults, *row.unnoticed)),
        *(f"({row.label}) {_mark(False, words)}" for row in _wording(rows) if not row.symbolic),
    ]


def _wording(rows: Sequence[paper.Row]) -> list[paper.Row]:
    """Rows of the formulas that stand in sentences."""
    return [row for row in rows if row.label in paper.STATEMENTS]


def _said(rows: Sequence[paper.Row], words: paper.Words) -> list[str]:
    formulas = [row for row in rows if row.step != paper.StepKind.STATE]
    lines = [words.ui("check_said", sum(not row.faults for row in formulas), len(formulas))]
    stated = _wording(rows)
    if stated:
        whole = [row for row in rows if row.label in paper.LANGUAGES]
        proved = sum(row.symbolic for row in stated)
        sound = sum(not row.faults for row in whole)
        lines.append(words.ui("check_wording", proved, len(stated), sound, len(whole)))
    return lines


def _sabotages(rows: Sequence[paper.Row], words: paper.Words) -> list[str]:
    """How many sabotages of each kind were made, and how many of them were noticed."""
    made, noticed = Counter[str](), Counter[str]()
    for row in rows:
        for kind, tried, found in row.sabotages:
            made[kind] += tried
            noticed[kind] += found
    lines = [
        words.ui("check_sabotage", words.ui(f"check_of_{kind}"), noticed[kind], made[kind])
        for kind in made
    ]
    return [words.ui("check_sabotages", noticed.total(), made.total()), *lines] if lines else []


def _mark(holds: bool, words: paper.Words) -> str:
    return words.ui("check_holds") if holds else words.ui("check_fails")


def _mutants(row: paper.Row, words: paper.Words) -> str:
    text = f"{row.killed}/{row.killed + len(row.survivors)}"
    if row.equal:
        text += f" (+{row.equal} {words.ui('check_equal')})"
    return text
