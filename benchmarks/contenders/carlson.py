"""Frequency and precession of many pendulums from SciPy's elliprf and elliprj.

Lengths in l, times in 1/ω0. Both complete integrals of the third kind are written
with positive terms only; what stays is ΔΦ - π.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import elliprf, elliprj

Array = np.ndarray


@dataclass(frozen=True)
class Roots:
    """Heights of the turning points, the third root of Q(s), and λ (signed)."""

    high: Array
    low: Array
    top: Array
    momentum: Array

    @classmethod
    def apsides(cls, a: Array, b: Array) -> Roots:
        """From the turning radii a ≥ |b| on the lower half."""
        high, low = (r * r / (1 + np.sqrt((1 - r) * (1 + r))) for r in (a, b))
        top = 2 + high * low / (2 - high - low)
        return cls(high, low, top, np.copysign(np.sqrt(2 * high * low * top), b))

    @classmethod
    def ellipse(cls, a: Array, b: Array) -> Roots:
        """From the paper's launch: at rest radially at a, pushed sideways with b."""
        down = np.sqrt((1 - a) * (1 + a))
        start = a * a / (1 + down)
        push = b * b
        top = 1 + push / 4 + np.sqrt(1 - push * down / 2 + push * push / 16)
        other = push * (1 + down) / 2 / top
        return cls(np.maximum(start, other), np.minimum(start, other), top, a * b)

    @classmethod
    def plane(cls, x: Array, y: Array, vx: Array, vy: Array) -> Roots:
        """From any state on the lower half with less energy than the height of the support.

        Newton's method for s_c - 2, from above, where the cubic is convex.
        """
        radius2 = x * x + y * y
        down2 = 1 - radius2
        energy = (vx * vx + vy * vy + (x * vx + y * vy) ** 2 / down2) / 2
        energy += radius2 / (1 + np.sqrt(down2))
        momentum = x * vy - y * vx
        square = momentum * momentum
        linear, quadratic = 8 - 4 * energy, 8 - 2 * energy
        over = square / linear
        for _ in range(4):
            value = ((2 * over + quadratic) * over + linear) * over - square
            over -= value / ((6 * over + 2 * quadratic) * over + linear)
        top = 2 + over
        total, product = energy - over, square / (2 * top)
        high = (total + np.sqrt(np.maximum(total * total - 4 * product, 0))) / 2
        return cls(high, product / high, top, momentum)


def rates(roots: Roots) -> tuple[Array, Array]:
    """Frequency and signed precession in ω0: one R_F and two R_J per pendulum."""
    high, low, span = roots.high, roots.low, roots.high - roots.low
    wide = roots.top - low
    w = np.sqrt(wide / 2)
    m1 = (roots.top - high) / wide
    K = elliprf(0.0, m1, 1.0)
    third1 = (K + m1 * span / high / 3 * elliprj(0.0, m1, 1.0, m1 * low / high)) / high
    n2 = span / (2 - low)
    third2 = (K + n2 / 3 * elliprj(0.0, m1, 1.0, (2 - high) / (2 - low))) / (2 - low)
    slope = np.abs(roots.momentum) / w
    period = 2 * K / w
    precession = ((slope * third1 - np.pi) + slope * third2) / period
    return np.pi / period, np.copysign(precession, roots.momentum)
