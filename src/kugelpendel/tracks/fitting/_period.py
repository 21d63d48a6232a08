"""The period against the amplitude, and what a support that stiffens would make of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from kugelpendel.tracks._scipy import student
from kugelpendel.tracks.fitting._intervals import undetermined
from kugelpendel.tracks.fitting._linear import LinearFit, linear
from kugelpendel.tracks.fitting._model import IDEAL, INTRINSIC
from kugelpendel.tracks.fitting._results import Estimate, FittedModel, PeriodTable, Stiffening
from kugelpendel.tracks.reduction import column

THEORY = -1 / 16
"""d ln ω/d((a² + b²)/l²) of an ideal pendulum: Olsson (1981), eq. (26)."""


def period_table(ellipses: Any, length: float, scaled: bool) -> PeriodTable | None:
    """Ln ω against (a² + b²)/l² and against time; None where no frequency was measured.

    Parameters
    ----------
    ellipses
        As `fit` got them.
    length
        m.
    scaled
        Whether the track is in metres; without, only a drift with no slope at all can be given.
    """
    frequency = column(ellipses, "frequency")
    error = column(ellipses, "frequency_stderr") / frequency
    if not np.isfinite(frequency).all() or not (error > 0).all():
        return None
    size = (column(ellipses, "a") ** 2 + column(ellipses, "b") ** 2) / length**2
    if not scaled:
        size = np.zeros_like(size)
    time = column(ellipses, "time") - float(column(ellipses, "time").mean())
    logs = np.log(frequency)
    ones = np.ones_like(time)
    fits = {
        "theory": linear([ones], logs - THEORY * size, error),
        "drift": linear([ones, time], logs - THEORY * size, error),
        "slope": linear([ones, size], logs, error) if scaled else None,
        "both": linear([ones, size, time], logs, error) if scaled else None,
    }
    return PeriodTable(
        slope=_told(fits["slope"], 1, ""),
        theory=THEORY,
        drift=_told(fits["drift"], 1, "1/s"),
        both=(_told(fits["both"], 1, ""), _told(fits["both"], 2, "1/s")),
        chi_square={name: one.chi_square for name, one in fits.items() if one},
        degrees=len(time) - 2,
    )


def stiffening(model: FittedModel | None, period: PeriodTable | None) -> Stiffening | None:
    """η from κ and from the slope of the period; None where one of them is not there.

    Of ⟨ρ⁴⟩ = A₊⁴ + A₋⁴ + 4A₊²A₋² follow κ = 3/8 − η/4 and a slope of −1/16 + (3/8)η.
    """
    if model is None or period is None:
        return None
    kappa = model.parameters[INTRINSIC]
    if "not determined" in (kappa.verdict, period.slope.verdict):
        return None
    first = _scaled(kappa, -4.0, 4 * IDEAL)
    second = _scaled(period.slope, 8 / 3, -8 / 3 * THEORY)
    weights = np.array([1 / first.stderr**2, 1 / second.stderr**2])
    mean = float(weights @ [first.value, second.value] / weights.sum())
    error = float(1 / np.sqrt(weights.sum()))
    apart = abs(first.value - second.value)
    joint = Estimate(mean, error, mean - 1.96 * error, mean + 1.96 * error)
    return Stiffening(
        first, second, joint, apart < 2 * float(np.hypot(first.stderr, second.stderr))
    )


def _told(line: LinearFit | None, index: int, unit: str) -> Estimate:
    if line is None:
        return undetermined(unit, "scale")
    error = float(np.sqrt(line.covariance[index, index] * line.ratio))
    if not np.isfinite(error):
        return undetermined(unit, "wide")
    value, t = float(line.found[index]), student(line.degrees)
    return Estimate(value, error, value - t * error, value + t * error, unit)


def _scaled(one: Estimate, factor: float, more: float) -> Estimate:
    ends = sorted((one.low * factor + more, one.high * factor + more))
    return Estimate(one.value * factor + more, abs(factor) * one.stderr, ends[0], ends[1])
