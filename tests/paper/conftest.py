"""What is proved once for all tests of the derivation."""

import os
import pickle
from collections.abc import Callable
from functools import cache

import pytest

from kugelpendel import paper

Examined = Callable[[str], paper.Row]


@pytest.fixture(scope="session")
def examined(tmp_path_factory: pytest.TempPathFactory) -> Examined:
    """The row of a formula with its evidence, found by whichever worker asks for it first."""
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    folder /= "rows"
    folder.mkdir(exist_ok=True)

    @cache
    def examined(label: str) -> paper.Row:
        path = folder / f"{label.replace(':', '-')}.pickle"
        if path.is_file():
            return pickle.loads(path.read_bytes())
        row = paper.examined(label, thorough=False)
        written = path.with_suffix(f".{os.getpid()}")
        written.write_bytes(pickle.dumps(row))
        written.replace(path)
        return row

    return examined
