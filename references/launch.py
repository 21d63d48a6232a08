"""What is given: a case with its binary64 inputs, and the exact start that follows from them."""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from references import fixed
from references.taylor import State

Vector = tuple[arb, arb, arb]


@dataclass(frozen=True)
class Case:
    """One reference motion. SI units; every number is a binary64 number taken exactly.

    ``motion`` names what the generator has to know beforehand: "general", "plane" (angular momentum
    exactly 0), "separatrix", "cone" (height exactly constant), "rest", "upright". ``check`` is the
    time in small-oscillation periods up to which the direct integration is run as a check.
    """

    regime: str
    length: float
    gravity: float
    kind: str
    state: tuple[float, ...]
    times: tuple[float, ...]
    motion: str = "general"
    check: float = 6.0

    @property
    def inputs(self) -> tuple[float, ...]:
        """Length, gravity, then the state."""
        return (self.length, self.gravity, *self.state)


@dataclass(frozen=True)
class Start:
    """Position (m) and velocity (m/s) at time 0 on the sphere, with the pendulum, as Arb balls."""

    length: arb
    gravity: arb
    position: Vector
    velocity: Vector

    @property
    def angular_frequency(self) -> arb:
        """ω0, rad/s."""
        return (self.gravity / self.length).sqrt()

    @property
    def energy(self) -> arb:
        """J/kg above the lowest point."""
        return _dot(self.velocity, self.velocity) / 2 + self.gravity * (
            self.length - self.position[2]
        )

    @property
    def angular_momentum(self) -> arb:
        """x vy − y vx, m²/s, positive counter-clockwise seen from above."""
        (x, y, _), (vx, vy, _) = self.position, self.velocity
        return x * vy - y * vx

    def scaled(self, bits: int) -> State:
        """Position in lengths, velocity in length·ω0, fixed point."""
        speed = self.length * self.angular_frequency
        numbers = [r / self.length for r in self.position] + [v / speed for v in self.velocity]
        x, y, z, u, v, w = (fixed.from_arb(number, bits) for number in numbers)
        return (x, y, z, u, v, w)


def start(kind: str, inputs: list[arb]) -> Start:
    """The start of a launch from length, gravity and its state.

    A "state" that is off the sphere (only the perturbed ones are) is moved radially onto it, and
    the radial part of its velocity dropped.
    """
    length, gravity, *given = inputs
    if kind == "angles":
        theta, phi, theta_rate, phi_rate = given
        (st, ct), (sp, cp) = (theta.sin(), theta.cos()), (phi.sin(), phi.cos())
        position = (length * st * cp, length * st * sp, length * ct)
        velocity = (
            length * (theta_rate * ct * cp - phi_rate * st * sp),
            length * (theta_rate * ct * sp + phi_rate * st * cp),
            -length * theta_rate * st,
        )
    elif kind == "plane":
        x, y, vx, vy = given
        z = (length * length - x * x - y * y).sqrt()
        position, velocity = (x, y, z), (vx, vy, -(x * vx + y * vy) / z)
    elif kind == "state":
        x, y, z, vx, vy, vz = given
        radius = (x * x + y * y + z * z).sqrt()
        outward = (x / radius, y / radius, z / radius)
        radial = vx * outward[0] + vy * outward[1] + vz * outward[2]
        position = (length * outward[0], length * outward[1], length * outward[2])
        velocity = (vx - radial * outward[0], vy - radial * outward[1], vz - radial * outward[2])
    else:
        raise ValueError(f"unknown kind {kind!r}; known: angles, plane, state")
    return Start(length, gravity, position, velocity)


def is_plane(kind: str, state: tuple[float, ...]) -> bool:
    """Whether the angular momentum is exactly 0 in exact arithmetic."""
    if kind == "angles":
        return state[3] == 0.0 or state[0] == 0.0
    x, y = Fraction(state[0]), Fraction(state[1])
    vx, vy = (Fraction(v) for v in (state[2:4] if kind == "plane" else state[3:5]))
    return x * vy == y * vx


def _dot(a: Vector, b: Vector) -> arb:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
