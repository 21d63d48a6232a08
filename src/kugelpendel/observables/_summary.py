"""What kind of motion it is, and the numbers that a report of an ideal motion gives."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, TypeAlias

from kugelpendel import _core
from kugelpendel.motion import ExactMotion, Motion
from kugelpendel.parameters import InvalidInput, require_type

Regime: TypeAlias = Literal[
    "rest", "balance", "separatrix", "plane", "rotation", "cone", "ellipse", "above"
]


@dataclass(frozen=True)
class IdealSummary:
    """Numbers in SI; angles in rad, azimuths and rates positive counter-clockwise seen from above.

    Attributes
    ----------
    motion
        The exact motion that this is about: a single one.
    regime
        "rest"; "balance" (at rest on top); "separatrix" (never comes back); "plane" (to and fro) or
        "rotation" (over the top) in a vertical plane; "cone" (below the support, turning heights
        within a thousandth); "ellipse" (below the support); or "above" (rises above it).
    sense
        1 for counter-clockwise seen from above, −1 for clockwise, 0 for neither.
    swing_period
        2π/ω, s: there and back, or once round a vertical circle; inf on the separatrix.
    turning
        Rate of the outer turning points on the branch that turns least, rad/s: the precession where
        half a turn lies between successive ones; less half a turn a radial period where it is
        closer to a whole one, for a path over the top.
    whole_turns
        Whether whole turns and not half turns were taken off for that.
    full_turn
        Time for one turn of the ellipse, or of the highest point, s; inf where nothing turns.
    once_round
        Time for one turn of the bob about the vertical on a cone, s; inf otherwise.
    largest_angle
        From the downward vertical, rad.
    formula_25
        Precession by the paper's (25), rad/s; None where it does not apply.
    frequency_26
        Frequency by the paper's (26), rad/s; None where it does not apply.
    """

    motion: ExactMotion
    regime: Regime
    sense: int
    swing_period: float
    turning: float
    whole_turns: bool
    full_turn: float
    once_round: float
    largest_angle: float
    formula_25: float | None
    frequency_26: float | None

    @classmethod
    def of(cls, motion: Motion) -> IdealSummary:
        """Read all of it off the ideal motion that starts like a single motion does.

        That is the exact motion itself, or that of the `effective_pendulum` from the same launch.
        Raises InvalidInput for an ensemble.
        """
        require_type("The motion", motion, Motion, way_out="write kp.ExactMotion(pendulum, launch)")
        if motion.shape != ():
            raise InvalidInput(
                f"One motion can be shown at a time, and this is an ensemble of shape "
                f"{motion.shape}; pick one of its motions, motion[0] for instance."
            )
        if not isinstance(motion, ExactMotion):
            motion = ExactMotion(motion.effective_pendulum, motion.launch)
        regime, sense, rates, largest_angle, formula_25, frequency_26 = motion.summary()
        swing_period, turning, whole_turns, full_turn, once_round = rates
        return cls(
            motion=motion,
            regime=regime,  # pyright: ignore[reportArgumentType]
            sense=int(sense),
            swing_period=swing_period,
            turning=turning,
            whole_turns=whole_turns,
            full_turn=full_turn,
            once_round=once_round,
            largest_angle=largest_angle,
            formula_25=None if math.isnan(formula_25) else formula_25,
            frequency_26=None if math.isnan(frequency_26) else frequency_26,
        )

    @property
    def length(self) -> float:
        """Of the pendulum, m."""
        return float(self.motion.pendulum.length)

    @property
    def outer(self) -> float:
        """Distance from the vertical at the highest turning point, m."""
        return float(self.motion.turning_radii[0])

    @property
    def inner(self) -> float:
        """Distance from the vertical at the lowest turning point, m."""
        return float(self.motion.turning_radii[1])

    @property
    def high(self) -> float:
        """Height of the highest turning point above the lowest point of the sphere, m."""
        return float(self.motion.turning_heights[0])

    @property
    def low(self) -> float:
        """Height of the lowest turning point above the lowest point of the sphere, m."""
        return float(self.motion.turning_heights[1])

    @property
    def frequency(self) -> float:
        """ω of the exact motion, rad/s."""
        return float(self.motion.frequency)

    @property
    def precession(self) -> float:
        """Ω of the exact motion, rad/s."""
        return float(self.motion.precession)

    @property
    def fastest(self) -> float:
        """Largest of ω0, ω and the angular velocity of the thread at the lowest point, rad/s."""
        energy = float(self.motion.energy)
        rest = float(self.motion.pendulum.angular_frequency)
        return max(rest, self.frequency, math.sqrt(2 * energy) / self.length)

    @property
    def rises_above(self) -> bool:
        """Whether the path rises above the support."""
        return self.high > self.length

    @property
    def is_cone(self) -> bool:
        """Whether the bob circles below the support and all but keeps its height."""
        return self.regime == "cone"

    @property
    def error_25(self) -> float | None:
        """How far (25) is off, as a fraction of the exact precession, signed."""
        return self._error(self.formula_25, self.precession)

    @property
    def period_error_26(self) -> float | None:
        """How far the period by (26) is off, as a fraction of the exact one, signed."""
        if self.frequency_26 is None:
            return None
        return self._error(self.frequency, self.frequency_26)

    @property
    def tension(self) -> tuple[float, float]:
        """Smallest and largest pull of the thread, N."""
        least, most = self.motion.tension_range
        return float(least), float(most)

    @property
    def slack_time(self) -> float:
        """When a thread first goes slack, s after the launch; inf for never."""
        return float(self.motion.slack_time)

    @staticmethod
    def _error(approximate: float | None, truth: float) -> float | None:
        return None if approximate is None else _core.relative_error(approximate, truth)
