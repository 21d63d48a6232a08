"""What is fitted: ellipses in metres, where the search begins, what is free in each model."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.parameters import Numbers, Site, one_number
from kugelpendel.tracks._asked import require
from kugelpendel.tracks._scipy import chi_square_limit
from kugelpendel.tracks._track import Track
from kugelpendel.tracks.fitting._model import (
    ALL,
    DAMPING,
    FORCES,
    IDEAL,
    INTRINSIC,
    SHAPE,
    TILT,
    Measured,
)
from kugelpendel.tracks.fitting._search import Found, search
from kugelpendel.tracks.reduction import column, polynomial
from kugelpendel.tracks.reduction import ellipses as ellipses_of

_LEAST = 6
"""Windows that a fit needs: three numbers each, for eight parameters and twelve with nuisances."""

_GUESS = 0.02
"""a/l that is assumed of a track without a scale, where κ is free to make up for it."""

_LIGHTEST, _HEAVIEST = 8.0, 12.0
"""m/s²: between which gravity and a bob's corrections to it lie; beyond, the length or the sampling
is wrong."""

_FEW = 64
"""Windows that are fitted at first."""


def silent(share: float) -> None:
    """A progress that nobody watches."""


@dataclass(frozen=True)
class Problem:
    """Ellipses, and what can be asked of them.

    Attributes
    ----------
    ellipses
        The data set.
    measured
        The same in metres, with their whitening.
    scale
        Metres per unit of the track.
    scaled
        Whether the track is in metres.
    middle
        Index of the window at t0.
    start
        Where the search begins, in the order of `ALL`.
    free
        The free parameters of each model.
    sizes
        Standard deviations of the nuisances of a stated size.
    latitude
        rad, where it was given.
    """

    ellipses: Any
    measured: Measured
    scale: float
    scaled: bool
    middle: int
    start: Numbers
    free: Mapping[str, tuple[str, ...]]
    sizes: Mapping[str, float]
    latitude: float | None

    def stated(self, model: str) -> dict[str, float]:
        """The nuisances of a model that have a stated size; one alone is entirely free."""
        has_both = {*DAMPING, *TILT} <= set(self.free[model])
        return dict(self.sizes) if has_both else {}

    def narrow(self) -> Found:
        """The narrow model, found for the middle of a long record first and then outwards.

        Over hours the ellipse turns and widens so often that a search from afar would end in
        another minimum.
        """
        row, count = self.start, _FEW
        while count < len(self.measured.time):
            some = self.measured.near(self.middle, count)
            row = search(some, row, self.free["narrow"], {}).row
            count *= 2
        return self.solved("narrow", row)

    def solved(self, model: str, begin: Numbers) -> Found:
        """The least-squares fit of a model from a set of parameters."""
        row = begin.copy()
        if model == "intrinsic_known":
            assert self.latitude is not None
            row[ALL.index("rotation")] = float(np.asarray(Site(self.latitude).vertical_rotation))
        return search(self.measured, row, self.free[model], self.stated(model))


def problem_of(
    ellipses: Any,
    length: float | None,
    gravity: float,
    latitude: float | None,
    damping_unevenness: float,
    tilt: float,
    tell: Callable[[float], None],
) -> Problem:
    """The problem that `fit` solves; raises what it does."""
    require_extra("fit", "kugelpendel.tracks", "scipy", "xarray")
    damping_unevenness = _positive("damping_unevenness", damping_unevenness, "")
    tilt, gravity = _positive("tilt", tilt, ""), _positive("gravity", gravity, "m/s²")
    length = None if length is None else _positive("length", length, "m")
    if latitude is not None:
        latitude = one_number(latitude, "latitude", "rad")
        Site(latitude)  # refuses what is no latitude
    if isinstance(ellipses, Track):
        ellipses = ellipses_of(ellipses, progress=lambda share: tell(0.3 * share))
    is_reduced = type(ellipses).__name__ == "Dataset" and {*SHAPE, "covariance"} <= {*ellipses}
    way_out = "give what kugelpendel.tracks.ellipses(track) gives, or a track"
    require(is_reduced, "What is fitted", ellipses, "table of ellipses", way_out)
    windows = ellipses.sizes["time"]
    if windows < _LEAST:
        raise InvalidInput.of("fit_windows", windows=windows, least=_LEAST)
    middle = windows // 2
    scaled = ellipses.attrs["unit"] == "m"
    measured, scale = measured_of(ellipses, middle, length, gravity, scaled)
    if ellipses.attrs["planar"]:
        _refuse_plane(ellipses)
    start, decay = _start(measured.near(middle, _FEW))
    names = (*SHAPE, *FORCES) if scaled else (*SHAPE, *FORCES, INTRINSIC)
    wide = (*names, *DAMPING, *TILT)
    free: dict[str, tuple[str, ...]] = {
        "headline": wide,
        "narrow": names,
        "uneven": (*names, *DAMPING),
        "tilted": (*names, *TILT),
    }
    if scaled:
        free |= {"intrinsic": (*wide, INTRINSIC), "intrinsic_narrow": (*names, INTRINSIC)}
    if scaled and latitude is not None:
        known = (name for name in (*names, INTRINSIC) if name != "rotation")
        free["intrinsic_known"] = tuple(known)
    nuisances: dict[str, float] = dict.fromkeys(TILT, tilt)
    nuisances |= dict.fromkeys(DAMPING, damping_unevenness * decay)
    return Problem(ellipses, measured, scale, scaled, middle, start, free, nuisances, latitude)


def _positive(name: str, value: float, unit: str) -> float:
    number = one_number(value, name, unit)
    if not 0 < number < np.inf:
        raise InvalidInput.of("fit_positive", what=name, seen=number)
    return number


def measured_of(
    ellipses: Any, middle: int, length: float | None, gravity: float, scaled: bool
) -> tuple[Measured, float]:
    """What is fitted, and metres per unit of the track."""
    time = column(ellipses, "time")
    values = np.stack([column(ellipses, name) for name in SHAPE], axis=-1)
    covariance = column(ellipses, "covariance")[:, :3, :3].copy()
    frequency = _frequency(ellipses, middle, length, gravity)
    scale = 1.0
    if not scaled:
        reach = length if length is not None else gravity / frequency**2
        scale = _GUESS * reach / float(np.median(values[:, 0]))
    values[:, :2] *= scale
    covariance[:, :2, :] *= scale
    covariance[:, :, :2] *= scale
    # Where there is no noise at all, a trace of it keeps the matrices regular.
    floor = np.array([1e-12, 1e-12, 1e-12]) * np.array([values[middle, 0]] * 2 + [1.0])
    covariance += np.diag(floor**2)
    lower = np.linalg.cholesky(np.linalg.inv(covariance))
    whitening = np.asarray(lower.swapaxes(1, 2), dtype=float)
    spread = column(ellipses, "spread")
    return (
        Measured(time - time[middle], spread, values, whitening, frequency, gravity, length),
        scale,
    )


def _frequency(ellipses: Any, middle: int, length: float | None, gravity: float) -> float:
    """ω at t0 in rad/s: of a straight line through the windows, as one alone knows it less well."""
    frequency = column(ellipses, "frequency")
    if np.isfinite(frequency).all():
        time = column(ellipses, "time") - column(ellipses, "time")[middle]
        degree = min(4, len(time) - 2)
        scaled = time / max(float(np.abs(time).max()), 1e-9)
        weights = 1 / (column(ellipses, "frequency_stderr") + 1e-15)
        omega = float(polynomial(scaled, frequency, degree, weights)[0])
        if length is not None and not _LIGHTEST < length * omega**2 < _HEAVIEST:
            seen = {"length": (float(length), "m"), "period": (2 * np.pi / omega, "s")}
            raise InvalidInput.of("fit_length", gravity=(length * omega**2, "m/s²"), **seen)
        return omega
    if length is None:
        raise InvalidInput.of("fit_table_length", rows=len(frequency))
    return float(np.sqrt(gravity / length))


def _refuse_plane(ellipses: Any) -> None:
    """Raise InvalidInput for a swing that stays in one plane: nothing turns it."""
    azimuth, error = column(ellipses, "azimuth"), column(ellipses, "azimuth_stderr")
    weights = 1 / error**2
    mean = np.sum(weights * azimuth) / weights.sum()
    if np.sum(weights * (azimuth - mean) ** 2) < chi_square_limit(len(azimuth) - 1):
        unit = ellipses.attrs["unit"]
        a = float(np.median(column(ellipses, "a")))
        b = float(np.max(column(ellipses, "b_stderr")))
        raise InvalidInput.of("fit_plane", a=(a, unit), b=(b, unit))


def _start(measured: Measured) -> tuple[Numbers, float]:
    """Where the search begins, and the decay rate of a in 1/s."""
    time, (a, b, azimuth) = measured.time, measured.values.T
    columns: Numbers = np.stack([np.log(a), b, azimuth], axis=1)
    lines: list[list[float]] = polynomial(time, columns, 1).tolist()
    middle, slope = lines
    decay, size, across = -slope[0], float(np.exp(middle[0])), middle[1]
    length, _, omega0 = measured.pendulum(measured.row({"a": size, "b": across})[None])
    area = (np.exp(columns[:, 0]) * columns[:, 1]).mean()
    turned = IDEAL * float(area) * float(omega0[0]) / float(length[0]) ** 2
    given = {
        "a": size,
        "b": min(max(across, -0.9 * size), 0.9 * size),
        "azimuth": middle[2],
        "rotation": turned - slope[2],
        "linear": 0.5 * decay,
        "quadratic": 0.5 * decay * 3 * np.pi / (4 * float(omega0[0]) * size),
    }
    return measured.row(given), max(abs(decay), 1e-9)
