"""How the motion begins."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._invalid import InvalidInput
from kugelpendel.parameters._numbers import (
    Scalars,
    as_numbers,
    common_shape,
    equal,
    hashed,
    lock,
    unfit,
)


@dataclass(frozen=True, eq=False)
class Launch:
    """Position and velocity at t = 0, in the words of whoever launches.

    Made by one of the class methods; arrays are an ensemble and broadcast, with one another and
    with the pendulum. Whether a launch lies on the sphere is known only with the pendulum's
    length, so it is the motion that checks it.

    Attributes
    ----------
    kind
        "ellipse", "apsides", "plane", "angles" or "state".
    values
        The numbers given, in SI and in the order of that class method's arguments
        ("state": x, y, z, vx, vy, vz).
    """

    kind: str
    values: tuple[Scalars, ...]

    @classmethod
    def ellipse(cls, a: ArrayLike, b: ArrayLike, azimuth: ArrayLike = 0.0) -> Launch:
        """Displaced by a and pushed sideways with speed b·ω0: Olsson (1981), eq. (16).

        Parameters
        ----------
        a
            m, 0 ≤ a < length; horizontal, towards `azimuth`, on the lower half of the sphere.
        b
            m, any size; positive counter-clockwise seen from above. For small a and b, the
            semi-axes of the ellipse; for the exact turning radii use `apsides`.
        azimuth
            rad, counter-clockwise from x.
        """
        return cls._of("ellipse", ("a", a, "m"), ("b", b, "m"), ("azimuth", azimuth, "rad"))

    @classmethod
    def apsides(cls, a: ArrayLike, b: ArrayLike, azimuth: ArrayLike = 0.0) -> Launch:
        """The exact turning radii, both on the lower half of the sphere; starts at the outer one.

        Parameters
        ----------
        a
            m, outer turning radius, 0 ≤ a < length; the launch lies towards `azimuth`.
        b
            m, inner turning radius, |b| ≤ a; its sign is the sense, positive counter-clockwise.
        azimuth
            rad, counter-clockwise from x.
        """
        return cls._of("apsides", ("a", a, "m"), ("b", b, "m"), ("azimuth", azimuth, "rad"))

    @classmethod
    def plane(cls, x: ArrayLike, y: ArrayLike, vx: ArrayLike, vy: ArrayLike) -> Launch:
        """The plan view from above, m and m/s; z and its rate follow, on the lower half."""
        return cls._of("plane", ("x", x, "m"), ("y", y, "m"), ("vx", vx, "m/s"), ("vy", vy, "m/s"))

    @classmethod
    def angles(
        cls,
        theta: ArrayLike,
        phi: ArrayLike = 0.0,
        theta_rate: ArrayLike = 0.0,
        phi_rate: ArrayLike = 0.0,
    ) -> Launch:
        """θ from the downward vertical and azimuth φ, rad, and their rates, rad/s.

        The numbers are taken exactly: `math.pi` is 1.2e-16 short of upright, and falls.
        """
        return cls._of(
            "angles",
            ("theta", theta, "rad"),
            ("phi", phi, "rad"),
            ("theta_rate", theta_rate, "rad/s"),
            ("phi_rate", phi_rate, "rad/s"),
        )

    @classmethod
    def state(cls, position: ArrayLike, velocity: ArrayLike) -> Launch:
        """Position from the support, m, z down, and velocity, m/s: shape (..., 3) each.

        |position| must be the length, and the velocity at right angles to it, to a relative
        1e-9; what is left within that is projected away.
        """
        columns: list[tuple[str, ArrayLike, str]] = []
        for name, value, unit in (("position", position, "m"), ("velocity", velocity, "m/s")):
            vector = np.asarray(as_numbers(value, f"The launch's {name}", unit))
            if vector.shape[-1:] != (3,):
                raise InvalidInput(
                    f"The launch's {name} must have three components (x, y, z) on its last axis, "
                    f"but its shape is {vector.shape}."
                )
            columns += [(f"{name} {axis}", vector[..., k], unit) for k, axis in enumerate("xyz")]
        return cls._of("state", *columns)

    @classmethod
    def at_rest(cls, theta: ArrayLike, phi: ArrayLike = 0.0) -> Launch:
        """Let go at the angle θ from the downward vertical, azimuth φ; rad."""
        return cls.angles(theta, phi)

    def __post_init__(self) -> None:
        lock(self.values)

    def __reduce__(self) -> tuple[type[Launch], tuple[str, tuple[Scalars, ...]]]:
        return (Launch, (self.kind, self.values))

    @classmethod
    def _of(cls, kind: str, *arguments: tuple[str, ArrayLike, str]) -> Launch:
        values = tuple(as_numbers(v, f"The launch's {name}", unit) for name, v, unit in arguments)
        launch = cls(kind, values)
        try:
            _ = launch.shape
        except ValueError:
            names = ", ".join(name for name, _, _ in arguments)
            raise unfit(f"the launch's {names}", values) from None
        return launch

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single launch."""
        return common_shape(self.values)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Launch)
            and self.kind == other.kind
            and equal(self.values, other.values)
        )

    def __hash__(self) -> int:
        return hash((self.kind, hashed(self.values)))
