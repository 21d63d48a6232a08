"""Everything that can be wrong with a job: a sentence, exit code 2, and no file."""

import sys
from pathlib import Path
from typing import Any

import pytest

SENTENCES: list[tuple[str, dict[str, dict[str, Any]], list[str]]] = [
    ("unknown key", {"pendulum": {"lenght": 1.0}}, ["lenght", "did you mean length?", "gravity"]),
    ("unknown table", {"pendulums": {"x": 1}}, ["[pendulums]", "did you mean pendulum?"]),
    (
        "unknown kind",
        {"launch": {"kind": "elipse"}},
        ['"elipse"', "did you mean ellipse?", "plane"],
    ),
    ("no kind", {"launch": {"kind": None, "a": 1}}, ["[launch] kind is missing", '"ellipse"']),
    ("key of another kind", {"launch": {"theta": 1}}, ["theta", 'kind = "apsides"', "azimuth"]),
    ("missing key", {"launch": {"b": None}}, ["[launch] b is missing", 'b = "3 cm"']),
    (
        "missing length",
        {"pendulum": {"length": None}},
        ["[pendulum] length is missing", 'length = "67 m"'],
    ),
    ("mass as length", {"launch": {"a": "3 kg"}}, ['a = "3 kg" is not a length', '"3 cm"']),
    ("unknown unit", {"launch": {"a": "3 furlog"}}, ['the unit "furlog" is not known', '"3 cm"']),
    ("broken unit", {"launch": {"a": "3 m**"}}, ['the unit "m**" is not known']),
    ("scaled unit", {"launch": {"a": "3 2m"}}, ['the unit "2m" is not known']),
    ("no unit", {"launch": {"a": "3"}}, ['a = "3" has no unit', "plain number in m"]),
    ("no number", {"launch": {"a": "wide"}}, ['"wide" does not start with a number']),
    ("two commas", {"launch": {"a": "1,234,567 m"}}, ["more than one point or comma"]),
    ("comma of thousands", {"launch": {"a": "1,234 m"}}, ['write "1.234 m" or "1234 m"']),
    ("degrees in German", {"launch": {"kind": "at_rest", "theta": "45 Grad"}}, ['"deg" or "gon"']),
    ("degrees without a unit", {"launch": {"kind": "at_rest", "theta": 45}}, ['write "45 deg"']),
    ("beyond a turn", {"launch": {"azimuth": "361 deg"}}, ["more than a full turn", "360 deg"]),
    ("grains", {"pendulum": {"mass": "500 gr"}}, ["is the grain of 64.8 mg", 'write "g"']),
    ("open bracket", {"launch": {"azimuth": "4{ deg"}}, ['the unit "{ deg" is not known']),
    ("longitude", {"site": {"latitude": "2.35 E"}}, ["is not a latitude", '"48.85 N"']),
    ("sign and side", {"site": {"latitude": "-33 S"}}, ["both a sign and S"]),
    ("feet of 13 inches", {"pendulum": {"length": "12 ft 13 in"}}, ["ever smaller units"]),
    ("a page for a number", {"launch": {"a": "1" * 500 + " m"}}, ["too long for a quantity"]),
    ("true for a number", {"launch": {"a": True}}, ["a = true is not a number"]),
    ("list for a number", {"launch": {"a": [1]}}, ["is not a number"]),
    ("Hz", {"launch": {"kind": "angles", "theta": 1, "phi_rate": "5 Hz"}}, ["Hz", "turns"]),
    ("percent", {"launch": {"kind": "at_rest", "theta": "5 percent"}}, ["not an angle", "30 deg"]),
    ("nan", {"pendulum": {"length": "|nan|"}}, ["length = nan is not a finite number"]),
    ("nan in quotes", {"pendulum": {"length": "nan m"}}, ["is not a finite number"]),
    ("inf", {"launch": {"a": "|inf|"}}, ["a = inf is not a finite number"]),
    ("overflow", {"launch": {"a": "1e400 m"}}, ["is not a finite number"]),
    ("overflow by unit", {"pendulum": {"length": "1e308 km"}}, ["is not a finite number"]),
    ("huge exponent", {"launch": {"a": "1e999999999 m"}}, ["is not a finite number"]),
    ("huge integer", {"launch": {"a": "|" + "9" * 400 + "|"}}, ["…", "is not a finite number"]),
    ("negative length", {"pendulum": {"length": "-1 m"}}, ["length", "-1"]),
    ("zero length", {"pendulum": {"length": 0}}, ["length", "0"]),
    ("zero gravity", {"pendulum": {"gravity": 0}}, ["gravity", "0"]),
    ("negative mass", {"pendulum": {"mass": "-2 kg"}}, ["mass", "-2"]),
    ("a beyond the length", {"launch": {"a": "2 m"}}, ["outer turning radius", "2 m", "1 m"]),
    ("b larger than a", {"launch": {"b": "-30 cm"}}, ["0.3 m", "0.2 m"]),
    (
        "off the sphere",
        {"launch": {"kind": "state", "position": [0, 0, 2], "velocity": [0, 0, 0]}},
        ["sphere", "2 m", 'use kind = "plane"'],
    ),
    (
        "velocity out of the tangent plane",
        {"launch": {"kind": "state", "position": [0, 0, 1], "velocity": [0, 0, 3]}},
        ["velocity", "3 m/s"],
    ),
    (
        "two components",
        {"launch": {"kind": "state", "position": [0, 1], "velocity": [0, 0, 0]}},
        ["[launch] position = [0, 1]", "three components"],
    ),
    (
        "bad component",
        {"launch": {"kind": "state", "position": [0, "1 s", 0], "velocity": [0, 0, 0]}},
        ["position[y]", "not a length"],
    ),
    (
        "no velocity",
        {"launch": {"kind": "state", "position": [0, 0, 1]}},
        ["[launch] velocity is missing"],
    ),
    ("step of zero", {"output": {"step": 0}}, ["step = 0", "longer than zero", '"0.1 s"']),
    ("negative step", {"output": {"step": "-1 s"}}, ['step = "-1 s"', "longer than zero"]),
    ("negative duration", {"output": {"duration": -1}}, ["duration = -1", '"10 min"']),
    ("step in metres", {"output": {"step": "1 m"}}, ["not a time"]),
    ("step beyond the end", {"output": {"step": "1 h"}}, ["3600 s", "10 s", "shorter step"]),
    ("step and samples", {"output": {"samples": 5}}, ["more than once: step, samples; give"]),
    ("no step", {"output": {"step": None}}, ["neither step nor samples", "samples = 1000"]),
    ("one sample", {"output": {"step": None, "samples": 1}}, ["samples = 1 ", "at least 2"]),
    ("half a sample", {"output": {"step": None, "samples": 2.5}}, ["samples = 2.5", "whole"]),
    ("1e12 samples", {"output": {"step": None, "samples": "|1e12|"}}, ["1e+12", "64 TB", "6.4 GB"]),
    ("1e12 steps", {"output": {"step": 1e-11}}, ["1e+12 samples", "64 TB", 'step = "1e-07 s"']),
    ("1e300 steps", {"output": {"step": 1e-300}}, ["more memory than there is"]),
    ("inf steps", {"output": {"step": 1e-310}}, ["more than 1e308 samples"]),
    ("unknown format", {"output": {"format": "hdf"}}, ['format = "hdf"', '"netcdf"', '"parquet"']),
    ("latitude beyond a pole", {"site": {"latitude": "95 deg"}}, ['"95 deg" lies beyond a pole']),
    ("latitude in metres", {"site": {"latitude": "48 m"}}, ["is not an angle", '"30 deg"']),
    ("negative drag", {"drag": {"linear": "-1e-5 1/s"}}, ["The linear drag", "-1e-05 1/s"]),
    ("drag said twice", {"drag": {"quality": 800, "half_life": "1 h"}}, ["quality, half_life"]),
    ("drag in metres", {"drag": {"linear": "1 m"}}, ["is not a decay rate", "1e-5 1/s"]),
    ("unknown key of a site", {"site": {"lattitude": 1}}, ["lattitude", "did you mean latitude?"]),
    ("unknown key of a drive", {"drive": {"pusch": 1}}, ["pusch", "did you mean push?"]),
    ("a bob of air", {"bob": {"radius": "1 cm", "density": 1}}, ["density", "exceed that of"]),
    (
        "a drive without drag",
        {"drive": {"push": "1 mm/s", "phase": "10 deg"}},
        ["push of 0.001 m/s pumps without end", "give it a drag"],
    ),
    (
        "a drive that the drag cannot hold",
        {"drive": {"push": "1 m/s", "radius": "1 cm"}, "drag": {"half_life": "1 h"}},
        ["pumps without end", "keeps an amplitude of 0.2 m"],
    ),
    (
        "two gravities",
        {"site": {"latitude": "48 deg", "gravity": 9.7}, "pendulum": {"gravity": 9.8}},
        ["The site's gravity is 9.7 m/s²", "the pendulum's 9.8 m/s²"],
    ),
    (
        "slack at the launch",
        {"launch": {"kind": "at_rest", "theta": "100 deg"}, "drag": {"linear": 0}},
        ["slack at the launch", "start lower or faster"],
    ),
    (
        "a real job of years, step by step",
        {"drag": {"half_life": "1 h"}, "output": {"duration": "100 years", "step": "1 s"}},
        ["3.16e+09 samples", "longer step"],
    ),
    ("figure in words", {"output": {"figure": "yes"}}, ['figure = "yes"', "true or false"]),
]


