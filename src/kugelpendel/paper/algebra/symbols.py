"""The paper's letters as SymPy symbols, their LaTeX, their time derivatives, their dimensions.

A quantity and its derivatives are separate symbols (x, ẋ, ẍ), so that the equations are polynomials
and rational functions; `calculus.rate` differentiates along the motion.
"""

from __future__ import annotations

from kugelpendel.paper.algebra.sympy_names import Expr, Function, Symbol

Dimension = tuple[int, int, int]  # powers of mass, length, time

_LETTERS: dict[str, tuple[str, Dimension]] = {
    "m": ("m", (1, 0, 0)),
    "g": ("g", (0, 1, -2)),
    "l": ("l", (0, 1, 0)),
    "T": ("T", (1, 1, -2)),
    "t": ("t", (0, 0, 1)),
    "r": ("r", (0, 1, 0)),
    "a": ("a", (0, 1, 0)),
    "b": ("b", (0, 1, 0)),
    "x": ("x", (0, 1, 0)),
    "y": ("y", (0, 1, 0)),
    "z": ("z", (0, 1, 0)),
    "x'": ("xp", (0, 1, 0)),
    "y'": ("yp", (0, 1, 0)),
    r"\rho": ("rho", (0, 1, 0)),
    r"\theta": ("theta", (0, 0, 0)),
    r"\phi": ("phi", (0, 0, 0)),
    r"\omega": ("omega", (0, 0, -1)),
    r"\omega_0": ("omega_0", (0, 0, -1)),
    r"\Omega": ("Omega", (0, 0, -1)),
    "A_1": ("A_1", (0, 1, 0)),
    "A_2": ("A_2", (0, 1, 0)),
    r"\omega_1": ("omega_1", (0, 0, -1)),
    r"\omega_2": ("omega_2", (0, 0, -1)),
    "E": ("E", (0, 2, -2)),
    "h": ("h", (0, 0, -1)),
    "u": ("u", (0, 0, 0)),
    "u_1": ("u_1", (0, 0, 0)),
    "u_2": ("u_2", (0, 0, 0)),
    "u_3": ("u_3", (0, 0, 0)),
    r"\alpha": ("alpha", (0, 0, 0)),
    r"\beta": ("beta", (0, 0, 0)),
    "H": ("H", (0, 2, -2)),
    "J_1": ("J_1", (0, 2, -1)),
    "J_2": ("J_2", (0, 2, -1)),
    "L_x": ("L_x", (1, 2, -1)),
    "L_y": ("L_y", (1, 2, -1)),
    "L_z": ("L_z", (1, 2, -1)),
    r"\vec{e}_x": ("e_x", (0, 0, 0)),
    r"\vec{e}_y": ("e_y", (0, 0, 0)),
    r"\vec{e}_z": ("e_z", (0, 0, 0)),
    r"\vec{e}_r": ("e_r", (0, 0, 0)),
    r"\vec{e}_\theta": ("e_theta", (0, 0, 0)),
    r"\vec{e}_\phi": ("e_phi", (0, 0, 0)),
}
_POSITIVE = ("m", "g", "l", "omega_0")
_MOVING = ("x", "y", "z", r"\theta", r"\phi", "u")
_STILL = ("l", "a", "b", r"\Omega")  # constant in the paper; conditions speak of their rates

SYMBOL: dict[str, Expr] = {}  # LaTeX → symbol
DIMENSION: dict[Expr, Dimension] = {}
RATE: dict[Expr, Expr] = {}  # symbol → its time derivative
STILL: dict[Expr, Expr] = {}  # constant → its time derivative, 0 in the paper
STILL_RATE: dict[str, Expr] = {}  # LaTeX of such a derivative, for conditions only → symbol


def _add(latex: str, name: str, dimension: Dimension) -> Expr:
    symbol = Symbol(name, positive=True) if name in _POSITIVE else Symbol(name, real=True)
    SYMBOL[latex] = symbol
    DIMENSION[symbol] = dimension
    return symbol


for _latex, (_name, _dimension) in _LETTERS.items():
    _add(_latex, _name, _dimension)
for _latex in _MOVING:
    _name, (_m, _l, _t) = _LETTERS[_latex]
    _dot = _add(rf"\dot{{{_latex}}}", f"{_name}dot", (_m, _l, _t - 1))
    _ddot = _add(rf"\ddot{{{_latex}}}", f"{_name}ddot", (_m, _l, _t - 2))
    RATE[SYMBOL[_latex]], RATE[_dot] = _dot, _ddot

for _latex in _STILL:
    _name, (_m, _l, _t) = _LETTERS[_latex]
    _dot = Symbol(f"{_name}dot", real=True)
    STILL[SYMBOL[_latex]], STILL_RATE[rf"\dot{{{_latex}}}"] = _dot, _dot

LATEX: dict[Expr, str] = {symbol: latex for latex, symbol in SYMBOL.items()}

m, g, l, T, t, a, b = (SYMBOL[name] for name in "mglTtab")  # noqa: E741 (the paper's letter)
x, y, z, xd, yd, zd, xdd, ydd, zdd = (
    SYMBOL[form.format(q)] for form in ("{}", r"\dot{{{}}}", r"\ddot{{{}}}") for q in "xyz"
)
xp, yp, r, rho = SYMBOL["x'"], SYMBOL["y'"], SYMBOL["r"], SYMBOL[r"\rho"]
theta, thetad, thetadd = (SYMBOL[s] for s in (r"\theta", r"\dot{\theta}", r"\ddot{\theta}"))
phi, phid, phidd = (SYMBOL[s] for s in (r"\phi", r"\dot{\phi}", r"\ddot{\phi}"))
omega, omega0, Omega = SYMBOL[r"\omega"], SYMBOL[r"\omega_0"], SYMBOL[r"\Omega"]
A_1, A_2, omega_1, omega_2 = (SYMBOL[s] for s in ("A_1", "A_2", r"\omega_1", r"\omega_2"))
E, h, H, J_1, J_2 = (SYMBOL[s] for s in ("E", "h", "H", "J_1", "J_2"))
u, ud, u_1, u_2, u_3 = (SYMBOL[s] for s in ("u", r"\dot{u}", "u_1", "u_2", "u_3"))
alpha, beta = SYMBOL[r"\alpha"], SYMBOL[r"\beta"]
e_x, e_y, e_z = (SYMBOL[rf"\vec{{e}}_{q}"] for q in "xyz")
e_r, e_theta, e_phi = (SYMBOL[rf"\vec{{e}}_{q}"] for q in ("r", r"\theta", r"\phi"))

CARTESIAN = (e_x, e_y, e_z)
SPHERICAL = (e_r, e_theta, e_phi)

# The two circular motions that make the ellipse: what they are in its letters.
CIRCLES: dict[Expr, Expr] = {
    A_1: (a + b) / 2, A_2: (a - b) / 2, omega_1: omega + Omega, omega_2: omega - Omega,
}  # fmt: skip

VECTORS: dict[str, Expr] = {
    r"\vec{r}": x * e_x + y * e_y + z * e_z,
    r"\vec{v}": xd * e_x + yd * e_y + zd * e_z,
    r"\ddot{\vec{r}}": xdd * e_x + ydd * e_y + zdd * e_z,
    r"\vec{L}": SYMBOL["L_x"] * e_x + SYMBOL["L_y"] * e_y + SYMBOL["L_z"] * e_z,
}


class Ddt(Function):
    """d/dt of its argument along the motion, not yet carried out."""


class Integrated(Function):
    """The integral of the first argument over u, from the second to the third, as it stands."""
