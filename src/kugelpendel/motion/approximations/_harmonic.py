"""What the linear, the Olsson and the series motion have in common: a turning figure."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.motion._base import Motion, event_step
from kugelpendel.motion._kept import kept
from kugelpendel.motion._times import checked_grid, checked_times, motion_shape
from kugelpendel.parameters import (
    Launch,
    Numbers,
    Pendulum,
    Scalar_co,
    column,
    require_given,
)


class HarmonicMotion(Motion[Scalar_co]):
    """A figure of a few harmonics in a frame that turns, through the launch's exact turning points.

    x + iy = e^{i(Ωt + …)} (cos ζ·P(sin² ζ) + i sin ζ·Q(sin² ζ)) with ζ = ωt + …, and z on the lower
    half of the sphere. Semi-axes are the exact turning radii of the launch, the phase is that of
    its first outer turning point: what differs from the exact motion is the law alone.
    """

    _law: ClassVar[str]

    def __init__(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
    ):
        require_given(type(self).__name__, pendulum, launch)
        self._pendulum = pendulum
        self._launch = launch
        self._shape = motion_shape(pendulum, launch)
        self._motions = _core.HarmonicMotions(
            self._count,
            [column(value, self._shape) for value in pendulum.values],
            launch.kind,
            launch.columns(self._shape),
            self._law,
        )
        self._refuse_bad()

    def _arguments(self) -> dict[str, Any]:
        return {"pendulum": self._pendulum, "launch": self._launch}

    @property
    def pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The pendulum as it was given."""
        return self._pendulum

    @property
    def launch(self) -> Launch[Scalar_co] | Launch[float]:
        """Position and velocity at t = 0, as they were given."""
        return self._launch

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the ensemble; () for a single motion."""
        return self._shape

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s: all of them."""
        return (-np.inf, np.inf)

    @property
    @abstractmethod
    def trust(self) -> str:
        """A sentence that says where the motion holds."""

    @kept
    def frequency(self) -> Scalar_co:
        """ω of the swing in the turning frame, rad/s."""
        return self._constant(self._motions.frequency())

    @kept
    def precession(self) -> Scalar_co:
        """Ω of that frame, rad/s, positive counter-clockwise seen from above."""
        return self._constant(self._motions.precession())

    @kept
    def semi_axes(self) -> Numbers:
        """Outer and inner semi-axis, m, this one positive counter-clockwise: (*shape, 2)."""
        return self._constant(self._motions.semi_axes(), 2)

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3)."""
        times = checked_times(t, 3 * self._count)
        return self._motions.position(times.ravel()).reshape(*self.shape, *times.shape, 3)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3); the rate of `position`."""
        times = checked_times(t, 3 * self._count)
        return self._motions.velocity(times.ravel()).reshape(*self.shape, *times.shape, 3)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3); the fast path."""
        size = checked_grid(start, step, count, 3 * self._count)
        return self._motions.sample(float(start), float(step), size).reshape(*self.shape, size, 3)

    def _find_events(
        self, kind: str, value: float, between: tuple[float, float], most: int
    ) -> Numbers:
        event_step(between, float(self.pendulum.angular_frequency))  # raises
        return self._motions.events(kind, value, between, most)
