"""The arguments of ``kugelpendel explore``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import a_path

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands

_PORT = "8315"
"""Where the page is unless a port is asked for: 3/8 and 15, of Olsson's (25)."""


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "explore",
        help="open the pendulum in the browser, to drag and to watch",
        description="Serve the explorer's page to the browser of this machine, and open it. "
        "Ctrl-C ends it.",
        epilog="kugelpendel explore examples/pantheon-day.toml opens the page on that job.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file",
        nargs="?",
        type=a_path,
        metavar="FILE.toml",
        help="job file to open the page on; - reads standard input",
    )
    parser.add_argument(
        "--port",
        default=_PORT,
        metavar="PORT",
        help=f"port on 127.0.0.1 (default: {_PORT}); where it is taken, the next free one",
    )
    parser.add_argument(
        "--no-browser", action="store_true", help="print the address and open nothing"
    )
    parser.set_defaults(do=_explore, extra="run")


def _explore(options: argparse.Namespace) -> int:
    from kugelpendel.cli.explore.command import explore

    explore(options.file, options.port, opens=not options.no_browser)
    return 0
