"""What a fit says: numbers with their intervals, and what they assume; no sentences."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, TypeAlias

from kugelpendel.errors import InvalidInput
from kugelpendel.parameters import Numbers

if TYPE_CHECKING:
    from kugelpendel.tracks.fitting._problem import Problem
    from kugelpendel.tracks.fitting._search import Found

Verdict: TypeAlias = Literal["determined", "not determined", "nuisance"]
Reason: TypeAlias = Literal["", "wide", "outside", "scale", "modulus", "failed"]


@dataclass(frozen=True)
class Estimate:
    """A fitted number with its interval.

    Attributes
    ----------
    value, stderr
        In `unit`; NaN where it is not determined.
    low, high
        The limits of the 95 % interval.
    unit
        As in "1/s"; "" for a plain number.
    verdict
        "determined"; "not determined", when there is no number; "nuisance" for what has a stated
        size and is there to widen the others honestly.
    reason
        Why it is not determined: "wide", the interval does not close inside the physical range;
        "outside", it lies beside that range; "scale", it needs a length that the track does not
        have; "failed", the fit found no end. With "modulus" the number cannot be told from 0, and
        `high` is its upper bound.
    """

    value: float
    stderr: float
    low: float
    high: float
    unit: str = ""
    verdict: Verdict = "determined"
    reason: Reason = ""


@dataclass(frozen=True, eq=False)
class FittedModel:
    """One fit of the averaged motion to the ellipses, under one assumption.

    Attributes
    ----------
    name
        Its key in `TrackFit.models`.
    parameters
        By their names; those fitted first, in the order of `correlation`, then what follows from
        them.
    correlation
        Of the fitted ones.
    chi_square, degrees
        Of the whitened residuals, nuisances of a stated size counted as data.
    failed
        Whether the fit found no end.
    time
        s, of the windows.
    a, b, azimuth
        The model there; a and b are NaN for a model of the azimuth alone.
    residual_a, residual_b, residual_azimuth
        Measured less model.
    """

    name: str
    parameters: Mapping[str, Estimate]
    correlation: Numbers
    chi_square: float
    degrees: int
    failed: bool
    time: Numbers
    a: Numbers
    b: Numbers
    azimuth: Numbers
    residual_a: Numbers
    residual_b: Numbers
    residual_azimuth: Numbers


@dataclass(frozen=True)
class Misfit:
    """Whether the residuals are larger than the noise.

    Attributes
    ----------
    chi_square, degrees, ratio
        χ² of the narrow model, its degrees of freedom, and one over the other.
    probability
        Of a χ² as large as this where the model is right.
    excess
        Root mean square of the residuals over their standard errors, for "a", "b", "azimuth".
    is_misfit
        Whether the probability is below one in a thousand.
    """

    chi_square: float
    degrees: int
    ratio: float
    probability: float
    excess: Mapping[str, float]
    is_misfit: bool


@dataclass(frozen=True)
class PeriodTable:
    """Period against amplitude: three readings of ln ω side by side.

    Standard errors are multiplied by √(χ²/ndof) where this is above 1.

    Attributes
    ----------
    slope
        d ln ω/d((a² + b²)/l²) where the clock is perfect; −1/16 for an ideal pendulum.
    theory
        That −1/16.
    drift
        Of ln ω, 1/s, where the slope is −1/16: a clock, or a length that changes.
    both
        Slope and drift fitted together.
    chi_square
        Of "slope", "drift", "both" and "theory", which has neither.
    degrees
        Of "slope" and "drift"; one less for "both", one more for "theory".
    """

    slope: Estimate
    theory: float
    drift: Estimate
    both: tuple[Estimate, Estimate]
    chi_square: Mapping[str, float]
    degrees: int


@dataclass(frozen=True)
class Wobble:
    """How evenly the plane turns: its mean rate, and what goes with twice and four times ψ.

    Attributes
    ----------
    rate
        Mean rate of the azimuth, rad/s, counter-clockwise.
    rate_stderr, naive_stderr
        With the correlation of what 2ψ and 4ψ leave over, and as if the azimuths strayed from the
        line independently of each other.
    range
        By how much the plane has turned, rad.
    explained_2, explained_4
        Share of what the azimuth strays from a straight line and the ellipse's own turning, that
        goes with cos 2ψ and sin 2ψ in the rate, and with those and cos 4ψ and sin 4ψ; NaN where
        the plane has turned by less than half a turn.
    amplitude_2, amplitude_4
        Amplitude of those parts of the rate, rad/s.
    """

    rate: float
    rate_stderr: float
    naive_stderr: float
    range: float
    explained_2: float
    explained_4: float
    amplitude_2: float
    amplitude_4: float


@dataclass(frozen=True)
class Stiffening:
    """A support that stiffens with amplitude by −η ω0² ρ²/l² r, read off in two ways.

    Attributes
    ----------
    from_intrinsic
        η = 4(3/8 − κ).
    from_period
        η = (8/3)(slope + 1/16).
    joint
        Their weighted mean.
    agree
        Whether they differ by less than two of their standard errors.
    """

    from_intrinsic: Estimate
    from_period: Estimate
    joint: Estimate
    agree: bool


@dataclass(frozen=True, eq=False)
class TrackFit:
    """What ellipses say about the pendulum.

    Attributes
    ----------
    time
        t0 in s, to which a, b and the azimuth belong.
    length, gravity
        m and m/s²: given, or what follows from the frequency with the other one.
    frequency
        ω0 of infinitesimal swings, rad/s, mean of the two axes.
    scaled
        Whether the places are in metres.
    models
        By their names: "headline", the one to quote; "narrow", without nuisances, to be quoted
        with its assumption only; "uneven" and "tilted", with Δγ or the tilt entirely free;
        "intrinsic", "intrinsic_narrow" and "intrinsic_known" with κ free, with nuisances, without
        them, and with Ω_z from the latitude; "measured" and "measured_anisotropy", of the azimuth
        alone with a(t) and b(t) as they were measured.
    misfit, period, wobble, stiffening
        As their classes say; None where a track does not have them.
    planar
        Whether b cannot be told from 0, so that the sense is not determined.
    problem, minima
        What was fitted, and what was found of each model of the averaged motion: where `profile`
        begins.
    """

    time: float
    length: float
    gravity: float
    frequency: float
    scaled: bool
    models: Mapping[str, FittedModel]
    misfit: Misfit
    period: PeriodTable | None
    wobble: Wobble | None
    stiffening: Stiffening | None
    planar: bool
    problem: Problem = field(repr=False)
    minima: Mapping[str, Found] = field(repr=False)

    @property
    def headline(self) -> FittedModel:
        """The model with nuisances of a stated size: the one to quote."""
        return self.models["headline"]

    @property
    def narrow(self) -> FittedModel:
        """The model that assumes even damping and a camera without tilt."""
        return self.models["narrow"]

    def estimate(self, name: str) -> Estimate:
        """A parameter of the headline. Raises InvalidInput for an unknown name."""
        known = self.headline.parameters
        if name not in known:
            raise InvalidInput.of("fit_parameter", seen=name, known=", ".join(known))
        return known[name]


@dataclass(frozen=True, eq=False)
class Profile:
    """χ² as one parameter is held at one value after the other and the rest are fitted.

    Attributes
    ----------
    name
        The parameter.
    values
        At which it is held, in its unit.
    chi_square
        Above the least one.
    level
        Which χ² passes at the ends of a 95 % interval.
    low, high
        Where it crosses that level; NaN where it does not within `values`.
    closes
        Whether it does so on both sides.
    """

    name: str
    values: Numbers
    chi_square: Numbers
    level: float
    low: float
    high: float
    closes: bool
