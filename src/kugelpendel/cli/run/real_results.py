"""What a real job has come to: what its report and its results.json tell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.observables import Explanation, RealSummary


@dataclass(frozen=True)
class RealResults:
    """What a real job has come to.

    Attributes
    ----------
    summary
        Of the motion.
    explanation
        Of the plane's rate.
    samples
        Rows of the track.
    stopped
        Whether the user stopped it.
    """

    summary: RealSummary
    explanation: Explanation
    samples: int
    stopped: bool
