"""docs/series.md says what its command measures, and its listing runs."""

import re
import runpy
from pathlib import Path
from typing import Any

import pytest

import kugelpendel as kp


@pytest.fixture(scope="module")
def page(repository: Path) -> str:
    return (repository / "docs/series.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def command(repository: Path) -> dict[str, Any]:
    return runpy.run_path(str(repository / "docs/scripts/convergence.py"))


def test_formulas_are_the_ones_derived(page: str, command: dict[str, Any]) -> None:
    assert command["formulas"]() in page


def test_errors_are_the_ones_measured(page: str, command: dict[str, Any]) -> None:
    command["errors_table"].__globals__["ORDERS"] = (2, 6, 12)  # 40 takes seconds
    rows = command["errors_table"]().splitlines()[3:]

    def without_rounding(row: str) -> list[str]:
        """Errors above 1e-12: the last digits of the others are the machine's."""
        return re.findall(r"\d(?:e−\d)(?!\d)", row)

    for row in rows:
        order = row.split("|")[1]
        stored = re.search(rf"^\|{order}\|.*$", page, re.MULTILINE)
        assert stored is not None
        assert without_rounding(stored[0]) == without_rounding(row)


def test_listing_runs(page: str, capsys: pytest.CaptureFixture[str]) -> None:
    listing = re.search(r"```python\n(.*?)```", page, re.DOTALL)
    assert listing is not None
    exec(compile(listing[1], "docs/series.md", "exec"), {})
    printed = capsys.readouterr().out
    assert printed.splitlines()[0] == "3/8 α β + 21/256 α³ β + 21/256 α β³"
    assert kp.series.frequency(4).coefficients[4, 0] == -21 / 1024
