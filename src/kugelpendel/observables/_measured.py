"""Frequency and precession of any motion, measured at its outer turning points."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kugelpendel.motion import Motion
from kugelpendel.parameters import Numbers

_HALF_SWINGS = 64
"""So many are averaged over: what an integrator leaves in one of them counts a 64th."""

_GRID = 24
"""Points a half swing that look for the change of sign."""

_ROUNDS = 60
"""Of the bracketing: it doubles the digits most of the time, and halves the bracket at worst."""

_ROUND_ENOUGH = 1e-9
"""Relative change of ρ² below which turning points drown in the tolerance of an integrator."""

_STANDSTILL = 1e-9
"""rad turned in all those half swings below which that is noise too."""


class Rates(NamedTuple):
    """Measured rates, rad/s; None for what the motion does not show."""

    frequency: float | None
    precession: float | None


def measured_rates(motion: Motion, half_swing: float) -> Rates:
    """Rates as a stopwatch and a protractor at the outer turning points give them.

    Parameters
    ----------
    motion
        A single one, below the support.
    half_swing
        s, about one radial period; ten per cent more or less do no harm.

    Returns
    -------
    Frequency and precession, signed like those of `ExactMotion`; None on a circle or at rest, and
    the precession None where less than 1e-9 rad is turned in 64 half swings.

    Notes
    -----
    A turning point is a zero of xẋ + yẏ, which falls through it. A motion exact to ε has times off
    by ε/(1 − b²/a²) and azimuths by ε, so the frequency is good to ε/64(1 − b²/a²) and the
    precession to ε/(turned angle), relative.
    """
    times = np.linspace(0, (_HALF_SWINGS + 2) * half_swing, (_HALF_SWINGS + 2) * _GRID + 1)
    position = motion.position(times)[:, :2]
    distance = np.square(position).sum(axis=-1)
    if not np.ptp(distance) > _ROUND_ENOUGH * distance.max():
        return Rates(None, None)
    outward = _outward(motion, times)
    first = np.flatnonzero((outward[:-1] > 0) & (outward[1:] <= 0))[: _HALF_SWINGS + 1]
    turning = _zeros(motion, times[first], times[first + 1], outward[first], outward[first + 1])
    x, y = motion.position(turning)[:, :2].T
    elapsed = float(turning[-1] - turning[0])
    # Half a turn from one to the next is the swing; the rest, brought to one branch, is precession.
    steps = np.diff(np.arctan2(y, x)) - np.pi
    turned = float(np.sum(steps - 2 * np.pi * np.rint(steps / (2 * np.pi))))
    return Rates(
        np.pi * (len(turning) - 1) / elapsed,
        turned / elapsed if abs(turned) > _STANDSTILL else None,
    )


def _outward(motion: Motion, times: Numbers) -> Numbers:
    position, velocity = motion.position(times)[:, :2], motion.velocity(times)[:, :2]
    return np.asarray((position * velocity).sum(axis=-1))


def _zeros(motion: Motion, low: Numbers, high: Numbers, f_low: Numbers, f_high: Numbers) -> Numbers:
    """Where the bob stops going outwards, in brackets, by the Illinois variant of regula falsi."""
    best, least = np.where(f_low < -f_high, low, high), np.minimum(f_low, -f_high)
    for _ in range(_ROUNDS):
        with np.errstate(invalid="ignore", divide="ignore"):
            middle = low + (high - low) * f_low / (f_low - f_high)
        middle = np.where(np.isfinite(middle), middle, (low + high) / 2)
        if np.all((middle <= low) | (middle >= high)):
            break
        f = _outward(motion, middle)
        best, least = np.where(abs(f) < least, middle, best), np.minimum(abs(f), least)
        outward = f > 0
        # The end that stays put has its value halved, or it would stay for good.
        f_low, f_high = np.where(outward, f, f_low / 2), np.where(outward, f_high / 2, f)
        low, high = np.where(outward, middle, low), np.where(outward, high, middle)
    return np.asarray(best)
