"""What a file may say is declared once: the help, the README and docs are its words."""

import re
import tomllib
from pathlib import Path

import pytest

from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.kinds import Kind
from kugelpendel.cli.job_file.quantity import read_quantity
from kugelpendel.cli.job_file.schema_text import example, listing, markdown, value_to_paste
from kugelpendel.cli.job_file.sweep_schema import SWEEP_FILE

FILES = [schema.JOB, schema.DESIGN, SWEEP_FILE]
SECTIONS = {section.name: section for file in FILES for section in file.sections}


def test_pages_have_the_tables_of_the_schema(repository: Path) -> None:
    import runpy

    script = runpy.run_path(str(repository / "docs/scripts/job_files.py"))
    assert sorted(script["PAGES"]) == [
        "README.md",
        "docs/design.md",
        "docs/real.md",
        "docs/sweeps.md",
    ]
    for name, table in script["PAGES"].items():
        page = (repository / name).read_text(encoding="utf-8")
        assert script["written"](page, table) == page, "run make tables"


def test_every_key_stands_on_a_page(repository: Path) -> None:
    pages = "".join(
        (repository / name).read_text(encoding="utf-8")
        for name in ("README.md", "docs/real.md", "docs/design.md", "docs/sweeps.md")
    )
    for section in SECTIONS.values():
        assert f"`[{section.name}]`" in pages
        for key in section.keys:
            assert re.search(rf"^\|.*`{key.name}`.*\|$", pages, re.MULTILINE), key


@pytest.mark.parametrize("width", [50, 78])
@pytest.mark.parametrize("file", FILES)
def test_the_help_lists_every_key(file: schema.FileSchema, width: int) -> None:
    listed = listing(file, width)
    assert all(len(line) <= width for line in listed.splitlines())
    for section in file.sections:
        assert re.search(rf"^  {section.name} ", listed, re.MULTILINE)
        for key in section.keys:
            assert re.search(rf"\b{key.name}\b", listed), key


@pytest.mark.parametrize("name", SECTIONS)
def test_sections_are_consistent(name: str) -> None:
    section = SECTIONS[name]
    keys = [key.name for key in section.keys]
    assert len(set(keys)) == len(keys)
    for option in section.one_of:
        assert set(option) <= set(keys)
    for way in section.ways:
        assert set(way.keys) <= set(keys)
    if section.ways:
        kinds = section.key("kind").holds
        assert isinstance(kinds, schema.Choice)
        assert [way.word for way in section.ways] == list(kinds.choices)
        assert {key for way in section.ways for key in way.keys} == set(keys) - {"kind"}


@pytest.mark.parametrize("name", SECTIONS)
def test_what_is_shown_to_paste_can_be_read(name: str) -> None:
    for key in SECTIONS[name].keys:
        value = tomllib.loads(f"key = {value_to_paste(key)}")["key"]
        if isinstance(key.holds, Kind):
            read_quantity(value, key.holds, key.name)
        elif isinstance(key.holds, schema.Vector):
            assert len(value) == 3
            read_quantity(value[0], key.holds.kind, key.name)
        elif isinstance(key.holds, schema.Choice):
            assert value in key.holds.choices
        else:
            assert isinstance(value, bool) == isinstance(key.holds, schema.Truth)


@pytest.mark.parametrize("file", FILES)
def test_examples_are_of_their_schema(file: schema.FileSchema) -> None:
    tables = tomllib.loads(example(file))
    assert list(tables) == list(file.example)
    assert all(section.name in tables for section in file.sections if section.needed)


def test_tables_name_the_alternatives() -> None:
    table = markdown((schema.OUTPUT,))
    assert "| `samples` | `1000` | in place of `step`: how many rows |" in table
    assert '`"csv"`, `"netcdf"` or `"parquet"`; `"csv"` unless given |' in table
    assert example(schema.JOB).endswith('step = "0.1 s"         # or samples\n')
