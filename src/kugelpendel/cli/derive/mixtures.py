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
        raise InvalidInput.of("derive_two", first=first, second=second)
    (command,) = commands or [""]
    if options.json and command not in ("check", "misprints"):
        raise InvalidInput.of("derive_json")
    if not command:
        return
    # the table of --check goes where a page on standard output would go
    is_stream = str(options.out) == "-" and command != "check"
    is_file = options.out is None or options.out.suffix == ".html"
    is_page = options.format in (None, "html") and (is_file or is_stream)
    given = {"--format": options.format, "--out": options.out, "EQUATION": options.equation}
    useless = {
        "check": [] if is_page and not options.json else ["--format", "--out"],
        "misprints": ["--format", "--out", "EQUATION"],
        "handout": ["EQUATION"] if is_page else ["--format", "--out", "EQUATION"],
    }[command]
    found = [name for name in useless if given[name] is not None]
    if found:
        raise InvalidInput.of(f"derive_{command}", useless=", ".join(found))
