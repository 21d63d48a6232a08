"""What the linear, the Olsson and the series motion have in common: a turning figure."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.motion._exact import ExactMotion
from kugelpendel.motion._times import checked_grid, checked_times
from kugelpendel.parameters import InvalidInput, Launch, Numbers, Pendulum, Scalars

POWERS = 7
"""How many powers of sin² ζ the core takes for each part of the figure."""


class HarmonicMotion(ABC):
    """A figure of a few harmonics in a frame that turns, through the launch's exact turning points.

    x + iy = e^{i(Ωt + …)} (cos ζ·P(sin² ζ) + i sin ζ·Q(sin² ζ)) with ζ = ωt + …, and z on the lower
    half of the sphere. Semi-axes are the exact turning radii of the launch, the phase is that of
    its first outer turning point: what differs from the exact motion is the law alone.
    """

    def __init__(self, pendulum: Pendulum, launch: Launch):
        exact = ExactMotion(pendulum, launch)
        below = exact.turning_heights[..., 0] < np.asarray(pendulum.length)
        if exact.shape == () and not below:
            raise InvalidInput(
                f"{type(self).__name__} holds below the support, but this launch rises to "
                f"{exact.turning_heights[0]:.6g} m above the lowest point, and the length is "
                f"{pendulum.length} m; use ExactMotion."
            )
        self._exact = exact
        radii = np.where(below[..., np.newaxis], exact.turning_radii, np.nan)
        sense = np.where(np.asarray(exact.angular_momentum) < 0, -1.0, 1.0)
        self._outer, self._inner = radii[..., 0], sense * radii[..., 1]
        frequency, precession = self._rates()
        inner, outer = self._figure()
        columns = [
            *(np.asarray(c)[..., np.newaxis] for c in (pendulum.length, frequency, precession)),
            *(np.asarray(c)[..., np.newaxis] for c in (exact.apsis_time, exact.apsis_azimuth)),
            inner,
            outer,
        ]
        rows = np.concatenate(
            [np.broadcast_to(c, (*exact.shape, c.shape[-1])) for c in columns], axis=-1
        )
        self._frequency, self._precession = frequency, precession
        self._motions = _core.HarmonicMotions(rows.reshape(-1, rows.shape[-1]))

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (self.pendulum, self.launch))

    @abstractmethod
    def _rates(self) -> tuple[Numbers, Numbers]:
        """ω and Ω, rad/s, of `_outer` and `_inner`."""

    def _figure(self) -> tuple[Numbers, Numbers]:
        """Powers of P and Q, m: shapes (*shape, POWERS); here those of an ellipse."""
        rest = np.zeros((*self.shape, POWERS - 1))
        return (
            np.concatenate([self._inner[..., np.newaxis], rest], axis=-1),
            np.concatenate([self._outer[..., np.newaxis], rest], axis=-1),
        )

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
        """Of the ensemble; () for a single motion."""
        return self._exact.shape

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s: all of them."""
        return (-np.inf, np.inf)

    @property
    @abstractmethod
    def trust(self) -> str:
        """Where the motion holds."""

    @cached_property
    def frequency(self) -> Scalars:
        """ω of the swing in the turning frame, rad/s."""
        return self._scalars(self._frequency)

    @cached_property
    def precession(self) -> Scalars:
        """Ω of that frame, rad/s, positive counter-clockwise seen from above."""
        return self._scalars(self._precession)

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

    @property
    def _count(self) -> int:
        return int(np.prod(self.shape))

    def _scalars(self, values: Numbers) -> Scalars:
        full = np.broadcast_to(values, self.shape)
        return float(full) if self.shape == () else full
