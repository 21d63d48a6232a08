"""The scripts in examples/gallery run, and show what they say."""

import runpy
from pathlib import Path

import pytest

NAMES = ["careless_integration", "fitted_track"]


def test_every_script_is_tested(repository: Path) -> None:
    assert sorted(path.stem for path in (repository / "examples/gallery").glob("*.py")) == NAMES


def test_careless_integration(
    repository: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    script = runpy.run_path(str(repository / "examples/gallery/careless_integration.py"))
    errors = script["main"](str(tmp_path / "figure.png"))
    assert (tmp_path / "figure.png").stat().st_size > 10_000
    said = capsys.readouterr().out
    assert "formula (25)      -0.024 %" in said
    # The page says 2 %; SciPy's own step control may move it.
    assert errors[1e-3] == pytest.approx(0.02, rel=0.3)
    formula = abs(script["FORMULA"] / script["EXACT"].precession - 1)
    assert errors[1e-3] > 50 * formula
    assert errors[1e-7] < 1e-3 * errors[1e-3]


def test_fitted_track(repository: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = runpy.run_path(str(repository / "examples/gallery/fitted_track.py"))
    missed = script["main"](str(tmp_path / "figure.png"))
    assert (tmp_path / "figure.png").stat().st_size > 10_000
    assert "truth             a = " in capsys.readouterr().out
    # Nothing in χ² shows the tilt, and yet the narrow error bar excludes the truth.
    assert missed["ratio"] < 1.2
    assert missed["narrow"] > 10
    assert missed["headline"] < 2
