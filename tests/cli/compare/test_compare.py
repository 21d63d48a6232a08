"""``kugelpendel compare``: table, figure, JSON, and what is refused."""

import json
import sys
from pathlib import Path

import pytest

from kugelpendel.spelling import spell_percent


def rows(out: str) -> dict[str, list[str]]:
    """The table by the names of its rows, cells apart by two blanks or more."""
    found: dict[str, list[str]] = {}
    for line in out.splitlines():
        name, *cells = [cell.strip() for cell in line.split("  ") if cell.strip()] or [""]
        found.setdefault(name, cells)
    return found


def test_table(call, write) -> None:
    outcome = call("compare", write())
    assert outcome.code == 0, outcome.err
    assert outcome.err == ""
    table = rows(outcome.out)
    assert table["Pendulum"] == ["1 m, 2 kg, g = 9.80665 m/s²"]
    assert table["Compared"] == ["over 10.00 s, 4.97 swings, with the exact motion:"]
    assert table["LinearMotion"] == ["(16)", "3.72 cm", "19 %", "3.72 cm", "−0.31 %", "−100 %"]
    assert table["OlssonMotion"][-2:] == ["−0.0017 %", "−1.1 %"]
    assert table["SeriesMotion(6)"][0] == "series"
    assert table["PlaneMotion"][0] == "(12)"
    assert outcome.out.count("PlaneMotion") == 2
    assert "Exact below the support's level" in outcome.out
    assert all(len(line) <= 100 for line in outcome.out.splitlines())
    assert outcome.out.endswith("In out/job: comparison.json\n")


@pytest.mark.parametrize("columns", [60, 80, 140])
def test_numbers_are_whole_at_any_width(
    call, write, monkeypatch: pytest.MonkeyPatch, columns: int
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    outcome = call("compare", write(launch={"a": "1 mm", "b": "0.5 mm"}))
    assert outcome.code == 0, outcome.err
    assert "…" not in outcome.out
    assert all(len(line) <= columns for line in outcome.out.splitlines())
    motions = json.loads(Path("out/job/comparison.json").read_text(encoding="utf-8"))["motions"]
    for name, motion in motions.items():
        if motion["precession_relative_error"] is not None:
            assert spell_percent(motion["precession_relative_error"]) in outcome.out, name


def test_files(call, write) -> None:
    outcome = call("compare", write(output={"figure": True}), "--out", "there")
    assert outcome.code == 0
    assert sorted(path.name for path in Path("there").glob("[!.]*")) == [
        "comparison.json",
        "comparison.png",
    ]
    assert Path("there/comparison.png").read_bytes().startswith(b"\x89PNG")
    assert outcome.out.endswith("In there: comparison.png, comparison.json\n")


def test_json_is_the_file(call, write) -> None:
    outcome = call("compare", write(), "--json")
    assert outcome.out == Path("out/job/comparison.json").read_text(encoding="utf-8")
    motions = outcome.results["motions"]
    assert motions["LinearMotion"]["precession_relative_error"] == -1
    assert motions["OlssonMotion"]["precession_relative_error"] == pytest.approx(-0.01103, abs=1e-5)
    assert motions["PlaneMotion"]["largest_error_m"] < 1e-12
    assert motions["PlaneMotion"]["why_it_does_not_apply"] is None
    assert outcome.results["duration_s"] == 10


def test_results_of_a_run_stay(call, write) -> None:
    path = write()
    assert call("run", path).code == call("compare", path).code == 0
    assert {"results.json", "comparison.json"} < {p.name for p in Path("out/job").iterdir()}


def test_upper_half_has_reasons_in_place_of_numbers(call, write) -> None:
    path = write(launch={"kind": "at_rest", "theta": "120 deg"}, output={"figure": True})
    outcome = call("compare", path)
    assert outcome.code == 0, outcome.err
    table = rows(outcome.out)
    assert table["LinearMotion"] == ["(16)", *"–––––"]
    assert "the support" in outcome.out
    results = json.loads(Path("out/job/comparison.json").read_text(encoding="utf-8"))
    assert "ExactMotion" in results["motions"]["PlaneMotion"]["why_it_does_not_apply"]
    assert results["motions"]["PlaneMotion"]["largest_error_m"] is None


@pytest.mark.parametrize("name", ["cone", "over-the-top", "pantheon"])
def test_examples(call, repository: Path, name: str) -> None:
    outcome = call("compare", repository / "examples" / f"{name}.toml")
    assert outcome.code == 0, outcome.err
    assert "nan" not in outcome.out


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"pendulum": {"length": "nan m"}}, ["is not a finite number"]),
        ({"launch": {"a": "2 m"}}, ["job.toml", "outer turning radius", "2 m"]),
        ({"launch": {"kind": "elipse"}}, ["did you mean ellipse?"]),
        ({"output": {"duration": "1 year", "step": "1 h"}}, ["job.toml", "20000 swings"]),
        ({"output": {"duration": -1}}, ["duration = -1"]),
    ],
)
def test_bad_job(call, write, changes: dict, words: list[str]) -> None:
    outcome = call("compare", write(**changes))
    assert outcome.code == 2
    assert outcome.out == ""
    assert outcome.err.startswith("kugelpendel: ")
    for word in words:
        assert word in outcome.err
    assert list(Path.cwd().iterdir()) == []


def test_missing_file(call, write) -> None:
    outcome = call("compare", write().with_name("jbo.toml"))
    assert outcome.code == 2
    assert "jbo.toml does not exist; that folder has job.toml" in outcome.err


def test_folder_that_is_a_file(call, write, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("mine")
    outcome = call("compare", write(), "--out", tmp_path / "taken")
    assert outcome.code == 2
    assert "is a file" in outcome.err


@pytest.mark.parametrize("arguments", [["compare"], ["compare", "a", "--format", "csv"]])
def test_wrong_arguments(call, capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as leaving:
        call(*arguments)
    assert leaving.value.code == 2
    assert "usage: kugelpendel" in capsys.readouterr().err


def test_package_that_is_not_installed(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    from kugelpendel.cli.compare import command

    def absent(*_: object) -> None:
        raise ModuleNotFoundError("No module named 'rich'", name="rich")

    monkeypatch.setattr(command, "comparison_report", absent)
    monkeypatch.setitem(sys.modules, "rich", None)
    monkeypatch.setitem(sys.modules, "rich", None)
    outcome = call("compare", write())
    assert outcome.code == 2
    assert "rich is not installed, and `kugelpendel compare` needs it" in outcome.err
