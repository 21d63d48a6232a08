"""MuJoCo's spherical pendulum: a small round body on a ball joint, no damping, no contacts.

A ball joint needs some inertia about the rod. With the same moment I in every direction and no
spin, the body moves as a point at d + I/(m d); d is chosen to make that the length.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import mujoco
import numpy as np
import numpy.typing as npt

from contenders.cartesian import GRAVITY, LENGTH, OMEGA, A, B
from contenders.turning_points import Path

STEP = 1e-3  # s: ours to choose; a two-thousandth of a period
INERTIA = 1e-6  # kg m², of a mass of 1 kg


def runner(times: np.ndarray) -> Callable[[], Path]:
    """A function that runs from the launch over evenly spaced times, whole steps apart."""
    d = (LENGTH + math.sqrt(LENGTH**2 - 4 * INERTIA)) / 2
    model = mujoco.MjModel.from_xml_string(
        f"""
        <mujoco>
          <option timestep="{STEP}" integrator="RK4" gravity="0 0 {-GRAVITY}">
            <flag contact="disable" constraint="disable"/>
          </option>
          <worldbody>
            <body>
              <joint type="ball"/>
              <inertial pos="0 0 {-d!r}" mass="1" diaginertia="{INERTIA} {INERTIA} {INERTIA}"/>
            </body>
          </worldbody>
        </mujoco>
        """
    )
    data = mujoco.MjData(model)
    lean = math.asin(A / LENGTH)  # about -y, z up
    stride = round((times[1] - times[0]) / STEP)

    def run() -> Path:
        mujoco.mj_resetData(model, data)
        data.qpos[:] = math.cos(lean / 2), 0.0, -math.sin(lean / 2), 0.0
        data.qvel[:] = B * OMEGA / LENGTH, 0.0, 0.0  # in the body's frame
        turned, spin = np.empty((times.size, 4)), np.empty((times.size, 3))
        turned[0], spin[0] = data.qpos, data.qvel
        for row in range(1, times.size):
            mujoco.mj_step(model, data, nstep=stride)
            turned[row], spin[row] = data.qpos, data.qvel
        place, speed = along(turned, (0, 0, -LENGTH)), np.cross(spin, (0, 0, -LENGTH))
        return place * (1, 1, -1), along(turned, speed) * (1, 1, -1)

    return run


def along(turned: np.ndarray, vector: npt.ArrayLike) -> np.ndarray:
    """Vectors of the body's frame, seen from the world: rotation by unit quaternions."""
    w, axis = turned[:, :1], turned[:, 1:]
    vector = np.asarray(vector, dtype=float)
    twice = 2 * np.cross(axis, vector)
    return vector + w * twice + np.cross(axis, twice)
