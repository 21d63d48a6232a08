"""The command line: ``kugelpendel run FILE.toml`` and its sisters.

Nothing heavy is imported before a command needs it, so that ``kugelpendel --help`` answers at once.
"""

from kugelpendel.cli.command_line import main as main

__all__ = ["main"]
