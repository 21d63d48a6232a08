"""The full equations once more, for an integrator that is not ours."""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp

import kugelpendel as kp

NO_FORCES = {"gamma": 0.0, "c": 0.0, "up": 0.0, "north": 0.0, "delta": 0.0, "chi": 0.0,
             "fading": 0.0, "chi_d": 0.0}  # fmt: skip


def slope(length: float, gravity: float, **forces: float):
    """d(r, v)/dt in SI with up = −z and right-handed vector algebra (x east, y north, z up)."""
    f = NO_FORCES | forces
    omega0 = np.sqrt(gravity / length)
    rotation = np.array([0.0, f["north"], f["up"]])
    stiff = np.array([np.cos(f["chi"]), np.sin(f["chi"]), 0.0])
    damped = np.array([np.cos(f["chi_d"]), np.sin(f["chi_d"]), 0.0])

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        r, v = state[:3], state[3:]
        flat = np.array([v[0], v[1], 0.0])
        force = (
            np.array([0.0, 0.0, -gravity])
            - 2 * np.cross(rotation, v)
            - 2 * f["gamma"] * v
            - f["c"] * np.linalg.norm(v) * v
            - 2 * omega0 * f["delta"] * (r @ stiff) * stiff
            - f["fading"] * (2 * (v @ damped) * damped - flat)
        )
        pull = (v @ v + force @ r) / (r @ r)
        return np.concatenate([v, force - pull * r])

    return rates


def integrated(motion: kp.RealMotion, times: np.ndarray, **forces: float) -> np.ndarray:
    """Positions, z down, by DOP853."""
    length, gravity, _ = (float(value) for value in motion.effective_pendulum.values)
    flip = np.array([1.0, 1.0, -1.0])
    start = np.concatenate([motion.position(0.0) * flip, motion.velocity(0.0) * flip])
    done = solve_ivp(
        slope(length, gravity, **forces), (0.0, times[-1]), start, "DOP853",
        t_eval=times, rtol=1e-12, atol=1e-13,
    )  # fmt: skip
    assert done.success
    return done.y[:3].T * flip
