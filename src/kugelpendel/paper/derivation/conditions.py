"""The conditions under which steps are allowed, each named once.

Silent ones are those that the paper does not say. A condition is named at the step that breaks
without it, not again at what follows from that step. What happens where it fails is checked in
`checks.conditions_violated`, and that each step needs exactly these in `checks.requirements`.
"""

from __future__ import annotations

from kugelpendel.paper.derivation.model import Condition

SPHERE = Condition("taut-thread", r"T \geq 0", True, "slack")
INEXTENSIBLE = Condition("fixed-length", r"\dot{l} = 0", True, "longer")
INERTIAL = Condition("inertial-frame", "", True)
DOWNWARD = Condition("z-down", r"z = r \cos \theta", True)
OFF_AXIS = Condition("off-axis", r"\sin \theta \neq 0", True, "axis")
LOWER_HALF = Condition("lower-half", r"\cos \theta \geq 0", True, "upper_half")
NOT_EQUATOR = Condition("off-equator", r"\cos \theta \neq 0", True, "equator")
OMEGA_ZERO = Condition("omega-zero", r"\omega_0^2 = \frac{g}{l}", True)
X_NOT_ZERO = Condition("x-not-zero", r"x \neq 0", True, "x_zero")
RHO_NOT_ZERO = Condition("rho-not-zero", r"\rho \neq 0", True, "x_zero")
SMALL = Condition("small", r"|x|, |y| \ll l", False, "large")
SMALL_RATES = Condition("small-rates", r"|\dot{x}|, |\dot{y}| \ll \omega_0 l", True, "large")
LINEAR = Condition("very-small", r"|a|, |b| \ll l", False, "not_so_small")
NO_GROWTH = Condition("stationary", r"\dot{a}, \dot{b} = 0", True, "stationary")
UNIFORM = Condition("uniform-turning", r"\dot{\Omega} = 0", True)
SLOW = Condition("slow-turning", r"|\Omega| \ll \omega", False, "slow")
SLOW_MINOR = Condition("slow-against-minor-axis", r"|a\Omega| \ll |b\omega|", True, "slow")
NEAR = Condition("near-frequency", r"|\omega - \omega_0| \ll \omega_0", False, "near")
THIRD = Condition("third-harmonics", "", False, "third_harmonics")
OMEGA_SQUARED = Condition(
    "omega-squared", r"\Omega^2 \ll |\omega^2 - \omega_0^2|", False, "omega_squared"
)
INDEPENDENT = Condition("independent", r"\omega \Omega \neq 0", True, "independent")
OTHER_EQUATION = Condition("y-equation", "", True, "y_equation")
NOT_OPPOSITE = Condition("not-opposite-circle", r"a \neq -b", True, "circle")
NOT_CIRCLE = Condition("not-circle", r"a \neq b", True, "circle")
MEAN_BELOW = Condition("mean-below", r"u_1 + u_2 \neq 0", False, "over_the_top")
SMALL_RADII = Condition("small-radii", r"|\alpha|, |\beta| \ll 1", False, "beyond_c12")
SAME_BY_SYMMETRY = Condition("symmetry", "", True, "symmetry")
