"""How accurate the exact motion is, by the stored references: a table for each regime.

``python -m tests.reference.accuracy [FILE …]`` prints it, for this project's own set where no file
is named, and ends with 1 where an error is larger than promised.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from tests.reference.cases import STORED, Case, read

# What the docstring of ExactMotion promises. The project's own targets are 8 and 1e-13.
POSITION = 3.0  # (spread + 4e-16) of the length
VELOCITY = 3.0  # (spread + 4e-16) of the largest speed
RELATIVE = 4e-16  # frequency and precession
PLAN = 2e-15  # outer turning radius, however small the ellipse and however late


@dataclass(frozen=True)
class Errors:
    """The largest of one or more cases."""

    cases: int
    states: int
    position: float
    velocity: float
    frequency: float
    precession: float
    position_in_lengths: float
    """Without regard to the spread."""
    plan: float
    """The plan view, of the outer turning radius, for paths below the support."""

    @classmethod
    def of(cls, case: Case) -> Errors:
        positions = case.motion.position(case.times)
        position, plan = case.position_errors(positions), case.plan_errors(positions)
        velocity = case.velocity_errors(case.motion.velocity(case.times))
        return cls(
            1,
            case.times.size,
            float(np.max(position / case.unit)),
            float(np.max(velocity / case.unit)),
            case.constant_error("frequency"),
            case.constant_error("precession"),
            float(np.max(position)),
            float(np.max(plan)),
        )

    def __or__(self, other: Errors) -> Errors:
        return Errors(
            self.cases + other.cases,
            self.states + other.states,
            *(float(np.fmax(getattr(self, name), getattr(other, name))) for name in FIGURES),
        )

    @property
    def kept(self) -> bool:
        """Whether they are as small as promised."""
        return (
            self.position <= POSITION
            and self.velocity <= VELOCITY
            and max(self.frequency, self.precession) <= RELATIVE
            and not self.plan > PLAN
        )


FIGURES = ("position", "velocity", "frequency", "precession", "position_in_lengths", "plan")


def table(cases: list[Case]) -> dict[str, Errors]:
    """The errors of each regime, in the file's order, and of "all"."""
    rows: dict[str, Errors] = {}
    for case in cases:
        errors = Errors.of(case)
        for row in (case.regime, "all"):
            rows[row] = rows[row] | errors if row in rows else errors
    rows["all"] = rows.pop("all")
    return rows


def main(paths: list[str]) -> int:
    kept = True
    for path in [Path(name) for name in paths] or [STORED]:
        print(f"{path.name}: largest errors, position and velocity in units of spread + 4e-16")
        print(
            f"{'regime':22}cases states  position velocity  frequency precession  position/length"
            "  plan/ellipse"
        )
        for regime, row in table(read(path)).items():
            plan = "-" if np.isnan(row.plan) else f"{row.plan:.1e}"
            print(
                f"{regime:22}{row.cases:5}{row.states:7}{row.position:10.2f}{row.velocity:9.2f}"
                f"{row.frequency:11.1e}{row.precession:11.1e}{row.position_in_lengths:17.1e}{plan:>14}"
            )
            kept = kept and row.kept
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