@pytest.mark.parametrize(
    ("changes", "words"), [case[1:] for case in SENTENCES], ids=[case[0] for case in SENTENCES]
)
def test_sentence(call, write, changes, words) -> None:
    path = write(**changes)
    outcome = call("run", path)
    _is_refused(outcome, words)
    assert path.name in outcome.err
    assert list(Path.cwd().iterdir()) == []


FILES: list[tuple[str, bytes, list[str]]] = [
    ("empty", b"", ["is empty", "[pendulum]", 'kind = "ellipse"']),
    ("comments only", b"# nothing\n", ["is empty"]),
    ("truncated in a value", b'[pendulum]\nlength = "67', ["not valid TOML", "Unterminated"]),
    ("truncated after a table", b"[pendulum]\nlength = 67\n", ["[launch] is missing", "[output]"]),
    ("bare unit", b"[pendulum]\nlength = 67 m\n", ["not valid TOML", 'length = "67 m"']),
    ("not UTF-8", b"[pendulum]\n# Panth\xe9on\n", ["not UTF-8", "0xe9", "position 18"]),
    ("UTF-16", "[pendulum]".encode("utf-16"), ["not UTF-8"]),
    ("key outside a table", b"length = 3\n", ["length = 3", "[pendulum]"]),
    ("number for a table", b"pendulum = 3\n", ["pendulum = 3", "write [pendulum]"]),
    ("list of tables", b"[[pendulum]]\nlength=1\n[launch]\n[output]\n", ["write [pendulum]"]),
    ("deeply nested", b"a = " + b"[" * 100_000, ["not valid TOML"]),
    ("huge", b"#" * 3_000_000, ["larger than 1024 KiB"]),
]


