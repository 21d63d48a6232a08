"""How the thread is held: not quite alike in all directions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters._given import Given, require_finite, require_positive
from kugelpendel.parameters._numbers import Scalars, as_numbers, unfit


@dataclass(frozen=True, eq=False, init=False)
class Suspension(Given):
    """Stiffness and friction that depend on the direction, or an ensemble where arrays are given.

    Parameters
    ----------
    anisotropy
        δ, rad/s: angular frequency of small swings along the axis less that across it, which is
        ω0. The force is −2ω0δ (r·χ̂)χ̂ per unit mass, horizontal. Positive where the axis is the
        stiff one.
    axis
        χ, rad, azimuth of that axis, counter-clockwise from x seen from above.
    damping_anisotropy
        Δγ, 1/s: decay rate of the amplitude along its axis less that across it. The force is
        −Δγ(2(v·χ̂)χ̂ − v) per unit mass, horizontal; beside a drag γ, γ + Δγ/2 along and γ − Δγ/2
        across. Where Δγ exceeds 2γ it brings energy in, which no support does.
    damping_axis
        Azimuth of the axis along which more is lost, rad.

    Raises
    ------
    InvalidInput
        For what is not finite, one element of an array included.
    """

    anisotropy: Scalars
    axis: Scalars
    damping_anisotropy: Scalars
    damping_axis: Scalars

    def __init__(
        self,
        anisotropy: ArrayLike = 0.0,
        axis: ArrayLike = 0.0,
        damping_anisotropy: ArrayLike = 0.0,
        damping_axis: ArrayLike = 0.0,
    ):
        for name, given, unit in (
            ("anisotropy", anisotropy, "rad/s"),
            ("axis", axis, "rad"),
            ("damping_anisotropy", damping_anisotropy, "1/s"),
            ("damping_axis", damping_axis, "rad"),
        ):
            spoken = f"The suspension's {name.replace('_', ' ')}"
            value = as_numbers(given, spoken, unit)
            object.__setattr__(self, name, value)
            require_finite(value, spoken, unit)
        self._check_shapes("the suspension's anisotropies and axes")

    @property
    def values(self) -> tuple[Scalars, ...]:
        """Anisotropy, axis, damping anisotropy, damping axis."""
        return (self.anisotropy, self.axis, self.damping_anisotropy, self.damping_axis)

    @classmethod
    def from_periods(
        cls,
        along: ArrayLike,
        across: ArrayLike,
        axis: ArrayLike = 0.0,
        damping_anisotropy: ArrayLike = 0.0,
        damping_axis: ArrayLike = 0.0,
    ) -> Suspension:
        """From the two measured periods of small swings, s, along the axis and across it.

        δ = 2π/T_along − 2π/T_across. The periods must be of the same amplitude, and small or
        corrected for it: at 3° the amplitude makes 1.7e-4 of the period, and a fine suspension's
        anisotropy makes less. Raises InvalidInput for periods that are not positive and finite.
        """
        periods: list[Scalars] = []
        for given, where in ((along, "along"), (across, "across")):
            value = as_numbers(given, f"The period {where} the axis", "s")
            way_out = "measure a full swing there and back"
            require_positive(value, f"The period {where} the axis", "s", way_out)
            periods.append(value)
        t, u = (np.asarray(period) for period in periods)
        try:
            # As a product, so that nearly equal periods lose no digits.
            anisotropy = 2 * np.pi * (u - t) / (t * u)
        except ValueError:
            raise unfit("the two periods", tuple(periods)) from None
        return cls(anisotropy, axis, damping_anisotropy, damping_axis)
