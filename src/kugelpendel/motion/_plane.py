"""Olsson's (12): the exact equation in the plan view."""

from __future__ import annotations

from functools import cached_property
from typing import final

import numpy as np

from .. import _core
from ._integrated import IntegratedMotion


@final
class PlaneMotion(IntegratedMotion):
    """The exact law in x and y alone, integrated: Olsson (1981), eq. (12).

    As printed, the second term lacks a factor 1/l². Error: 1e-12 l over 100 swings
    (tests/motion/test_integrated.py). Where the bob reaches the height of the support the equation
    divides by zero: `span` ends there. Raises InvalidInput for a launch on the
    upper half of the sphere; in an ensemble such a case is NaN.
    """

    _equation = "plane"

    @cached_property
    def _ends(self) -> tuple[float, float]:
        first, last = -np.inf, np.inf
        heights = self._exact.turning_heights[..., 0].reshape(-1)
        periods = np.broadcast_to(self._exact.radial_period, self.shape).reshape(-1)
        for k in self._cases():
            if heights[k] >= self._pendulums[k, 0]:
                pendulum, start = self._pendulums[k].tolist(), self._starts[k].tolist()
                period = min(float(periods[k]), 1e3)
                begin, end = _core.integrated_span(pendulum, self._equation, start, period)
                first, last = max(first, begin), min(last, end)
        return (first, last)

    @property
    def span(self) -> tuple[float, float]:
        """First and last time, s: until the bob reaches the height of the support."""
        return self._ends

    @property
    def trust(self) -> str:
        """Where the motion holds."""
        return "Exact below the support's level; ends where the bob reaches it."
