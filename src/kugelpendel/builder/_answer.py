"""One answer: a number with its unit, where it comes from, and what the full equations say."""

from __future__ import annotations

import re
from dataclasses import dataclass

from kugelpendel.builder._words import ANSWERS, DOUBTED, DOUBTED_BASIS, HOW, REMARKS

CONTRADICTS = 0.1
"""A check that is off by more than this part of its scale contradicts the formula."""


@dataclass(frozen=True)
class DesignCheck:
    """What `RealMotion` gives where the formula expects something.

    Attributes
    ----------
    expected, measured
        Both of the same question, in the unit of the answer.
    how
        What was run.
    scale
        What the difference is judged by, in the unit of the answer; None for what was measured
        itself.
    of
        What the scale is, such as "Ω_z"; "" for what was measured itself.
    """

    expected: float
    measured: float
    how: str
    scale: float | None = None
    of: str = ""

    @property
    def difference(self) -> float:
        """Measured less expected, in the unit of the answer."""
        return self.measured - self.expected

    @property
    def relative(self) -> float | None:
        """The difference over its scale; None where that is zero."""
        scale = self.measured if self.scale is None else self.scale
        return self.difference / abs(scale) if scale else None

    @property
    def agrees(self) -> bool:
        """Whether the difference is no more than a tenth of its scale."""
        if self.relative is None:
            return self.difference == 0
        return abs(self.relative) <= CONTRADICTS


@dataclass(frozen=True)
class DesignAnswer:
    """One answer to a builder's question.

    Attributes
    ----------
    key
        What it is, for programs; no two answers of a design have the same, and none has a value in
        it.
    value
        In `unit`; azimuths and rates positive counter-clockwise seen from above; inf for never.
    check
        By the full equations; None where there is none.
    remarks
        Keys of what is said of this value, unless the check contradicts it.
    facts
        Names and numbers of what name and note say.
    basis
        The check of another answer on which the remarks of this one rest; None where they do not.
    """

    key: str
    value: float
    check: DesignCheck | None = None
    remarks: tuple[str, ...] = ()
    facts: tuple[tuple[str, float], ...] = ()
    basis: DesignCheck | None = None

    @property
    def group(self) -> str:
        """One of "period", "turning", "decay", "suspension", "drive", "passage", "wire"."""
        return ANSWERS[self.key].group

    @property
    def name(self) -> str:
        """What it is, for readers."""
        return _told(ANSWERS[self.key].name, self.facts)

    @property
    def unit(self) -> str:
        """SI, such as "s" or "rad/s"; "1" for a plain number, such as a share."""
        return ANSWERS[self.key].unit

    @property
    def formula(self) -> str:
        """For the reader; the number is the core's, which has the higher orders as well."""
        return ANSWERS[self.key].formula

    @property
    def source(self) -> str:
        """Where the formula comes from."""
        return ANSWERS[self.key].source

    @property
    def contradicted(self) -> bool:
        """Whether a run gives another answer; then the remarks are not said."""
        return any(check is not None and not check.agrees for check in (self.check, self.basis))

    @property
    def note(self) -> str:
        """What else has to be said, or ""."""
        parts = [_told(ANSWERS[self.key].note, self.facts)]
        if self.check is not None and not self.check.agrees:
            parts.append(DOUBTED.format(of=self.check.of or "itself"))
        elif self.basis is not None and not self.basis.agrees:
            parts.append(DOUBTED_BASIS)
        else:
            parts += [_told(REMARKS[remark], self.facts) for remark in self.remarks]
        return "; ".join(part for part in parts if part)


def _told(text: str, facts: tuple[tuple[str, float], ...]) -> str:
    """Put numbers into a text, with minus signs before them."""
    return re.sub(r"-(?=\d)", "−", text.format(**dict(facts)))


def answer(
    key: str,
    value: float,
    check: DesignCheck | None = None,
    *remarks: str,
    **facts: float,
) -> DesignAnswer:
    """Make one; remarks that are "" are none."""
    said = tuple(remark for remark in remarks if remark)
    return DesignAnswer(key, value, check, said, tuple(facts.items()))


def how(key: str, **facts: float) -> str:
    """Say what was run."""
    return HOW[key].format(**facts)
