"""What was checked at a step, in words: residual, random point, spoilt forms."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel.paper.typeset.unicode import plain

if TYPE_CHECKING:
    from collections.abc import Mapping

    from kugelpendel.paper.checks.evidence import Evidence, Residual
    from kugelpendel.paper.checks.row import Row
    from kugelpendel.paper.document.wording import Words

_SHOWN = 5
"""Digits of a random number that are shown of its fifty."""

_LONGEST = 100
"""Signs of a residual that are shown; of a longer one the beginning."""

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Proofs:
    """What was checked when a document was written.

    Attributes
    ----------
    evidence
        For the label of each formula, what was compared to prove it.
    rows
        For the label of each formula, what became of its spoilt forms; empty where none was made.
    when
        The day on which it was checked, and by which version, as the document shall say it.
    """

    evidence: Mapping[str, Evidence]
    rows: Mapping[str, Row]
    when: str

    @property
    def proved(self) -> int:
        """How many formulas are proved both ways."""
        return sum(one.holds for one in self.evidence.values())

    def holds(self, label: str) -> bool:
        """Tell whether a formula is proved, and no spoilt form of it went through."""
        row = self.rows.get(label)
        return self.evidence[label].holds and (row is None or row.holds)


def told(label: str, proofs: Proofs, words: Words) -> list[str]:
    """Say what was compared to prove a formula, in a paragraph for each kind of proof."""
    found, ui = proofs.evidence[label], words.ui
    comma = "," if words.language == "de" else "."

    def number(text: str) -> str:
        """Write 3.7e-61 as 3,7·10⁻⁶¹, and a long number with few digits."""
        digits, _, power = text.partition("e")
        short = digits[: _SHOWN + digits.startswith("-")].rstrip("0").rstrip(".") or "0"
        raised = f"·10{power.lstrip('+').translate(_SUPERSCRIPTS)}" if power else ""
        return short.replace(".", comma).replace("-", "−") + raised

    parts = [_residuals(found.residuals, words)]
    point = found.points[0]
    values = ", ".join(f"{plain(letter)} = {number(value)}" for letter, value in point.values)
    text = ui(
        "proof_point", len(found.points), f"`{values}`", number(point.rest), number(point.allowed)
    )
    if found.kept is not None:
        text += f" {ui('proof_order', found.kept)}"
    parts.append(text)
    row = proofs.rows.get(label)
    if row is not None:
        made = sum(tried for _, tried, _ in row.sabotages)
        seen = sum(noticed for _, _, noticed in row.sabotages)
        mutants = (row.mutants, row.killed, row.equal, len(row.survivors))
        parts.append(ui("proof_mutants", *mutants, made, seen))
    return parts


def _residuals(residuals: tuple[Residual, ...], words: Words) -> str:
    """Say what had to vanish, and whether it does."""
    ui = words.ui
    written = [one for one in residuals if one.latex != "0"]
    failing = [one for one in residuals if not one.is_zero]
    if failing:
        return ui("proof_residual_left", _short(failing[0].latex))
    if not written:
        return ui("proof_same")
    shown = "; ".join(_short(one.latex) for one in written)
    return ui("proof_residual", shown)


def _short(latex: str) -> str:
    text = re.sub(r"\s+", " ", plain(latex))
    return f"`{text if len(text) <= _LONGEST else text[:_LONGEST] + ' …'}`"
