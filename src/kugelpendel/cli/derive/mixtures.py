"""Which options of ``kugelpendel derive`` say nothing together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    import argparse


def refuse_mixture(options: argparse.Namespace) -> None:
    """Refuse options that say nothing together, with a sentence that tells what to leave out.

    Raises
    ------
    InvalidInput
        Two commands at once, or an option that the command has no use for.
    """
    commands = [name for name in ("check", "misprints", "handout") if getattr(options, name)]
    if len(commands) > 1:
        first, second = commands[:2]
        raise InvalidInput(f"--{first} and --{second} are two commands; give one of them.")
    (command,) = commands or [""]
    if options.json and command not in ("check", "misprints"):
        raise InvalidInput(
            "--json prints what --check or --misprints finds; add one of them, or choose the form "
            "of the derivation by --format."
        )
    if not command:
        return
    # the table of --check goes where a page on standard output would go
    is_stream = str(options.out) == "-" and command != "check"
    is_file = options.out is None or options.out.suffix == ".html"
    is_page = options.format in (None, "html") and (is_file or is_stream)
    given = {"--format": options.format, "--out": options.out, "the equation": options.equation}
    useless = {
        "check": [] if is_page and not options.json else ["--format", "--out"],
        "misprints": ["--format", "--out", "the equation"],
        "handout": ["the equation"] if is_page else ["--format", "--out", "the equation"],
    }[command]
    found = [name for name in useless if given[name] is not None]
    if found:
        raise InvalidInput(f"{_WHAT[command]}; leave out {' and '.join(found)}.")


_WHAT = {
    "check": "--check prints one list to the terminal, and writes a page only as HTML",
    "misprints": "--misprints prints one list to the terminal",
    "handout": "--handout writes one page of the whole derivation, in a file that ends in .html",
}
