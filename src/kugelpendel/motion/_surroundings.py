"""What acts on a pendulum beside gravity and its thread, ready for the core."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import prod

import numpy as np

from kugelpendel.parameters import (
    Bob,
    Drag,
    Drive,
    InvalidInput,
    Launch,
    Numbers,
    Pendulum,
    Scalars,
    Site,
    Suspension,
)


@dataclass(frozen=True)
class Surroundings:
    """A pendulum, its launch, and everything that acts on it; None is not there.

    Raises
    ------
    InvalidInput
        Where shapes do not broadcast, and where a gravity given for the site is not the
        pendulum's.
    """

    pendulum: Pendulum
    launch: Launch
    site: Site | None = None
    drag: Drag | None = None
    suspension: Suspension | None = None
    bob: Bob | None = None
    drive: Drive | None = None

    def __post_init__(self) -> None:
        try:
            _ = self.shape
        except ValueError:
            shapes = ", ".join(f"{type(part).__name__} {part.shape}" for part in self._parts)
            raise InvalidInput(
                f"The shapes of what was given do not fit together: {shapes}; give them shapes "
                f"that broadcast."
            ) from None
        if self.site is not None and self.site.gravity_given:
            ours, theirs = np.broadcast_arrays(self.pendulum.gravity, self.site.gravity)
            for here, there in zip(ours.flat, theirs.flat, strict=True):
                if here != there:
                    raise InvalidInput(
                        f"The site's gravity is {there:.9g} m/s² and the pendulum's {here:.9g} "
                        f"m/s²; say it once: kp.Pendulum(length, gravity=site.gravity)."
                    )

    @property
    def _parts(self) -> list[Pendulum | Launch | Site | Drag | Suspension | Bob | Drive]:
        parts = (
            self.pendulum, self.launch, self.site, self.drag, self.suspension, self.bob, self.drive
        )  # fmt: skip
        return [part for part in parts if part is not None]

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () where everything is one number."""
        return np.broadcast_shapes(*(part.shape for part in self._parts))

    @property
    def count(self) -> int:
        """How many motions there are."""
        return prod(self.shape)

    @cached_property
    def effective_pendulum(self) -> Pendulum:
        """The point mass that moves like this bob: its gravity takes in buoyancy and inertia.

        Its weight is that of the bob, so that the thread's pull is right but for buoyancy.
        """
        if self.bob is None:
            return self.pendulum
        length, gravity, mass = self.pendulum.values
        factor = self.bob.gravity_factor(length)
        return Pendulum(length, np.multiply(gravity, factor), np.divide(mass, factor))

    @property
    def acts(self) -> bool:
        """Whether anything acts that the ideal pendulum does without."""
        return any(np.any(column != 0) for column in (*self.forces, self.drive_columns[0]))

    @property
    def pendulum_columns(self) -> list[Numbers]:
        """Length, effective gravity and mass."""
        return [self.column(value) for value in self.effective_pendulum.values]

    @property
    def launch_columns(self) -> list[Numbers]:
        """The launch's values."""
        return [self.column(value) for value in self.launch.values]

    @property
    def forces(self) -> list[Numbers]:
        """γ, c, Ω_h, Ω_z, δ, its axis, Δγ, its axis."""
        values: list[Scalars] = [0.0] * 8
        if self.drag is not None:
            values[0:2] = self.drag.linear, self.drag.quadratic
        if self.site is not None:
            values[2:4] = self.site.horizontal_rotation, self.site.vertical_rotation
        if self.suspension is not None:
            values[4:8] = self.suspension.values
        return [self.column(value) for value in values]

    @property
    def drive_kind(self) -> str:
        """When it pushes: "phase", "radius", or "" where there is no drive."""
        if self.drive is None:
            return ""
        return "radius" if self.drive.phase is None else "phase"

    @property
    def drive_columns(self) -> list[Numbers]:
        """The push, and the phase or the radius."""
        return [self.column(v) for v in ((0.0, 0.0) if self.drive is None else self.drive.values)]

    def column(self, value: Scalars) -> Numbers:
        """One number for all motions, or one for each."""
        if isinstance(value, float):
            return np.array([value])
        return np.ascontiguousarray(np.broadcast_to(value, self.shape).ravel())
