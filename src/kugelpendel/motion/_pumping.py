"""Whether a drive would lift the bob to its support, for want of drag."""

from __future__ import annotations

import numpy as np

from kugelpendel.motion._exact import ExactMotion
from kugelpendel.parameters import Drag, Drive, InvalidInput, Launch, Numbers, Pendulum

_LOOKS = 400
"""Amplitudes at which gain and loss are compared."""


def refuse_pumping(
    pendulum: Pendulum, launch: Launch, drag: Drag | None, drive: Drive | None
) -> None:
    """Refuse a drive that gives more than the drag takes at every amplitude up to the support.

    Gain and loss are those of small straight swings: in each half swing the push p gives
    Δa = p cos φ/ω0, φ the phase after the closest approach, and drag takes
    (π/ω0)(γa + (4/3π) c ω0 a²).

    Parameters
    ----------
    pendulum
        With the gravity that acts.
    launch
        From its amplitude on the swing would grow.
    drag, drive
        None where there is none.

    Raises
    ------
    InvalidInput
        The swing would grow to the length; the sentence says which push keeps its amplitude. Not
        for ensembles, nor for launches that rise to the support by themselves.
    """
    if drive is None:
        return
    exact = ExactMotion(pendulum, launch)
    parts = (exact.shape, drive.shape, () if drag is None else drag.shape)
    if np.broadcast_shapes(*parts) != () or exact.turning_heights[0] >= pendulum.length:
        return
    length, omega0 = float(pendulum.length), float(pendulum.angular_frequency)
    amplitude = np.linspace(float(exact.turning_radii[0]), length, _LOOKS)
    leverage, loss = _leverage(drive, amplitude), _loss(drag, omega0, amplitude)
    push = float(drive.push)
    if (push * leverage <= loss).any():
        return
    way_out = "give it a drag"
    if loss[0] > 0:
        way_out = f"push={loss[0] / leverage[0]:.4g} keeps an amplitude of {amplitude[0]:.4g} m"
    raise InvalidInput(
        f"The drive's push of {push:.6g} m/s pumps without end: at every amplitude from "
        f"{amplitude[0]:.4g} m up to the length, {length:.6g} m, it gives more than the drag "
        f"takes; {way_out}."
    )


def _leverage(drive: Drive, amplitude: Numbers) -> Numbers:
    """Gain of amplitude in half a swing times ω0, for each unit of the push: the phase's cosine."""
    if drive.radius is None:
        return np.full_like(amplitude, np.cos(0.0 if drive.phase is None else drive.phase))
    share = np.divide(drive.radius, amplitude, out=np.ones_like(amplitude), where=amplitude > 0)
    return np.sqrt(np.clip(1 - share**2, 0.0, None))


def _loss(drag: Drag | None, omega0: float, amplitude: Numbers) -> Numbers:
    """Loss of amplitude in half a swing times ω0, m/s."""
    if drag is None:
        return np.zeros_like(amplitude)
    linear, quadratic = (float(value) for value in drag.values)
    return np.pi * linear * amplitude + 4 / 3 * quadratic * omega0 * amplitude**2
