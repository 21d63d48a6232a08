"""What the motions by the paper's equations (12) and (13) have in common."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel import _core
from kugelpendel.motion._base import Motion
from kugelpendel.motion._exact import ExactMotion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._times import checked_grid, checked_times
from kugelpendel.parameters import InvalidInput, Launch, Numbers, Pendulum, Scalars


class IntegratedMotion(Motion):
    """A motion in the plan view by an equation r̈ = −Λr, integrated by Taylor series of order 24.

    In an ensemble, a case that has ended is NaN from there on; a single motion raises.
    Every request is integrated from t = 0 on, forwards and backwards, so it takes time in
    proportion to the span and keeps nothing; z lies on the lower half of the sphere.
    """

    _equation: ClassVar[str]

    def __init__(self, pendulum: Pendulum, launch: Launch):
        self._exact = ExactMotion(pendulum, launch)
        place, velocity = self._exact.position(0.0), self._exact.velocity(0.0)
        below = place[..., 2] > 0
        if self.shape == () and not below:
            raise InvalidInput(
                f"{type(self).__name__} starts on the lower half of the sphere, but this launch "
                f"lies {-place[2]:.6g} m above the support; use ExactMotion."
            )
        start = np.concatenate([place[..., :2], velocity[..., :2]], axis=-1)
        self._starts = np.where(below[..., np.newaxis], start, np.nan).reshape(-1, 4)
        columns = (np.broadcast_to(value, self.shape) for value in pendulum.values)
        self._pendulums = np.stack(list(columns), axis=-1).reshape(-1, 3)

    def _arguments(self) -> dict[str, Any]:
        return {"pendulum": self.pendulum, "launch": self.launch}

    def _problems(self) -> Iterable[tuple[int, str]]:
        # Those of the launch, and what starts above the support.
        refused = dict(enumerate(self._exact.reason.ravel().tolist()))
        for index in np.flatnonzero(~np.isfinite(self._starts).all(axis=-1)).tolist():
            above = f"{type(self).__name__} starts on the lower half of the sphere."
            yield index, refused[index] or above

    @kept
    def _rates(self) -> tuple[Scalars, Scalars]:
        rates = np.full((self._count, 2), np.nan)
        for index in self._cases():
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
        """Of the ensemble; () for a single motion."""
        return self._exact.shape

    @kept
    def _ends(self) -> tuple[float, float]:
        first, last = -np.inf, np.inf
        periods = np.broadcast_to(self._exact.radial_period, self.shape).reshape(-1)
        for k in self._cases():
            pendulum, start = self._pendulums[k].tolist(), self._starts[k].tolist()
            # Radially both laws are periodic, with nearly the exact period: what ends, ends soon.
            within = 2 * min(float(periods[k]), 1e3)
            begin, end = _core.integrated_span(pendulum, self._equation, start, within)
            first, last = max(first, begin), min(last, end)
        return (first, last)

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which all motions of the ensemble can be asked.

        Until a bob reaches the height of the support.
        """
        return self._ends

    @property
    @abstractmethod
    def trust(self) -> str:
        """Where the motion holds."""

    def position(self, t: ArrayLike) -> Numbers:
        """Position from the support, m, z down: shape (*shape, *t.shape, 3)."""
        return self._filled(t, velocity=False)

    def velocity(self, t: ArrayLike) -> Numbers:
        """Velocity, m/s: shape (*shape, *t.shape, 3)."""
        return self._filled(t, velocity=True)

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: m, shape (*shape, count, 3)."""
        size = checked_grid(start, step, count, 3 * self._count)
        return self._filled(start + step * np.arange(size), velocity=False)

    def _cases(self) -> NDArray[np.intp]:
        return np.flatnonzero(np.isfinite(self._starts).all(axis=-1))

    def _filled(self, t: ArrayLike, *, velocity: bool) -> Numbers:
        times = checked_times(t, 3 * self._count)
        rows = np.full((self._count, 3 * times.size), np.nan)
        for k in self._cases():
            pendulum, start = self._pendulums[k].tolist(), self._starts[k].tolist()
            rows[k], end = _core.integrated(
                pendulum, self._equation, start, times.ravel(), velocity
            )
            if end is not None and self.shape == ():
                raise InvalidInput(
                    f"{type(self).__name__} ends at {end:.6g} s, where the bob reaches the height "
                    f"of the support; asked for are times from {times.min():.6g} s to "
                    f"{times.max():.6g} s. Keep to its span, or use ExactMotion."
                )
        return rows.reshape(*self.shape, *times.shape, 3)
