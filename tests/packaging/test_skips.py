"""In CI a skip is a failure, so that a missing oracle cannot pass unseen."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CASES = {
    "call": ("import pytest\ndef test(): pytest.skip('no oracle')\n", "failed"),
    "module": ("import pytest\npytest.importorskip('no_such_oracle')\n", "error"),
    "mark": ("import pytest\n@pytest.mark.skip\ndef test(): ...\n", "error"),
    "expected": ("import pytest\n@pytest.mark.xfail\ndef test(): assert False\n", "xfailed"),
    "shared": ("def test(shared): ...\n", "skipped"),
}


def outcome(text: str, repository: Path, folder: Path, ci: str) -> str:
    """The closing line of pytest on one test file under our rules."""
    shutil.copy(repository / "tests" / "conftest.py", folder)
    (folder / "test_case.py").write_text(text)
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-p", "no:randomly"],
        cwd=folder,
        env=os.environ | {"CI": ci},
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout.splitlines()[-1]


@pytest.mark.parametrize("kind", CASES)
def test_skip_in_ci(kind: str, repository: Path, tmp_path: Path) -> None:
    text, expected = CASES[kind]
    assert f"1 {expected}" in outcome(text, repository, tmp_path, "true")


@pytest.mark.parametrize("kind", ["call", "module", "mark", "shared"])
def test_skip_on_a_desk(kind: str, repository: Path, tmp_path: Path) -> None:
    text, _ = CASES[kind]
    assert "1 skipped" in outcome(text, repository, tmp_path, "")
