"""``python -m kugelpendel`` is the command ``kugelpendel``."""

import sys

from kugelpendel.cli import main

if __name__ == "__main__":
    sys.exit(main())
