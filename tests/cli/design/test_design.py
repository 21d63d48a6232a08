"""``kugelpendel design``: tables, figure, JSON, and what is refused."""

import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from kugelpendel.cli.terminal import progress

FILE: dict[str, dict[str, Any]] = {
    "pendulum": {"length": "20 m"},
    "swing": {"a": "1 m", "b": "5 mm"},
    "site": {"latitude": "50 deg"},
    "bob": {"diameter": "24 cm", "density": "7860 kg/m^3", "thread_mass": "280 g"},
    "drag": {"half_life": "2 h"},
    "wire": {"diameter": "1.5 mm"},
}


@pytest.fixture
def ask(tmp_path: Path):
    """Write the usual questions with some tables changed, and give the path."""

    def ask(**changes: dict[str, Any] | None) -> Path:
        tables = {**FILE, **{name: FILE.get(name, {}) | (change or {})
                             for name, change in changes.items()}}  # fmt: skip
        lines: list[str] = []
        for name, entries in tables.items():
            if name in changes and changes[name] is None:
                continue
            lines.append(f"[{name}]")
            lines += [f"{key} = {json.dumps(value)}" for key, value in entries.items()]
        path = tmp_path / "tower.toml"
        path.write_text("\n".join(lines), encoding="utf-8")
        return path

    return ask


def rows(out: str) -> dict[str, list[str]]:
    """The lines by their names; cells apart by two blanks or more."""
    found: dict[str, list[str]] = {}
    for line in out.splitlines():
        name, *cells = [cell.strip() for cell in line.split("  ") if cell.strip()] or [""]
        found.setdefault(name, cells)
    return found


def test_tables(call, ask) -> None:
    outcome = call("design", ask())
    assert outcome.code == 0, outcome.err
    assert outcome.err == ""
    table = rows(outcome.out)
    assert table["Swing"] == ["a = 1 m, b = 5 mm, 2.866° to either side"]
    assert table["Site"] == ["latitude 50°, g = 9.8107 m/s²"]
    assert table["Foucault rate"][:2] == ["−11.522 °/h", "−11.522 °/h"]
    assert table["Intrinsic rate, formula (25)"] == ["+0.67737 °/h"]
    assert table["Amplitude, by the series"] == ["156.4 ppm"]
    assert table["Bob's radius"] == ["7.200 ppm"]
    assert table["One turn by the Earth"] == ["31.24 h"]
    assert table["Period of the swing"][0].startswith("8.96990")
    assert table["Period of the swing"][1].startswith("8.96990")
    assert table["Largest stress"] == ["318.2 MPa"]
    assert table["Period by a kelvin"] == ["6.000 ppm/K"]
    assert "(3/8) ω0 ab/l² [" in outcome.out
    assert "M. G. Olsson, Am. J. Phys. 49, 531 (1981), eq. (25)" in outcome.out
    assert "physics.md" not in outcome.out
    assert all(len(line) <= 100 for line in outcome.out.splitlines())
    assert outcome.out.endswith("In out/tower: design.png, design.json\n")


def test_tables_without_checks(call, ask) -> None:
    outcome = call("design", ask(), "--formulas")
    assert rows(outcome.out)["Foucault rate"] == ["−11.522 °/h"]
    assert rows(outcome.out)["Turning"] == ["By formula"]
    assert "By RealMotion" not in outcome.out


def test_files_and_json(call, ask) -> None:
    outcome = call("design", ask(), "--json", "--out", "there")
    assert outcome.code == 0, outcome.err
    assert sorted(path.name for path in Path("there").glob("[!.]*")) == [
        "design.json",
        "design.png",
    ]
    assert Path("there/design.png").read_bytes().startswith(b"\x89PNG")
    assert outcome.out == Path("there/design.json").read_text(encoding="utf-8")
    answers = {answer["name"]: answer for answer in outcome.results["answers"]}
    rate = answers["Foucault rate"]
    assert rate["unit"] == "rad/s"
    assert rate["value"] == pytest.approx(-7.292115e-5 * math.sin(math.radians(50)))
    assert rate["check"]["measured"] == pytest.approx(rate["value"], rel=1e-8)
    assert rate["check"]["how"].startswith("RealMotion with the Earth alone")
    assert rate["source"].startswith("L. Foucault")
    assert outcome.results["rates_at_the_start_rad_per_s"]["earth"] == rate["value"]


def test_only_what_must_be_there(call, ask) -> None:
    nothing = dict.fromkeys(("site", "bob", "drag", "wire"))
    outcome = call("design", ask(**nothing), "--json")
    assert outcome.code == 0, outcome.err
    groups = {answer["group"] for answer in outcome.results["answers"]}
    assert groups == {"period", "turning", "passage", "wire"}
    call("design", ask(**nothing))


def test_equator_never_turns(call, ask) -> None:
    path = ask(site={"latitude": "0 deg"})
    assert rows(call("design", path).out)["One turn by the Earth"] == ["never"]
    answers = call("design", path, "--json").results["answers"]
    assert [a["value"] for a in answers if a["name"] == "One turn by the Earth"] == [None]


