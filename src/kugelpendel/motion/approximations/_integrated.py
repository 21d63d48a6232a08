"""What the motions by the paper's equations (12) and (13) have in common."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar

import numpy as np

from kugelpendel import _core
from kugelpendel.motion._exact import ExactMotion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._walk import SteppedMotion
from kugelpendel.parameters import InvalidInput, Launch, Numbers, Pendulum, Scalars


class IntegratedMotion(SteppedMotion):
    """A motion in the plan view by an equation r̈ = −Λr, integrated by Taylor series of order 20.

    In an ensemble, a case that has ended is NaN from there on; a single motion raises. z lies on
    the lower half of the sphere, and the tension is m·g·Λ.
    """

    _equation: ClassVar[str]

    def __init__(self, pendulum: Pendulum, launch: Launch):
        self._exact = exact = ExactMotion(pendulum, launch)
        if exact.shape == () and not (height := exact.position(0.0)[2]) > 0:
            raise InvalidInput(
                f"{type(self).__name__} starts on the lower half of the sphere, but this launch "
                f"lies {-height:.6g} m above the support; use ExactMotion."
            )
        self._motions = _core.IntegratedMotions(
            self._count,
            [self._column(value) for value in pendulum.values],
            (launch.kind, [self._column(value) for value in launch.values]),
            self._equation,
        )

    def _arguments(self) -> dict[str, Any]:
        return {"pendulum": self.pendulum, "launch": self.launch}

    @kept
    def _rates(self) -> tuple[Scalars, Scalars]:
        rates = np.full((self._count, 2), np.nan)
        bad = {index for index, _ in self._problems()}
        for index in sorted(set(range(self._count)) - bad):
            motion = self[np.unravel_index(index, self.shape)] if self.shape else self
            half_swing = float(motion._exact.radial_period)
            found = _core.measured_rates(motion._states, half_swing)
            rates[index] = [np.nan if rate is None else rate for rate in found]
        return self._constant(rates[:, 0].copy()), self._constant(rates[:, 1].copy())

    @property
    def frequency(self) -> Scalars:
        """ω of the swing in the turning frame, rad/s: measured at 65 outer turning points.

        NaN on a circle and at rest, which show no turning points. Raises InvalidInput where the
        motion ends before.
        """
        return self._rates[0]

    @property
    def precession(self) -> Scalars:
        """Ω of that frame, rad/s, positive counter-clockwise seen from above: measured likewise.

        NaN where less than 1e-9 rad is turned in 64 half swings; else as `frequency`.
        """
        return self._rates[1]

    @property
    def pendulum(self) -> Pendulum:
        """What swings."""
        return self._exact.pendulum

    @property
    def launch(self) -> Launch:
        """Position and velocity at t = 0, as given."""
        return self._exact.launch

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the ensemble; () for a single motion."""
        return self._exact.shape

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which all motions of the ensemble can be asked.

        A motion ends where the bob reaches the height of the support.
        """
        return self._ends

    @kept
    def _ends(self) -> tuple[float, float]:
        # Radially both laws are periodic, with nearly the exact period: what ends, ends soon.
        return self._span_within(2 * np.minimum(self._column(self._exact.radial_period), 1e3))

    @property
    @abstractmethod
    def trust(self) -> str:
        """A sentence that says where the motion holds."""

    def _check_times(self, times: Numbers) -> None:
        """All times are good: these motions can be followed backwards too."""

    def _end_sentence(self, end: float, why: str, times: Numbers) -> str:
        return (
            f"{type(self).__name__} ends at {end:.6g} s, where the bob reaches the height of the "
            f"support; asked for are times from {times.min():.6g} s to {times.max():.6g} s. Keep "
            f"to its span, or use ExactMotion."
        )
