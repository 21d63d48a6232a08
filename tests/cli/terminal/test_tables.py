"""Columns: no number is cut at any width, text is wrapped, and a file has its own width."""

import io
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kugelpendel.cli.terminal import tables

HEADERS = ("Motion", "Equation", "Largest error", "of a", "At the end", "Period", "Precession")
ROWS = [
    ("LinearMotion", "(16)", "3.72 cm", "19 %", "3.72 cm", "−0.31 %", "−100 %"),
    ("SeriesMotion(10)", "series", "−5.3e−09 %", "7e−14 %", "1.23e−12 m", "the same", "−5.3e−09 %"),
]


def words(text: str) -> list[str]:
    return text.split()


@pytest.mark.parametrize("columns", [60, 61, 72, 80, 100, 200])
def test_numbers_are_whole_at_every_width(columns: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    said = tables.numbers(HEADERS, ROWS, text=2)
    assert all(len(line) <= columns for line in said.splitlines())
    assert "…" not in said
    for row in (HEADERS, *ROWS):
        for cell in row:
            assert cell in said, cell
    # Every part says which motion its numbers are of.
    assert said.count("LinearMotion") == said.count("SeriesMotion") == said.count(" Motion ") >= 1


def test_a_table_that_fits_is_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    assert tables.numbers(HEADERS, ROWS, text=2).count("LinearMotion") == 1
    monkeypatch.setenv("COLUMNS", "60")
    assert tables.numbers(HEADERS, ROWS, text=2).count("LinearMotion") == 2


@pytest.mark.parametrize(
    ("columns", "room"), [("59", 60), ("1", 60), ("60", 60), ("140", 140), ("", 100), ("x", 100)]
)
def test_a_file_has_100_columns_unless_told(
    columns: str, room: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setattr("sys.stdout", io.StringIO())
    assert tables.room() == room
    monkeypatch.setattr("sys.stdout", None)  # closed
    assert tables.room() == room


def test_a_terminal_has_its_own_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr("sys.stdout", Terminal())
    monkeypatch.setenv("COLUMNS", "77")
    assert tables.room() == 77


def test_facts_stand_in_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    rows = [
        ("Launch", "3 m out"),
        ("Swing period", "16.42292 s", "2π/ω, there and back, and what else there is to say"),
        ("  by formula (26)", "16.42292 s", ""),
    ]
    assert tables.facts(rows).splitlines() == [
        "Launch             3 m out",
        "Swing period       16.42292 s             2π/ω, there and",
        "                                          back, and what",
        "                                          else there is to",
        "                                          say",
        "  by formula (26)  16.42292 s",
    ]


def test_brackets_are_no_markup(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    assert "[bold]a[/bold] :+1:" in tables.listing([("[1]", "[bold]a[/bold] :+1:")])
    assert tables.paragraph("[red]") == "[red]"
    assert "[x]" in tables.numbers(["[y]", "[z]"], [("[x]", "[w]")])


@given(st.lists(st.from_regex(r"[a-z(]{1,150}", fullmatch=True), min_size=1, max_size=30))
def test_nothing_is_lost_when_text_is_wrapped(text: list[str]) -> None:
    said = tables.paragraph(" ".join(text))
    assert "".join(words(said)) == "".join(text)
    assert all(len(line) <= max(tables.room(), 60) for line in said.splitlines())
    beside = tables.listing([("name", " ".join(text))]).removeprefix("name")
    assert "".join(words(beside)) == "".join(text)


def test_a_number_keeps_its_unit(monkeypatch: pytest.MonkeyPatch) -> None:
    text = " ".join(f"it turns by {k}.46 °/h over {k} h and {k} %," for k in range(10, 40))
    for width in range(60, 101):
        monkeypatch.setenv("COLUMNS", str(width))
        for said in (tables.paragraph(text), tables.facts([("Name", text)])):
            assert "\ue000" not in said
            assert not re.search(r"\d$", said, re.MULTILINE)
