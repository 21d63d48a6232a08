"""The report on a track for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.fit.words import words
from kugelpendel.cli.terminal.tables import facts, listing, paragraph

if TYPE_CHECKING:
    from kugelpendel.cli.fit.report import FitReport


def report_text(report: FitReport) -> str:
    """Set a report as lines, the misfit or its absence first."""
    said = words(report.language)
    parts = [paragraph(report.headline), paragraph(said["how"])]
    for section in report.sections:
        lines = [section.title]
        if section.rows:
            lines.append(facts((row.name, row.value, row.meaning) for row in section.rows))
        lines += [paragraph(sentence) for sentence in section.sentences]
        parts.append("\n".join(lines))
    notes = listing(report.notes, 0) if report.notes else said["nothing_noted"]
    parts.append(f"{said['section_notes']}\n{notes}")
    return "\n\n".join(parts)
