"""What a job finds out: the numbers of the report and of ``results.json``."""

from __future__ import annotations

import math
from dataclasses import dataclass

import kugelpendel as kp
from kugelpendel.plot import Constants, turning_rate


@dataclass(frozen=True)
class Answer:
    """Numbers in SI; angles in rad, azimuths and rates positive counter-clockwise seen from above.

    Attributes
    ----------
    known : Constants
        The constants of the motion.
    regime : str
        "rest"; "balance" (at rest on top); "separatrix" (never comes back); "plane" (to and fro) or
        "rotation" (over the top) in a vertical plane; "cone"; "ellipse" (below the support); or
        "above" (rises above it).
    sense : int
        1 for counter-clockwise seen from above, −1 for clockwise, 0 for neither.
    turning : float
        Rate of the outer turning points on the branch that turns least, rad/s: the precession,
        unless ``whole_turns`` is true.
    full_turn : float
        Time for one turn of the ellipse, or of the highest point, s; inf where nothing turns.
    once_round : float
        Time for one turn of the bob about the vertical on a cone, s; inf otherwise.
    formula_25 : float or None
        Precession by the paper's (25), rad/s; None where it does not apply, as ``why_not`` says.
    frequency_26 : float or None
        Frequency by the paper's (26), rad/s; None where it does not apply.
    energy : float
        Above the lowest point, J/kg.
    tension : tuple of float
        Smallest and largest, N.
    slack_time : float
        When a thread first goes slack, s after the launch; inf for never.
    """

    known: Constants
    regime: str
    sense: int
    turning: float
    whole_turns: bool
    full_turn: float
    once_round: float
    formula_25: float | None
    why_not: str
    frequency_26: float | None
    largest_angle: float
    energy: float
    tension: tuple[float, float]
    slack_time: float

    @property
    def swing_period(self) -> float:
        """2π/ω in s: there and back, or once round a vertical circle; inf on the separatrix."""
        return 2 * math.pi / self.known.frequency if self.known.frequency > 0 else math.inf

    @property
    def error_25(self) -> float | None:
        """How far (25) is off, as a fraction of the exact precession."""
        if self.formula_25 is None or self.known.precession == 0:
            return None
        return self.formula_25 / self.known.precession - 1


def find(motion: kp.ExactMotion) -> Answer:
    """Ask one motion for everything that the report says."""
    known = Constants.of(motion)
    gravity = float(motion.pendulum.gravity)
    regime = _regime(known, moves=bool(motion.velocity(0.0).any()))
    tension = motion.tension_range
    turning, whole = turning_rate(motion)
    sense = (known.angular_momentum > 0) - (known.angular_momentum < 0)
    a, b = known.outer, sense * known.inner
    formula_25 = frequency_26 = None
    if regime in ("cone", "ellipse"):
        formula_25 = float(kp.olsson.precession(a, b, known.length, gravity))
    if regime in ("cone", "ellipse", "plane") and not known.rises_above:
        frequency_26 = float(kp.olsson.frequency(a, b, known.length, gravity))
    turns = regime in ("ellipse", "above") and turning != 0
    azimuth_rate = abs(known.precession) + known.frequency
    return Answer(
        known=known,
        regime=regime,
        sense=sense,
        turning=turning,
        whole_turns=whole,
        full_turn=2 * math.pi / abs(turning) if turns else math.inf,
        once_round=2 * math.pi / azimuth_rate if regime == "cone" else math.inf,
        formula_25=formula_25,
        why_not=_WHY_NOT_25.get(regime, ""),
        frequency_26=frequency_26,
        largest_angle=2 * math.asin(min(math.sqrt(known.high / (2 * known.length)), 1.0)),
        energy=float(motion.energy),
        tension=(float(tension[0]), float(tension[1])),
        slack_time=float(motion.slack_time),
    )


_WHY_NOT_25 = {
    "rest": "there is no ellipse at rest",
    "balance": "there is no ellipse at rest",
    "separatrix": "the motion never comes back",
    "plane": "the swing stays in a vertical plane",
    "rotation": "the bob turns over the top in a vertical plane",
    "above": "it holds for small ellipses, below the support",
}


def _regime(known: Constants, moves: bool) -> str:
    if known.high == 0:
        return "rest"
    if not known.frequency > 0:
        return "separatrix" if moves else "balance"
    if known.angular_momentum == 0:
        # A revolution takes 2π/ω, a swing to the other side π/ω.
        over = known.frequency * known.radial_period > 1.5 * math.pi
        return "rotation" if over else "plane"
    if known.rises_above:
        return "above"
    return "cone" if known.is_cone else "ellipse"
