"""Standard output in old encodings, full, closed, gone: every command ends with a sentence."""

import io
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from kugelpendel.cli.terminal import streams

ENCODINGS = ["ascii", "cp1252", "cp437", "latin-1", "iso8859-2", "utf-8", "utf-16"]

EXAMPLE = {
    "run": ["run", "job.toml", "--out", "o"],
    "compare": ["compare", "job.toml", "--out", "o"],
    "validity": ["validity", "--length", "67", "--a", "3"],
    "misprints": ["derive", "--misprints", "--lang", "de"],
    "text": ["derive", "25", "--lang", "de"],
    "help": ["run", "--help"],
    "version": ["--version"],
}


def program(*arguments: str, cwd: Path, encoding: str = "utf-8", stdout: Any = subprocess.PIPE):
    return subprocess.run(
        [sys.executable, "-m", "kugelpendel", *arguments],
        cwd=cwd,
        env={**os.environ, "PYTHONIOENCODING": encoding},
        stdout=stdout,
        stderr=subprocess.PIPE,
        check=False,
    )


@pytest.mark.parametrize("name", ["run", "compare", "validity", "misprints", "text"])
@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_every_command_writes_to_any_stream(write, tmp_path, name: str, encoding: str) -> None:
    write(output={"duration": "1 s"})
    done = program(*EXAMPLE[name], cwd=tmp_path, encoding=encoding)
    assert done.returncode == 0, done.stderr
    assert done.stderr == b""
    text = done.stdout.decode(encoding)
    assert text
    if name == "run":
        assert "2pi" in text
        assert "In o: track.csv" in text


@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_json_is_json_in_any_encoding(tmp_path: Path, write, encoding: str) -> None:
    path = write(output={"duration": "1 s"})
    path.rename(path.with_name("Fußgänger−Ω.toml"))
    done = program("run", "Fußgänger−Ω.toml", "--json", cwd=tmp_path, encoding=encoding)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.decode("ascii"))["job"] == "Fußgänger−Ω.toml"


def test_errors_are_said_in_any_encoding(tmp_path: Path) -> None:
    done = program("run", "Ωmega.toml", cwd=tmp_path, encoding="ascii")
    assert done.returncode == 2
    assert done.stderr.startswith(b"kugelpendel: Omegamega.toml does not exist")


@pytest.mark.parametrize("buffered", ["", "1"])
@pytest.mark.parametrize("name", ["run", "validity", "text", "help", "version"])
def test_a_full_device_gets_a_sentence(
    write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, buffered: str
) -> None:
    monkeypatch.setenv("PYTHONUNBUFFERED", buffered)
    if not Path("/dev/full").exists():
        pytest.skip("needs /dev/full")
    write(output={"duration": "1 s"})
    with Path("/dev/full").open("w") as full:
        done = program(*EXAMPLE[name], cwd=tmp_path, stdout=full)
    assert done.returncode == 2
    said = {
        "en": "standard output cannot be written: No space left on device; the files, if any, are "
        "complete.",
        "de": "Die Standardausgabe nimmt nichts auf: No space left on device; die Dateien, falls "
        "es welche gibt, sind vollständig.",
    }["de" if "de" in EXAMPLE[name] else "en"]
    assert done.stderr.decode() == f"kugelpendel: {said}\n"
    if name == "run":
        assert (tmp_path / "o" / "results.json").exists()


@pytest.mark.parametrize("name", ["run", "help", "version", "validity"])
def test_a_closed_stream_gets_a_sentence(write, tmp_path: Path, name: str) -> None:
    write(output={"duration": "1 s"})
    command = " ".join([sys.executable, "-m", "kugelpendel", *EXAMPLE[name], ">&-"])
    done = subprocess.run(command, shell=True, cwd=tmp_path, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith(b"kugelpendel: standard output is closed")
    assert not (tmp_path / "o").exists()


def test_a_closed_error_stream_is_no_traceback(tmp_path: Path) -> None:
    command = f"{sys.executable} -m kugelpendel run nothing.toml 2>&-"
    done = subprocess.run(command, shell=True, cwd=tmp_path, stdout=subprocess.PIPE, check=False)
    assert done.returncode == 2
    assert done.stdout == b""


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_signs_that_an_encoding_lacks_are_written_plainly(encoding: str) -> None:
    stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding, errors="kugelpendel")
    stream.write("−1 √(l/g) Ω ψ → 中")
    stream.flush()
    assert isinstance(stream.buffer, io.BytesIO)
    text = stream.buffer.getvalue().decode(encoding)
    assert text.startswith(("−1", "-1"))
    if encoding == "ascii":
        assert text == "-1 sqrt (l/g) Omega psi -> ?"


def test_every_replacement_is_plain() -> None:
    assert "".join(streams._PLAIN.values()).isascii()
    assert not "".join(streams._PLAIN).isascii()


def test_tilde_is_the_users_folder(call, write, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    path = write(output={"duration": "1 s"})
    (tmp_path / "home").mkdir()
    path.rename(tmp_path / "home" / "mine.toml")
    outcome = call("run", "~/mine.toml", "--out=~/results")
    assert outcome.code == 0, outcome.err
    assert (tmp_path / "home" / "results" / "results.json").exists()
    assert not Path("~").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["run", "job.toml", "--out", "-"], "several files do not fit into standard output"),
        (["run", "job.toml", "--out", ""], "an empty name names no file"),
        (["run", "~nobody-of-that-name/job.toml"], "there is no user of that name; write ~ alone"),
        (["validity", "--out", "~nobody-of-that-name/a.png"], "there is no user of that name"),
    ],
)
def test_paths_that_are_none(call, arguments: list[str], said: str) -> None:
    outcome = call(*arguments)
    assert outcome.code == 2
    assert outcome.out == ""
    assert said in outcome.err
