"""What turns the plane of a swing, cause by cause, and where the Earth alone would do it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kugelpendel.motion import EnvelopeMotion

CAUSES = ("earth", "intrinsic", "anisotropy", "damping", "drive")
"""Whose shares add up to the rate of the plane; the names are those of `Shares`."""

ALIKE = 0.01
"""A rate that differs by no more than this fraction from the Earth's share is as it should be."""

STALL = 0.1
"""Slower than this fraction of the Earth's share, or backwards, the plane stalls."""

PACES = ("hurries", "lags", "stalls", "as it should")


@dataclass(frozen=True)
class Stretch:
    """A time in which the plane keeps one pace.

    Attributes
    ----------
    pace : str
        One of `PACES`: "hurries" and "lags" against the Earth's share, "stalls" below `STALL` of it
        or backwards, "as it should" within `ALIKE` of it.
    start, stop : float
        s.
    cause : str
        The largest share that drives the rate that way, one of `CAUSES` without "earth"; "" where
        the pace is as it should be. Of the ellipse's own turning and the drive's the larger one
        counts, with what the other leaves of it.
    against : str
        The largest share the other way, where it is more than half of that; "" where none is.
    """

    pace: str
    start: float
    stop: float
    cause: str
    against: str


@dataclass(frozen=True)
class Shares:
    """Rate of the plane by its causes, at some times: averaged over a swing.

    Attributes
    ----------
    times, azimuth : (n,) arrays
        s; rad, continuous, counter-clockwise seen from above.
    earth, intrinsic, anisotropy, damping, drive : (n,) arrays
        Shares of dψ/dt, rad/s, counter-clockwise seen from above; they add up to `total`.
    """

    times: NDArray[np.float64]
    azimuth: NDArray[np.float64]
    earth: NDArray[np.float64]
    intrinsic: NDArray[np.float64]
    anisotropy: NDArray[np.float64]
    damping: NDArray[np.float64]
    drive: NDArray[np.float64]

    @classmethod
    def of(cls, motion: EnvelopeMotion, times: NDArray[np.float64]) -> Shares:
        """Ask one averaged motion, not an ensemble, at ascending times in s."""
        rates = motion.rates(times)
        return cls(
            times,
            motion.azimuth(times),
            *(np.broadcast_to(getattr(rates, cause), times.shape) for cause in CAUSES),
        )

    @property
    def total(self) -> NDArray[np.float64]:
        """dψ/dt, rad/s."""
        return self.earth + self.beyond_earth

    @property
    def beyond_earth(self) -> NDArray[np.float64]:
        """What all causes but the Earth add, rad/s."""
        return self.intrinsic + self.anisotropy + self.damping + self.drive

    @property
    def pace(self) -> NDArray[np.str_]:
        """One of `PACES` for each time; "" where the Earth has no share."""
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = self.total / self.earth
        return np.select(
            [self.earth == 0, ratio < STALL, ratio < 1 - ALIKE, ratio > 1 + ALIKE],
            ["", "stalls", "lags", "hurries"],
            "as it should",
        )

    def stretches(self) -> list[Stretch]:
        """The times of one pace each, in order; none where the Earth has no share."""
        pace = self.pace
        edges = np.flatnonzero(pace[1:] != pace[:-1]) + 1
        found: list[Stretch] = []
        for part in np.split(np.arange(len(pace)), edges):
            if pace[part[0]] == "":
                continue
            # A stretch reaches half-way to the samples of its neighbours.
            first, last = max(part[0] - 1, 0), min(part[-1] + 1, len(pace) - 1)
            found.append(
                Stretch(
                    str(pace[part[0]]),
                    float(self.times[first] + self.times[part[0]]) / 2,
                    float(self.times[last] + self.times[part[-1]]) / 2,
                    *self._causes(part, str(pace[part[0]])),
                )
            )
        return found

    def _causes(self, part: NDArray[np.int64], pace: str) -> tuple[str, str]:
        if pace == "as it should":
            return "", ""
        way = np.sign(self.earth[part[0]]) * (1 if pace == "hurries" else -1)
        shares = {cause: way * getattr(self, cause)[part].mean() for cause in CAUSES[1:]}
        # A drive that is timed well takes back what the ellipse turns by itself: both are large,
        # and only what remains of the two can be to blame.
        greater, lesser = sorted(("intrinsic", "drive"), key=lambda cause: -abs(shares[cause]))
        held = -shares[lesser] > shares[greater] / 2 > 0
        shares[greater] += shares.pop(lesser)
        most = max(shares, key=lambda cause: shares[cause])
        least = min(shares, key=lambda cause: shares[cause])
        if most == greater and held:
            return most, lesser
        return most, least if -shares[least] > shares[most] / 2 else ""
