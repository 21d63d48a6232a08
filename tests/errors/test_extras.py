"""What is said where an extra is not installed: all that is missing, and how to get it."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from kugelpendel import MissingExtra
from kugelpendel.errors import require_extra
from kugelpendel.errors._extras import EXTRAS

BLOCKED = """
import sys
for name in {names}:
    sys.modules[name] = None
import kugelpendel as kp
try:
    {statement}
except kp.MissingExtra as error:
    print(error)
"""


def said(names: list[str], statement: str) -> str:
    script = BLOCKED.format(names=names, statement=statement)
    return subprocess.run(
        [sys.executable, "-c", script], check=True, capture_output=True, text=True
    ).stdout.strip()


def test_the_packages_are_those_of_the_project(repository: Path) -> None:
    project = tomllib.loads((repository / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    for extra, packages in project["optional-dependencies"].items():
        assert sorted(EXTRAS[extra]) == sorted(re.split("[<>=]", name)[0] for name in packages)


def test_all_that_is_missing_is_named_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    require_extra("run", "this")
    for name in ("xarray", "matplotlib", "pint"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtra) as raised:
        require_extra("run", "`kugelpendel run`")
    assert str(raised.value) == (
        "matplotlib, pint and xarray are not installed, and `kugelpendel run` needs them: python "
        "-m pip install 'kugelpendel[run]'"
    )
    assert raised.value.extra == "run"
    with pytest.raises(
        MissingExtra, match=r"^xarray is not installed, and to_xarray needs it: pyt"
    ):
        require_extra("run", "to_xarray", "xarray", "numpy")


@pytest.mark.parametrize(
    ("names", "statement", "sentence"),
    [
        (["xarray"], "kp.ExactMotion(kp.Pendulum(1.0), kp.Launch.at_rest(0.1)).to_xarray([0.0])",
         "xarray is not installed, and to_xarray needs it: python -m pip install "
         "'kugelpendel[run]'"),
        (["matplotlib"], "import kugelpendel.plot; kugelpendel.plot.overview",
         "matplotlib is not installed, and kugelpendel.plot needs it: python -m pip install "
         "'kugelpendel[run]'"),
        (["markdown_it"], "import kugelpendel.paper; kugelpendel.paper.write",
         "markdown-it-py is not installed, and kugelpendel.paper needs it: python -m pip install "
         "'kugelpendel[paper]'"),
        (["sympy", "mpmath"], "import kugelpendel.paper; kugelpendel.paper.formula",
         "mpmath and sympy are not installed, and kugelpendel.paper needs them: python -m pip "
         "install 'kugelpendel[paper]'"),
    ],
)  # fmt: skip
def test_what_the_library_says(names: list[str], statement: str, sentence: str) -> None:
    assert said(names, statement) == sentence
