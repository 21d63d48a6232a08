"""``kugelpendel validity``: the map in numbers, one pendulum, the figure, and what is refused."""

import subprocess
import sys
from pathlib import Path

import pytest

import kugelpendel as kp


def test_all_pendulums(call) -> None:
    outcome = call("validity")
    assert outcome.code == 0, outcome.err
    lines = [line.split() for line in outcome.out.splitlines()]
    assert ["precession", "by", "(25)", "0.0151", "0.0478", "0.151", "0.467"] in lines
    assert ["frequency", "by", "(26)", "0.268", "0.464", "0.758", "0.933"] in lines
    assert sum(line[:2] == ["series,", "order"] for line in lines) == 12
    # Where the table says 1 %, it is 1 % for the worst width.
    assert abs(kp.validity(0.151, 0.151, 1.0).formula_25) == pytest.approx(0.01, rel=0.01)
    assert list(Path.cwd().iterdir()) == []


def test_one_pendulum(call) -> None:
    outcome = call("validity", "--length", "67 m", "--a", "3 m", "--b", "1 cm")
    assert outcome.code == 0, outcome.err
    first, *rest = outcome.out.splitlines()
    assert first == "3 m by 1 cm on 67 m: formula (25) is good to 0.044 %"
    rows = [line.split() for line in rest]
    assert ["formulas", "(25),", "(26)", "−0.044", "%", "+7.5e−06", "%"] in rows
    assert ["series,", "order", "12", "the", "same", "the", "same"] in rows


def test_plain_numbers_are_metres_and_the_sense_makes_no_difference(call) -> None:
    one = call("validity", "--length", "67", "--a", "3", "--b", "0.01").out
    assert one == call("validity", "--length", "67 m", "--a", "300 cm", "--b=-1 cm").out


def test_narrow_ellipse(call) -> None:
    outcome = call("validity", "--length", "1", "--a", "0.2")
    assert "Nothing precesses at b = 0" in outcome.out
    assert "0.89 %" in outcome.out


def test_figure(call) -> None:
    outcome = call("validity", "--length", "1 m", "--a", "0.2", "--out", "new/map.PNG")
    assert outcome.code == 0, outcome.err
    assert [path.name for path in Path("new").iterdir()] == ["map.PNG"]
    assert Path("new/map.PNG").stat().st_size > 10_000
    assert outcome.out.endswith("In new/map.PNG: the map\n")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--a", "3 m"], ["--length is missing", "kugelpendel validity --length"]),
        (["--length", "3 m"], ["--a is missing"]),
        (["--b", "3 m"], ["--length is missing"]),
        (["--length", "nan", "--a", "1"], ["--length", "not a finite number"]),
        (["--length", "67 m", "--a", "inf m"], ["--a", "not a finite number"]),
        (["--length", "67 kg", "--a", "1"], ["--length", "not a length"]),
        (["--length", "67 m", "--a", "wide"], ["--a", "does not start with a number"]),
        (["--length", "67 m", "--a", "1 furlog"], ["furlog"]),
        (["--length", "0", "--a", "1"], ["length", "0 m"]),
        (["--length", "1", "--a", "1"], ["outer turning radius", "1 m"]),
        (["--length", "1", "--a=-0.1"], ["outer turning radius", "-0.1 m"]),
        (["--length", "1", "--a", "0.1", "--b", "0.2"], ["0.2 m", "0.1 m"]),
        (["--out", "map.jpg"], ["map.jpg", ".png", ".svg", ".pdf"]),
        (["--out", "."], ["must end in"]),
    ],
)
def test_bad_options(call, options: list[str], words: list[str]) -> None:
    outcome = call("validity", *options, *(["--out", "map.png"] if "--out" not in options else []))
    assert outcome.code == 2
    assert outcome.out == ""
    assert outcome.err.startswith("kugelpendel: ")
    for word in words:
        assert word in outcome.err
    assert list(Path.cwd().iterdir()) == []


def test_unknown_option(call, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as leaving:
        call("validity", "--width", "1")
    assert leaving.value.code == 2
    assert "usage: kugelpendel" in capsys.readouterr().err


def test_folder_in_the_way_of_the_figure(call) -> None:
    Path("map.png").mkdir()
    outcome = call("validity", "--out", "map.png")
    assert outcome.code == 2
    assert "map.png cannot be written: it is a folder" in outcome.err


def test_run_says_the_same(call, write) -> None:
    results = call("run", write(), "--json").results
    said = results["formula_25"]["difference_percent"]
    assert said == pytest.approx(100 * kp.validity(0.2, 0.1, 1.0).formula_25, abs=1e-12)


def test_json_of_one_pendulum(call) -> None:
    results = call("validity", "--length", "67 m", "--a", "3 m", "--b=-1 cm", "--json").results
    assert results["length_m"] == 67
    assert results["inner_turning_radius_m"] == 0.01
    errors = results["relative_errors"]
    found = kp.validity(3.0, 0.01, 67.0)
    assert errors["formulas (25), (26)"] == {
        "precession": found.formula_25,
        "frequency": found.formula_26,
    }
    assert errors["series, order 4"]["precession"] == found.series[4].precession
    assert len(errors) == 1 + len(found.series)


def test_json_of_all(call) -> None:
    results = call("validity", "--json").results
    assert results["levels"] == [1e-4, 1e-3, 1e-2, 1e-1]
    reach = results["largest_a_over_l"]
    assert reach["precession"]["by (25)"] == pytest.approx([0.0151, 0.0478, 0.151, 0.467], rel=4e-3)
    assert len(reach["frequency"]) == 7


def test_figure_on_standard_output(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "kugelpendel", "validity", "--out", "-"],
        cwd=tmp_path, capture_output=True, check=True,
    )  # fmt: skip
    assert done.stdout.startswith(b"\x89PNG")
    assert done.stdout.endswith(b"IEND\xaeB`\x82")
    assert list(tmp_path.iterdir()) == []


def test_two_things_for_standard_output(call) -> None:
    outcome = call("validity", "--json", "--out", "-")
    assert outcome.code == 2
    assert "both want standard output" in outcome.err


def test_numbers_need_no_matplotlib(call, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.startswith("kugelpendel.plot")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert "formula (25) is good to" in call("validity", "--length", "1", "--a", "0.2").out
    outcome = call("validity", "--out", "map.png")
    assert outcome.code == 2
    assert "matplotlib is not installed, and `kugelpendel validity` needs it" in outcome.err
    assert list(Path.cwd().iterdir()) == []
