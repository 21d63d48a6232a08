"""A job to vary, and the command line as a function."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from kugelpendel.cli import main

JOB: dict[str, dict[str, Any]] = {
    "pendulum": {"length": "1 m", "mass": "2 kg"},
    "launch": {"kind": "apsides", "a": "20 cm", "b": "10 cm"},
    "output": {"duration": "10 s", "step": "0.1 s", "figure": False},
}

Change = dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Outcome:
    """What a call of the command line did."""

    code: int
    out: str
    err: str

    @property
    def results(self) -> dict[str, Any]:
        """What ``--json`` printed."""
        return json.loads(self.out)


def as_toml(tables: dict[str, dict[str, Any]]) -> str:
    """The tables as TOML; a value of None leaves the key out, and strings in | | stand bare."""
    lines: list[str] = []
    for name, entries in tables.items():
        lines.append(f"[{name}]")
        for key, value in entries.items():
            if isinstance(value, str) and value.startswith("|"):
                lines.append(f"{key} = {value.strip('|')}")
            elif value is not None:
                lines.append(f"{key} = {json.dumps(value)}")
    return "\n".join(lines) + "\n"


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Write the usual job with some entries changed, and give its path."""

    def write(**changes: dict[str, Any]) -> Path:
        tables = copy.deepcopy(JOB)
        for name, entries in changes.items():
            if name == "launch" and "kind" in entries:
                tables["launch"] = {}
            tables.setdefault(name, {}).update(entries)
        path = tmp_path / "job.toml"
        path.write_text(as_toml(tables), encoding="utf-8")
        return path

    return write


@pytest.fixture
def call(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[..., Outcome]:
    """Call the command line from an empty folder."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.delenv("COLUMNS", raising=False)  # pytest-xdist tells its workers 80

    def call(*arguments: str | Path) -> Outcome:
        capsys.readouterr()
        code = main([str(argument) for argument in arguments])
        out, err = capsys.readouterr()
        return Outcome(code, out, err)

    return call
