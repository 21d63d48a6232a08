"""The arguments of ``kugelpendel sweep``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import takes_a_file

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "sweep",
        help="do the job of a file for many pendulums at once",
        description="Vary any numbers of a job over a grid or at random, keep the results in a "
        "Zarr store that survives interruptions, and print and draw what they come to. Any number "
        'may be a list, a range such as { from = "1 cm", to = "5 cm", count = 20 }, also with '
        'scale = "log", and in samples { normal = ["1 cm", "1 mm"] } or { uniform = ["0 deg", '
        '"180 deg"] }.',
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    from kugelpendel.cli.job_file.sweep_schema import SWEEP_FILE

    takes_a_file(parser, SWEEP_FILE, "the sweep")
    engine = parser.add_mutually_exclusive_group()
    engine.add_argument(
        "--workers",
        metavar="N",
        help="processes of this machine, by Dask (default: this one alone)",
    )
    engine.add_argument(
        "--scheduler", metavar="ADDRESS", help="of Dask, whose workers do it, as tcp://host:8786"
    )
    parser.add_argument("--lang", metavar="de|en", help="language (default: that of the locale)")
    parser.set_defaults(do=_sweep, extra="sweep")


def _sweep(options: argparse.Namespace) -> int:
    from kugelpendel.cli.sweep.command import sweep

    sweep(options)
    return 0
