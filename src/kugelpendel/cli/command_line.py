"""Arguments, and what becomes of an error: a sentence on stderr and exit code 2."""

from __future__ import annotations

import argparse
import signal
import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING

from kugelpendel.cli.compare import arguments as compare
from kugelpendel.cli.derive import arguments as derive
from kugelpendel.cli.design import arguments as design
from kugelpendel.cli.explore import arguments as explore
from kugelpendel.cli.fit import arguments as fit
from kugelpendel.cli.options import CommandParser, Refused
from kugelpendel.cli.run import arguments as run
from kugelpendel.cli.sweep import arguments as sweep
from kugelpendel.cli.synth import arguments as synth
from kugelpendel.cli.terminal import streams
from kugelpendel.cli.terminal.interrupted import NOTHING_LEFT, is_interruption
from kugelpendel.cli.validity import arguments as validity

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Sequence
    from types import FrameType

    from kugelpendel.errors import Language

_BAD_INPUT = 2
_INTERRUPTED = 130

_COMMANDS = (run, sweep, compare, validity, design, fit, synth, derive, explore)
"""In the order of the help. The parser of each says what does it and which extra it needs."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments
        ``sys.argv`` without the program, unless given.

    Returns
    -------
    int
        Exit code: 0, 1 when a proof fails, 2 for bad input (with a sentence on stderr), 130 when
        interrupted.
    """
    options = argparse.Namespace()
    try:
        with streams.guarded():
            options = _parser().parse_args(arguments)
            return _answered(options)
    except Refused as error:
        return _refuse(error.what.sentence(_language(error.options), door="file"))
    except streams.Unwritable as error:
        return _refuse(error.what.sentence(_language(options), door="file"))
    except BrokenPipeError:
        return 0  # whoever read has had enough


def _answered(options: argparse.Namespace) -> int:
    """Do what the arguments say."""
    if options.version:
        from importlib.metadata import version

        print(f"kugelpendel {version('kugelpendel')}")
        return 0
    if options.command is None:
        _parser().print_help(sys.stderr)
        return _BAD_INPUT
    with _terminated_like_interrupted():
        return _done(options)


def _done(options: argparse.Namespace) -> int:
    """Run the command, and say in a sentence what it refuses."""
    do: Callable[[argparse.Namespace], int] = options.do
    from kugelpendel.errors import KugelpendelError

    try:
        return do(options)
    except ImportError as error:
        return _refuse(_not_installed(error, options))
    except KugelpendelError as error:
        return _refuse(error.sentence(_language(options), door="file"))
    except (KeyboardInterrupt, RuntimeError) as error:
        if not is_interruption(error):
            raise
        said = str(error) if isinstance(error, KeyboardInterrupt) else ""
        streams.complain(said or NOTHING_LEFT[_language(options)])
        return _INTERRUPTED


def _language(options: argparse.Namespace) -> Language:
    """The language of a command that has several, where the one asked for is there; or English."""
    if not hasattr(options, "lang"):
        return "en"
    from kugelpendel.cli.terminal.language import known_language
    from kugelpendel.errors import InvalidInput

    try:
        return known_language(options.lang)
    except InvalidInput:  # which is what is being said
        return "en"


def _not_installed(error: ImportError, options: argparse.Namespace) -> str:
    """Name all that is missing of the extra, so that it is installed in one go."""
    from kugelpendel.errors import MissingExtra, require_extra

    what = f"`kugelpendel {options.command}`"
    try:
        require_extra(options.extra, what)
    except MissingExtra as missing:
        return missing.sentence(_language(options), door="file")
    broken = MissingExtra.of("option_cannot_run", what=what, said=str(error))
    return broken.sentence(_language(options), door="file")


def _refuse(sentence: str) -> int:
    streams.complain(sentence)
    return _BAD_INPUT


@contextmanager
def _terminated_like_interrupted() -> Generator[None]:
    """Within the block, the signal that ends a program interrupts like Ctrl-C."""
    try:
        before = signal.signal(signal.SIGTERM, _interrupt)
    except ValueError:  # not in the main thread
        yield
        return
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def _interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="kugelpendel",
        description="The exact motion of the spherical pendulum and its precession.",
        epilog="kugelpendel run --help shows what a job file looks like.",
    )
    parser.add_argument("--version", action="store_true", help="print the version and leave")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", parser_class=CommandParser)
    for command in _COMMANDS:
        command.add(commands)
    return parser
