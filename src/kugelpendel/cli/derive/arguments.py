"""The arguments of ``kugelpendel derive``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import a_path

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "derive",
        help="show or check why it is true",
        description="The derivation of the precession, from Newton's law on, with every step.",
        epilog="kugelpendel derive --format html writes the page to read or print.",
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "equation",
        nargs="?",
        metavar="EQUATION",
        help="such as 25: show only this one and what it rests on (default: everything)",
    )
    parser.add_argument("--lang", metavar="de|en", help="language (default: that of the locale)")
    parser.add_argument(
        "--format", metavar="html|md|latex|text", help="default: by the name of the file, or text"
    )
    parser.add_argument(
        "--out",
        type=a_path,
        metavar="FILE",
        help="file to write, - for standard output (default: the terminal; "
        "derivation.LANG.html for html)",
    )
    parser.add_argument(
        "--handout",
        action="store_true",
        help="write a page of at most six sheets of A4: numbered equations, pictures, numbers",
    )
    parser.add_argument("--misprints", action="store_true", help="list the misprints of the paper")
    parser.add_argument(
        "--check",
        action="store_true",
        help="run all proofs; the exit code is 1 if one fails; with --format html also write the "
        "page with what was found",
    )
    parser.add_argument(
        "--json", action="store_true", help="print the list of --misprints or --check as JSON"
    )
    parser.set_defaults(do=_derive, extra="paper")


def _derive(options: argparse.Namespace) -> int:
    from kugelpendel.cli.derive.command import derive, handout, list_misprints
    from kugelpendel.cli.derive.mixtures import refuse_mixture

    refuse_mixture(options)
    if options.check:
        from kugelpendel.cli.derive.check import check

        return check(options.equation, options.lang, options.json, options.format, options.out)
    if options.handout:
        handout(options.lang, options.out)
    elif options.misprints:
        list_misprints(options.lang, options.json)
    else:
        derive(options.equation, options.lang, options.format, options.out)
    return 0
