"""One answer: a number with its unit, where it comes from, and what the full equations say."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Check:
    """What `RealMotion` gives where the formula expects something.

    Attributes
    ----------
    expected, measured
        In the unit of the answer; expected is the answer's value, or what its formula says for the
        case that was run.
    how
        What was run.
    scale
        What the difference is to be judged by, in the unit of the answer; None for what was
        measured itself.
    """

    expected: float
    measured: float
    how: str
    scale: float | None = None

    @property
    def difference(self) -> float:
        """Measured less expected, in the unit of the answer."""
        return self.measured - self.expected

    @property
    def relative(self) -> float | None:
        """The difference over its scale; None where that is zero."""
        scale = self.measured if self.scale is None else self.scale
        return self.difference / abs(scale) if scale else None


@dataclass(frozen=True)
class Answer:
    """One answer to a builder's question.

    Attributes
    ----------
    group
        What it is about: "period", "turning", "decay", "suspension", "drive", "passage", "wire".
    name
        What it is; no two answers of a design have the same.
    value
        In `unit`; azimuths and rates positive counter-clockwise seen from above; inf for never.
    unit
        SI, such as "s" or "rad/s"; "1" for a plain number, such as a share.
    formula
        As it was computed.
    source
        Where the formula comes from.
    note
        What else has to be said, or "".
    check
        By the full equations; None where there is none.
    """

    group: str
    name: str
    value: float
    unit: str
    formula: str
    source: str
    note: str = ""
    check: Check | None = None


CLOSED_FORM = "closed form: E. T. Whittaker, Analytical Dynamics, §55"
OLSSON = "M. G. Olsson, Am. J. Phys. 49, 531 (1981), eq. "
NELSON = "R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112 (1986)"
FOUCAULT = "L. Foucault, C. R. Acad. Sci. Paris 32, 135 (1851)"
AVERAGED = "averaged equations, docs/design.md"
HOOKE = "Hooke's law"
SCHUMACHER = "method: R. A. Schumacher and B. Tarbet, arXiv:0902.1829 (2009)"
