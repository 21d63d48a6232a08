"""A motion as a sum of harmonics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kugelpendel.motion._times import checked_times
from kugelpendel.parameters import Numbers


@dataclass(frozen=True, eq=False)
class Spectrum:
    """x + iy = Σ amplitude·exp(i·frequency·t) and z = Re Σ vertical_amplitude·exp(i·…·t).

    In the frame that turns with the precession Ω the frequencies are odd multiples of ω in the plan
    view and even ones in the height. Orders −1 and 1 are the ellipse of Olsson's ansatz (20), with
    semi-axes |amplitude of 1| ± |amplitude of −1|.

    Attributes
    ----------
    order
        −(2n − 1), …, −1, 1, …, 2n − 1; for motion in a plane over the top, where the motion's
        frequency counts revolutions, all whole numbers −n + 1, …, n. Shape (*motion.shape, 2n).
    frequency
        Ω + order·ω, rad/s, signed: shape (*motion.shape, 2n).
    amplitude
        m, complex, phase at t = 0: shape (*motion.shape, 2n).
    vertical_order, vertical_frequency, vertical_amplitude
        The same for z: orders 0, 2, …, 2n, shapes (*motion.shape, n + 1).

    In an ensemble, what has no spectrum (a bad case, the separatrix) has NaN, and order 0.

    Notes
    -----
    Error: 4e-15 of the largest amplitude (tests/motion/exact/test_spectrum.py). Source: the residue
    of x + iy at its double pole in the complex plane of time; see the core, exact/spectrum.rs.
    """

    order: NDArray[np.int32]
    frequency: Numbers
    amplitude: NDArray[np.complex128]
    vertical_order: NDArray[np.int32]
    vertical_frequency: Numbers
    vertical_amplitude: NDArray[np.complex128]

    def position(self, t: ArrayLike) -> Numbers:
        """The sum, m: shape (*motion.shape, *t.shape, 3); what is left out is beyond the orders."""
        times = checked_times(t, 3 * self.amplitude.size)
        phases = np.multiply.outer(self.frequency, times)
        weights = self.amplitude.reshape(self.amplitude.shape + (1,) * times.ndim)
        axis = self.amplitude.ndim - 1
        plan = np.sum(weights * np.exp(1j * phases), axis=axis)
        phases = np.multiply.outer(self.vertical_frequency, times)
        weights = self.vertical_amplitude.reshape(self.vertical_amplitude.shape + (1,) * times.ndim)
        height = np.sum((weights * np.exp(1j * phases)).real, axis=axis)
        return np.stack([plan.real, plan.imag, height], axis=-1)
