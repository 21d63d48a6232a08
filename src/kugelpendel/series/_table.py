"""The shipped coefficients, written by ``python -m references.series``."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import TypedDict

from kugelpendel.series._expansion import Expansion, in_harmonics, in_radii
from kugelpendel.series._orders import NAMES, Variables
from kugelpendel.series._polynomial import Polynomial
from kugelpendel.series._power_series import PowerSeries

FILE = "table.json"
SHIPPED = 16
"""The highest order in the table; higher ones are derived when they are asked for."""

Written = dict[str, dict[str, str]]


class Table(TypedDict):
    """The table that the file holds.

    Attributes
    ----------
    series
        By variables, then by the names of `written`.
    radius
        See `radius`: for "harmonics", at equidistant ratios b/a from 0 to 1.
    """

    series: dict[str, Written]
    radius: list[float]


def written(expansion: Expansion) -> Written:
    """All coefficients as text, by "frequency", "precession", "plan 1", "height 2", … and "i j"."""

    def texts(series: PowerSeries) -> dict[str, str]:
        terms = Polynomial.of(series.coefficients(), ("", "")).terms
        return {f"{i} {j}": str(coefficient) for i, j, coefficient in terms}

    rates = {"frequency": expansion.frequency, "precession": expansion.precession}
    plan = {f"plan {n}": amplitude for n, amplitude in expansion.plan.items()}
    height = {f"height {n}": amplitude for n, amplitude in expansion.height.items()}
    return {name: texts(series) for name, series in (rates | plan | height).items()}


def derived(order: int, variables: Variables) -> Written:
    """The coefficients, computed."""
    # Two degrees more than the frequency's, for the heights, which begin with the second.
    amplitudes = PowerSeries.variables(order + 2)
    return written((in_radii if variables == "radii" else in_harmonics)(*amplitudes))


@cache
def stored() -> Table:
    """The shipped table."""
    # Not by importlib.resources, which takes longer to import than all else here.
    return json.loads(Path(__file__).with_name(FILE).read_text(encoding="utf-8"))


@cache
def _texts(order: int, variables: Variables) -> Written:
    return stored()["series"][variables] if order <= SHIPPED else derived(order, variables)


def names(order: int, variables: Variables, kind: str) -> dict[int, str]:
    """The harmonics of one kind, "plan" or "height": their names by n."""
    parts = (name.split() for name in _texts(order, variables))
    return {int(part[1]): " ".join(part) for part in parts if part[0] == kind}


@cache
def polynomial(order: int, variables: Variables, name: str, degree: int) -> Polynomial:
    """One of the series up to a total degree, out of the table where it is there."""
    terms: list[tuple[int, int, Fraction]] = []
    for powers, text in _texts(order, variables)[name].items():
        i, j = map(int, powers.split())
        if i + j <= degree:
            numerator, _, denominator = text.partition("/")
            terms.append((i, j, Fraction(int(numerator), int(denominator or 1))))
    return Polynomial(tuple(terms), NAMES[variables])
