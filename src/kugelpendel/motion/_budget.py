"""What turns the plane of a swing, cause by cause, and where it hurries, lags or stalls."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kugelpendel import _core
from kugelpendel.parameters import InvalidInput, Numbers

CAUSES = ("earth", "intrinsic", "anisotropy", "damping", "drive")
"""Whose shares add up to the rate of the plane; the names are those of `PrecessionBudget`."""


@dataclass(frozen=True)
class Stretch:
    """A time in which the plane keeps one pace.

    Attributes
    ----------
    pace
        "hurries" and "lags" against the Earth's share, "stalls" below a tenth of it or backwards,
        "as it should" within a hundredth of it.
    start, stop
        When it begins and ends, s.
    cause
        The largest share that drives the rate that way, one of `CAUSES` without "earth"; "" where
        the pace is as it should be. Of the ellipse's own turning and the drive's the larger one
        counts, with what the other leaves of it.
    against
        The largest share the other way, where it is more than half of that; "" where none is.
    """

    pace: str
    start: float
    stop: float
    cause: str
    against: str


@dataclass(frozen=True, eq=False)
class PrecessionBudget:
    """How fast the plane of a swing turns, cause by cause, and how the swing changes.

    All are averaged over a swing, and arrays of one shape, (*motion.shape, *times.shape); `times`
    has its own. Angles and rates are positive counter-clockwise seen from above. The five shares
    add up to `total`.

    Attributes
    ----------
    times
        s.
    azimuth
        Of the major axis, rad, continuous.
    earth
        −Ω_z of the site, rad/s.
    intrinsic
        Ω of the ideal motion, which goes with the area of the ellipse, rad/s.
    anisotropy
        Of the suspension's stiffness, rad/s; infinite on a circle, which has no axis.
    damping
        Of damping that depends on the direction, rad/s. Drag that does not turns no plane.
    drive
        Of the pushes, rad/s.
    outer, inner
        Rates of a and b, m/s, all causes together.
    """

    times: Numbers
    azimuth: Numbers
    earth: Numbers
    intrinsic: Numbers
    anisotropy: Numbers
    damping: Numbers
    drive: Numbers
    outer: Numbers
    inner: Numbers

    @property
    def total(self) -> Numbers:
        """dψ/dt, rad/s."""
        return self.earth + self.beyond_earth

    @property
    def beyond_earth(self) -> Numbers:
        """What all causes but the Earth add, rad/s."""
        return self.intrinsic + self.anisotropy + self.damping + self.drive

    @property
    def pace(self) -> NDArray[np.str_]:
        """The pace at each time, as in `Stretch`; "" where the Earth has no share."""
        paces = _core.precession_pace(self._rows)
        return np.array(paces, dtype=np.str_).reshape(np.shape(self.earth))

    def stretches(self) -> list[Stretch]:
        """The times of one pace each, in order; none where the Earth has no share.

        A stretch reaches half-way to the times of its neighbours. Raises InvalidInput for an
        ensemble, and for anything but a row of times that ascend.
        """
        if self.times.ndim != 1 or np.shape(self.earth) != self.times.shape:
            raise InvalidInput(
                f"Stretches are those of one motion at a row of times, but the times have the "
                f"shape {self.times.shape} and the rates {np.shape(self.earth)}; ask each motion "
                f"by itself, at times such as numpy.linspace(0, 3600, 500)."
            )
        if not (np.diff(self.times) > 0).all():
            raise InvalidInput(
                "Stretches need times that ascend, but these do not; sort them before the motion "
                "is asked for its rates."
            )
        return [Stretch(*row) for row in _core.precession_stretches(self.times, self._rows)]

    @property
    def _rows(self) -> Numbers:
        """The five shares to a time, row after row."""
        return np.stack([getattr(self, cause) for cause in CAUSES], axis=-1).ravel()
