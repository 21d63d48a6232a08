"""What a number in a file may measure."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """A kind of quantity.

    Attributes
    ----------
    name
        The word by which sentences call it (``words.measure`` of their files).
    unit
        The SI unit that it is turned into.
    example
        A value to paste.
    most
        The largest size that makes sense, in the SI unit.
    """

    name: str
    unit: str
    example: str
    most: float = math.inf


LENGTH = Kind("length", "m", "3 cm")
TIME = Kind("time", "s", "10 min")
MASS = Kind("mass", "kg", "28 kg")
ACCELERATION = Kind("acceleration", "m/s^2", "9.81 m/s^2")
SPEED = Kind("speed", "m/s", "5 cm/s")
ANGLE = Kind("angle", "rad", "30 deg", 2 * math.pi * (1 + 1e-15))
"""Up to a full turn to either side, so that 45 for 45° is not taken for 45 rad."""
LATITUDE = Kind("angle", "rad", "30 deg")
"""An angle that may also end in N or S; how far it goes, the site knows."""
RATE = Kind("angular velocity", "rad/s", "30 deg/s")
DENSITY = Kind("density", "kg/m^3", "8500 kg/m^3")
DECAY = Kind("decay rate", "1/s", "1e-5 1/s")
QUADRATIC = Kind("quadratic drag", "1/m", "1e-3 1/m")
PRESSURE = Kind("pressure", "Pa", "200 GPa")
EXPANSION = Kind("expansion", "1/K", "1.2e-5 1/K")
