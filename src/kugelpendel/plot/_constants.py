"""The constants of one motion, as plain numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    from kugelpendel import ExactMotion


_CONE = 1e-3
"""From turning heights closer than this, relative to the higher one, one sees a cone."""


@dataclass(frozen=True)
class Constants:
    """What a figure or a report needs to know about a motion, in SI.

    Attributes
    ----------
    outer, inner : float
        Distance from the vertical at the highest and at the lowest turning point, m.
    high, low : float
        Their heights above the lowest point of the sphere, m.
    """

    length: float
    small_swing: float
    outer: float
    inner: float
    high: float
    low: float
    frequency: float
    precession: float
    radial_period: float
    apsidal_angle: float
    apsis_time: float
    angular_momentum: float
    energy: float

    @classmethod
    def of(cls, motion: ExactMotion) -> Constants:
        """Ask one motion.

        Raises
        ------
        InvalidInput
            For an ensemble.
        """
        if motion.shape != ():
            raise InvalidInput(
                f"One motion can be shown at a time, and this is an ensemble of shape "
                f"{motion.shape}; make an ExactMotion of one pendulum and one launch."
            )
        outer, inner = (float(radius) for radius in motion.turning_radii)
        high, low = (float(height) for height in motion.turning_heights)
        return cls(
            length=float(motion.pendulum.length),
            small_swing=float(motion.pendulum.angular_frequency),
            outer=outer,
            inner=inner,
            high=high,
            low=low,
            frequency=float(motion.frequency),
            precession=float(motion.precession),
            radial_period=float(motion.radial_period),
            apsidal_angle=float(motion.apsidal_angle),
            apsis_time=float(motion.apsis_time),
            angular_momentum=float(motion.angular_momentum),
            energy=float(motion.energy),
        )

    @property
    def rises_above(self) -> bool:
        """Whether the path rises above the support."""
        return self.high > self.length

    @property
    def is_cone(self) -> bool:
        """Whether the bob circles below the support and all but keeps its height."""
        return 0 < self.high <= self.length and self.high - self.low <= _CONE * self.high
