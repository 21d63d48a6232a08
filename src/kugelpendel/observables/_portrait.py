"""What an uneven clamp makes of the plane of a swing: its orbit on the sphere of all ellipses."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Unpack

from numpy.typing import ArrayLike

from kugelpendel import _core
from kugelpendel.motion import EnvelopeMotion, RealMotion
from kugelpendel.motion._times import check_memory, checked_count
from kugelpendel.observables._ellipse import ellipse
from kugelpendel.parameters import (
    ForceParts,
    Forces,
    InvalidInput,
    Numbers,
    Pendulum,
    as_array,
    gathered,
    one_number,
    require_type,
    together,
)

VERDICTS = ("round", "to and fro", "stands")
"""What a plane does: it goes round and round, it turns back again and again, or it stays."""


@dataclass(frozen=True)
class Orbit:
    """The path of one ellipse over the sphere, closed, without drag and drive.

    Rates are in rad/s, azimuths in rad, both positive counter-clockwise seen from above.

    Attributes
    ----------
    circularity, longitude
        The start: u = 2ab/(a² + b²), and φ = 2(ψ − χ) in rad.
    limits
        Least and largest circularity on the way.
    verdict
        One of `VERDICTS`.
    period
        Time once round the orbit, s, in which a plane that goes round turns by half a turn;
        infinite on the separatrix.
    rate
        Mean rate of the plane; 0 where it does not go round.
    slowest, fastest
        Least and largest rate of the plane on the way, in the sense in which the Earth turns it.
    azimuths
        Between which a plane swings to and fro; infinite for one that goes round.
    widest
        Largest |b| on the way, m.
    """

    circularity: float
    longitude: float
    limits: tuple[float, float]
    verdict: str
    period: float
    rate: float
    slowest: float
    fastest: float
    azimuths: tuple[float, float]
    widest: float


@dataclass(frozen=True)
class Equilibrium:
    """An ellipse that keeps its shape and its direction.

    Attributes
    ----------
    circularity, longitude
        As in `Orbit`.
    stable
        Whether its neighbours stay near it; otherwise it is a saddle.
    """

    circularity: float
    longitude: float
    stable: bool


@dataclass(frozen=True, init=False)
class Portrait:
    """All ellipses of one size, in one clamp and on the turning Earth, as a map of a sphere.

    As polarised light on Poincaré's sphere: the sine of the latitude is the circularity
    u = 2ab/(a² + b²), the longitude φ = 2(ψ − χ) is twice the azimuth from the stiff axis. The
    poles are circles, the equator are straight swings. Without drag and drive every ellipse stays
    on a closed orbit; with drag the map changes slowly as the swing dies away.

    Parameters
    ----------
    pendulum
        A single one.
    a, b
        Semi-axes of the ellipse that is looked at, m, b positive counter-clockwise and no larger
        than a, a less than the length. Its a² + b² is that of all on this map.
    azimuth
        Of its major axis, rad, counter-clockwise from x.
    forces
        Of what acts only the site, the anisotropy of the suspension and the bob count here.
    parts
        In place of `forces`: site, drag, suspension, bob, drive.

    Raises
    ------
    InvalidInput
        For ensembles and semi-axes out of their range.

    Notes
    -----
    To second order in a/l for the ellipse's own turning and to first order in the anisotropy over
    ω0. On 450 random pendulums with a/l from 1e-3 to 0.13 the verdict is that of `EnvelopeMotion`
    450 times (benchmarks/portrait.py). The formulas and their sources are in docs/design.md.
    """

    pendulum: Pendulum
    a: float
    b: float
    azimuth: float
    forces: Forces

    def __init__(
        self,
        pendulum: Pendulum,
        a: float,
        b: float = 0.0,
        azimuth: float = 0.0,
        forces: Forces | None = None,
        **parts: Unpack[ForceParts],
    ):
        acting = gathered("Portrait", forces, parts)
        require_type("The pendulum", pendulum, Pendulum)
        numbers = (("a", a, "m"), ("b", b, "m"), ("azimuth", azimuth, "rad"))
        given = {"pendulum": pendulum, "forces": acting}
        given |= {name: one_number(value, name, unit) for name, value, unit in numbers}
        for name, value in given.items():
            object.__setattr__(self, name, value)
        for name, part in {"pendulum": pendulum, **acting.parts}.items():
            if part.shape != ():
                raise InvalidInput(
                    f"A portrait is of one pendulum, but the {name} has the shape {part.shape}; "
                    f"draw each case by itself."
                )
        length = float(self.pendulum.length)
        if not abs(self.b) <= self.a < length or not self.a > 0:
            raise InvalidInput(
                f"The semi-axes of a portrait's ellipse must obey |b| ≤ a < length and a > 0, but "
                f"a = {self.a:.6g} m, b = {self.b:.6g} m, and the length is {length:.6g} m."
            )
        if not math.isfinite(self.azimuth):
            raise InvalidInput(f"The azimuth must be finite, but it is {self.azimuth} rad.")

    @classmethod
    def of(cls, motion: RealMotion | EnvelopeMotion, t: float = 0.0) -> Portrait:
        """With the ellipse that a motion runs through at a time in s."""
        way_out = "write kp.RealMotion(pendulum, launch)"
        require_type("The motion", motion, RealMotion, EnvelopeMotion, way_out=way_out)
        if motion.shape != ():
            raise InvalidInput(
                f"A portrait is of one pendulum, but the motion has the shape {motion.shape}; draw "
                f"each case by itself."
            )
        time = one_number(t, "The time", "s")
        if isinstance(motion, EnvelopeMotion):
            (a, b), azimuth = motion.semi_axes(time), motion.azimuth(time)
        else:
            a, b, azimuth = ellipse(motion, time)
        axis = math.remainder(float(azimuth), math.pi)
        return cls(motion.pendulum, float(a), float(b), axis, motion.forces)

    @cached_property
    def _core(self) -> _core.Portraits:
        effective = self.forces.effective_pendulum(self.pendulum)
        pendulum = [float(value) for value in effective.values]
        site, suspension = self.forces.site, self.forces.suspension
        rotation = 0.0 if site is None else float(site.vertical_rotation)
        clamp = (0.0, 0.0)
        if suspension is not None:
            clamp = (float(suspension.anisotropy), float(suspension.axis))
        return _core.Portraits.of(pendulum, rotation, clamp, (self.a, self.b))

    @property
    def axis(self) -> float:
        """χ, the azimuth of the axis of the higher frequency, rad."""
        return self._core.values()[2]

    @cached_property
    def orbit(self) -> Orbit:
        """Of the ellipse that is looked at."""
        circularity, longitude = self._core.form(self.a, self.b, self.azimuth)
        row = self._core.orbit(circularity, longitude)
        _, (low, high), verdict, period, rate, slowest, fastest, (left, right) = row
        size = math.hypot(self.a, self.b)
        widest = size * abs(_core.Portraits.semi_axes(max(-low, high))[1])
        return Orbit(
            circularity, longitude, (low, high), verdict, period, rate, slowest, fastest,
            (left, right), widest,
        )  # fmt: skip

    def path(self, count: int = 400) -> tuple[Numbers, Numbers]:
        """Circularity and longitude, rad from −π to π, along the orbit, once round it.

        Both have the shape (count,); places are evenly apart in an angle, not in time.
        """
        places = checked_count(count, 1, "The count of places")
        check_memory(places, 2)
        return self._core.path(self.orbit.circularity, self.orbit.longitude, places)

    @cached_property
    def equilibria(self) -> tuple[Equilibrium, ...]:
        """Two that are stable, or three and a saddle."""
        return tuple(Equilibrium(*row) for row in self._core.equilibria())

    def invariant(self, circularity: ArrayLike, longitude: ArrayLike) -> Numbers:
        """H at places on the sphere, rad/s, in the shape to which the arguments broadcast.

        δ√(1−u²) cos φ − 2Ω_z u + μu²/2, constant on every orbit.
        """
        u, phi = _places(circularity, longitude)
        return self._core.invariants(u.ravel(), phi.ravel()).reshape(u.shape)

    def mean_rate(self, circularity: ArrayLike, longitude: ArrayLike) -> Numbers:
        """Mean rate of the plane from places on the sphere, rad/s; 0 where it does not go round."""
        u, phi = _places(circularity, longitude)
        return self._core.rates(u.ravel(), phi.ravel()).reshape(u.shape)


def _places(circularity: ArrayLike, longitude: ArrayLike) -> tuple[Numbers, ...]:
    return together(
        "circularity and longitude",
        as_array(circularity, "The circularity", ""),
        as_array(longitude, "The longitude", "rad"),
    )
