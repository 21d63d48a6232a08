"""Olsson's (20) with (25) and (26): the turning ellipse."""

from __future__ import annotations

from typing import final

from kugelpendel.motion.approximations._harmonic import HarmonicMotion


@final
class OlssonMotion(HarmonicMotion):
    """The turning ellipse: Olsson (1981), eq. (20), its Ω from (25) and its ω from (26).

    Semi-axes are the launch's exact turning radii, z lies on the sphere; no harmonics but the
    first. Raises InvalidInput where the path rises above the support; in an ensemble such a case
    is NaN.
    """

    _law = "olsson"

    @property
    def trust(self) -> str:
        """A sentence that says where the motion holds."""
        return (
            "Small ellipses: Ω is low by a relative (7/32)(a² + b²)/l², and the shape lacks "
            "harmonics of relative size (a² + b²)/l²."
        )
