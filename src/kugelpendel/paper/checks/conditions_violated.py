"""What happens where a condition fails: each statement is checked, by the name that conditions use.

Every function returns whether its statement, the docstring, holds identically.
"""

from __future__ import annotations

from collections.abc import Callable

from kugelpendel.paper.algebra import symbols as s
from kugelpendel.paper.algebra.calculus import EPS, is_zero, leading, rate, slow, small, taylor
from kugelpendel.paper.algebra.notation import Relation, components, read
from kugelpendel.paper.algebra.symbols import STILL
from kugelpendel.paper.algebra.sympy_names import (
    Add,
    Expr,
    Rational,
    Symbol,
    cos,
    diff,
    pi,
    sin,
    solve,
    sqrt,
)
from kugelpendel.paper.checks.remainders import (
    dropped_harmonics,
    imbalance,
    motion,
    remainders,
    third_harmonic,
)
from kugelpendel.paper.derivation.graph import formula, right
from kugelpendel.paper.derivation.section1 import turned_plumb_line
from kugelpendel.paper.derivation.statements import STATEMENTS


def slack() -> bool:
    """At rest above the support's height (5a) gives T = mg cos θ < 0: a thread cannot push."""
    pull = right("5a").rhs.xreplace({s.thetad: 0, s.phid: 0})
    return is_zero(pull - s.m * s.g * cos(s.theta)) and pull.subs(s.theta, 2 * pi / 3).is_negative


def longer() -> bool:
    """With a length that changes, r̈ has l̈ more along e_r, 2l̇θ̇ along e_θ, 2l̇φ̇ sin θ along e_φ."""
    ld, ldd = STILL[s.l], Symbol("lddot", real=True)
    extra = (ldd, 2 * ld * s.thetad, 2 * ld * s.phid * sin(s.theta))
    return all(is_zero(p - e) for p, e in zip(lengthening(ldd), extra, strict=True))


def lengthening(second_rate: Expr) -> tuple[Expr, ...]:
    """What l̇ and l̈ add to r̈, along e_r, e_θ and e_φ."""
    ld = STILL[s.l]

    def changing(e: Expr) -> Expr:
        return rate(e) + diff(e, s.l) * ld + diff(e, ld) * second_rate

    vector = Add(
        *(
            changing(changing(place)) * right(f"4:{q}").rhs
            for q, place in zip("xyz", turned_plumb_line(), strict=True)
        )
    )
    fixed = components(right("4.1:2").rhs.expand(), s.SPHERICAL)
    changed = components(vector.expand(), s.SPHERICAL)
    return tuple((p - f).expand() for p, f in zip(changed, fixed, strict=True))


def axis() -> bool:
    """Where sin θ = 0, (5c) says nothing about φ̈ and (10) nothing at all; yet (9) holds.

    (1) gives (9) without angles.
    """
    silent = right("5c").lhs.xreplace({sin(s.theta): 0}).diff(s.phidd) == 0
    silent = silent and is_zero(right("10").lhs.subs({s.x: 0, s.y: 0, s.rho: 0}))
    law = right("1").difference.xreplace({s.e_r: _direction()}).expand()
    along_x, along_y, _ = components(law, s.CARTESIAN)
    return silent and is_zero(s.x * along_y - s.y * along_x - s.m * right("9:2").difference)


def _direction() -> Expr:
    return (s.x * s.e_x + s.y * s.e_y + s.z * s.e_z) / s.l


def upper_half() -> bool:
    """With cos θ < 0 the root is −cos θ, and (10) is wrong by −2ω0² l² sin²θ cos θ > 0."""
    c = Symbol("c", real=True)  # cos θ, of either sign
    root = sqrt(1 - s.rho**2 / s.l**2)
    term = right("10").lhs.coeff(root) * root
    falsified = term.xreplace({root: -c}) - term.xreplace({root: c})
    angles = {s.x: s.l * sin(s.theta) * cos(s.phi), s.y: s.l * sin(s.theta) * sin(s.phi)}
    wanted = -2 * s.omega0**2 * s.l**2 * sin(s.theta) ** 2 * c
    return is_zero(falsified.xreplace(angles) - wanted)


def equator() -> bool:
    """On the equator 10.3 is 0 = 0, whatever θ̈; (5b) still says θ̈ = −g/l."""
    there = {sin(s.theta): 1, cos(s.theta): 0}
    empty = is_zero(right("10.3").lhs.xreplace(there))
    return empty and is_zero(right("5b").lhs.xreplace(there) - s.thetadd - s.g / s.l)