def test_example(call, repository: Path) -> None:
    outcome = call("design", repository / "examples" / "design" / "stairwell.toml")
    assert outcome.code == 0, outcome.err
    assert "nan" not in outcome.out
    table = rows(outcome.out)
    for title in ("Period", "Turning", "Decay", "Drive", "Passage", "Wire"):
        assert table[title] == ["By formula", "By RealMotion", "Off by"]
    assert "Turning under the drive given" in table
    assert "Slowest turning by the damping" in table


@pytest.mark.parametrize("help_of", ["--help", "design"])
def test_help_shows_a_file_that_works(
    call, tmp_path: Path, capsys: pytest.CaptureFixture[str], help_of: str
) -> None:
    arguments = [help_of] if help_of.startswith("-") else [help_of, "--help"]
    with pytest.raises(SystemExit):
        call(*arguments)
    text = capsys.readouterr().out
    if help_of.startswith("-"):
        assert "what the builder of a pendulum asks" in text
        return
    path = tmp_path / "help.toml"
    path.write_text(text[text.index("[pendulum]") :], encoding="utf-8")
    assert call("design", path, "--formulas").code == 0


REFUSED: list[tuple[dict[str, dict[str, Any] | None], str]] = [
    ({"pendulum": {"length": "-20 m"}}, "length"),
    ({"swing": None}, "the table [swing] is missing; a job has [pendulum], [swing]."),
    ({"swing": {"a": "25 m"}}, "amplitude a must lie between 0 and the length 20 m"),
    ({"swing": {"a": "1 kg"}}, "[swing] a"),
    ({"swing": {"b": "80 cm"}}, "must not exceed half the amplitude"),
    ({"swing": {"c": 1}}, "[swing] c is not known"),
    ({"launch": {"kind": "ellipse"}}, "[launch] is not known"),
    ({"site": {"latitude": "91 deg"}}, '[site] latitude = "91 deg" lies beyond a pole'),
    ({"site": {"gravity": 9.9}, "pendulum": {"gravity": 9.8}}, "the pendulum's is 9.8 m/s²"),
    ({"drag": {"half_life": "-1 h"}}, "[drag] The half life must be positive"),
    ({"bob": {"diameter": "50 m"}}, "[bob] The bob's radius must be less than the length"),
    ({"wire": {"diameter": "0 mm"}}, "[wire] The wire's diameter must be positive"),
    ({"wire": {"young": "200 kg"}}, "[wire] young"),
    ({"questions": {"share": "1 %"}}, '[questions] share = "1 %" is not a plain number; write'),
    ({"questions": {"share": 2}}, "share of the Foucault rate must lie between 0 and 1"),
    ({"questions": {"radius": "2 m"}}, "radius to pass must lie between"),
    ({"questions": {"after": "0 h"}}, "time after which"),
    ({"questions": {"when": 1}}, "[questions] when is not known"),
    ({"drive": {"push": "1 mm/s"}}, "[drive] A drive needs exactly one of phase and radius"),
]


@pytest.mark.parametrize(("changes", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(call, ask, changes: dict[str, Any], said: str) -> None:
    outcome = call("design", ask(**changes))
    assert outcome.code == 2
    assert outcome.out == ""
    assert outcome.err.startswith("kugelpendel: ")
    assert re.search(r"tower\.toml(, line \d+)?: ", outcome.err)
    assert said in outcome.err
    assert list(Path.cwd().iterdir()) == []


def test_missing_and_empty_files(call, ask, tmp_path: Path) -> None:
    outcome = call("design", ask().with_name("towre.toml"))
    assert outcome.code == 2
    assert "towre.toml does not exist; that folder has tower.toml" in outcome.err
    (tmp_path / "empty.toml").write_text("")
    assert "is empty" in call("design", tmp_path / "empty.toml").err


def test_folder_that_is_a_file(call, ask, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("mine")
    outcome = call("design", ask(), "--out", tmp_path / "taken", "--formulas")
    assert outcome.code == 2
    assert "is a file" in outcome.err


def test_progress_reaches_its_end(call, ask, monkeypatch: pytest.MonkeyPatch) -> None:
    counted: list[tuple[int, int]] = []
    monkeypatch.setattr(progress.Progress, "reach", lambda self, *of: counted.append(of))
    call("design", ask(suspension={"anisotropy": "1e-6 rad/s"}))
    assert [taken for taken, _ in counted] == list(range(1, counted[-1][1] + 1))
    assert len(counted) > 50


def test_interrupted_leaves_nothing(ask, tmp_path: Path) -> None:
    folder = tmp_path / "there"
    call = [sys.executable, "-c", "import os, signal\nfrom kugelpendel.builder import _suspension\n"
            "_suspension._run = lambda *_: os.kill(os.getpid(), signal.SIGINT)\n"
            "from kugelpendel.cli import main\nraise SystemExit(main())",
            "design", ask(suspension={"anisotropy": "1e-6 rad/s"}), "--out", folder]  # fmt: skip
    done = subprocess.run(call, capture_output=True, text=True, check=False, env=os.environ)
    assert done.returncode == 130, done.stderr
    assert "interrupted" in done.stderr
    assert not folder.exists()
