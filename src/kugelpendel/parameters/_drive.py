"""A drive: a push towards or away from the axis, once in every half swing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Drive(Given[Scalar_co]):
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
        For both or neither of phase and radius, for arrays that do not broadcast, and for a single
        drive whose phase is out of range, whose radius is not positive, or with what is not
        finite. In an ensemble a bad case becomes NaN in the motion, which gives the reason.
    """

    push: Scalar_co
    phase: Scalar_co | None
    radius: Scalar_co | None

    part = "drive"
    units: ClassVar = {"push": "m/s", "phase": "rad", "radius": "m"}
    strengths = ("push",)

    @overload
    def __init__(
        self: Drive[float],
        push: OneNumber,
        phase: OneNumber | None = ...,
        radius: OneNumber | None = ...,
    ) -> None: ...

    @overload
    def __init__(
        self: Drive[Numbers],
        push: ArrayLike,
        phase: ArrayLike | None = ...,
        radius: ArrayLike | None = ...,
    ) -> None: ...

    def __init__(
        self, push: ArrayLike, phase: ArrayLike | None = None, radius: ArrayLike | None = None
    ):
        if (phase is None) == (radius is None):
            both = "neither is" if phase is None else "both are"
            raise InvalidInput.of("drive_when", both=both)
        names = f"the drive's push and {'phase' if radius is None else 'radius'}"
        self._give(names, "phase", "radius", push=push, phase=phase, radius=radius)
