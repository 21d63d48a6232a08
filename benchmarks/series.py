"""How long the coefficients of the series take: derived anew, and out of the shipped table."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time

from report import Ratio, Section, Table, duration

from kugelpendel.series._table import derived

ORDERS = (2, 6, 12, 20, 40)
LIMIT = 20.0  # s, for order 12
COLD = (
    "import time; import kugelpendel.series as s; t = time.perf_counter(); "
    "s.frequency(12); s.precession(12); s.harmonics(12); print(time.perf_counter() - t)"
)


def seconds(order: int, variables: str) -> float:
    taken = []
    for _ in range(1 if order > 20 else 5):
        start = time.perf_counter()
        derived(order, variables)
        taken.append(time.perf_counter() - start)
    return statistics.median(taken)


def measure() -> Section:
    times = {order: [seconds(order, v) for v in ("radii", "harmonics")] for order in ORDERS}
    cold = [
        float(subprocess.run([sys.executable, "-c", COLD], capture_output=True, check=True).stdout)
        for _ in range(5)
    ]
    total = sum(times[12])
    return Section(
        "The series",
        [Ratio("derive order 12 in both variables", "20 s", total, LIMIT, total / LIMIT, 1.0)],
        [
            Table(
                "Deriving frequency, precession and all harmonics:",
                ("order", "in the radii", "in the first harmonics"),
                [(str(order), *map(duration, pair)) for order, pair in times.items()],
            )
        ],
        [
            "Order 12 out of the shipped table, the first time: "
            f"{duration(statistics.median(cold))}."
        ],
    )
