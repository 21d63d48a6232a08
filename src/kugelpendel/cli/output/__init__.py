"""Files that appear complete or not at all, and replace only what an earlier run has made.

Whatever fails, a whole set of files stays: the old one or the new one. A run writes into a folder
of its own, ``.kugelpendel-…``, that lies where a move is a renaming. While the files of that folder
are put in their places it keeps a link to each new file and to each one that is replaced; so a
failure puts the old ones back, and what a killed run has left half-done the next run completes.
"""

from kugelpendel.cli.output.files import one_file as one_file
from kugelpendel.cli.output.files import staged as staged
from kugelpendel.cli.output.files import write_file as write_file

__all__ = ["one_file", "staged", "write_file"]
