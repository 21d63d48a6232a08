"""How long to record, before anyone hangs a pendulum up, by the Cramér–Rao bound."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kugelpendel import _core
from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.parameters import Numbers, Site, one_number
from kugelpendel.tracks.fitting._model import (
    ALL,
    FORCES,
    IDEAL,
    INTRINSIC,
    SHAPE,
    Measured,
)
from kugelpendel.tracks.fitting._search import inverse

_DAYS = 30
_SHORTEST = 60.0
"""s: from here to thirty days a length of the record is looked for."""

_WINDOWS = 96
"""Windows into which a planned track is cut; each has the information of its points."""

_LOOKED = 28
"""Lengths of the record that are looked at, in even ratios; between them the bound is a power."""


@dataclass(frozen=True)
class PlanRow:
    """What a record of one length would tell, at the best.

    Attributes
    ----------
    duration
        s.
    intrinsic
        Standard error of κ over 3/8, with Ω_z fitted as well.
    intrinsic_known
        The same with Ω_z known from the latitude.
    latitude
        Standard error of the latitude over itself, NaN where none is given.
    """

    duration: float
    intrinsic: float
    intrinsic_known: float
    latitude: float


@dataclass(frozen=True)
class Plan:
    """How long to record.

    Attributes
    ----------
    share
        The relative standard error that is aimed at.
    intrinsic_time
        s for κ, the coefficient of ω0 ab/l², 3/8 in theory; NaN where thirty days are too short.
    intrinsic_time_known
        s for κ with Ω_z known from the latitude.
    latitude_time
        s for the latitude.
    rows
        The bound for records of several lengths.
    half_life
        s, in which the amplitude halves, as it was assumed.
    """

    share: float
    intrinsic_time: float
    intrinsic_time_known: float
    latitude_time: float
    rows: Sequence[PlanRow]
    half_life: float


def plan(
    length: float,
    *,
    a: float,
    b: float,
    noise: float,
    rate: float,
    gravity: float = 9.80665,
    latitude: float | None = None,
    half_life: float | None = None,
    share: float = 0.01,
) -> Plan:
    """How long a pendulum must be recorded to see 3/8 · ab, or the latitude, to a per cent.

    Parameters
    ----------
    length
        m.
    a, b
        Semi-axes at the start, m. Without b there is nothing to see of κ.
    noise
        Standard deviation of one coordinate of a point, m.
    rate
        Points a second.
    gravity
        m/s².
    latitude
        rad; without, there is no `latitude_time`.
    half_life
        s, in which the amplitude halves; an hour where it is not given. Without decay κ could not
        be told from Ω_z.
    share
        The relative standard error that is aimed at.

    Returns
    -------
    Plan
        From the bound of a perfect fit with the eight parameters of the narrow model, the
        suspension's axis unknown: no real record does better. White noise; what no noise shows,
        uneven damping and tilt, comes on top.

    Raises
    ------
    InvalidInput
        For numbers that are not positive, and an ellipse that is none.
    """
    require_extra("fit", "kugelpendel.tracks", "scipy", "xarray")
    given = {
        "length": (length, "m"), "noise": (noise, "m"), "rate": (rate, "1/s"),
        "gravity": (gravity, "m/s²"), "share": (share, ""),
        "half_life": (3600.0 if half_life is None else half_life, "s"),
    }  # fmt: skip
    sizes = {name: one_number(value, name, unit) for name, (value, unit) in given.items()}
    for name, value in sizes.items():
        if not 0 < value < np.inf:
            raise InvalidInput.of("fit_positive", what=name, seen=value)
    length, noise, rate, gravity, share, half_life = sizes.values()
    a, b = one_number(a, "a", "m"), one_number(b, "b", "m")
    latitude = None if latitude is None else one_number(latitude, "latitude", "rad")
    if not 0 < abs(b) < a < length:
        raise InvalidInput.of("plan_ellipse", a=a, b=b, length=length)
    rotation = 0.0 if latitude is None else float(np.asarray(Site(latitude).vertical_rotation))
    period = 2 * np.pi * np.sqrt(length / gravity)
    durations = np.geomspace(max(_SHORTEST, 24 * period), _DAYS * 86400.0, _LOOKED)
    decay = np.log(2) / half_life
    rows = [
        _row(duration, (length, gravity, a, b, rotation, decay), noise, rate, latitude)
        for duration in durations
    ]
    times = [
        _first([getattr(row, name) for row in rows], durations, share)
        for name in ("intrinsic", "intrinsic_known", "latitude")
    ]
    intrinsic, known, angle = times
    return Plan(share, intrinsic, known, angle, rows, half_life)


def _row(
    duration: float,
    pendulum: tuple[float, ...],
    noise: float,
    rate: float,
    latitude: float | None,
) -> PlanRow:
    length, gravity, a, b, rotation, decay = pendulum
    edges = np.linspace(0.0, duration, _WINDOWS + 1)
    time = 0.5 * (edges[1:] + edges[:-1])
    points = rate * duration / _WINDOWS
    level = 2 * noise**2 / points
    fading = np.exp(-decay * time)
    # Of what has died away nothing is left to see; the errors stay finite.
    p, q = (0.5 * size * np.maximum(fading, 1e-9) for size in (a + b, a - b))
    # As in `covariance_of`, with white noise; b of the plan is near enough to weigh the windows.
    errors = np.stack(
        [
            np.full(_WINDOWS, np.sqrt(level)),
            np.full(_WINDOWS, np.sqrt(level)),
            np.sqrt(level * (1 / p**2 + 1 / q**2) / 8),
        ],
        axis=-1,
    )
    whitening = np.zeros((_WINDOWS, 3, 3))
    whitening[:, range(3), range(3)] = 1 / errors
    omega = np.sqrt(gravity / length)
    spread = np.zeros(_WINDOWS)
    measured = Measured(time, spread, np.stack([a * fading, b * fading, 0 * time], -1), whitening, omega, gravity, length)  # fmt: skip # noqa: E501
    row = measured.row({"a": a, "b": b, "rotation": rotation, "linear": decay})
    names = (*SHAPE, *FORCES, INTRINSIC)
    slopes = _slopes(measured, row, names)
    intrinsic = _error(slopes, names, INTRINSIC, ()) / IDEAL
    known = _error(slopes, names, INTRINSIC, ("rotation",)) / IDEAL
    turning = _error(slopes, names, "rotation", (INTRINSIC,))
    if latitude is None or latitude == 0:
        return PlanRow(duration, intrinsic, known, float("nan"))
    angle = turning / (_core.ROTATION * max(abs(np.cos(latitude)), 1e-9))
    return PlanRow(duration, intrinsic, known, angle / abs(latitude))


def _slopes(measured: Measured, row: Numbers, names: tuple[str, ...]) -> Numbers:
    """Derivatives of the whitened windows, a column for each parameter."""
    free = [ALL.index(name) for name in names]
    steps = measured.steps()[free]
    rows = np.tile(row, (2 * len(free), 1))
    rows[np.arange(len(free)), free] += steps
    rows[len(free) + np.arange(len(free)), free] -= steps
    white = measured.whitened(measured.differences(measured.predicted(rows)))
    return ((white[len(free) :] - white[: len(free)]) / (2 * steps[:, None])).T


def _error(slopes: Numbers, names: tuple[str, ...], name: str, known: tuple[str, ...]) -> float:
    left = [k for k, each in enumerate(names) if each not in known]
    covariance = inverse(slopes[:, left])
    k = left.index(names.index(name))
    return float(np.sqrt(covariance[k, k]))


def _first(errors: list[float], durations: Numbers, share: float) -> float:
    """When the error first falls below the share, by a power law between two lengths."""
    for k, error in enumerate(errors):
        if error <= share:
            if k == 0:
                return float(durations[0])
            before = errors[k - 1]
            if not np.isfinite(before):
                return float(durations[k])
            part = np.log(before / share) / np.log(before / error)
            return float(durations[k - 1] * (durations[k] / durations[k - 1]) ** part)
    return float("nan")
