"""What the motions by the paper's equations (12) and (13) have in common."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar, Self, cast

import numpy as np

from kugelpendel import _core
from kugelpendel.motion._exact import ExactMotion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._walk import SteppedMotion
from kugelpendel.parameters import Launch, Pendulum, Scalar_co, column


class IntegratedMotion(SteppedMotion[Scalar_co]):
    """A motion in the plan view by an equation r̈ = −Λr, integrated by Taylor series of order 20.

    In an ensemble, a case that has ended is NaN from there on; a single motion raises. z lies on
    the lower half of the sphere, and the tension is m·g·Λ.
    """

    _equation: ClassVar[str]

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
    ):
        self._exact = ExactMotion(pendulum, launch)
        self._motions = _core.IntegratedMotions(
            self._count,
            [column(value, self.shape) for value in pendulum.values],
            (launch.kind, launch.columns(self.shape)),
            self._equation,
        )
        self._refuse_bad()

    def _arguments(self) -> dict[str, Any]:
        return {"pendulum": self.pendulum, "launch": self.launch}

    @kept
    def _rates(self) -> tuple[Scalar_co, Scalar_co]:
        rates = np.full((self._count, 2), np.nan)
        for index in np.flatnonzero(self.status.ravel() == 0).tolist():
            motion = cast("Self", self[np.unravel_index(index, self.shape)]) if self.shape else self
            half_swing = float(motion._exact.radial_period)
            found = _core.measured_rates(motion._states, half_swing)
            rates[index] = [np.nan if rate is None else rate for rate in found]
        return self._constant(rates[:, 0].copy()), self._constant(rates[:, 1].copy())

    @property
    def frequency(self) -> Scalar_co:
        """ω of the swing in the turning frame, rad/s: measured at 65 outer turning points.

        NaN on a circle and at rest, which show no turning points. Raises InvalidInput where the
        motion ends before.
        """
        return self._rates[0]

    @property
    def precession(self) -> Scalar_co:
        """Ω of that frame, rad/s, positive counter-clockwise seen from above: measured likewise.

        NaN where less than 1e-9 rad is turned in 64 half swings; else as `frequency`.
        """
        return self._rates[1]

    @property
    def pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The pendulum that swings."""
        return self._exact.pendulum

    @property
    def launch(self) -> Launch[Scalar_co] | Launch[float]:
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
        return self._span_within(2 * np.minimum(column(self._exact.radial_period, self.shape), 1e3))

    @property
    @abstractmethod
    def trust(self) -> str:
        """A sentence that says where the motion holds."""

    def _check_start(self, first: float) -> None:
        """All times are good: these motions can be followed backwards too."""

    def _ended(self, why: str) -> tuple[str, dict[str, str]]:
        return "level_with_support", {"motion": type(self).__name__}
