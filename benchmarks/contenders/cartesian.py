"""The pendulum as the integrators get it: Cartesian, z down.

r'' = g e_z - Λ r with Λ = (v² + g z)/(r·r) stays on the sphere; dividing by l² instead drifts off.
"""

from __future__ import annotations

import math

import heyoka as hy
import numpy as np

LENGTH, GRAVITY = 1.0, 9.80665  # m, m/s²: the laboratory pendulum
A, B = 0.2, 0.1  # m: displaced by A, pushed sideways with B·ω0
OMEGA = math.sqrt(GRAVITY / LENGTH)
PERIOD = 2 * math.pi / OMEGA  # s: a period of small swings, the unit of "100 periods"


def start() -> list[float]:
    """Position (m) and velocity (m/s) at the launch."""
    return [A, 0.0, math.sqrt(LENGTH**2 - A**2), 0.0, B * OMEGA, 0.0]


def slope(_: float, state: np.ndarray) -> list[float]:
    """Time derivative for solve_ivp; plain floats are faster than arrays of three."""
    x, y, z, vx, vy, vz = state.tolist()
    pull = (vx * vx + vy * vy + vz * vz + GRAVITY * z) / (x * x + y * y + z * z)
    return [vx, vy, vz, -pull * x, -pull * y, GRAVITY - pull * z]


def heyoka() -> hy.taylor_adaptive:
    """Heyoka's integrator at its own tolerance, which is machine precision; compiled here."""
    x, y, z, vx, vy, vz = hy.make_vars("x", "y", "z", "vx", "vy", "vz")
    pull = (vx * vx + vy * vy + vz * vz + GRAVITY * z) / (x * x + y * y + z * z)
    force = [(vx, -pull * x), (vy, -pull * y), (vz, GRAVITY - pull * z)]
    return hy.taylor_adaptive([(x, vx), (y, vy), (z, vz), *force], start())


def rewind(integrator: hy.taylor_adaptive) -> None:
    """Back to the launch, without compiling again."""
    integrator.time = 0.0
    integrator.state[:] = start()
