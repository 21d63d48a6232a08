"""The arguments of ``kugelpendel compare``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import takes_a_file

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "compare",
        help="compare the paper's motions with the exact one",
        description="Print how far every motion goes astray, and write a figure and the results.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    from kugelpendel.cli.job_file.schema import IDEAL_JOB

    takes_a_file(parser, IDEAL_JOB, "the job, without forces")
    parser.set_defaults(do=_compare, extra="run")


def _compare(options: argparse.Namespace) -> int:
    from kugelpendel.cli.compare.command import compare

    compare(options.file, options.out, options.json)
    return 0