def x_zero() -> bool:
    """(12) holds at x = 0 and on the axis too: it is (1) along e_x, with T from r·(1)."""
    z = s.l * sqrt(1 - s.rho**2 / s.l**2)
    fall = -(s.x * s.xd + s.y * s.yd) / z
    square = s.xd**2 + s.yd**2 + fall**2
    gravity = s.omega0**2 * s.l
    without_division = s.xdd + s.x * (square + gravity * z) / s.l**2
    return is_zero((right("12").lhs - without_division).xreplace({s.rho: _distance()}))


def _distance() -> Expr:
    return sqrt(s.x**2 + s.y**2)


def large() -> bool:
    """What (13a) lacks begins in fifth order: small only if ρ ≪ l and the velocities are."""
    (lacking,) = (one for one in remainders() if one.label == "13a")
    claimed = read(STATEMENTS["missing-in-13a"]).lhs.xreplace({s.rho: _distance()})
    return lacking.order == 5 and is_zero(lacking.term - claimed)


def not_so_small() -> bool:
    """What (16) lacks is of third order, and turns the ellipse and lowers its frequency."""
    order = {one.order for one in remainders() if one.label.startswith("16")}
    lowered = (s.omega0**2 - right("26").rhs).subs({s.a: 1, s.b: Rational(1, 2), s.l: 1})
    turning = right("25").rhs.subs({s.a: 1, s.b: Rational(1, 2), s.l: 1})
    return order == {3} and bool(lowered.is_positive) and bool(turning.is_positive)


def stationary() -> bool:
    """Nothing in (13a) makes a or b grow: sin ωt cos Ωt and cos ωt sin Ωt do not occur."""
    rest = imbalance("13a")
    fast, slowly = s.omega * s.t, s.Omega * s.t
    start = {sin(fast): 0, cos(fast): 1, sin(slowly): 0, cos(slowly): 1}
    quarter = {sin(fast): 1, cos(fast): 0, sin(slowly): 1, cos(slowly): 0}
    along = rest.xreplace(start) * cos(fast) * cos(slowly)
    across = rest.xreplace(quarter) * sin(fast) * sin(slowly)
    return is_zero(rest - along - across)


def slow_turning() -> bool:
    """20.6 lacks 2abωΩ + Ω²(a² cos²ωt + b² sin²ωt); by (25), aΩ/bω is 3a²/8l², however small b."""
    lacking = motion()[s.xd] ** 2 + motion()[s.yd] ** 2 - right("20.6").rhs
    angle = s.omega * s.t
    square = s.a**2 * cos(angle) ** 2 + s.b**2 * sin(angle) ** 2
    wanted = read(STATEMENTS["omega-beside-omega"]).lhs + s.Omega**2 * square
    ratio = s.a * right("25").rhs / (s.b * s.omega0)
    claimed = read(STATEMENTS["turning-per-minor-axis"]).rhs
    return is_zero(lacking - wanted) and is_zero(ratio - claimed)


def near() -> bool:
    """ω0 for ω changes the balance in fifth order only, two orders below what is kept."""
    (lacking,) = (one for one in remainders() if one.label == "23.4")
    return lacking.kept == 3 and lacking.order == 5


def third_harmonics() -> bool:
    """Kept, they would add to x what the text says; the two cubic terms have opposite ones."""
    claimed = read(STATEMENTS["third-harmonic"]).lhs
    opposite = dropped_harmonics("20.10:2") + s.omega**2 * dropped_harmonics("20.8:1")
    return is_zero(third_harmonic() - claimed) and is_zero(opposite)


def omega_squared() -> bool:
    """By (25), (26): Ω²/(ω0² − ω²) = (9/8) a²b²/((a² + b²) l²) ≤ (9/32)(a² + b²)/l²."""
    turning = right("25").rhs ** 2
    shift = s.omega0**2 - right("26").rhs
    a2, b2 = s.a**2, s.b**2
    ratio = read(STATEMENTS["squared-share"]).lhs
    gap = Rational(9, 32) * (a2 + b2) / s.l**2 - ratio
    square = Rational(9, 32) * (a2 - b2) ** 2 / ((a2 + b2) * s.l**2)
    return is_zero(turning / shift - ratio) and is_zero(gap - square)


def independent() -> bool:
    """On a straight line (b = 0): 23.6 gives Ω = 0 and ω² = ω0²(1 − a²/8l²), as (25), (26) do."""
    line = {s.b: 0}
    (turning,) = solve(right("23.6:2").lhs.subs(line), s.Omega)
    first = right("23.6:1").lhs.subs(line).subs(s.Omega, turning)
    shift = s.omega**2 - right("26").rhs.subs(line)
    same = is_zero(turning - right("25").rhs.subs(line)) and is_zero(first - s.a * shift)
    # the plane pendulum: period longer by θ0²/16, energy integral expanded to second order
    return same and is_zero(taylor(sqrt(1 - EPS**2 / 8), 2)[2] + Rational(1, 16))


