"""Olsson's (12): the exact equation in the plan view."""

from __future__ import annotations

from typing import final

from kugelpendel.motion.approximations._integrated import IntegratedMotion


@final
class PlaneMotion(IntegratedMotion):
    """The exact law in x and y alone, integrated: Olsson (1981), eq. (12).

    As printed, the second term lacks a factor 1/l². Error: 1e-12 l over 100 swings
    (tests/motion/approximations/test_integrated.py). Where the bob reaches the height of the
    support the equation divides by zero: `span` ends there. Raises InvalidInput for a launch on the
    upper half of the sphere; in an ensemble such a case is NaN.
    """

    _equation = "plane"

    @property
    def trust(self) -> str:
        """A sentence on where the motion holds."""
        return "Exact below the support's level; ends where the bob reaches it."
