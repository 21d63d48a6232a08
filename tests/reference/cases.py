"""The stored reference motions, and how far numbers are from them: no stored digit is rounded."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import inf, sqrt
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kugelpendel import ExactMotion, Launch, Pendulum

STORED = Path(__file__).with_name("ideal.json")
CONSTANTS = {
    "frequency": "frequency",
    "precession": "precession",
    "radial_period": "radial_period",
    "energy": "energy_above_bottom",
    "angular_momentum": "angular_momentum",
}


@dataclass(frozen=True)
class Case:
    """One launch with its reference values, as in the file's "about"."""

    stored: dict[str, Any]

    @property
    def name(self) -> str:
        return self.stored["id"]

    @property
    def regime(self) -> str:
        return self.stored["regime"]

    @property
    def kind(self) -> str:
        """How the motion goes: "general", "plane", "cone", "separatrix", "rest" or "upright"."""
        if "motion" in self.stored:
            return self.stored["motion"]
        return "plane" if Fraction(self.stored["angular_momentum"]) == 0 else "general"

    @property
    def times(self) -> NDArray[np.float64]:
        return np.array(self.stored["times"])

    @property
    def unit(self) -> NDArray[np.float64]:
        """What errors are counted in at each time: spread + 4e-16, of the length."""
        return np.array(self.stored["spread"]) + 4e-16

    @property
    def pendulum(self) -> Pendulum:
        return Pendulum(self.stored["length"], self.stored["gravity"])

    @property
    def launch(self) -> Launch:
        state = self.stored["state"]
        match self.stored["kind"]:
            case "plane":
                return Launch.plane(*state)
            case "angles":
                return Launch.angles(*state)
            case "state":
                return Launch.state(state[:3], state[3:])
            case kind:
                raise ValueError(f"{self.name}: there is no launch of kind {kind}")

    @cached_property
    def motion(self) -> ExactMotion:
        return ExactMotion(self.pendulum, self.launch)

    @property
    def largest_speed(self) -> float:
        """m/s, on the whole path, by the stored energy."""
        lowest = float(self.motion.turning_heights[1])
        energy = float(Fraction(self.stored["energy_above_bottom"]))
        return sqrt(2 * max(energy - self.stored["gravity"] * lowest, 0))

    def position_errors(self, positions: NDArray[np.float64]) -> NDArray[np.float64]:
        """At each time, of the length."""
        return distances(self.stored["position"], positions) / self.stored["length"]

    def plan_errors(self, positions: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of the plan view at each time, of the outer turning radius; for paths below the support.

        NaN for others, which may turn next to the axis, and at rest.
        """
        (outer, _), (highest, _) = self.motion.turning_radii, self.motion.turning_heights
        if not 0 < highest <= self.stored["length"]:
            return np.full(self.times.shape, np.nan)
        return distances([texts[:2] for texts in self.stored["position"]], positions[:, :2]) / outer

    def velocity_errors(self, velocities: NDArray[np.float64]) -> NDArray[np.float64]:
        """At each time, of the largest speed; at rest of the speed of a fall through the length."""
        speed = self.largest_speed or sqrt(2 * self.stored["gravity"] * self.stored["length"])
        return distances(self.stored["velocity"], velocities) / speed

    def constant_error(self, name: str) -> float:
        """Relative; infinite where 0 or inf is expected and not met. 0 where it has no meaning."""
        expected, seen = self.stored[CONSTANTS[name]], getattr(self.motion, name)
        if expected is None:
            return 0.0
        if expected == "inf" or Fraction(expected) == 0:
            return 0.0 if seen == float(expected) else inf
        return abs(float(Fraction(seen) / Fraction(expected) - 1))


def distances(texts: list[list[str]], vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Between points written in decimals and binary ones, subtracted exactly."""
    gaps = [
        [
            float(Fraction(text) - Fraction(float(number)))
            for text, number in zip(*pair, strict=True)
        ]
        for pair in zip(texts, vectors, strict=True)
    ]
    return np.linalg.norm(np.array(gaps), axis=-1)


def read(path: Path = STORED) -> list[Case]:
    """All cases of one file."""
    return [Case(stored) for stored in json.loads(path.read_text())["cases"]]
