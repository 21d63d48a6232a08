"""Arguments that several commands have."""

from __future__ import annotations

import argparse
import shutil
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from kugelpendel.errors import InvalidInput

if TYPE_CHECKING:
    from collections.abc import Callable

    from kugelpendel.cli.job_file.schema import FileSchema


_NARROWEST = 50
_WIDEST = 78
"""Columns of what argparse leaves as it is in a help; the rest is as wide as the terminal."""


class CommandParser(argparse.ArgumentParser):
    """The parser of one command, whose arguments are added when the command is asked for.

    So the help of all commands answers before what any one of them needs is imported.

    Parameters
    ----------
    arguments
        Adds them to the parser.
    words
        As for its base.
    """

    def __init__(self, *, arguments: Callable[[argparse.ArgumentParser], None], **words: Any):
        super().__init__(**words)
        self._add = arguments

    def parse_known_args(  # pyright: ignore[reportIncompatibleMethodOverride] - all its overloads
        self, args: Any = None, namespace: Any = None
    ) -> Any:
        """Read the words behind the command."""
        self._add(self)
        try:
            return super().parse_known_args(args, namespace)
        except Refused as refused:
            # The language may stand behind what is refused.
            rest = argparse.ArgumentParser(add_help=False)
            if any(action.dest == "lang" for action in self._actions):
                rest.add_argument("--lang", nargs="?")
            refused.options = rest.parse_known_args(args)[0]
            raise


class Commands(Protocol):
    """Where a command adds its parser."""

    def add_parser(
        self,
        name: str,
        *,
        help: str,  # noqa: A002 - it is argparse's
        description: str,
        arguments: Callable[[argparse.ArgumentParser], None],
        epilog: str | None = None,
    ) -> object:
        """Add one."""
        ...


class Refused(Exception):
    """An argument that makes no sense.

    It is none of the errors of which argparse would make a line of its own.

    Parameters
    ----------
    what
        The error to say.

    Attributes
    ----------
    options
        The language that was asked for, where the command has several.
    """

    def __init__(self, what: InvalidInput) -> None:
        super().__init__(what)
        self.what = what
        self.options = argparse.Namespace()


def a_path(text: str) -> Path:
    """A path, in which ``~`` is the user's folder; ``-`` stays what it is."""
    if not text:
        raise Refused(InvalidInput.of("option_no_name"))
    try:
        return Path(text).expanduser()
    except RuntimeError as error:  # no such user, or one without a folder
        raise Refused(InvalidInput.of("option_no_user", file=text)) from error


def a_folder(text: str) -> Path:
    """A folder for several files, which standard output cannot be."""
    if text == "-":
        raise Refused(InvalidInput.of("option_several_files"))
    return a_path(text)


def takes_a_file(parser: argparse.ArgumentParser, schema: FileSchema, what: str) -> None:
    """Let a command take a job file and say where the files go; its help shows such a file."""
    from kugelpendel.cli.job_file.schema_text import example, listing

    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    width = min(max(shutil.get_terminal_size().columns - 2, _NARROWEST), _WIDEST)
    parser.description = textwrap.fill(parser.description or "", width)
    indented = example(schema).replace("\n", "\n  ").replace("\n  \n", "\n\n").rstrip()
    head = "What a file may say; quantities have a unit or are plain SI numbers:"
    parser.epilog = (
        f"{textwrap.fill(head, width)}\n\n{listing(schema, width)}\n\n"
        f"A file looks like this:\n\n  {indented}\n"
    )
    parser.add_argument(
        "file", type=a_path, metavar="FILE.toml", help=f"{what}; - reads standard input"
    )
    parser.add_argument(
        "--out", type=a_folder, metavar="DIR", help="folder for the files (default: out/NAME)"
    )
    parser.add_argument(
        "--json", action="store_true", help="print the results as JSON, and nothing else, on stdout"
    )
