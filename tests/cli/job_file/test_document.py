"""Where a mistake stands in a file, and files that are none."""

import io
import sys
from pathlib import Path

import pytest

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file.document import line_of, read_document
from kugelpendel.cli.job_file.schema import JOB

TEXT = '''\
# [launch] in a remark, a = 1
[pendulum]
length = "1 m"
mass = """
[launch]
a = 3
"""

[ launch ]   # the one
kind = "apsides"
  a = "20 cm"
"b" = 3

[output]
samples = [
  1,
]
a = 1
'''


@pytest.mark.parametrize(
    ("section", "key", "line"),
    [
        ("pendulum", "", 2),
        ("pendulum", "length", 3),
        ("pendulum", "mass", 4),
        ("launch", "", 9),
        ("launch", "kind", 10),
        ("launch", "a", 11),
        ("launch", "b", 12),
        ("launch", "azimuth", 9),
        ("output", "samples", 15),
        ("output", "a", 18),
        ("drag", "linear", None),
        ("", "", None),
    ],
)
def test_line(section: str, key: str, line: int | None) -> None:
    assert line_of(TEXT, section, key) == line


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ('pendulum.length = "1 m"\nlaunch.a = 3\n', 2),
        ('pendulum = { length = "1 m" }\n\nlaunch = { a = 3 }\n', 3),
        ("[\"launch\"]\n'a' = 3\n", 2),
    ],
)
def test_other_ways_to_write_a_table(text: str, line: int) -> None:
    assert line_of(text, "launch", "a") == line


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"launch": {"a": "3 kg"}}, "job.toml, line 6: [launch] a"),
        ({"pendulum": {"lenght": 1}}, "job.toml, line 4: [pendulum] lenght"),
        ({"launch": {"b": None}}, "job.toml, line 4: [launch] b is missing"),
        ({"output": {"samples": 5}}, "job.toml, line 12: [output] says one thing more than once: "),
        ({"drag": {"quality": 0}}, "job.toml, line 13: [drag] The quality factor"),
        ({"sight": {"x": 1}}, "job.toml, line 12: [sight] is not known"),
        ({"pendulum": {"length": -1}}, "job.toml, line 2: [pendulum] The pendulum"),
    ],
)
def test_a_mistake_names_its_line(call, write, changes: dict, place: str) -> None:
    outcome = call("run", write(**changes))
    assert outcome.code == 2
    assert place in outcome.err


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (
            "length = 0,2",
            "line 2: length = 0,2 has a decimal comma outside quotes; write",
        ),
        ("length = 67,5 m", 'write length = "67,5 m", with the unit, or a point: length = 67.5 m.'),
        ("length = -0,2 # metres", 'length = "-0,2", with the unit, or a point: length = -0.2.'),
        ("length = 67 m", "at line 2"),
    ],
)
def test_a_decimal_comma_without_quotes_is_named(tmp_path: Path, line: str, said: str) -> None:
    path = tmp_path / "job.toml"
    path.write_text(f"[pendulum]\n{line}\n")
    with pytest.raises(InvalidInput) as refused:
        read_document(path, JOB)
    assert said in str(refused.value)


def test_a_job_from_standard_input(call, write, monkeypatch: pytest.MonkeyPatch) -> None:
    class Stdin:
        closed = False
        buffer = io.BytesIO(write().read_bytes())

    monkeypatch.setattr(sys, "stdin", Stdin())
    outcome = call("run", "-", "--json")
    assert outcome.code == 0, outcome.err
    assert outcome.results["job"] == "stdin"
    assert Path("out/stdin/track.csv").exists()


def test_mistakes_on_standard_input(call, monkeypatch: pytest.MonkeyPatch) -> None:
    class Stdin:
        closed = False
        buffer = io.BytesIO(b"[pendulum]\nlength = 3\n")

    monkeypatch.setattr(sys, "stdin", Stdin())
    assert "stdin: the table [launch] is missing" in call("run", "-").err
    monkeypatch.setattr(sys, "stdin", None)
    assert "standard input is closed; name a job file instead of -." in call("run", "-").err


def test_a_name_that_none_can_have(call) -> None:
    assert "cannot be read" in call("run", "a\0b").err
