"""Measure the numbers of a page: ``python docs/scripts/motions.py docs/motions.md``."""

import re
import sys
from pathlib import Path

import numpy as np

import kugelpendel as kp
from kugelpendel.observables import LEVELS, measured_rates
from kugelpendel.spelling import significant

UNIT = kp.Pendulum(length=1.0, gravity=1.0)
LAUNCHES = ((0.05, 0.005), (0.2, 0.1), (0.5, 0.25))  # a/l, b/l
SWINGS = 100


def errors() -> str:
    """Errors of every motion for three launches."""
    found = []
    for a, b in LAUNCHES:
        launch = kp.Launch.apsides(a, b)
        swing = 2 * np.pi / kp.ExactMotion(UNIT, launch).frequency
        found.append(kp.compare(UNIT, launch, SWINGS * swing, orders=(2, 6, 12)))
    head = ["motion"]
    for a, b in LAUNCHES:
        head += [f"{a:g}, {b:g}: position", "period", "precession"]
    rows = []
    for same in zip(*(comparison.rows for comparison in found), strict=True):
        cells = [f"`{same[0].name}`"]
        for row, comparison in zip(same, found, strict=True):
            relative = row.largest / comparison.amplitude
            cells += [shown(e) for e in (relative, row.period, row.precession)]
        rows.append(cells)
    return table(head, rows)


def reach() -> str:
    """Up to which amplitude the formulas hold."""
    validity = kp.validity_map(n=1000)
    of = validity.errors
    rows = [["precession by (25)", of.formula_25], ["frequency by (26)", of.formula_26]]
    for order, pair in of.series.items():
        rows += [[f"precession, series of order {order}", pair.precession]]
    for order, pair in of.series.items():
        rows += [[f"frequency, series of order {order}", pair.frequency]]
    cells = []
    for name, error in rows:
        worst = np.abs(error).max(axis=0)
        last = [validity.a_over_l[np.flatnonzero(worst > level)[0] - 1] for level in LEVELS]
        cells.append([name, *(f"{a:.2g}" for a in last)])
    return table(["error below", *(f"{100 * level:g} %" for level in LEVELS)], cells)


def cubic() -> str:
    """Coefficients of the rates of (13), measured on its paths, and of the exact ones."""
    c, d, e, f, g = coefficients()
    exact_frequency = kp.series.frequency(4).coefficients
    exact_precession = kp.series.precession(4).coefficients
    of_exact = (
        exact_precession[1, 1],
        exact_precession[3, 1] / exact_precession[1, 1],
        -exact_frequency[2, 0],
        -exact_frequency[4, 0],
        exact_frequency[2, 2],
    )
    rows = [
        [name, f"{value:.5f}", guess, str(exact), f"{float(exact):.5f}"]
        for name, value, guess, exact in zip(
            ("c", "d", "e", "f", "g"),
            (c, d, e, f, g),
            ("3/8", "13/96", "1/16", "45/1024", "105/512"),
            of_exact,
            strict=True,
        )
    ]
    return table(["", "(13), measured", "likely", "exact", ""], rows)


def coefficients() -> tuple[float, ...]:
    """c, d, e, f, g of (13), from integrations at three amplitudes, extrapolated to none."""
    amplitudes, ratios = np.array([0.03, 0.05, 0.07]), np.array([0.25, 0.5])
    powers = np.vander(amplitudes**2, increasing=True)
    turning, slowing = [], []
    for ratio in ratios:
        rates = [
            measured_rates(kp.CubicMotion(UNIT, own_launch(a, a * ratio)), np.pi)
            for a in amplitudes
        ]
        # In powers of a²: Ω/ab = c + cd (1 + r²) a² …, (1 − ω)/a² = e (1 + r²) + … a² …
        omega = [
            rate.precession / (a * a * ratio) for a, rate in zip(amplitudes, rates, strict=True)
        ]
        slow = [(1 - rate.frequency) / a**2 for a, rate in zip(amplitudes, rates, strict=True)]
        turning.append(np.linalg.solve(powers, omega))
        slowing.append(np.linalg.solve(powers, slow))
    turning, slowing = np.array(turning), np.array(slowing)
    c = turning[:, 0].mean()
    d = (turning[:, 1] / (1 + ratios**2)).mean() / c
    e = (slowing[:, 0] / (1 + ratios**2)).mean()
    f, g = np.linalg.solve(np.column_stack([1 + ratios**4, -(ratios**2)]), slowing[:, 1])
    return c, d, e, f, g


def own_launch(a: float, b: float) -> kp.Launch:
    """The launch for which (13) itself has the turning radii a, b; l = ω0 = 1.

    With s = x² + y², (13) gives d(v²)/ds = −v² − 1 + s/2, so v² = C e^(−s) + s/2 − 3/2, and at the
    turning points s v² is the square of the angular momentum.
    """
    s, u = a * a, b * b
    constant = (1.5 * (s - u) - (s * s - u * u) / 2) / (s * np.exp(-s) - u * np.exp(-u))
    return kp.Launch.plane(a, 0.0, 0.0, np.sqrt(constant * np.exp(-s) + s / 2 - 1.5))


def shown(error: float) -> str:
    """Two digits, in per cent; nothing that is noise."""
    if abs(error) < 1e-11:
        return "< 1e−9 %"
    return f"{significant(100 * error, 2)} %".replace("e−0", "e−")


def table(head: list[str], rows: list[list[str]]) -> str:
    """In Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def written(page: str) -> str:
    """The page with its numbers measured anew."""
    for name, part in (("errors", errors), ("reach", reach), ("cubic", cubic)):
        page = re.sub(
            rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
            lambda found, part=part: f"{found[1]}{part()}\n{found[2]}",
            page,
            flags=re.DOTALL,
        )
    return page


if __name__ == "__main__":
    path = Path(sys.argv[1])
    path.write_text(written(path.read_text(encoding="utf-8")), encoding="utf-8")
