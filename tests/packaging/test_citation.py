"""How to cite: what the package says is what CITATION.cff and the metadata say."""

from __future__ import annotations

import re
from importlib.metadata import version
from pathlib import Path

import pytest

import kugelpendel as kp


def test_version_is_that_of_the_metadata() -> None:
    assert kp.__version__ == version("kugelpendel")
    assert not hasattr(kp, "__versions__")


def test_says_what_the_file_says(repository: Path) -> None:
    stored = (repository / "CITATION.cff").read_text(encoding="utf-8")
    text, bibtex = kp.cite(), kp.cite("bibtex")
    found = dict(re.findall(r"^\s*(?:- )?([\w-]+): \"?(.+?)\"?$", stored, re.MULTILINE))
    year = found["date-released"][:4]
    for said in (text, bibtex):
        assert re.search(r'^title: "(.+)"$', stored, re.MULTILINE).group(1) in said  # pyright: ignore[reportOptionalMemberAccess]
        assert f"version {found['version']} ({year})" in said or f"year = {{{year}}}" in said
        for part in ("Spherical pendulum revisited", "Olsson", found["volume"], found["start"]):
            assert part in said
    assert found["version"] == kp.__version__


def test_entries_are_whole() -> None:
    entries = kp.cite("bibtex")
    assert re.findall(r"^@(\w+)\{(\w+),$", entries, re.MULTILINE) == [
        ("software", "kugelpendel"),
        ("article", "olsson1981"),
    ]
    assert entries.count("{") == entries.count("}")


def test_another_form_is_refused() -> None:
    with pytest.raises(kp.InvalidInput, match='"text" or as "bibtex", but not as \'ris\''):
        kp.cite("ris")  # pyright: ignore[reportArgumentType]
