"""Worlds in which a condition of the first equations does not hold.

Each is a moment of a motion in which that condition alone fails, computed as those of `worlds` are.
"""

from __future__ import annotations

from functools import cache
from random import Random

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.sympy_names import Expr, mp, mpf
from kugelpendel.paper.proofs.worlds import Number, Vector, World, common, dot, draw, moment


def _elsewhere(rng: Random) -> tuple[dict[Expr, Number], Vector, Vector]:
    """Constants, a place on the lower half of the sphere, and a velocity along it."""
    constants = common(rng)
    length = constants[s.l]
    px, py = (length * draw(rng, 0.2, 0.5) for _ in range(2))
    vx, vy = (length * draw(rng, 0.5, 1.5) for _ in range(2))
    height = mp.sqrt(length**2 - px**2 - py**2)
    constants[s.omega0] = mp.sqrt(constants[s.g] / length)
    return constants, (px, py, height), (vx, vy, -(px * vx + py * vy) / height)


def _pulled(constants: dict[Expr, Number], place: Vector, speed: Vector) -> Number:
    """Give the T that keeps the bob on the sphere."""
    mass, length = constants[s.m], constants[s.l]
    return mass * (dot(speed, speed) + constants[s.g] * place[2]) / length


def _accelerated(constants: dict[Expr, Number], place: Vector, up: Vector) -> Vector:
    """Give gravity and the thread's pull, per mass; gravity points against `up`."""
    pull = constants[s.T] / (constants[s.m] * constants[s.l])
    gravity = constants[s.g]
    x, y, z = (-gravity * up[k] - pull * place[k] for k in range(3))
    return x, y, z


@cache
def slack(seed: int) -> World:
    """The thread would have to push, T < 0, and so the bob falls freely inside the sphere."""
    rng = Random(f"slack {seed}")
    constants, (px, py, height), speed = _elsewhere(rng)
    inside = draw(rng, 0.5, 0.9)
    place = (inside * px, inside * py, -inside * height)
    slow = (speed[0] / 100, speed[1] / 100, speed[2] / 100)
    constants[s.T] = _pulled(constants, place, slow)
    free = (mpf(0), mpf(0), constants[s.g])
    return moment(constants, place, slow, free, rng)


@cache
def turning_frame(seed: int) -> World:
    """The pendulum in a frame that turns: Coriolis' acceleration comes to gravity and pull."""
    rng = Random(f"turning frame {seed}")
    constants, place, speed = _elsewhere(rng)
    constants[s.T] = _pulled(constants, place, speed)
    x, y, z = _accelerated(constants, place, (mpf(0), mpf(0), mpf(-1)))
    turn = draw(rng, 0.1, 0.5)
    return moment(
        constants, place, speed, (x + 2 * turn * speed[1], y - 2 * turn * speed[0], z), rng
    )


@cache
def upwards(seed: int) -> World:
    """The pendulum with z counted upwards, and θ still from straight down."""
    rng = Random(f"upwards {seed}")
    constants, (px, py, height), (vx, vy, vz) = _elsewhere(rng)
    constants[s.T] = _pulled(constants, (px, py, height), (vx, vy, vz))
    place, speed = (px, py, -height), (vx, vy, -vz)
    push = _accelerated(constants, place, (mpf(0), mpf(0), mpf(1)))
    world = moment(constants, place, speed, push, rng)
    down = world.paths[s.theta]
    world.paths[s.theta] = lambda tau: mp.pi - down(tau)
    return world
