"""Numbers in which a formula is true or false, found without the paper's algebra.

Every quantity is computed from its meaning: positions by turning the plumb line, rates by numerical
differentiation, accelerations from d'Alembert's principle, frequencies of the balanced ellipse by
solving for them. Working precision: 60 digits; 50 are asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from random import Random
from typing import Any

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.symbols import CIRCLES, RATE, SYMBOL, Ddt, Integrated
from kugelpendel.paper.algebra.sympy_names import (
    Abs,
    Add,
    Expr,
    I,
    Mul,
    Pow,
    cos,
    mp,
    mpc,
    mpf,
    pi,
    sin,
)
from kugelpendel.paper.proofs.quadrature import Number, over_swing

DIGITS = 60
Path = Callable[[Number], Number]
Vector = tuple[Number, Number, Number]

_BASE = {dot: q for q, dot in RATE.items()}


class World:
    """Values of the paper's letters, as functions of a time τ around 0.

    `constants` do not change; `paths` do; `phases` are angles like ωt, with their rate. Derivatives
    are taken numerically from the paths.
    """

    def __init__(
        self,
        constants: dict[Expr, Number],
        paths: dict[Expr, Path],
        phases: dict[Expr, tuple[Number, Number]] | None = None,
    ):
        self.constants = constants
        self.paths = paths
        self.phases = phases or {}
        self._known: dict[Expr, Number] = {}

    def value(self, expression: Expr, tau: Number = 0) -> Number:
        """The expression's value at τ; at τ = 0 remembered, so that mutants share what is equal."""
        if tau != 0:
            return self._compute(expression, tau)
        if expression not in self._known:
            self._known[expression] = self._compute(expression, tau)
        return self._known[expression]

    def _compute(self, e: Expr, tau: Number) -> Number:
        if e.is_Symbol:
            return self._letter(e, tau)
        if e is I:
            return mpc(0, 1)
        if e is pi:
            return +mp.pi
        if e.is_Rational:
            return mpf(int(e.p)) / int(e.q)
        if isinstance(e, Add):
            return mp.fsum(self.value(term, tau) for term in e.args)
        if isinstance(e, Mul):
            return mp.fprod(self.value(factor, tau) for factor in e.args)
        if isinstance(e, Pow):
            return self._power(e, tau)
        if isinstance(e, (sin, cos)):
            function = mp.sin if isinstance(e, sin) else mp.cos
            return function(self._angle(e.args[0], tau))
        if isinstance(e, Abs):
            return abs(self.value(e.args[0], tau))
        if isinstance(e, Ddt):
            return mp.diff(partial(self.value, e.args[0]), tau)
        if isinstance(e, Integrated):
            return self._integral(e, tau)
        raise TypeError(f"{e} is not an expression of the paper.")

    def _integral(self, e: Expr, tau: Number) -> Number:
        """Between two values of u, near which 20 digits go: differences of nearly equal numbers."""
        integrand, lower, upper = e.args
        with mp.workdps(mp.dps + 20):
            others = integrand.free_symbols - {s.u}
            known = {letter: self.value(letter, tau) for letter in others}
            bounds = self.value(lower, tau), self.value(upper, tau)
            found = over_swing(
                lambda u: World({**known, s.u: u}, {}).value(integrand), *bounds, mp.dps - 18
            )
        return +found

    def _power(self, e: Expr, tau: Number) -> Number:
        base, exponent = self.value(e.base, tau), e.exp
        if exponent.is_Integer:
            return base ** int(exponent)
        return mp.sqrt(base) ** int(2 * exponent)

    def _angle(self, angle: Expr, tau: Number) -> Number:
        factor, base = angle.as_coeff_Mul()
        if base in self.phases:
            phase, rate = self.phases[base]
            return int(factor) * (phase + rate * tau)
        return self.value(angle, tau)

    def _letter(self, symbol: Expr, tau: Number) -> Number:
        if symbol in self.constants:
            return self.constants[symbol]
        order, base = 0, symbol
        while base not in self.paths:
            base = _BASE[base]
            order += 1
        path = self.paths[base]
        return path(tau) if order == 0 else mp.diff(path, tau, order)


def draw(rng: Random, low: float, high: float) -> Number:
    """Draw a number between two bounds, with 160 random bits."""
    return mpf(low) + (mpf(high) - mpf(low)) * mpf(rng.getrandbits(160)) / (1 << 160)


