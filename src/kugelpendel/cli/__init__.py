"""The command line: ``kugelpendel run FILE.toml``, ``compare``, ``validity`` and ``derive``.

Nothing heavy is imported before a command needs it, so that ``kugelpendel --help`` answers at once.
"""

from kugelpendel.cli.main import main as main

__all__ = ["main"]
