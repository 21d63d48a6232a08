"""The one interface of every motion."""

from __future__ import annotations

from typing import Protocol

from numpy.typing import ArrayLike

from kugelpendel.parameters import Launch, Numbers, Pendulum


class Motion(Protocol):
    """What plots, observables and exports take: a pendulum under way."""

    @property
    def pendulum(self) -> Pendulum:
        """What swings."""
        ...

    @property
    def launch(self) -> Launch:
        """How it began, at t = 0."""
        ...

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single motion."""
        ...

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s, for which the motion can be asked."""
        ...

    @property
    def trust(self) -> str:
        """A sentence: where the motion holds."""
        ...

    def position(self, t: ArrayLike) -> Numbers:
        """In m, z down from the support: shape (*shape, *t.shape, 3)."""
        ...

    def velocity(self, t: ArrayLike) -> Numbers:
        """In m/s: shape (*shape, *t.shape, 3)."""
        ...

    def sample(self, start: float, step: float, count: int) -> Numbers:
        """Positions at start + step·k: shape (*shape, count, 3)."""
        ...
