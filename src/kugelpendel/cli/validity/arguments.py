"""The arguments of ``kugelpendel validity``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import a_path

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "validity",
        help="say how good the formulas for small ellipses are",
        description="Print the errors of (25), (26) and of the series of each order, for one "
        "pendulum or for all. Lengths have a unit or are in m.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--length", metavar="LENGTH", help='of the pendulum, such as "67 m"')
    parser.add_argument("--a", metavar="LENGTH", help="outer turning radius")
    parser.add_argument(
        "--b", metavar="LENGTH", help="inner turning radius (default: the limit b = 0)"
    )
    parser.add_argument(
        "--out",
        type=a_path,
        metavar="FILE.png",
        help="draw the map; .svg and .pdf do as well, and - is standard output",
    )
    parser.add_argument("--json", action="store_true", help="print the errors as JSON")
    parser.set_defaults(do=_validity, extra="run")


def _validity(options: argparse.Namespace) -> int:
    from kugelpendel.cli.validity.command import validity

    validity(options.length, options.a, options.b, options.out, as_json=options.json)
    return 0
