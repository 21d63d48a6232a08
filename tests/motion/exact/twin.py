"""The exact motion once more, in 50 digits, out of Legendre's and Carlson's integrals.

Everything is a standard function of mpmath: the roots of the cubic, sn, Π, R_F and R_J. It shares
neither a formula nor an arithmetic with the package, which has theta series in binary64, nor with
the stored references, which are integrated. Not for λ = 0 nor for exact cones, where these forms
divide by 0.
"""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
from tests.motion.launches import Vector

from kugelpendel import Launch, Pendulum

mp: Any = mpmath.mp.clone()
mp.dps = 50


class Twin:
    """A motion with angular momentum, in units of the length and of 1/ω0."""

    def __init__(self, pendulum: Pendulum, launch: Launch):
        self.length, gravity = mp.mpf(pendulum.length), mp.mpf(pendulum.gravity)
        self.omega0 = mp.sqrt(gravity / self.length)
        (x, y, z), (u, v, w) = self._launched(launch)
        self.sense = mp.sign(x * v - y * u)
        momentum, height = abs(x * v - y * u), 1 - z
        energy = (u**2 + v**2 + w**2) / 2 + height
        cubic = [-(momentum**2), 4 * energy, -2 * energy - 4, 2]
        roots = mp.polyroots(cubic[::-1], maxsteps=500, extraprec=500)
        self.low, self.high, third = sorted(mp.re(root) for root in roots)
        self.rate = mp.sqrt((third - self.low) / 2)
        self.parameter = (self.high - self.low) / (third - self.low)
        self.quarter = mp.ellipk(self.parameter)
        # Weight and characteristic of the two integrals of the third kind, below and above.
        self.poles = [
            (momentum / (2 * self.rate * self.low), (self.low - self.high) / self.low),
            (momentum / (2 * self.rate * (2 - self.low)), (self.high - self.low) / (2 - self.low)),
        ]
        share = (height - self.low) / (self.high - self.low)
        phase = mp.ellipf(mp.asin(mp.sqrt(min(max(share, 0), 1))), self.parameter)
        self.phase = -phase if w > 0 else phase
        self.azimuth = mp.atan2(y, x) - self.sense * self._turn(self.phase)

    @property
    def radial_period(self) -> Any:
        """s."""
        return 2 * self.quarter / self.rate / self.omega0

    @property
    def frequency(self) -> Any:
        """rad/s."""
        return mp.pi / self.radial_period

    @property
    def precession(self) -> Any:
        """rad/s, by Carlson's functions: nothing of `position` enters."""
        rest = 1 - self.parameter
        turn = 0
        for weight, n in self.poles:
            third_kind = mp.elliprf(0, rest, 1) + n / 3 * mp.elliprj(0, rest, 1, 1 - n)
            turn += 2 * weight * third_kind
        return self.sense * (turn - mp.pi) / self.radial_period

    def position(self, time: float) -> Vector:
        """m; correctly rounded."""
        argument = self.phase + self.rate * self.omega0 * mp.mpf(time)
        sine = mp.ellipfun("sn", argument, m=self.parameter)
        height = self.low + (self.high - self.low) * sine**2
        radius = mp.sqrt(height * (2 - height))
        azimuth = self.azimuth + self.sense * self._turn(argument)
        vector = (radius * mp.cos(azimuth), radius * mp.sin(azimuth), 1 - height)
        return np.array([float(self.length * number) for number in vector])

    def _turn(self, argument: Any) -> Any:
        """Azimuth since a lowest point."""
        swings = mp.nint(argument / (2 * self.quarter))
        sine = mp.ellipfun("sn", argument - 2 * swings * self.quarter, m=self.parameter)
        amplitude, turn = mp.asin(sine), 0
        for weight, n in self.poles:
            whole = 2 * swings * mp.ellippi(n, self.parameter)
            turn += weight * (whole + mp.ellippi(n, amplitude, self.parameter))
        return turn

    def _launched(self, launch: Launch) -> tuple[list[Any], list[Any]]:
        values = [mp.mpf(value) for value in launch.values]
        unit = self.length * self.omega0
        match launch.kind:
            case "plane":
                x, y, u, v = (values[0] / self.length, values[1] / self.length, *values[2:])
                z = mp.sqrt(1 - x**2 - y**2)
                return [x, y, z], [u / unit, v / unit, -(x * u + y * v) / z / unit]
            case "ellipse":
                a, b, azimuth = values[0] / self.length, values[1] / self.length, values[2]
                cos, sin = mp.cos(azimuth), mp.sin(azimuth)
                return [a * cos, a * sin, mp.sqrt(1 - a**2)], [-b * sin, b * cos, mp.mpf(0)]
            case "angles":
                theta, phi, up, around = (
                    values[0],
                    values[1],
                    *(v / self.omega0 for v in values[2:]),
                )
                sine, cosine = mp.sin(theta), mp.cos(theta)
                cos, sin = mp.cos(phi), mp.sin(phi)
                outward = up * cosine
                return [sine * cos, sine * sin, cosine], [
                    outward * cos - around * sine * sin,
                    outward * sin + around * sine * cos,
                    -up * sine,
                ]
            case kind:
                raise ValueError(f"the twin takes no launch of kind {kind}")
