"""Chapter 8: the next order of (25) and (26), by the same steps from (12)."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.balance import rates
from kugelpendel.paper.algebra.calculus import small, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import Add, Expr, cos, sin, sqrt
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Step, StepKind, claim
from kugelpendel.paper.proofs.harmonics import harmonic
from kugelpendel.paper.proofs.numeric import to_order
from kugelpendel.paper.proofs.symbolic import Premises, Proof, follows
from kugelpendel.paper.proofs.worlds import dynamic


def _fifth(p: Premises) -> Expr:
    """(12) with its root and its fraction as series, up to the fifth order."""
    series = truncated(small(p["12"].lhs), 5)
    return series.xreplace({s.rho: sqrt(p["6:1"].rhs)})


def _ellipse(p: Premises) -> list[Expr]:
    """The first harmonics are those of (20), whose semi-axes are a and b."""
    fast, slow = s.omega * s.t, s.Omega * s.t
    place = s.a * cos(fast) * cos(slow) - s.b * sin(fast) * sin(slow)
    return [p["20:x"].rhs - place]


def _turning(relation: Relation, p: Premises) -> list[Expr]:
    _, turning = rates(p["D1"].lhs)
    return [*_ellipse(p), relation.difference - (s.Omega - s.omega0 * Add(*turning[:3]))]


def _swinging(relation: Relation, p: Premises) -> list[Expr]:
    swing, _ = rates(p["D1"].lhs)
    square = Add(*(swing[j] * swing[k] for j in range(3) for k in range(3 - j)))
    return [*_ellipse(p), relation.difference - (s.omega**2 - s.omega0**2 * square)]


_MOMENT = r"(x\dot{x} + y\dot{y})^2"

FORMULAS: tuple[Formula, ...] = (
    claim(
        "D1",
        r"\ddot{x} + \omega_0^2 x - \frac{1}{2} \omega_0^2 \frac{x}{l^2} (x^2 + y^2) "
        r"+ \frac{x}{l^2} (\dot{x}^2 + \dot{y}^2) "
        rf"+ \frac{{x}}{{l^4}} {_MOMENT} - \frac{{1}}{{8}} \omega_0^2 \frac{{x}}{{l^4}} "
        r"(x^2 + y^2)^2 = 0",
        Step(
            StepKind.NEGLECT,
            ("6:1", "12"),
            (c.SMALL, c.SMALL_RATES),
            neglected=rf"\frac{{x\rho^2}}{{l^6}} {_MOMENT} "
            r"- \frac{1}{16} \omega_0^2 \frac{x\rho^6}{l^6}",
        ),
        Proof(follows(_fifth), to_order(6, dynamic)),
    ),
    claim(
        "D2",
        r"\Omega = \frac{3}{8} \omega_0 \frac{ab}{l^2} "
        r"\left( 1 + \frac{7}{32} \frac{a^2 + b^2}{l^2} \right)",
        Step(
            StepKind.NEGLECT,
            ("20:x", "D1"),
            neglected=r"\omega_0 \frac{ab}{l^6} \left[ \frac{969}{32768} (a^4 + b^4) "
            r"+ \frac{711}{16384} a^2b^2 \right]",
        ),
        Proof(_turning, to_order(5, harmonic)),
    ),
    claim(
        "D3",
        r"\omega^2 = \omega_0^2 \left[ 1 - \frac{a^2 + b^2}{8l^2} "
        r"- \frac{13}{512} \frac{(a^2 - b^2)^2}{l^4} \right]",
        Step(
            StepKind.NEGLECT,
            ("20:x", "D1"),
            neglected=r"-\frac{\omega_0^2}{l^6} \left[ \frac{309}{32768} (a^6 + b^6) "
            r"- \frac{821}{32768} a^2b^2 (a^2 + b^2) \right]",
        ),
        Proof(_swinging, to_order(5, harmonic)),
    ),
)
