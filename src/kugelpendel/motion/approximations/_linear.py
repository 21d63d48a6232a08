"""Olsson's (16): the standing ellipse of infinitesimal swings."""

from __future__ import annotations

from typing import final

from kugelpendel.motion.approximations._harmonic import HarmonicMotion


@final
class LinearMotion(HarmonicMotion):
    """The standing ellipse: frequency ω0, no precession. Olsson (1981), eq. (16).

    Semi-axes are the launch's exact turning radii, z lies on the sphere. Raises InvalidInput where
    the path rises above the support; in an ensemble such a case is NaN.
    """

    _law = "linear"

    @property
    def trust(self) -> str:
        """A sentence that says where the motion holds."""
        return (
            "Infinitesimal swings, for few of them: the phase is off by (a² + b²)/16l² and the "
            "azimuth by (3/8)ab/l² in each radian of swing."
        )
