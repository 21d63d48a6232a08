"""Measure where the series stop converging: ``python docs/scripts/convergence.py docs/series.md``.

Writes the tables of that page anew, and the picture beside it. Left in the picture, the relative
error of the precession against the exact motion; right, the radius of convergence from the ratios
of the coefficients of ω along rays b = ratio · a (Domb and Sykes: a branch point of the kind
√(1 − a²/R²) makes the ratios (1 − 3/2n + …)/R²), and what `kp.series.radius` says.
"""

import math
import re
import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import kugelpendel as kp
from kugelpendel.plot._ink import INNER, OUTER, QUIET, STYLE
from kugelpendel.series._expansion import in_harmonics, rates
from kugelpendel.series._power_series import PowerSeries

PENDULUM = kp.Pendulum(length=1.0, gravity=1.0)
ORDERS = (2, 4, 6, 8, 12, 16, 40)
SHOWN = (0.1, 0.2, 0.3, 0.5, 0.7, 0.9)
RATIO = 0.25
RAYS = (0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75)
DEGREE = 62
SCALE = 256


def errors(order: int, alpha: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Relative errors of ω and Ω at turning radii α and RATIO · α."""
    exact = kp.ExactMotion(PENDULUM, kp.Launch.apsides(alpha, RATIO * alpha))
    return (
        np.abs(kp.series.frequency(order)(alpha, RATIO * alpha) / exact.frequency - 1),
        np.abs(kp.series.precession(order)(alpha, RATIO * alpha) / exact.precession - 1),
    )


def from_ratios(ratio: float, variables: str) -> float:
    """The radius of convergence, extrapolated from the coefficients of ω up to DEGREE."""
    rest = (0,) * (DEGREE - 1)
    a, b = (PowerSeries((0, int(SCALE * share), *rest), slot=64) for share in (1, ratio))
    series = rates(a, b)[0] if variables == "radii" else in_harmonics(a, b).frequency
    parts = series.parts[::2]

    def freed(n: int) -> float:
        return parts[n] / parts[n - 1] / SCALE**2 / (1 - 1.5 / n)

    limit = (4 * freed(DEGREE // 2) - freed(DEGREE // 4)) / 3  # free of 1/n² as well
    return 1 / math.sqrt(limit)


def errors_table() -> str:
    """By order and amplitude."""
    rows = [["order", *(f"a = {value} l" for value in SHOWN)]]
    for order in ORDERS:
        pairs = zip(*errors(order, np.array(SHOWN)), strict=True)
        rows.append([str(order), *(f"{shown(w)}, {shown(o)}" for w, o in pairs)])
    return table(rows)


def radii_table() -> str:
    """By ratio b/a."""
    head = ["b/a", "radii, from ratios", "radii", "harmonics, from ratios", "harmonics"]
    rows = [head]
    for ratio in RAYS:
        cells = [str(ratio)]
        for variables in ("radii", "harmonics"):
            found = from_ratios(ratio, variables), kp.series.radius(ratio, variables)
            cells += [f"{value:.4f}" for value in found]
        rows.append(cells)
    return table(rows)


def formulas() -> str:
    """The first orders, as text."""
    lines = ["```text"]
    for variables in ("radii", "harmonics"):
        lines.append(f"ω/ω0 = {kp.series.frequency(4, variables)} + …")
        lines.append(f"Ω/ω0 = {kp.series.precession(6, variables)} + …")
    harmonics = kp.series.harmonics(2)
    lines += [f"e^{{i(Ω + {n}ω)t}}: {harmonics.plan[n]} + …" for n in (1, 3)]
    lines += [f"cos {n}ωt in 1 − z/l: {harmonics.height[n]} + …" for n in (0, 2, 4)]
    return "\n".join([*lines, "```"])


def shown(error: float) -> str:
    """One digit; nothing that is rounding."""
    text = f"{error:.0e}".replace("e-0", "e-").replace("-", "−")
    return text if error > 1e-15 else "< 1e−15"


def table(rows: list[list[str]]) -> str:
    """In Markdown."""
    lines = [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def written(page: str) -> str:
    """The page with its tables made anew."""
    for name, part in (("formulas", formulas), ("errors", errors_table), ("radii", radii_table)):
        page = re.sub(
            rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
            lambda found, part=part: f"{found[1]}{part()}\n{found[2]}",
            page,
            flags=re.DOTALL,
        )
    return page


def draw_errors(axes: Axes) -> None:
    """One curve per order."""
    alpha = np.geomspace(0.05, 0.9995, 60)
    for order, shade in zip(ORDERS, np.linspace(0.35, 1, len(ORDERS)), strict=True):
        error = errors(order, alpha)[1]
        axes.loglog(alpha, np.where(error > 1e-15, error, np.nan), color=INNER, alpha=shade)
        at = int(np.argmin(np.abs(error - 3e-12))) if order > 6 else 0
        axes.annotate(
            str(order), (alpha[at], error[at]), xytext=(-2, 2), textcoords="offset points",
            ha="right", fontsize=9,
        )  # fmt: skip
    axes.axvline(1, color=OUTER, linewidth=1)
    axes.set(
        xlim=(0.04, 1.1), ylim=(1e-15, 2), xlabel="turning radius a/l",
        ylabel="relative error of Ω", title=f"Orders of the series, b = {RATIO:g} a",
    )  # fmt: skip
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1], ["0.05", "0.1", "0.2", "0.5", "1"])
    axes.minorticks_off()


def draw_radii(axes: Axes) -> None:
    """Lines from `radius`, dots from the coefficients."""
    ratios = np.linspace(0, 1, 33)
    for variables, colour, name in (
        ("harmonics", INNER, "first harmonics"),
        ("radii", OUTER, "turning radii"),
    ):
        found = [from_ratios(ratio, variables) for ratio in RAYS]
        axes.plot(ratios, kp.series.radius(ratios, variables), color=colour, label=name)
        axes.plot(RAYS, found, "o", color=colour, markersize=5)
    axes.plot([], [], "o", color=QUIET, markersize=5, label="from the coefficients")
    axes.set(
        xlim=(-0.02, 1.02), ylim=(0.95, 1.2), xlabel="b/a", ylabel="a/l",
        title="The series converge below",
    )  # fmt: skip
    axes.legend(frameon=False)


def draw(path: Path) -> None:
    """Write the picture."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9, 4), layout="constrained")
        left, right = figure.subplots(1, 2)
        draw_errors(left)
        draw_radii(right)
        figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    text = re.sub(r"\n +", "\n", path.read_text(encoding="utf-8"))
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    page = Path(sys.argv[1])
    page.write_text(written(page.read_text(encoding="utf-8")), encoding="utf-8")
    draw(page.with_name("convergence.svg"))