def turned(theta: Number, phi: Number, vector: Vector) -> Vector:
    """The vector turned by θ from z towards x, then by φ about z."""
    vx, vy, vz = vector
    vx, vz = mp.cos(theta) * vx + mp.sin(theta) * vz, mp.cos(theta) * vz - mp.sin(theta) * vx
    return (mp.cos(phi) * vx - mp.sin(phi) * vy, mp.sin(phi) * vx + mp.cos(phi) * vy, vz)


def dot(u: Vector, v: Vector) -> Number:
    """Give the scalar product."""
    return mp.fsum(p * q for p, q in zip(u, v, strict=True))


def _about_axis(axis: int, angle: Number, vector: Vector) -> Vector:
    """Turned about x (0), y (1) or z (2), from the next axis to the one after it."""
    rolled = [vector[(axis + k) % 3] for k in range(3)]
    c, si = mp.cos(angle), mp.sin(angle)
    rolled[1], rolled[2] = c * rolled[1] - si * rolled[2], si * rolled[1] + c * rolled[2]
    back = [rolled[(k - axis) % 3] for k in range(3)]
    return (back[0], back[1], back[2])


def _component(k: int, axis: int, vector: Vector, angle: Number) -> Number:
    return _about_axis(axis, angle, vector)[k]


def common(rng: Random) -> dict[Expr, Number]:
    """With an ω and an Ω that no right formula of sections 1 to 3 contains, but mutants do."""
    ranges = {s.m: (0.5, 2), s.g: (5, 12), s.l: (0.5, 2), s.omega: (1, 3), s.Omega: (0.1, 0.9)}
    return {letter: draw(rng, low, high) for letter, (low, high) in ranges.items()}


def _with_vectors(constants: dict[Expr, Number], paths: dict[Expr, Path], rng: Random) -> World:
    """Adds unit vectors, as their components along a random direction, and angular momentum."""
    theta, phi = paths[s.theta](0), paths[s.phi](0)
    along = tuple(draw(rng, -1, 1) for _ in range(3))
    triad = ((0, 0, 1), (1, 0, 0), (0, 1, 0))  # r, θ, φ at θ = φ = 0
    for unit, start in zip(s.SPHERICAL, triad, strict=True):
        constants[unit] = dot(along, turned(theta, phi, tuple(map(mpf, start))))
    constants.update(zip(s.CARTESIAN, along, strict=True))
    place = tuple(paths[q](0) for q in (s.x, s.y, s.z))
    speed = tuple(mp.diff(paths[q], 0) for q in (s.x, s.y, s.z))
    for axis, name in enumerate(("L_x", "L_y", "L_z")):
        turning = tuple(mp.diff(partial(_component, k, axis, place), 0) for k in range(3))
        constants[SYMBOL[name]] = constants[s.m] * dot(speed, turning)
    length, gravity = constants[s.l], constants[s.g]
    constants[s.E] = dot(speed, speed) / 2 + gravity * (length - place[2])
    constants[s.h] = (place[0] * speed[1] - place[1] * speed[0]) / length**2
    return World(constants, paths)


@cache
def kinematic(seed: int, above: bool = False) -> World:
    """Any motion on the sphere, whether forces allow it or not; on its lower half, or `above`."""
    rng = Random(f"kinematic {seed}")
    constants = common(rng)
    length = constants[s.l]
    thetas = [draw(rng, 0.3, 1.2), *(draw(rng, 0.3, 1.5) for _ in range(3))]
    if above:
        thetas[0] = mp.pi - thetas[0]
    phis = [draw(rng, 0.3, 1.2), *(draw(rng, 0.3, 1.5) for _ in range(3))]

    def theta(tau: Number) -> Number:
        return mp.fsum(c * tau**k / mp.factorial(k) for k, c in enumerate(thetas))

    def phi(tau: Number) -> Number:
        return mp.fsum(c * tau**k / mp.factorial(k) for k, c in enumerate(phis))

    def place(tau: Number) -> Vector:
        return turned(theta(tau), phi(tau), (mpf(0), mpf(0), length))

    paths = _cartesian(place) | {s.theta: theta, s.phi: phi}
    constants[s.T] = draw(rng, 1, 5)
    constants[s.omega0] = mp.sqrt(constants[s.g] / length)
    return _with_vectors(constants, paths, rng)


