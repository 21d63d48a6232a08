"""What is no track is refused in a sentence, in both languages and for both doors."""

import re
from pathlib import Path
from typing import Any, get_args

import pytest
from tests.tracks.read.spellings import motion, project

import kugelpendel as kp
from kugelpendel.errors import Language

ROWS = [f"{t:.4f};{x:.5f};{y:.5f}" for t, x, y in zip(*motion(), strict=True)]
OTHERS = ["{0};{2};{1}".format(*row.split(";")) for row in ROWS]
TWO = ["mass A", "t;x;y", *ROWS, "mass B", "t;x;y", *ROWS]
ENTITY = '<!DOCTYPE a [<!ENTITY e SYSTEM "file:///etc/hostname">]>'

REFUSED: dict[str, list[tuple[bytes | str | list[str], dict[str, Any]]]] = {
    "track_empty": [(b"", {}), ("\ufeff \n\n", {}), ("# t x y\n# nothing came\n", {})],
    "track_no_text": [(b"\x89PNG\r\n\x1a\n\x00\x01\x02" * 40, {}), (b"\xff\xfea\x00b", {})],
    "track_no_numbers": [("Dear Sir or Madam,\nthe pendulum swings.\n", {}), ("t;x;y\n", {})],
    "track_one_column": [([f"{i / 10}" for i in range(50)], {})],
    "track_no_time": [(["x;y", *(row.split(";", 1)[1] for row in ROWS)], {})],
    "track_no_rate": [(["frame;x;y", *(f"{i};{i % 7};{i % 5}" for i in range(99))], {})],
    "track_rate": [(ROWS, {"rate": 0.0}), (ROWS, {"rate": float("nan")})],
    "track_scale": [(ROWS, {"scale": -1.0}), (ROWS, {"scale": float("inf")})],
    "track_masses": [(TWO, {})],
    "track_mass_unknown": [(TWO, {"mass": "C"})],
    "track_role": [(["t;x;y", *ROWS], {"columns": {"z": "x", "y": "y"}})],
    "track_columns_incomplete": [(["t;x;y", *ROWS], {"columns": {"time": "t", "x": "x"}})],
    "track_column_unknown": [(["t;x;y", *ROWS], {"columns": {"time": "t", "x": "u", "y": "y"}})],
    "track_no_columns": [(["p;q;r;s", *(f"{row};7" for row in ROWS)], {})],
    "track_column_of_words": [
        (["t;x;y;why", *(f"{r};so" for r in ROWS)], {"columns": {"time": 1, "x": 2, "y": "why"}})
    ],
    "track_units_differ": [(["t (s);x (m);y (px)", *ROWS], {})],
    "track_nothing_seen": [(["t;x;y", *(f"{i / 30:.4f};NaN;n/a" for i in range(90))], {})],
    "track_too_few": [(["t;x;y", *ROWS[:7]], {})],
    "track_times_shared": [
        (["t;x;y", *ROWS, *OTHERS], {}),
        (["t;x;y", *(f"{i // 3};{i % 7};{i % 5}" for i in range(99))], {}),
    ],
    "track_motionless": [(["t;x;y", *(f"{i / 30:.4f};0.31;0.2" for i in range(90))], {})],
    "track_trk": [("<?xml version='1.0'?><a><b></a>", {})],
    "track_trk_no_mass": [("<?xml version='1.0'?><a/>", {})],
    "track_trk_entities": [(project(ENTITY, "&e;"), {})],
}  # fmt: skip

CASES = [(kind, index) for kind, cases in REFUSED.items() for index in range(len(cases))]


def refusal(file: Path, content: bytes | str | list[str], options: dict[str, Any]) -> Any:
    text = "\n".join(content) if isinstance(content, list) else content
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(kp.InvalidInput) as raised:
        kp.tracks.read(file, **options)
    return raised.value


@pytest.mark.parametrize(("kind", "index"), CASES)
def test_refused_in_a_sentence(kind: str, index: int, tmp_path: Path) -> None:
    error = refusal(tmp_path / "track.csv", *REFUSED[kind][index])
    assert error.kind == kind
    if str(error).startswith("track.csv"):
        assert "track.csv" not in str(error).removeprefix("track.csv")
    for language in get_args(Language):
        for door in ("python", "file"):
            said = error.sentence(language, door)
            assert said.endswith((".", "."))
            assert len(said) < 500
        assert "=3}" not in error.sentence(language, "file")
    assert "root:" not in str(error)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(kp.InvalidInput, match="cannot be read: No such file") as raised:
        kp.tracks.read(tmp_path / "nothing.csv")
    assert raised.value.kind == "track_not_read"


def test_every_refusal_of_the_reader_is_provoked_here(repository: Path) -> None:
    room = repository / "src/kugelpendel/tracks/read"
    raised = {
        kind
        for path in room.glob("*.py")
        for kind in re.findall(r'"(track_\w+)"', path.read_text("utf-8"))
    }
    # What follows a growing file is provoked in tests/cli/fit/test_follow.py.
    assert raised - {"track_replaced", "track_not_followed"} == {*REFUSED, "track_not_read"}
