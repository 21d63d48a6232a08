"""SymPy's expressions as LaTeX in the paper's notation: the way back from `notation`."""

from __future__ import annotations

from kugelpendel.paper.algebra.calculus import carry_out, parted
from kugelpendel.paper.algebra.symbols import LATEX
from kugelpendel.paper.algebra.sympy_names import Expr, LatexPrinter, fraction


def written(expression: Expr) -> str:
    """Write an expression so that `notation.read` gives it back; every d/dt is carried out.

    Sines and cosines of a sum of angles are written by those of the angles.
    """
    latex: str = _Printer({"symbol_names": LATEX}).doprint(parted(carry_out(expression)))
    return latex


class _Printer(LatexPrinter):
    """SymPy's printer, but for sines and cosines, whose angles need no brackets here."""

    def _print_sin(self, e: Expr, exp: str | None = None) -> str:
        return self._of_angle("sin", e, exp)

    def _print_cos(self, e: Expr, exp: str | None = None) -> str:
        return self._of_angle("cos", e, exp)

    def _print_Abs(self, e: Expr, exp: str | None = None) -> str:
        return f"|{self._print(e.args[0])}|" + (f"^{{{exp}}}" if exp else "")

    def _print_Integrated(self, e: Expr) -> str:
        above, below = (self._print(part) for part in fraction(e.args[0]))
        lower, upper = (self._print(bound) for bound in e.args[1:])
        measure = "du" if above == "1" else f"{above} du"
        return rf"\int_{{{lower}}}^{{{upper}}} \frac{{{measure}}}{{{below}}}"

    def _of_angle(self, name: str, e: Expr, exp: str | None) -> str:
        factor, angle = e.args[0].as_coeff_Mul()
        letters = sorted(angle.args or (angle,), key=lambda q: str(q) == "t")
        number = [] if factor == 1 else [str(factor)]
        power = f"^{{{exp}}}" if exp else ""
        return " ".join([rf"\{name}{power}", *number, *(LATEX[q] for q in letters)])
