"""``kugelpendel validity``: how good the formulas for small ellipses are."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.compare.report import plain_table, print_table
from kugelpendel.cli.job_file.quantity import LENGTH, read_quantity
from kugelpendel.cli.output import staged
from kugelpendel.observables import LEVELS
from kugelpendel.spelling import as_given, significant, spell_percent

if TYPE_CHECKING:
    from pathlib import Path

    from rich.table import Table

    from kugelpendel.parameters import Scalars

_ENDINGS = (".png", ".svg", ".pdf")

_EXAMPLE = 'kugelpendel validity --length "67 m" --a "3 m" --b "1 cm"'


def validity(length: str | None, a: str | None, b: str | None, picture: Path | None) -> None:
    """Print how good the formulas are, in general or for one pendulum, and draw the map.

    Parameters
    ----------
    length, a, b : str or None
        Of a pendulum and its turning radii, with units or plain in m; b is 0, the limit of narrow
        ellipses, unless given. None of them: the map in numbers.
    picture : Path or None
        Where the figure goes.

    Raises
    ------
    InvalidInput
        Anything wrong with the options. Nothing is left half-written.
    """
    if picture is not None and picture.suffix.lower() not in _ENDINGS:
        raise kp.InvalidInput(
            f"--out {picture}: the name of the figure must end in one of {', '.join(_ENDINGS)}."
        )
    errors = kp.validity_map()
    mark, name = None, ""
    if length is None and a is None and b is None:
        parts = _reaches(errors)
    else:
        outer, inner, size = _ellipse(length, a, b)
        parts, name = _for_one(outer, inner, size), _name(outer, inner, size)
        mark = (outer / size, abs(inner) / outer if outer else 0.0)
    if picture is not None:
        with staged(picture.parent, (picture.name,)) as temporary:
            plot.save(plot.validity(errors, mark, name), temporary / picture.name)
    lines, table = parts
    print("\n".join(lines))
    print_table(table)
    if picture is not None:
        print(f"\nIn {picture}: the map")


def _ellipse(length: str | None, a: str | None, b: str | None) -> tuple[float, float, float]:
    """Turning radii and length, m."""
    for option, text in (("--length", length), ("--a", a)):
        if text is None:
            raise kp.InvalidInput(
                f"{option} is missing: one pendulum needs --length and --a, and --b unless the "
                f"ellipse is narrow; such as {_EXAMPLE}."
            )
    radii = (_read(a or "", "--a"), _read(b or "0", "--b"))
    return *radii, _read(length or "", "--length")


def _read(text: str, option: str) -> float:
    try:
        return read_quantity(float(text), LENGTH, option)
    except ValueError:
        return read_quantity(text, LENGTH, option)


def _name(a: float, b: float, length: float) -> str:
    return f"{as_given(a, 'm')} by {as_given(abs(b), 'm')} on {as_given(length, 'm')}"


def _for_one(a: float, b: float, length: float) -> tuple[list[str], Table]:
    found = kp.validity(a, b, length)
    table = plain_table("Relative errors", "Precession", "Frequency")
    lines = [f"{_name(a, b, length)}: formula (25) is good to {_good(found.formula_25)}"]
    if b == 0:
        lines.append("Nothing precesses at b = 0: the errors are the limits for narrow ellipses.")
    formulas = (spell_percent(float(error)) for error in (found.formula_25, found.formula_26))
    table.add_row("formulas (25), (26)", *formulas)
    for order, pair in found.series.items():
        table.add_row(f"series, order {order}", *(spell_percent(float(error)) for error in pair))
    return lines, table


def _good(error: Scalars) -> str:
    size = abs(float(error))
    return f"{significant(100 * size, 2)} %" if size > 5e-15 else "the last digit"


def _reaches(errors: kp.ValidityMap) -> tuple[list[str], Table]:
    levels = [f"{100 * level:g} %" for level in LEVELS]
    table = plain_table("Largest a/l for an error of", *levels)
    found = errors.errors
    rows = [
        ("precession by (25)", found.formula_25),
        *((f"  series, order {n}", pair.precession) for n, pair in found.series.items()),
        ("frequency by (26)", found.formula_26),
        *((f"  series, order {n}", pair.frequency) for n, pair in found.series.items()),
    ]
    for name, error in rows:
        table.add_row(name, *(_reach(errors, error, level) for level in LEVELS))
    lines = ["Ellipses of any width: turning radii a and b ≤ a below the support, length l."]
    return lines, table


def _reach(errors: kp.ValidityMap, error: Scalars, level: float) -> str:
    """Up to which a/l no ellipse has a larger error, to three digits."""
    reach = errors.reach(error, level)
    if reach == math.inf:
        return f"> {errors.a_over_l[-1]:g}"
    return significant(reach, 3) if reach > 0 else f"< {errors.a_over_l[0]:.3g}"