def _cartesian(place: Callable[[Number], Vector]) -> dict[Expr, Path]:
    return {
        s.x: lambda tau: place(tau)[0],
        s.y: lambda tau: place(tau)[1],
        s.z: lambda tau: place(tau)[2],
        s.rho: lambda tau: mp.hypot(place(tau)[0], place(tau)[1]),
        s.r: lambda tau: mp.sqrt(dot(place(tau), place(tau))),
    }


@cache
def dynamic(seed: int, exponent: int = 0) -> World:
    """A moment of the pendulum's motion; sizes are scaled by ε = 10^−exponent.

    The acceleration is the one that does no work against gravity along any displacement on the
    sphere (d'Alembert), and keeps the bob on it.
    """
    rng = Random(f"dynamic {seed}")
    constants = common(rng)
    length, gravity, mass = constants[s.l], constants[s.g], constants[s.m]
    eps = mpf(10) ** (-exponent)
    px, py = (eps * length * draw(rng, 0.2, 0.6) for _ in range(2))
    vx, vy = (eps * length * draw(rng, 0.5, 2.5) for _ in range(2))
    place = (px, py, mp.sqrt(length**2 - px**2 - py**2))
    speed = (vx, vy, -(px * vx + py * vy) / place[2])
    across = [(mpf(1), mpf(0), -px / place[2]), (mpf(0), mpf(1), -py / place[2])]
    left = mp.matrix([*across, place])
    right = mp.matrix([gravity * across[0][2], gravity * across[1][2], -dot(speed, speed)])
    push = mp.lu_solve(left, right)
    pull = (-push[0], -push[1], gravity - push[2])
    constants[s.T] = mass * dot(pull, place) / length
    constants[s.omega0] = mp.sqrt(gravity / length)
    return moment(constants, place, speed, (push[0], push[1], push[2]), rng)


def moment(
    constants: dict[Expr, Number], place: Vector, speed: Vector, push: Vector, rng: Random
) -> World:
    """A motion with that place, velocity and acceleration, seen at the moment when it has them."""

    def at(tau: Number) -> Vector:
        x, y, z = (place[k] + speed[k] * tau + push[k] * tau**2 / 2 for k in range(3))
        return x, y, z

    paths = _cartesian(at)
    paths[s.theta] = lambda tau: mp.atan2(mp.hypot(at(tau)[0], at(tau)[1]), at(tau)[2])
    paths[s.phi] = lambda tau: mp.atan2(at(tau)[1], at(tau)[0])
    return _with_vectors(constants, paths, rng)


@cache
def linear(seed: int) -> World:
    """The linear oscillator ẍ = −ω0² x from the place (a, 0) with the velocity (0, bω0).

    Its motion is summed from the power series that the equation itself gives.
    """
    rng = Random(f"linear {seed}")
    constants = common(rng)
    constants |= {s.a: draw(rng, 0.5, 2), s.b: draw(rng, 0.3, 1.5), s.omega0: draw(rng, 1, 3)}
    rate, start = constants[s.omega0], draw(rng, 0.2, 0.6)
    constants[s.t] = start

    def series(place: Number, speed: Number, time: Number) -> Number:
        total, k = mpf(0), 0
        even, odd = place, speed * time
        while abs(even) + abs(odd) > mpf(10) ** (-mp.dps - 5):
            total += even + odd
            k += 2
            even *= -((rate * time) ** 2) / (k * (k - 1))
            odd *= -((rate * time) ** 2) / (k * (k + 1))
        return total

    paths: dict[Expr, Path] = {
        s.x: lambda tau: series(constants[s.a], mpf(0), start + tau),
        s.y: lambda tau: series(mpf(0), constants[s.b] * rate, start + tau),
    }
    return World(constants, paths)


def circles(constants: dict[Expr, Number]) -> dict[Expr, Number]:
    """Give the two circular motions of an ellipse, from its semi-axes and frequencies."""
    return {letter: World(constants, {}).value(e) for letter, e in CIRCLES.items()}


def _ellipse(constants: dict[Expr, Number], swing: Number, turn: Number) -> World:
    """The turning ellipse at the phases ωt = swing, Ωt = turn."""
    a, b = constants[s.a], constants[s.b]
    fast, slow = constants[s.omega], constants[s.Omega]

    def resting(tau: Number) -> Number:
        wheel = mp.expj(swing + fast * tau)
        return (a + b) / 2 * wheel + (a - b) / 2 / wheel

    def plan(tau: Number) -> Number:
        return resting(tau) * mp.expj(turn + slow * tau)

    paths: dict[Expr, Path] = {
        s.x: lambda tau: mpc(plan(tau)).real,
        s.y: lambda tau: mpc(plan(tau)).imag,
        s.rho: lambda tau: abs(plan(tau)),
        s.xp: lambda tau: mpc(resting(tau)).real,
        s.yp: lambda tau: mpc(resting(tau)).imag,
    }
    both = circles(constants)
    phases = {
        s.omega * s.t: (swing, fast),
        s.Omega * s.t: (turn, slow),
        s.omega_1 * s.t: (swing + turn, both[s.omega_1]),
        s.omega_2 * s.t: (swing - turn, both[s.omega_2]),
    }
    return World({**constants, **both}, paths, phases)


