"""``kugelpendel derive --check``: all proofs, as a table."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel import paper
from kugelpendel.cli.derive.command import known_label, known_language
from kugelpendel.cli.terminal.progress import Progress

if TYPE_CHECKING:
    from collections.abc import Sequence

_FAILED = 1


def check(equation: str | None, language: str | None) -> int:
    """Prove everything, or what leads to one equation, and print what was found.

    Returns
    -------
    int
        Exit code: 1 if anything fails.
    """
    words = paper.words(known_language(language))
    labels = [formula.label for formula in paper.FORMULAS]
    if equation is not None:
        target = known_label(equation)
        labels = [*paper.rests_on(target), *(one.label for one in paper.parts(target))]
    with Progress(words.ui("check_proving"), len(labels)) as progress:

        def advance(done: int, total: int, row: paper.Row) -> None:
            progress.advance(1)

        rows = paper.check(parallel=True, progress=advance, labels=labels)
    print("\n".join(table(rows, words)))
    return 0 if rows and all(row.holds for row in rows) else _FAILED


def table(rows: Sequence[paper.Row], words: paper.Words) -> list[str]:
    """Label, step, both proofs and the mutants of each formula, then the sums."""
    cells = [
        [words.ui(f"check_{name}") for name in ("label", "step", "symbolic", "numeric", "mutants")]
    ]
    cells.extend(
        [
            f"({row.label})",
            words.kind(row.step),
            _mark(row.symbolic, words),
            _mark(row.numeric, words),
            _mutants(row, words),
        ]
        for row in rows
    )
    widths = [max(len(line[column]) for line in cells) for column in range(len(cells[0]))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in cells
    ]
    proved = sum(row.symbolic and row.numeric for row in rows)
    mutants, killed, equal = (
        sum(row.mutants for row in rows),
        sum(row.killed for row in rows),
        sum(row.equal for row in rows),
    )
    survivors = [f"({row.label}) {text}" for row in rows for text in row.survivors]
    lines.insert(1, "  ".join("-" * width for width in widths))
    lines.extend(["", words.ui("check_proved", proved, len(rows))])
    lines.append(words.ui("check_sums", mutants, killed, equal, len(survivors)))
    return [*lines, *survivors]


def _mark(holds: bool, words: paper.Words) -> str:
    return words.ui("check_holds") if holds else words.ui("check_fails")


def _mutants(row: paper.Row, words: paper.Words) -> str:
    text = f"{row.killed}/{row.killed + len(row.survivors)}"
    if row.equal:
        text += f" (+{row.equal} {words.ui('check_equal')})"
    return text