@pytest.mark.parametrize(
    ("content", "words"), [case[1:] for case in FILES], ids=[case[0] for case in FILES]
)
def test_file(call, tmp_path: Path, content: bytes, words: list[str]) -> None:
    path = tmp_path / "job.toml"
    path.write_bytes(content)
    outcome = call("run", path)
    _is_refused(outcome, [str(path), *words])
    assert list(Path.cwd().iterdir()) == []


def test_missing_file_names_its_neighbours(call, write) -> None:
    path = write()
    _is_refused(call("run", path.with_name("jbo.toml")), ["jbo.toml does not exist", "job.toml"])


def test_folder_in_place_of_a_file(call, tmp_path: Path) -> None:
    _is_refused(call("run", tmp_path), [f"kugelpendel: {tmp_path} is a folder; name a job file"])


def test_name_that_is_too_long(call) -> None:
    _is_refused(call("run", "a" * 5000), ["cannot be read", "too long"])


@pytest.mark.parametrize("name", ["taken", "taken/inside", "taken/deep/inside"])
def test_output_folder_that_is_a_file(call, write, tmp_path: Path, name: str) -> None:
    (tmp_path / "taken").write_text("mine")
    outcome = call("run", write(), "--out", tmp_path / name)
    _is_refused(outcome, ["cannot be written", "is a file", "--out"])
    assert (tmp_path / "taken").read_text() == "mine"


def test_output_folder_on_a_read_only_system(call, write) -> None:
    if not Path("/proc/self").exists():
        pytest.skip("needs /proc, where nobody can make a folder")
    _is_refused(call("run", write(), "--out", "/proc/kugelpendel"), ["cannot be written", "--out"])


def test_folder_in_the_way_of_a_file(call, write, tmp_path: Path) -> None:
    (tmp_path / "out" / "track.csv").mkdir(parents=True)
    outcome = call("run", write(), "--out", tmp_path / "out")
    _is_refused(outcome, ["track.csv is a folder"])
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["track.csv"]


@pytest.mark.parametrize("arguments", [["rnu"], ["run"], ["run", "a", "--format", "hdf"], ["-x"]])
def test_wrong_arguments(arguments: list[str], capsys: pytest.CaptureFixture[str], call) -> None:
    with pytest.raises(SystemExit) as leaving:
        call(*arguments)
    assert leaving.value.code == 2
    assert "usage: kugelpendel" in capsys.readouterr().err


def test_no_command_shows_the_help(call) -> None:
    outcome = call()
    assert outcome.code == 2
    assert outcome.out == ""
    assert "usage: kugelpendel" in outcome.err


def test_package_that_is_not_installed(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    from kugelpendel.cli.job_file import units

    def absent() -> None:
        raise ModuleNotFoundError("No module named 'pint'", name="pint")

    monkeypatch.setattr(units, "_registry", absent)
    units._parsed.cache_clear()
    monkeypatch.setitem(sys.modules, "pint", None)
    in_feet = write(pendulum={"length": "219 ft"})
    _is_refused(call("run", in_feet), ["pint is not installed", "kugelpendel[run]"])


def _is_refused(outcome: Any, words: list[str]) -> None:
    assert outcome.code == 2, outcome
    assert outcome.out == ""
    assert outcome.err.startswith("kugelpendel: ")
    assert "Traceback" not in outcome.err
    for word in words:
        assert word in outcome.err