def _slow_constants(rng: Random, exponent: int) -> dict[Expr, Number]:
    eps = mpf(10) ** (-exponent)
    constants = {s.l: draw(rng, 0.7, 1.5), s.omega0: draw(rng, 1, 3)}
    constants[s.a] = eps * draw(rng, 0.8, 1.4)
    constants[s.b] = eps * draw(rng, 0.2, 0.6) * rng.choice((1, -1))
    constants[s.omega] = mp.sqrt(constants[s.omega0] ** 2 + eps**2 * draw(rng, -1, -0.3))
    constants[s.Omega] = eps**2 * draw(rng, 0.3, 0.9)
    return constants


@cache
def ellipse(seed: int, exponent: int = 0, beat: int = -1, beats: int = 8) -> World:
    """The ansatz with any ω and Ω, whether it moves so or not.

    With `beat`, the swing's phase is that fraction of a turn, to take harmonics from.
    """
    rng = Random(f"ellipse {seed}")
    constants = _slow_constants(rng, exponent)
    swing, turn = draw(rng, 0.3, 1.2), draw(rng, 0.3, 1.2)
    if beat >= 0:
        swing = 2 * mp.pi * beat / beats
    constants[s.t] = mpf(1)
    return _ellipse(constants, swing, turn)


@cache
def balanced(seed: int, exponent: int) -> World:
    """The ansatz with the ω and Ω at which the first harmonics of (13a) cancel, solved for."""
    rng = Random(f"ellipse {seed}")
    constants = _slow_constants(rng, exponent)
    eps = mpf(10) ** (-exponent)

    def imbalance(shift: Number, turning: Number) -> Any:
        constants[s.omega] = mp.sqrt(constants[s.omega0] ** 2 + eps**2 * shift)
        constants[s.Omega] = eps**2 * turning
        return mp.matrix([value / eps**3 for value in _first_harmonics(constants)])

    # linear but for terms of order ε²: four steps with one slope, each 2·EXPONENT digits better
    origin = imbalance(mpf(0), mpf(0))
    slope = mp.matrix(2, 2)
    slope[:, 0] = imbalance(mpf(1), mpf(0)) - origin
    slope[:, 1] = imbalance(mpf(0), mpf(1)) - origin
    found = mp.matrix(2, 1)
    for _ in range(2 + mp.dps // (2 * exponent)):
        found -= mp.lu_solve(slope, imbalance(found[0], found[1]))
    imbalance(found[0], found[1])
    return _ellipse(constants, draw(rng, 0.3, 1.2), draw(rng, 0.3, 1.2))


def _first_harmonics(constants: dict[Expr, Number], beats: int = 8) -> tuple[Number, Number]:
    """Of the left side of (13a), as cos ωt cos Ωt and sin ωt sin Ωt: by sums over a swing.

    The motion is that of two counter-rotating wheels; a rate multiplies each by i times its own.
    """
    rate, length = constants[s.omega0], constants[s.l]
    a, b = constants[s.a], constants[s.b]
    fast, slow = constants[s.omega], constants[s.Omega]
    wheels = (((a + b) / 2, slow + fast, 1), ((a - b) / 2, slow - fast, -1))
    sums: list[Number] = []
    for turn, weight in ((mpf(0), mp.cos), (mp.pi / 2, mp.sin)):
        total = mpf(0)
        for beat in range(beats):
            swing = 2 * mp.pi * beat / beats
            plan = [
                sum(
                    size * mpc(0, own) ** k * mp.expj(turn + way * swing)
                    for size, own, way in wheels
                )
                for k in range(3)
            ]
            place, speed, push = plan
            pull = push.real + rate**2 * place.real * (1 - abs(place) ** 2 / (2 * length**2))
            total += (pull + place.real * abs(speed) ** 2 / length**2) * weight(swing)
        sums.append(2 * total / beats)
    return sums[0], sums[1]
