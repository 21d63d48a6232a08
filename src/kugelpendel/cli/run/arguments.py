"""The arguments of ``kugelpendel run``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import takes_a_file

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "run",
        help="do the job that a file describes",
        description="Print what the pendulum does, and write its track, a figure and the results.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    from kugelpendel.cli.job_file.schema import JOB

    takes_a_file(parser, JOB, "the job")
    parser.add_argument(
        "--format", choices=("csv", "netcdf", "parquet"), help="format of the track (default: csv)"
    )
    parser.set_defaults(do=_run, extra="run")


def _run(options: argparse.Namespace) -> int:
    from kugelpendel.cli.run.command import run

    run(options.file, options.out, options.json, options.format)
    return 0
