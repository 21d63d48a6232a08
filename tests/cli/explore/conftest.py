"""The engine of the built page, for tests that ask it what Python is asked."""

from collections.abc import Iterator

import pytest
from tests.cli.explore.browsing import Engine, NotThere, running


@pytest.fixture(scope="session")
def engine() -> Iterator[Engine]:
    """What the page stands on, in the browser: call it with a script and what it is given."""
    try:
        with running() as engine:
            yield engine
    except NotThere as error:
        pytest.skip(str(error))
