"""Frequency and precession of any motion, measured at its outer turning points."""

from __future__ import annotations

import math
from typing import NamedTuple

from kugelpendel import _core
from kugelpendel.motion import Motion
from kugelpendel.parameters import InvalidInput, Numbers, one_number, require_type


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
        About one radial period, s; ten per cent more or less do no harm.

    Returns
    -------
    Frequency and precession, signed like those of `ExactMotion`; None on a circle or at rest, and
    the precession None where less than 1e-9 rad is turned in 64 half swings.

    Raises
    ------
    InvalidInput
        For what is no motion, an ensemble, a half swing that is not positive and finite, and where
        the motion ends before 66 half swings.

    Notes
    -----
    A turning point is a zero of xẋ + yẏ, which falls through it. A motion exact to ε has times off
    by ε/(1 − b²/a²) and azimuths by ε, so the frequency is good to ε/64(1 − b²/a²) and the
    precession to ε/(turned angle), relative.
    """
    require_type("The motion", motion, Motion, way_out="write kp.ExactMotion(pendulum, launch)")
    swing = one_number(half_swing, "The half swing", "s")
    if not 0 < swing < math.inf:
        raise InvalidInput(f"The half swing must be positive and finite, but it is {swing} s.")
    if motion.shape != ():
        raise InvalidInput(
            f"Rates are measured on a single motion, but this is an ensemble of shape "
            f"{motion.shape}; measure its motions one by one."
        )

    def states(times: Numbers) -> tuple[Numbers, Numbers]:
        return motion.position(times), motion.velocity(times)

    return Rates(*_core.measured_rates(states, swing))
