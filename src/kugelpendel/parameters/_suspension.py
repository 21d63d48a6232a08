"""How the thread is held: not quite alike in all directions."""

# One number is array-like too, so overloads for it come first.
# pyright: reportOverlappingOverload=false

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, overload

from numpy.typing import ArrayLike

from kugelpendel.parameters._derived import Origin, derived
from kugelpendel.parameters._given import Given
from kugelpendel.parameters._numbers import Numbers, OneNumber, Scalar_co, as_numbers


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Suspension(Given[Scalar_co]):
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
        For a single number that is not finite, and for arrays that do not broadcast. In an
        ensemble a bad case becomes NaN in the motion, which gives the reason.
    """

    anisotropy: Scalar_co
    axis: Scalar_co
    damping_anisotropy: Scalar_co
    damping_axis: Scalar_co

    part = "suspension"
    units: ClassVar = {
        "anisotropy": "rad/s",
        "axis": "rad",
        "damping_anisotropy": "1/s",
        "damping_axis": "rad",
    }
    strengths = ("anisotropy", "damping_anisotropy")

    @overload
    def __init__(
        self: Suspension[float],
        anisotropy: OneNumber = ...,
        axis: OneNumber = ...,
        damping_anisotropy: OneNumber = ...,
        damping_axis: OneNumber = ...,
    ) -> None: ...

    @overload
    def __init__(
        self: Suspension[Numbers],
        anisotropy: ArrayLike = ...,
        axis: ArrayLike = ...,
        damping_anisotropy: ArrayLike = ...,
        damping_axis: ArrayLike = ...,
    ) -> None: ...

    def __init__(
        self,
        anisotropy: ArrayLike = 0.0,
        axis: ArrayLike = 0.0,
        damping_anisotropy: ArrayLike = 0.0,
        damping_axis: ArrayLike = 0.0,
    ):
        self._give(
            "the suspension's anisotropies and axes",
            anisotropy=anisotropy,
            axis=axis,
            damping_anisotropy=damping_anisotropy,
            damping_axis=damping_axis,
        )

    @overload
    @classmethod
    def from_periods(
        cls,
        along: OneNumber,
        across: OneNumber,
        axis: OneNumber = ...,
        damping_anisotropy: OneNumber = ...,
        damping_axis: OneNumber = ...,
    ) -> Suspension[float]: ...

    @overload
    @classmethod
    def from_periods(
        cls,
        along: ArrayLike,
        across: ArrayLike,
        axis: ArrayLike = ...,
        damping_anisotropy: ArrayLike = ...,
        damping_axis: ArrayLike = ...,
    ) -> Suspension[Numbers]: ...

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
        anisotropy makes less. Raises InvalidInput for a single period that is not positive and
        finite; in an ensemble such a case becomes NaN.
        """
        periods = {
            f"suspension.{name}": as_numbers(value, f"suspension.{name}", "s")
            for name, value in (("period_along", along), ("period_across", across))
        }
        what = "anisotropy_from_periods"
        anisotropy = derived(what, "the two periods", periods)
        suspension = Suspension(anisotropy, axis, damping_anisotropy, damping_axis)
        return suspension._derived_from(anisotropy=Origin(what, periods))
