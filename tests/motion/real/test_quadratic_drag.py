"""Quadratic drag where a suspension takes b through zero: against a third method."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

import kugelpendel as kp

STORED = Path(__file__).parents[2] / "reference" / "drag.json"
UNIT = kp.Pendulum(length=1.0, gravity=1.0)


def test_turning_points_next_to_rest_cost_no_digits() -> None:
    """At a turning point |v| falls to bω0, and its series reaches no further than b/a.

    references/equations/drag.py integrates the same equations with 96 bits, and its steps see this.
    """
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    largest, least, crossings = 0.0, np.inf, 0
    for case in stored["cases"]:
        motion = kp.RealMotion(
            UNIT,
            kp.Launch.plane(*case["launch"]),
            drag=kp.Drag(0.0, case["quadratic"]),
            suspension=kp.Suspension(case["anisotropy"], case["axis"]),
        )
        error = motion.position(stored["times"]) - np.array(case["places"], dtype=float)
        largest = max(largest, float(np.linalg.norm(error, axis=-1).max()))
        outer = motion.events("outer", 0.0, stored["times"][-1])
        a, b, _ = kp.ellipse(motion, outer)
        crossings += (np.diff(np.sign(b)) != 0).sum()
        least = min(least, float(np.abs(b / a).min()))
    assert crossings > len(stored["cases"])
    assert least < 1e-4
    assert largest < 1e-13
