"""Section 3: the resting ellipse of infinitesimal displacements, (16)."""

from __future__ import annotations

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import small, truncated
from kugelpendel.paper.algebra.notation import Relation
from kugelpendel.paper.algebra.sympy_names import Expr, diff
from kugelpendel.paper.derivation import conditions as c
from kugelpendel.paper.derivation.model import Formula, Kind, Step, claim
from kugelpendel.paper.proofs.numeric import in_world
from kugelpendel.paper.proofs.symbolic import Premises, Proof
from kugelpendel.paper.proofs.worlds import linear

_LINEAR = in_world(linear)


def _solves(relation: Relation, p: Premises) -> list[Expr]:
    """It obeys the linear part of (13) and starts at (a, 0) with the velocity (0, bω0)."""
    results: list[Expr] = []
    for q, qdd, equation, place, speed in (
        (s.x, s.xdd, "13a", s.a, 0),
        (s.y, s.ydd, "13b", 0, s.b * s.omega0),
    ):
        if relation.lhs != q:
            continue
        law = truncated(small(p[equation].difference), 1)
        motion = relation.rhs
        results.append(law.xreplace({q: motion, qdd: diff(motion, s.t, 2)}))
        results.append(motion.subs(s.t, 0) - place)
        results.append(diff(motion, s.t).subs(s.t, 0) - speed)
    return results or [relation.difference]


_STEP_X = Step(Kind.SOLVE, ("13a",), (c.LINEAR,), neglected=r"\omega_0^2 \frac{x^3}{l^2}")
_STEP_Y = Step(Kind.SOLVE, ("13b",), (c.LINEAR,), neglected=r"\omega_0^2 \frac{y^3}{l^2}")

FORMULAS: tuple[Formula, ...] = (
    claim("16:x", r"x = a \cos \omega_0 t", _STEP_X, Proof(_solves, _LINEAR), number="16"),
    claim("16:y", r"y = b \sin \omega_0 t", _STEP_Y, Proof(_solves, _LINEAR), number="16"),
)
