"""All motions beside the exact one, from the same launch."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from kugelpendel import _core
from kugelpendel.errors import KugelpendelError
from kugelpendel.motion import (
    CubicMotion,
    ExactMotion,
    LinearMotion,
    Motion,
    OlssonMotion,
    PlaneMotion,
    SeriesMotion,
)
from kugelpendel.observables._measured import Rates, measured_rates
from kugelpendel.observables._pieces import Told
from kugelpendel.observables._validity import ORDERS
from kugelpendel.parameters import InvalidInput, Launch, Numbers, Pendulum, one_number

_SWINGS = 20
"""Swings that are compared unless a duration is given."""

_MOST_SWINGS = 20_000
"""Longer comparisons are refused: two of the motions are integrated step by step."""


@dataclass(frozen=True)
class Compared:
    """One motion beside the exact one.

    Attributes
    ----------
    name
        Of its class, with the order of a series.
    equation
        Which equation it obeys, or where it comes from.
    trust
        Where it holds, in words.
    reason
        Why there are no numbers for this launch; "" where there are.
    caution
        What it warned of, and when it ended before the duration did; "" for nothing.
    errors
        Distance from the exact position at the times of the comparison, m: shape (n,); NaN after
        its end. None where there is a reason.
    period, precession
        Relative error, signed: its own over the exact one, less 1. None where there is none: of
        the precession where the exact one is 0, or too slow to be measured on a motion that is
        integrated; of both on a circle, which shows no turning points.
    """

    name: str
    equation: str
    trust: str = ""
    reason: str = ""
    caution: str = ""
    errors: Numbers | None = None
    period: float | None = None
    precession: float | None = None

    @property
    def largest(self) -> float | None:
        """Largest error of a position at the times compared, m."""
        return None if self.errors is None else float(np.nanmax(self.errors))

    @property
    def final(self) -> float | None:
        """Error of the position at the last time, m; None where the motion ended before."""
        if self.errors is None or math.isnan(self.errors[-1]):
            return None
        return float(self.errors[-1])


@dataclass(frozen=True)
class Comparison:
    """All motions from one launch beside the exact one.

    Attributes
    ----------
    exact
        The exact motion.
    times
        When positions were compared, s: shape (n,), evenly spread from 0 to the duration.
    amplitude
        What errors are given as a fraction of, m: the outer turning radius, or the length where
        the path rises above the support.
    rows
        One for each motion, the coarsest first.
    """

    exact: ExactMotion
    times: Numbers
    amplitude: float
    rows: tuple[Compared, ...]

    def row(self, name: str) -> Compared:
        """The motion of that name. Raises InvalidInput where there is none."""
        for row in self.rows:
            if isinstance(name, str) and row.name == name:  # pyright: ignore[reportUnnecessaryIsInstance]
                return row
        names = ", ".join(row.name for row in self.rows)
        raise InvalidInput(f"No motion of this comparison is {name!r:.60}; there are {names}.")


def compare(
    pendulum: Pendulum,
    launch: Launch,
    duration: float | None = None,
    orders: Iterable[int] = (6, 12),
    *,
    done: Callable[[int, int], None] | None = None,
) -> Comparison:
    """Let every motion start from one launch and follow how far each goes astray.

    Parameters
    ----------
    pendulum, launch
        A single one of each.
    duration
        s; 20 swings unless given.
    orders
        Of `SeriesMotion`: even, 2 … 12.
    done
        Told, now and then, how many of how many positions are worked out: of those that are
        integrated, since the others take no time beside them.

    Returns
    -------
    Errors of position, period and precession of each motion; a motion that does not hold for this
    launch has the reason in their place.

    Raises
    ------
    InvalidInput
        For ensembles, launches that are not on the sphere, an order that does not exist, and a
        duration that is not positive and finite or is longer than 20 000 swings.

    Notes
    -----
    The exact positions are good to some 1e-15 l (`ExactMotion`): that is the least that can be
    seen. Period and precession of `CubicMotion` and `PlaneMotion` are measured at the outer turning
    points of their own paths, over 64 half swings; those of the others are their formulas.
    """
    exact = ExactMotion(pendulum, launch)
    if exact.shape != ():
        raise InvalidInput(
            f"One launch can be compared at a time, and this is an ensemble of shape "
            f"{exact.shape}; pick one launch and one pendulum."
        )
    try:
        wanted = tuple(orders)
    except TypeError:
        raise InvalidInput(
            f"The orders must be several, such as (6, 12), but they are {orders!r:.60}."
        ) from None
    rungs = [
        _Rung("LinearMotion", "(16)", LinearMotion, _own_rates),
        _Rung("OlssonMotion", "(20, 25, 26)", OlssonMotion, _own_rates),
        _Rung("CubicMotion", "(13)", CubicMotion, measured_rates),
        *(_series(order) for order in wanted),
        _Rung("PlaneMotion", "(12)", PlaneMotion, measured_rates),
    ]
    times = _times(exact, duration)
    truth = exact.sample(0.0, float(times[1]), len(times))
    told = Told(done, len(times) * sum(rung.rates is measured_rates for rung in rungs))
    return Comparison(
        exact=exact,
        times=times,
        amplitude=float(exact.amplitude),
        rows=tuple(_compared(rung, exact, times, truth, told) for rung in rungs),
    )


@dataclass(frozen=True)
class _Rung:
    """A motion of the ladder: its name, how to make it, and how to find its rates."""

    name: str
    equation: str
    make: Callable[[Pendulum, Launch], Motion]
    rates: Callable[[Motion, float], Rates]


def _series(order: int) -> _Rung:
    def make(pendulum: Pendulum, launch: Launch) -> Motion:
        return SeriesMotion(pendulum, launch, order)

    if not isinstance(order, int) or order not in ORDERS:  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(
            f"The order of a series to compare must be one of {', '.join(map(str, ORDERS))}, but "
            f"it is {order!r:.60}."
        )
    return _Rung(f"SeriesMotion({order})", "series", make, _own_rates)


def _own_rates(motion: Motion, half_swing: float) -> Rates:
    assert isinstance(motion, LinearMotion | OlssonMotion | SeriesMotion)
    return Rates(float(motion.frequency), float(motion.precession))


def _times(exact: ExactMotion, duration: float | None) -> Numbers:
    swing = exact.comparison_swing
    span = _SWINGS * swing if duration is None else one_number(duration, "The duration", "s")
    if not 0 < span < math.inf:
        raise InvalidInput(f"The duration must be positive and finite, but it is {duration} s.")
    if span > _MOST_SWINGS * swing:
        raise InvalidInput(
            f"A comparison over {span:.6g} s would take long: these are {span / swing:.4g} swings, "
            f"and two of the motions are integrated step by step; ask for {_MOST_SWINGS} swings, "
            f"{_MOST_SWINGS * swing:.6g} s, at most."
        )
    count = exact.comparison_count(span)
    return span / (count - 1) * np.arange(count, dtype=np.float64)


def _positions(motion: Motion, times: Numbers, told: Told) -> Numbers:
    """Positions at evenly spread times from 0 on, m: (n, 3)."""
    if isinstance(motion, CubicMotion | PlaneMotion):
        return told.positions(motion, times)
    return motion.sample(0.0, float(times[1]), len(times))


def _compared(
    rung: _Rung, exact: ExactMotion, times: Numbers, truth: Numbers, told: Told
) -> Compared:
    row = Compared(rung.name, rung.equation)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            motion = rung.make(exact.pendulum, exact.launch)
            # (13) knows no sphere: beyond the support's level it runs away, and takes long for it.
            known = (times <= motion.span[1]) & ~np.logical_or.accumulate(truth[:, 2] < 0)
            errors = np.full(len(times), np.nan)
            found = _positions(motion, times[known], told)
            errors[known] = _core.distances(found.ravel(), truth[known].ravel())
        except KugelpendelError as error:
            return replace(row, reason=str(error))
    cautions = [str(warning.message) for warning in caught]
    if np.isnan(errors).any():
        end = times[int(np.isnan(errors).argmax()) - 1]
        cautions.append(f"It ends after {end:.4g} s, where the bob comes to the support's level.")
    ends = np.isnan(errors).any() or not exact.frequency
    rates = Rates(None, None) if ends else rung.rates(motion, float(exact.radial_period))
    return replace(
        row,
        trust=motion.trust,
        caution=" ".join(cautions),
        errors=errors,
        period=_relative(float(exact.frequency), rates.frequency),
        precession=_relative(rates.precession, float(exact.precession)),
    )


def _relative(approximate: float | None, truth: float | None) -> float | None:
    if approximate is None or truth is None:
        return None
    return _core.relative_error(approximate, truth)
