"""How the motion begins."""

# One number is array-like too, so overloads for it come first.
# pyright: reportOverlappingOverload=false

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Generic, cast, overload

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.errors import InvalidInput
from kugelpendel.parameters._given import spelled
from kugelpendel.parameters._numbers import (
    Numbers,
    OneNumber,
    Scalar_co,
    Scalars,
    as_numbers,
    column,
    common_shape,
    equal,
    hashed,
    lock,
    unfit,
)

_ELLIPSE = {"a": "m", "b": "m", "azimuth": "rad"}
_ANGLES = {"theta": "rad", "phi": "rad"}


@dataclass(frozen=True, eq=False, repr=False)
class Launch(Generic[Scalar_co]):
    """Position and velocity at t = 0, in the words of whoever launches.

    Made by one of the class methods; arrays are an ensemble and broadcast, with one another and
    with the pendulum. Whether a launch lies on the sphere is known only with the pendulum's
    length, so it is the motion that checks it.

    Attributes
    ----------
    kind
        "ellipse", "apsides", "plane", "angles", "state" or "at_rest".
    values
        The numbers given, in SI and in the order of that class method's arguments
        ("state": x, y, z, vx, vy, vz).

    Raises
    ------
    InvalidInput
        For an unknown kind, another count of values, what is no number, shapes that do not
        broadcast, and for a single launch with a number that is not finite or an angle beyond ±2π.
    """

    kind: str
    values: tuple[Scalar_co, ...]

    kinds: ClassVar[dict[str, dict[str, str]]] = {
        "ellipse": _ELLIPSE,
        "apsides": _ELLIPSE,
        "plane": {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"},
        "angles": {**_ANGLES, "theta_rate": "rad/s", "phi_rate": "rad/s"},
        "state": {"x": "m", "y": "m", "z": "m", "vx": "m/s", "vy": "m/s", "vz": "m/s"},
        "at_rest": _ANGLES,
    }
    """The units of the values of each kind, under their names."""

    @overload
    @classmethod
    def ellipse(cls, a: OneNumber, b: OneNumber, azimuth: OneNumber = ...) -> Launch[float]: ...

    @overload
    @classmethod
    def ellipse(cls, a: ArrayLike, b: ArrayLike, azimuth: ArrayLike = ...) -> Launch[Numbers]: ...

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
        return cls._of("ellipse", a, b, azimuth)

    @overload
    @classmethod
    def apsides(cls, a: OneNumber, b: OneNumber, azimuth: OneNumber = ...) -> Launch[float]: ...

    @overload
    @classmethod
    def apsides(cls, a: ArrayLike, b: ArrayLike, azimuth: ArrayLike = ...) -> Launch[Numbers]: ...

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
        return cls._of("apsides", a, b, azimuth)

    @overload
    @classmethod
    def plane(cls, x: OneNumber, y: OneNumber, vx: OneNumber, vy: OneNumber) -> Launch[float]: ...

    @overload
    @classmethod
    def plane(cls, x: ArrayLike, y: ArrayLike, vx: ArrayLike, vy: ArrayLike) -> Launch[Numbers]: ...

    @classmethod
    def plane(cls, x: ArrayLike, y: ArrayLike, vx: ArrayLike, vy: ArrayLike) -> Launch:
        """The plan view from above, m and m/s; z and its rate follow, on the lower half."""
        return cls._of("plane", x, y, vx, vy)

    @overload
    @classmethod
    def angles(
        cls,
        theta: OneNumber,
        phi: OneNumber = ...,
        theta_rate: OneNumber = ...,
        phi_rate: OneNumber = ...,
    ) -> Launch[float]: ...

    @overload
    @classmethod
    def angles(
        cls,
        theta: ArrayLike,
        phi: ArrayLike = ...,
        theta_rate: ArrayLike = ...,
        phi_rate: ArrayLike = ...,
    ) -> Launch[Numbers]: ...

    @classmethod
    def angles(
        cls,
        theta: ArrayLike,
        phi: ArrayLike = 0.0,
        theta_rate: ArrayLike = 0.0,
        phi_rate: ArrayLike = 0.0,
    ) -> Launch:
        """θ from the downward vertical and azimuth φ, rad, and their rates, rad/s.

        Angles are at most 2π either way: what is larger was most likely meant in degrees. The
        numbers are taken exactly: `math.pi` is 1.2e-16 short of upright, and falls.
        """
        return cls._of("angles", theta, phi, theta_rate, phi_rate)

    @overload
    @classmethod
    def state(cls, position: Sequence[float], velocity: Sequence[float]) -> Launch[float]: ...

    @overload
    @classmethod
    def state(cls, position: ArrayLike, velocity: ArrayLike) -> Launch: ...

    @classmethod
    def state(cls, position: ArrayLike, velocity: ArrayLike) -> Launch:
        """Position from the support, m, z down, and velocity, m/s: shape (..., 3) each.

        |position| must be the length, and the velocity at right angles to it, to a relative
        1e-9; what is left within that is projected away.
        """
        columns: list[ArrayLike] = []
        for name, value, unit in (("position", position, "m"), ("velocity", velocity, "m/s")):
            vector = np.asarray(as_numbers(value, f"launch.{name}", unit))
            if vector.shape[-1:] != (3,):
                raise InvalidInput.of("state_components", name=name, shape=str(vector.shape))
            columns += [vector[..., k] for k in range(3)]
        return cls._of("state", *columns)

    @overload
    @classmethod
    def at_rest(cls, theta: OneNumber, phi: OneNumber = ...) -> Launch[float]: ...

    @overload
    @classmethod
    def at_rest(cls, theta: ArrayLike, phi: ArrayLike = ...) -> Launch[Numbers]: ...

    @classmethod
    def at_rest(cls, theta: ArrayLike, phi: ArrayLike = 0.0) -> Launch:
        """Let go at the angle θ from the downward vertical, azimuth φ; rad."""
        return cls._of("at_rest", theta, phi)

    @classmethod
    def _of(cls, kind: str, *values: ArrayLike) -> Launch:
        return Launch(kind, cast("tuple[Scalars, ...]", values))

    def __post_init__(self) -> None:
        kind, values = _checked(self.kind, self.values)
        lock(values)
        object.__setattr__(self, "values", values)
        try:
            single = self.shape == ()
        except ValueError:
            raise unfit(f"the launch's {', '.join(self.kinds[kind])}", values) from None
        if single:
            problem = _core.launch_problem(kind, [float(value) for value in values])
            if problem is not None:
                raise InvalidInput.told(problem)

    def __reduce__(self) -> tuple[type[Launch], tuple[str, tuple[Scalars, ...]]]:
        return (Launch, (self.kind, self.values))

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the ensemble; () for a single launch."""
        return common_shape(self.values)

    @property
    def named(self) -> dict[str, Scalars]:
        """The numbers given, in SI, by their names."""
        return dict(zip(self.kinds[self.kind], self.values, strict=True))

    def columns(self, shape: tuple[int, ...]) -> list[Numbers]:
        """What the core takes for an ensemble of this shape, in the order of the values."""
        return [column(value, shape) for value in self.values]

    def __repr__(self) -> str:
        return spelled(f"Launch.{self.kind}", self.named, self.kinds[self.kind])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Launch):
            return NotImplemented
        theirs = cast("Launch", other)
        return self.kind == theirs.kind and equal(self.values, theirs.values)

    def __hash__(self) -> int:
        return hash((self.kind, hashed(self.values)))


def _checked(kind: object, values: object) -> tuple[str, tuple[Scalars, ...]]:
    """What was given for a launch made by hand; raises InvalidInput where it is none."""
    if not isinstance(kind, str) or kind not in Launch.kinds:
        listed = ", ".join(map(repr, Launch.kinds))
        raise InvalidInput.of("launch_kind", kinds=listed, seen=f"{kind!r:.80}")
    units = Launch.kinds[kind]
    given = cast("tuple[ArrayLike, ...]", values if isinstance(values, tuple) else ())
    if len(given) != len(units):
        names, count = ", ".join(units), str(len(units))
        seen = str(len(given)) if isinstance(values, tuple) else f"{values!r:.80}"
        raise InvalidInput.of("launch_values", kind=kind, count=count, names=names, seen=seen)
    return kind, tuple(
        value if type(value) is float else as_numbers(value, f"launch.{name}", unit)
        for (name, unit), value in zip(units.items(), given, strict=True)
    )
