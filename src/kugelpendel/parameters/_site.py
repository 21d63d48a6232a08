"""Where the pendulum stands: the Earth's rotation and normal gravity there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._given import Given, require, require_finite, require_positive
from kugelpendel.parameters._numbers import Scalars, as_numbers

ROTATION = 7.292115e-5
"""Ω_E, rad/s: of the Earth against the stars, one turn in 86164 s (WGS84, NIMA TR8350.2 §3.2.4)."""

# WGS84, NIMA TR8350.2 (2000), tables 3.1, 3.3 and 3.4.
_SEMI_MAJOR_AXIS = 6378137.0  # m
_FLATTENING = 1 / 298.257223563
_ECCENTRICITY_SQUARED = 6.69437999014e-3
_EQUATORIAL_GRAVITY = 9.7803253359  # m/s²
_SOMIGLIANA = 0.00193185265241
_CENTRIFUGAL = 0.00344978650684  # ω²a²b/GM

_HIGHEST = 20e3  # m, to which TR8350.2 gives the expansion in the height


@dataclass(frozen=True, eq=False, init=False)
class Site(Given):
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
        For what is not finite or out of these ranges, one element of an array included.

    Notes
    -----
    Normal gravity is that of an ellipsoid without mountains and ores: local gravity differs from it
    by some 1e-4 m/s² in flat country and up to 3e-3 m/s² in mountains, a relative 3e-4 at most.
    It is not what moves the bob: that is the pendulum's own gravity.
    Source: NIMA TR8350.2, third edition (2000): Somigliana's closed formula, eq. (4-1), and its
    expansion to the second order in the height, eq. (4-3).
    """

    latitude: Scalars
    gravity: Scalars
    height: Scalars
    gravity_given: bool

    def __init__(
        self, latitude: ArrayLike, gravity: ArrayLike | None = None, height: ArrayLike = 0.0
    ):
        north = as_numbers(latitude, "The site's latitude", "rad")
        require_latitude(north)
        above = as_numbers(height, "The site's height", "m")
        object.__setattr__(self, "latitude", north)
        object.__setattr__(self, "height", above)
        object.__setattr__(self, "gravity_given", gravity is not None)
        object.__setattr__(self, "gravity", 0.0)
        require(
            above, "The site's height", "m", "lie between −20000 and 20000 m",
            np.less_equal(np.abs(above), _HIGHEST), "give gravity itself where it does not",
        )  # fmt: skip
        if gravity is None:
            self._check_shapes("the site's latitude, gravity and height")
            resolved = normal_gravity(north, above)
        else:
            resolved = as_numbers(gravity, "The site's gravity", "m/s²")
            way_out = "leave it out for the normal gravity of the latitude"
            require_positive(resolved, "The site's gravity", "m/s²", way_out)
        object.__setattr__(self, "gravity", resolved)
        self._check_shapes("the site's latitude, gravity and height")

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Latitude, gravity (given or normal) and height."""
        return (self.latitude, self.gravity, self.height)

    @property
    def rotation(self) -> float:
        """Ω_E, rad/s: of the Earth against the stars."""
        return ROTATION

    @property
    def vertical_rotation(self) -> Scalars:
        """Ω_z = Ω_E sin(latitude), rad/s, positive in the north: the plane turns with −Ω_z."""
        return as_numbers(ROTATION * np.sin(self.latitude), "Ω_z", "rad/s")

    @property
    def horizontal_rotation(self) -> Scalars:
        """Ω_h = Ω_E cos(latitude), rad/s, towards the north."""
        return as_numbers(ROTATION * np.cos(self.latitude), "Ω_h", "rad/s")

    def __reduce__(self) -> tuple[Callable[..., Site], tuple[Scalars | None, ...]]:
        return (type(self), (self.latitude, self.gravity if self.gravity_given else None,
                             self.height))  # fmt: skip

    def __eq__(self, other: object) -> bool:
        same_kind = isinstance(other, Site) and self.gravity_given == other.gravity_given
        return same_kind and super().__eq__(other)

    def __hash__(self) -> int:
        return hash((self.gravity_given, super().__hash__()))


def require_latitude(latitude: Scalars) -> None:
    """Raise InvalidInput for latitudes that are not finite or beyond a pole."""
    require_finite(latitude, "The site's latitude", "rad")
    inside = np.less_equal(np.abs(latitude), np.pi / 2)
    bad = float(np.asarray(latitude)[~inside].flat[0]) if not np.all(inside) else 0.0
    in_degrees = abs(bad) <= 90
    way_out = (
        f"write math.radians({bad:.6g}) if these are degrees"
        if in_degrees
        else ("it is at most 90 degrees, π/2")
    )
    name = "The site's latitude"
    require(latitude, name, "rad", "lie between −π/2 and π/2 rad", inside, way_out)


def normal_gravity(latitude: Scalars, height: Scalars) -> Scalars:
    """WGS84 normal gravity, m/s², at a geodetic latitude, rad, and height, m.

    TR8350.2 (2000), eq. (4-1), (4-3): 9.8321849378 m/s² at the poles.
    """
    north = np.sin(latitude) ** 2
    ground = (
        _EQUATORIAL_GRAVITY * (1 + _SOMIGLIANA * north)
        / np.sqrt(1 - _ECCENTRICITY_SQUARED * north)
    )  # fmt: skip
    up = np.divide(height, _SEMI_MAJOR_AXIS)
    slope = 1 + _FLATTENING + _CENTRIFUGAL - 2 * _FLATTENING * north
    gravity = ground * (1 - 2 * slope * up + 3 * up**2)
    return as_numbers(gravity, "Gravity", "m/s²")
