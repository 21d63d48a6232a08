"""The command line: ``kugelpendel run FILE.toml``, ``compare FILE.toml`` and ``validity``.

Nothing heavy is imported before a command needs it, so that ``kugelpendel --help`` answers at once.
"""

from kugelpendel.cli._main import main as main

__all__ = ["main"]
