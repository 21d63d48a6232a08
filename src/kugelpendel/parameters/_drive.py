"""A drive: a push towards or away from the axis, once in every half swing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._given import Given, require, require_finite, require_positive
from kugelpendel.parameters._invalid import InvalidInput
from kugelpendel.parameters._numbers import Scalars, as_numbers


@dataclass(frozen=True, eq=False, init=False)
class Drive(Given):
    """A sudden radial change of velocity once in every half swing, or an ensemble of such drives.

    Parameters
    ----------
    push
        m/s, horizontal and away from the axis, then projected so that the thread stays straight;
        negative pulls inwards. On the way out a positive push brings energy in.
    phase
        rad, 0 ≤ phase < π: the push comes phase/ω0 after the closest approach to the axis. A push
        before it, at −x, has the phase π − x.
    radius
        m: the push comes on the way out, where the bob passes this distance from the axis; not at
        all in a half swing that does not reach it. Give exactly one of phase and radius.

    Raises
    ------
    InvalidInput
        For both or neither of phase and radius, a phase out of range, a radius that is not
        positive, and what is not finite; one element of an array included.
    """

    push: Scalars
    phase: Scalars | None
    radius: Scalars | None

    def __init__(
        self, push: ArrayLike, phase: ArrayLike | None = None, radius: ArrayLike | None = None
    ):
        strength = as_numbers(push, "The drive's push", "m/s")
        require_finite(strength, "The drive's push", "m/s")
        object.__setattr__(self, "push", strength)
        object.__setattr__(self, "phase", None)
        object.__setattr__(self, "radius", None)
        if (phase is None) == (radius is None):
            both = "neither is" if phase is None else "both are"
            raise InvalidInput(
                f"A drive needs exactly one of phase and radius, to say when it pushes, but {both} "
                f"given; write kp.Drive(push, radius=0.3) or kp.Drive(push, phase=0.1)."
            )
        if phase is not None:
            value = as_numbers(phase, "The drive's phase", "rad")
            sound = np.greater_equal(value, 0) & np.less(value, np.pi)
            way_out = "a push x before the closest approach has the phase π − x"
            require(value, "The drive's phase", "rad", "lie between 0 and π", sound, way_out)
            object.__setattr__(self, "phase", value)
        if radius is not None:
            value = as_numbers(radius, "The drive's radius", "m")
            way_out = "a push at the axis itself has phase=0"
            require_positive(value, "The drive's radius", "m", way_out)
            object.__setattr__(self, "radius", value)
        self._check_shapes(f"the drive's push and {'phase' if radius is None else 'radius'}")

    @property
    def values(self) -> tuple[Scalars, ...]:
        """The push, and the phase or the radius."""
        when = self.phase if self.phase is not None else self.radius
        return (self.push, 0.0 if when is None else when)

    def __reduce__(self) -> tuple[type[Drive], tuple[Scalars | None, ...]]:
        return (type(self), (self.push, self.phase, self.radius))

    def __eq__(self, other: object) -> bool:
        same_kind = isinstance(other, Drive) and (self.phase is None) == (other.phase is None)
        return same_kind and super().__eq__(other)

    def __hash__(self) -> int:
        return hash((self.phase is None, super().__hash__()))
