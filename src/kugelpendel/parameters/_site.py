"""Where the pendulum stands: the Earth's rotation and normal gravity there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.parameters._derived import derived
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co, Scalars


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Site(Given[Scalar_co]):
    """A place on the Earth, or an ensemble of places where arrays are given; they broadcast.

    Parameters
    ----------
    latitude
        rad, geodetic, positive in the north: −π/2 to π/2.
    gravity
        m/s², as measured, the centrifugal part in it. Where it is left out, WGS84 normal gravity at
        this latitude and height.
    height
        m above the ellipsoid, −20 km to 20 km. Used for normal gravity only, so not at all where
        gravity is given.

    Attributes
    ----------
    gravity
        m/s², given or normal.
    gravity_given
        Whether it was given.

    Raises
    ------
    InvalidInput
        For a single site that is not finite or out of these ranges, and for arrays that do not
        broadcast. In an ensemble a bad case becomes NaN in the motion, which gives the reason.

    Notes
    -----
    Normal gravity is that of an ellipsoid without mountains and ores: local gravity differs from it
    by some 1e-4 m/s² in flat country and up to 3e-3 m/s² in mountains, a relative 3e-4 at most.
    It is not what moves the bob: that is the pendulum's own gravity.
    Source: NIMA TR8350.2, third edition (2000): Somigliana's closed formula, eq. (4-1), and its
    expansion to the second order in the height, eq. (4-3).
    """

    latitude: Scalar_co
    gravity: Scalar_co
    height: Scalar_co
    gravity_given: bool

    part = "site"
    units: ClassVar = {"latitude": "rad", "gravity": "m/s²", "height": "m"}
    strengths = ("rotation",)

    @overload
    def __init__(
        self: Site[float],
        latitude: OneNumber,
        gravity: OneNumber | None = ...,
        height: OneNumber = ...,
    ) -> None: ...

    @overload
    def __init__(
        self: Site[Numbers],
        latitude: ArrayLike,
        gravity: ArrayLike | None = ...,
        height: ArrayLike = ...,
    ) -> None: ...

    def __init__(
        self, latitude: ArrayLike, gravity: ArrayLike | None = None, height: ArrayLike = 0.0
    ):
        object.__setattr__(self, "gravity_given", gravity is not None)
        names = "the site's latitude, gravity and height"
        self._give(names, "gravity", latitude=latitude, gravity=gravity, height=height)
        if gravity is None:
            object.__setattr__(self, "gravity", derived("normal_gravity", names, self.prefixed))

    @property
    def named(self) -> dict[str, Scalars]:
        """Latitude, gravity if it was given, and height, in SI."""
        return {
            name: v for name, v in super().named.items() if name != "gravity" or self.gravity_given
        }

    @property
    def prefixed(self) -> dict[str, Scalars]:
        """Latitude, gravity if it was given, height and rotation by the names that the core has."""
        return super().prefixed | {"site.rotation": self.rotation}

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Latitude, gravity (given or normal) and height."""
        return (self.latitude, self.gravity, self.height)

    @property
    def rotation(self) -> float:
        """Ω_E, rad/s: of the Earth against the stars; a class for another planet has its own."""
        return _core.ROTATION

    @property
    def vertical_rotation(self) -> Scalar_co:
        """Ω_z = Ω_E sin(latitude), rad/s, positive in the north: the plane turns with −Ω_z."""
        return derived("vertical_rotation", "the site", self.prefixed)

    @property
    def horizontal_rotation(self) -> Scalar_co:
        """Ω_h = Ω_E cos(latitude), rad/s, towards the north."""
        return derived("horizontal_rotation", "the site", self.prefixed)