def y_equation() -> bool:
    """(13b) gives the same two conditions as (13a): with sin Ωt, cos Ωt in each other's places."""
    rest = taylor(slow(imbalance("13b")), 3)[3]
    first, second = (taylor(slow(right(f"23.6:{k}").lhs), 3)[3] for k in (1, 2))
    along = cos(s.omega * s.t) * sin(s.Omega * s.t)
    across = sin(s.omega * s.t) * cos(s.Omega * s.t)
    return is_zero(rest + first * along + second * across)


def circle() -> bool:
    """At a = b one equation is left, for ω + Ω only: that of the conical pendulum.

    (ω + Ω)² = ω0²(1 + a²/2l²) to second order is g/(l cos θ); (25) and (26) fulfil it. At a = −b
    the same holds for ω − Ω.
    """
    for sign, kept, lost in ((1, "23.8:1", "23.7:2"), (-1, "23.8:2", "23.7:1")):
        case = {s.b: sign * s.a}
        if not is_zero(right(lost).lhs.subs(case)):
            return False
        if not cone(read(STATEMENTS["cone" if sign == 1 else "opposite-cone"]), case):
            return False
        both = right(kept).lhs.xreplace({s.Omega: right("25").rhs, s.omega: sqrt(right("26").rhs)})
        if not is_zero(both.subs(case)):
            return False
    return True


def cone(relation: Relation, case: dict[Expr, Expr]) -> bool:
    """Whether a rate ω ± Ω is that of the conical pendulum, squared and to the order kept.

    The one of 23.8 that is left for the circle must say the same.
    """
    tilt = {cos(s.theta): sqrt(1 - s.a**2 / s.l**2), s.g: s.omega0**2 * s.l}  # sin θ = a/l
    squared = slow(relation.lhs**2) - slow((relation.rhs**2).xreplace(tilt))
    kept = "23.8:1" if case[s.b] == s.a else "23.8:2"
    return leading(slow(right(kept).lhs.subs(case)) - squared)[0] >= 4


def symmetry() -> bool:
    """X and y exchanged leave (10) as it is and turn (9) round; so (12) holds for y as well."""
    pairs = ((s.x, s.y), (s.xd, s.yd), (s.xdd, s.ydd))
    swap = {q: w for one, other in pairs for q, w in ((one, other), (other, one))}
    ten, nine = right("10").lhs, right("9:2").difference
    return is_zero(ten.xreplace(swap) - ten) and is_zero(nine.xreplace(swap) + nine)


def cartesian_small() -> bool:
    """Unused orders: (12) has no terms of even order, so the first neglected one is the fifth."""
    terms = taylor(small(right("12").lhs.xreplace({s.rho: _distance()})), 4)
    return all(is_zero(terms[k]) for k in (0, 2, 4))


def over_the_top() -> bool:
    """In a plane and with E > 2gl, u̇² has no zeros on the sphere but both ends of the vertical.

    There is no highest point: (C7) divides by 0, and the pendulum goes round.
    """
    square = right("C4").rhs.xreplace({s.h: 0})
    ends = all(is_zero(square.subs(s.u, end)) for end in (1, -1))
    zeros = set(solve(square, s.u)) - {1, -1}
    beyond = [zero.subs({s.E: 3, s.g: 1, s.l: 1}) for zero in zeros]
    return ends and len(beyond) == 1 and bool(beyond[0] < -1)


def beyond_c12() -> bool:
    """What (C11) and (C12) lack is of sixth order; (C8) and (C9) name no condition but (C7)'s."""
    orders = {one.order for one in remainders() if one.label in ("C11", "C12")}
    return orders == {6} and not any(formula(f"C{k}").step.conditions for k in (8, 9))


CONSEQUENCES: dict[str, Callable[[], bool]] = {
    "slack": slack,
    "longer": longer,
    "axis": axis,
    "upper_half": upper_half,
    "equator": equator,
    "x_zero": x_zero,
    "large": large,
    "not_so_small": not_so_small,
    "even_orders": cartesian_small,
    "stationary": stationary,
    "slow": slow_turning,
    "near": near,
    "third_harmonics": third_harmonics,
    "omega_squared": omega_squared,
    "independent": independent,
    "y_equation": y_equation,
    "circle": circle,
    "symmetry": symmetry,
    "over_the_top": over_the_top,
    "beyond_c12": beyond_c12,
}
