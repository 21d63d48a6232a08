"""The arguments of ``kugelpendel design``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import takes_a_file

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "design",
        help="answer what the builder of a pendulum asks",
        description="Print period, turning, decay, suspension, drive, passage and wire of a "
        "pendulum, each by its formula and by the full equations, and write a figure and the "
        "results.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    from kugelpendel.cli.job_file.schema import DESIGN

    takes_a_file(parser, DESIGN, "the pendulum and the questions")
    parser.add_argument(
        "--formulas", action="store_true", help="leave out the checks by the full equations"
    )
    parser.set_defaults(do=_design, extra="run")


def _design(options: argparse.Namespace) -> int:
    from kugelpendel.cli.design.command import design

    design(options.file, options.out, options.json, not options.formulas)
    return 0
