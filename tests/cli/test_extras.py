"""Missing packages: all of an extra are named at once."""

import sys

import pytest


def test_all_that_is_missing_is_named(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("pint", "rich", "pyarrow"):
        monkeypatch.setitem(sys.modules, name, None)
    from kugelpendel.cli.job_file import units

    units._parsed.cache_clear()
    units._registry.cache_clear()
    outcome = call("run", write())
    assert outcome.code == 2
    assert outcome.err == (
        "kugelpendel: pint, pyarrow and rich are not installed, and `kugelpendel run` needs them: "
        "python -m pip install 'kugelpendel[run]'\n"
    )
