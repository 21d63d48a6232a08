"""The ellipse of every window of a track, with its errors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.parameters import one_number
from kugelpendel.tracks._asked import require_listener, require_track
from kugelpendel.tracks._track import Track
from kugelpendel.tracks.reduction._carrier import (
    Array,
    Carrier,
    Complexes,
    first_guess,
    swing_frequency,
    usual_step,
)
from kugelpendel.tracks.reduction._labelled import covariance_of, labelled
from kugelpendel.tracks.reduction._spectrum import Noise, noise_of
from kugelpendel.tracks.reduction._windows import (
    AHEAD,
    BEHIND,
    CENTRE,
    Windows,
    cut,
    fitted,
    sure,
    without_outliers,
)

_CARRIER_ROUNDS = 3
_CARRIER_DEGREE = 4
_LEAST_PARTS = 6
"""A track is cut into so many windows at least, if they keep three swings."""

_ROUND = 4.0
"""Where the smaller circle is less than so many of its errors, the ellipse has no axis."""

_STRANGE = 0.25
"""A residual beyond this share of the amplitude, or such a share of outliers, is no noise."""


@dataclass(frozen=True)
class _Reduced:
    """A track taken apart."""

    time: Array
    z: Complexes
    kept: Array
    residuals: Complexes
    carrier: Carrier
    windows: Windows
    noise: Noise
    pieces: int
    left_out: int
    origin: complex


def ellipses(
    track: Track, *, swings: float = 8.0, progress: Callable[[float], None] | None = None
) -> Any:
    """Size, shape, direction and frequency of the swing, window by window, with errors.

    Parameters
    ----------
    track
        Times and positions.
    swings
        Swings in a window, from 3 on; a shorter track is cut into six windows if these keep three.
    progress
        Called now and then with the share that is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    An `xarray.Dataset` over `time`, s, the mean time of each window:
    `a` and `b` in the unit of the track, b positive where the ellipse is run through
    counter-clockwise; `azimuth` of the major axis in rad, counter-clockwise from x, unwrapped from
    its first value in (−π/2, π/2]; `frequency` in rad/s; the centre `x0`, `y0`. Each has its
    standard error `…_stderr`, and `covariance` has them all together. `spread` is the standard
    deviation of the times of a window, `points` its count. The attributes say what was seen on
    the way: `unit`, `noise` (rms of one coordinate of a point), `rejected`, `pieces`, `planar` …

    Raises
    ------
    InvalidInput
        For what is no track, tracks that show no swing, fewer than three, or less than three
        points to one; for two motions in one, circles, and constant positions.
    MissingExtra
        Where xarray or SciPy is not installed.

    Notes
    -----
    Of every window x + iy is fitted with the two circles of the swing and their slopes, the centre
    with its own, and two harmonics; outliers are those beyond 4.5 standard deviations. Errors come
    from the spectrum of the residuals at the frequency of the swing, so that slow or hasty noise
    is counted as it acts, and x may be noisier than y. On tracks with a known truth the 95 %
    intervals hold in 93 to 99 % (docs/tracks.md). a and b are those of the fundamental, at a time
    in the middle: a turning radius is (3/64)(a² − b²)/l² less for a, and as much more for b.
    """
    require_extra("fit", "kugelpendel.tracks", "scipy", "xarray")
    require_track(track)
    require_listener(progress)
    return _dataset(_reduced(track, swings, progress or (lambda share: None)), track.unit)


def residuals(track: Track, *, swings: float = 8.0) -> Any:
    """What the windows of a track leave over, and its spectrum.

    Parameters
    ----------
    track, swings
        As for `ellipses`.

    Returns
    -------
    An `xarray.Dataset` over the `time` of the points: residuals `x` and `y`, the fitted places
    `model_x` and `model_y`, and `kept`, whether the point was used; and over `angular_frequency`,
    rad/s, from the slow circle behind to the one ahead, the `spectrum` of x + iy per point with
    the line `spectrum_model` from which the errors are taken. Raises what `ellipses` does.
    """
    require_extra("fit", "kugelpendel.tracks", "scipy", "xarray")
    import xarray

    require_track(track)
    reduced = _reduced(track, swings, lambda share: None)
    place = reduced.z - reduced.residuals + reduced.origin
    rest = reduced.residuals.copy()
    omega0 = float(np.mean(reduced.carrier.frequency(reduced.windows.middle)))
    noise, unit = reduced.noise, track.unit
    line = noise.line(np.where(noise.frequency == 0, omega0, noise.frequency), omega0)
    return xarray.Dataset(
        {
            "x": ("time", rest.real, {"units": unit}),
            "y": ("time", rest.imag, {"units": unit}),
            "model_x": ("time", place.real, {"units": unit}),
            "model_y": ("time", place.imag, {"units": unit}),
            "kept": ("time", reduced.kept.copy()),
            "spectrum": ("angular_frequency", noise.power.copy(), {"units": f"{unit}2"}),
            "spectrum_model": ("angular_frequency", line, {"units": f"{unit}2"}),
        },
        {
            "time": ("time", reduced.time.copy(), {"units": "s"}),
            "angular_frequency": ("angular_frequency", noise.frequency.copy(), {"units": "rad/s"}),
        },
        {"swing_frequency": omega0, "unit": unit},
    )


_LATEST: WeakKeyDictionary[Track, tuple[float, _Reduced]] = WeakKeyDictionary()
"""The latest reduction of each track that is in use: ellipses and residuals come of the same."""


def _reduced(track: Track, swings: float, tell: Callable[[float], None]) -> _Reduced:
    """The track taken apart, once for all that is asked of it."""
    swings = one_number(swings, "swings", "")
    latest = _LATEST.get(track)
    if latest is None or latest[0] != swings:
        latest = _LATEST[track] = (swings, _reduce(track, swings, tell))
    tell(1.0)
    return latest[1]


def _reduce(track: Track, swings: float, tell: Callable[[float], None]) -> _Reduced:
    if not 3 <= swings < 1e6:
        raise InvalidInput.of("track_window", swings=float(swings))
    time, z = np.asarray(track.time), track.x + 1j * track.y
    origin = complex(np.median(z.real), np.median(z.imag))
    z = z - origin
    kept = first_guess(z)
    omega = swing_frequency(time, z, kept)
    tell(0.05)
    whole = (time[-1] - time[0]) * omega / (2 * np.pi)
    size = min(swings, max(3.0, whole / _LEAST_PARTS))
    bounds, count, left_out = cut(time, omega, size)
    seen = {"points": float(len(time)), "period": (2 * np.pi / omega, "s")}
    if not bounds:
        raise InvalidInput.of("track_pieces", **seen)
    half = 0.5 * float(time[-1] - time[0])
    carrier = Carrier(np.array([0.0, omega * half]), float(time[0]) + half, half)
    for turn in range(_CARRIER_ROUNDS):
        windows, _ = fitted(time, z, kept, bounds, carrier)
        carrier = _followed(windows, carrier)
        tell(0.1 + 0.1 * turn)
    windows, rest, kept = without_outliers(
        time, z, kept, bounds, carrier, lambda share: tell(0.4 + 0.5 * share)
    )
    good = sure(windows)
    if not good.any():
        raise InvalidInput.of("track_pieces", **seen)
    for begin, behind in zip(windows.first[~good], windows.behind[~good], strict=True):
        left_out += int(behind - begin)
        kept[begin:behind] = False
        rest[begin:behind] = 0.0
    windows = windows.chosen(good)
    _refuse_strange(windows, rest, kept, len(time) - left_out)
    noise = noise_of(time, rest, kept, windows, carrier)
    return _Reduced(time, z, kept, rest, carrier, windows, noise, count, left_out, origin)


def _followed(windows: Windows, carrier: Carrier) -> Carrier:
    """The carrier with the phase of the windows: half the turn of one circle against the other."""
    good = sure(windows)
    if not good.any():
        return carrier
    some = windows.chosen(good)
    ahead, behind = some.found[:, AHEAD], some.found[:, BEHIND]
    phase = np.unwrap(np.angle(ahead * behind.conj())) / 2
    weights = np.sqrt(np.abs(ahead * behind)) + 1e-300
    return carrier.corrected(some.middle, phase, weights, _CARRIER_DEGREE)


def _refuse_strange(windows: Windows, rest: Complexes, kept: Array, inside: int) -> None:
    """Raise InvalidInput where what is left over is no noise: another motion is in the track."""
    size = float(np.median(np.abs(windows.found[:, AHEAD]) + np.abs(windows.found[:, BEHIND])))
    left = float(np.sqrt(np.mean(np.abs(rest[kept]) ** 2))) if kept.any() else np.inf
    rejected = 1.0 - np.count_nonzero(kept) / max(inside, 1)
    if left > _STRANGE * size or rejected > _STRANGE:
        raise InvalidInput.of("track_two_motions", share=left / size, rejected=100 * rejected)


def _dataset(reduced: _Reduced, unit: str) -> Any:
    windows, noise = reduced.windows, reduced.noise
    ahead, behind = windows.found[:, AHEAD], windows.found[:, BEHIND]
    p, q = np.abs(ahead), np.abs(behind)
    g = windows.inverse[:, AHEAD, AHEAD].real
    floor = np.finfo(float).eps * (p + q)
    smaller = np.minimum(
        p / (np.sqrt(noise.ahead * g) + floor), q / (np.sqrt(noise.behind * g) + floor)
    )
    if np.median(smaller) < _ROUND:
        a, b = float(np.median(p + q)), float(np.median(p - q))
        raise InvalidInput.of("track_circle", a=(a, unit), b=(b, unit))
    azimuth = np.unwrap(np.angle(ahead * behind)) / 2
    azimuth -= np.pi * np.ceil(azimuth[0] / np.pi - 0.5)
    slopes = windows.found[:, AHEAD + 2] / ahead - windows.found[:, BEHIND + 2] / behind
    centre = windows.found[:, CENTRE] + reduced.origin
    values = {
        "a": p + q,
        "b": p - q,
        "azimuth": azimuth,
        "frequency": reduced.carrier.frequency(windows.middle) + 0.5 * slopes.imag / windows.spread,
        "x0": centre.real,
        "y0": centre.imag,
    }
    left = reduced.residuals[reduced.kept]
    attrs = {
        "unit": unit,
        "origin": "track",
        "noise": float(np.sqrt(np.mean(np.abs(left) ** 2) / 2)),
        "noise_x": float(np.std(left.real)),
        "noise_y": float(np.std(left.imag)),
        "noise_ahead": noise.ahead,
        "noise_behind": noise.behind,
        "cells": noise.cells,
        "points": len(left),
        "rejected": int(len(reduced.time) - reduced.left_out - len(left)),
        "left_out": reduced.left_out,
        "pieces": reduced.pieces,
        "rate": 1.0 / usual_step(reduced.time),
    }
    covariance = covariance_of(windows, noise, azimuth)
    own = (each.copy() for each in (windows.spread, windows.points))
    return labelled(windows.middle.copy(), values, covariance, attrs, *own)
