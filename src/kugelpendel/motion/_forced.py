"""What the motions of a real pendulum have in common: what they were given."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from kugelpendel.motion._base import Motion
from kugelpendel.motion._kept import kept
from kugelpendel.motion._problems import Problems
from kugelpendel.parameters import (
    ActedOn,
    ForceParts,
    Forces,
    Launch,
    Numbers,
    Pendulum,
    Scalar_co,
    column,
    gathered,
    require_given,
    unfit_parts,
)


class ForcedMotion(ActedOn[Scalar_co], Motion[Scalar_co]):
    """A pendulum under the forces that act on it."""

    _pendulum: Pendulum[Scalar_co] | Pendulum[float]
    _launch: Launch[Scalar_co] | Launch[float]
    _forces: Forces[Scalar_co] | Forces[float]
    _shape: tuple[int, ...]

    def _give(
        self,
        pendulum: Pendulum[Scalar_co] | Pendulum[float],
        launch: Launch[Scalar_co] | Launch[float],
        forces: Forces[Scalar_co] | Forces[float] | None,
        parts: ForceParts[Scalar_co],
    ) -> None:
        """Keep what was given; raises InvalidInput for what is not of its type or does not fit."""
        require_given(type(self).__name__, pendulum, launch)
        acting = gathered(type(self).__name__, forces, parts)
        given = (pendulum, launch, *acting.parts.values())
        try:
            self._shape = np.broadcast_shapes(*(part.shape for part in given))
        except ValueError:
            raise unfit_parts(*given) from None
        self._pendulum, self._launch, self._forces = pendulum, launch, acting

    @property
    def pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """What swings, as given."""
        return self._pendulum

    @property
    def launch(self) -> Launch[Scalar_co] | Launch[float]:
        """Position and velocity at t = 0, as given."""
        return self._launch

    @property
    def forces(self) -> Forces[Scalar_co] | Forces[float]:
        """Everything that acts beside gravity and the thread."""
        return self._forces

    @kept
    def effective_pendulum(self) -> Pendulum[Scalar_co] | Pendulum[float]:
        """The point mass that moves like this bob."""
        point = self._forces.effective_pendulum(self._pendulum)
        return cast("Pendulum[Scalar_co]", point)

    @property
    def angular_frequency(self) -> Scalar_co | float:
        """ω0, rad/s: of infinitesimal swings, with the bob's correction."""
        return self.effective_pendulum.angular_frequency

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single motion."""
        return self._shape

    @property
    def rotation(self) -> Scalar_co | float:
        """Rate of the ground about the vertical, rad/s, counter-clockwise seen from above."""
        return 0.0 if self.site is None else self.site.vertical_rotation

    @property
    def frequency(self) -> Scalar_co:
        """There is none that stays: forces change it. Raises AttributeError with the way out."""
        raise AttributeError(self._changes("frequency"))

    @property
    def precession(self) -> Scalar_co:
        """There is none that stays: forces change it. Raises AttributeError with the way out."""
        raise AttributeError(self._changes("precession"))

    def _changes(self, rate: str) -> str:
        return (
            f"{type(self).__name__} has no {rate} that stays: forces change it under way. Ask for "
            f"the times of its turning points, events('outer', …), for kp.ellipse(motion, t), or "
            f"for EnvelopeMotion.rates(t)."
        )

    @kept
    def problems(self) -> Problems:
        """The bad cases; a derived number is told by what was given, such as a half life.

        `status` keeps the kind of the derived number's own problem.
        """
        return Problems(self._motions, self.shape, self._forces)

    def _arguments(self) -> dict[str, Any]:
        acting = {"forces": self._forces} if self._forces.parts else {}
        return {"pendulum": self._pendulum, "launch": self._launch, **acting}

    @property
    def _columns(
        self,
    ) -> tuple[int, list[Numbers], tuple[str, list[Numbers]], dict[str, Numbers]]:
        """Count, pendulum, launch and forces as the core takes them."""
        shape = self._shape
        return (
            self._count,
            [column(value, shape) for value in self._pendulum.values],
            (self._launch.kind, self._launch.columns(shape)),
            self._forces.columns(shape),
        )
