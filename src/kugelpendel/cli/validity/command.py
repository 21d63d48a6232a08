"""``kugelpendel validity``: how good the formulas for small ellipses are."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, TypeAlias

import kugelpendel as kp
from kugelpendel.cli.job_file.kinds import LENGTH
from kugelpendel.cli.job_file.quantity import read_quantity
from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.output import one_file
from kugelpendel.cli.terminal.streams import write_bytes, write_json
from kugelpendel.cli.terminal.tables import numbers
from kugelpendel.observables import LEVELS
from kugelpendel.spelling import as_given, general, significant, spell_percent

if TYPE_CHECKING:
    from kugelpendel.parameters import Scalars

_Said: TypeAlias = tuple[list[str], str, dict[str, Any]]
"""Sentences, a table, and the same numbers for JSON."""

_Mark: TypeAlias = tuple[float, float] | None
"""a/l and b/a of the pendulum that is marked on the map."""

_ENDINGS = (".png", ".svg", ".pdf")
_STDOUT = Path("-")

_ABOUT = (
    "kugelpendel: errors of the formulas for small ellipses, approximate over exact, less 1; SI "
    "units, named in the keys; l is the length, a and b are the turning radii"
)

_EXAMPLE = 'kugelpendel validity --length "67 m" --a "3 m" --b "1 cm"'


def validity(
    length: str | None, a: str | None, b: str | None, picture: Path | None, *, as_json: bool
) -> None:
    """Print how good the formulas are, in general or for one pendulum, and draw the map.

    Parameters
    ----------
    length, a, b
        Of a pendulum and its turning radii, with units or plain in m; b is 0, the limit of narrow
        ellipses, unless given. None of them: the map in numbers.
    picture
        Where the figure goes; ``-`` for standard output, which then has nothing else.
    as_json
        Print the errors as JSON in place of the table.

    Raises
    ------
    InvalidInput
        Anything wrong with the options. Nothing is left half-written.
    """
    _refuse_mixture(picture, as_json)
    errors = kp.validity_map()
    mark, name = None, ""
    if length is None and a is None and b is None:
        lines, table, tables = _reaches(errors)
    else:
        outer, inner, size = _ellipse(length, a, b)
        lines, table, tables = _for_one(outer, inner, size)
        name = _name(outer, inner, size)
        mark = (outer / size, abs(inner) / outer if outer else 0.0)
    if picture == _STDOUT:
        write_bytes(_drawn(errors, mark, name))
        return
    if picture is not None:
        _draw(picture, errors, mark, name)
    if as_json:
        write_json(json_text({"about": _ABOUT, **tables}))
        return
    print("\n".join([*lines, "", table]))
    if picture is not None:
        print(f"\nIn {picture}: the map")


def _refuse_mixture(picture: Path | None, as_json: bool) -> None:
    if picture == _STDOUT:
        if as_json:
            raise kp.InvalidInput(
                "--json and --out - both want standard output; give one of them, or name a file."
            )
        if sys.stdout.isatty():
            raise kp.InvalidInput(
                "--out - writes the bytes of a picture, and standard output is a terminal; send it "
                "to a file or a program, or name a file."
            )
    elif picture is not None and picture.suffix.lower() not in _ENDINGS:
        raise kp.InvalidInput(
            f"--out {picture}: the name of the figure must end in one of {', '.join(_ENDINGS)}, or "
            "be - for a PNG on standard output."
        )


def _draw(picture: Path, errors: kp.ValidityMap, mark: _Mark, name: str) -> None:
    from kugelpendel import plot

    with one_file(picture, makes_parents=True) as temporary:
        plot.save(plot.validity(errors, mark, name), temporary)


def _drawn(errors: kp.ValidityMap, mark: _Mark, name: str) -> bytes:
    """The figure as a PNG."""
    with TemporaryDirectory() as folder:
        path = Path(folder, "map.png")
        _draw(path, errors, mark, name)
        return path.read_bytes()


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


def _for_one(a: float, b: float, length: float) -> _Said:
    found = kp.validity(a, b, length)
    lines = [f"{_name(a, b, length)}: formula (25) is good to {_good(found.formula_25)}"]
    if b == 0:
        lines.append("Nothing precesses at b = 0: the errors are the limits for narrow ellipses.")
    errors = {
        "formulas (25), (26)": (found.formula_25, found.formula_26),
        **{f"series, order {order}": pair for order, pair in found.series.items()},
    }
    rows = [(name, *(spell_percent(float(one)) for one in pair)) for name, pair in errors.items()]
    tables = {
        "length_m": length,
        "outer_turning_radius_m": a,
        "inner_turning_radius_m": abs(b),
        "relative_errors": {
            name: {"precession": float(precession), "frequency": float(frequency)}
            for name, (precession, frequency) in errors.items()
        },
    }
    return lines, numbers(("Relative errors", "Precession", "Frequency"), rows), tables


def _good(error: Scalars) -> str:
    size = abs(float(error))
    return f"{significant(100 * size, 2)} %" if size > 5e-15 else "the last digit"


def _reaches(errors: kp.ValidityMap) -> _Said:
    found = errors.errors
    groups = {
        "precession": {
            "by (25)": found.formula_25,
            **{f"series, order {n}": pair.precession for n, pair in found.series.items()},
        },
        "frequency": {
            "by (26)": found.formula_26,
            **{f"series, order {n}": pair.frequency for n, pair in found.series.items()},
        },
    }
    rows: list[tuple[str, ...]] = []
    for what, ways in groups.items():
        for way, error in ways.items():
            name = f"{what} {way}" if way.startswith("by") else f"  {way}"
            rows.append((name, *(_shown(_reach(errors, error, level)) for level in LEVELS)))
    tables: dict[str, Any] = {
        "levels": list(LEVELS),
        "largest_a_over_l": {
            what: {
                way: [_reach(errors, error, level)[1] for level in LEVELS]
                for way, error in ways.items()
            }
            for what, ways in groups.items()
        },
    }
    lines = ["Ellipses of any width: turning radii a and b ≤ a below the support, length l."]
    headers = ("Largest a/l for an error of", *(f"{100 * level:g} %" for level in LEVELS))
    return lines, numbers(headers, rows), tables


def _shown(reach: tuple[str, float]) -> str:
    sign, value = reach
    return f"{sign} {general(value, 3)}" if sign else significant(value, 3)


def _reach(errors: kp.ValidityMap, error: Scalars, level: float) -> tuple[str, float]:
    """Up to which a/l no ellipse has a larger error; with ">" or "<" beyond the map's ends."""
    reach = errors.reach(error, level)
    if reach == math.inf:
        return ">", float(errors.a_over_l[-1])
    return ("", reach) if reach > 0 else ("<", float(errors.a_over_l[0]))
