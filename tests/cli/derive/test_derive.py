"""``kugelpendel derive``: documents, proofs, misprints, and what it refuses."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from kugelpendel import paper
from kugelpendel.cli import main
from kugelpendel.cli.derive.check import table
from kugelpendel.cli.derive.command import nearest
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.paper.document.prose import sentence


class Outcome:
    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err


@pytest.fixture
def call(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LC_ALL", "C.UTF-8")

    def call(*arguments: str) -> Outcome:
        capsys.readouterr()
        code = main(["derive", *arguments])
        out, err = capsys.readouterr()
        return Outcome(code, out, err)

    return call


def test_text_on_the_terminal(call: Any) -> None:
    outcome = call("25")
    assert outcome.code == 0
    assert "Ω = 3/8 ω₀ ab/l²" in outcome.out
    assert outcome.out.startswith("What (25) rests on")
    assert "m r⃗̈ = mg e⃗_z − T e⃗_r" in outcome.out
    assert "\n(26)  " not in outcome.out


@pytest.mark.parametrize(
    ("name", "start"),
    [("a.html", "<!DOCTYPE html>"), ("a.md", "# "), ("a.tex", "\\documentclass"), ("a.txt", "W")],
)
def test_format_by_the_name(call: Any, tmp_path: Path, name: str, start: str) -> None:
    outcome = call("5b", "--lang", "de", "--out", name)
    assert outcome.code == 0
    assert outcome.out == f"Geschrieben: {name}\n"
    assert (tmp_path / name).read_text(encoding="utf-8").startswith(start)


def test_html_has_a_file_by_default(call: Any, tmp_path: Path) -> None:
    assert call("(3)", "--format", "html").code == 0
    assert [path.name for path in tmp_path.iterdir()] == ["derivation-3.en.html"]


def test_markdown_without_a_file(call: Any) -> None:
    assert call("3", "--format", "md").out == paper.write("en", "md", "3")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["7"], "The derivation has no equation '7'; near it are (6), (6b), (6c), (8)."),
        (["10.77"], "no equation '10.77'; near it are (10), (10.1), (10.2), (10.7)."),
        (["x"], "no equation 'x'; near it are (1), "),
        (["--lang", "fr"], "in the language 'fr'; choose --lang de or --lang en."),
        (["--format", "pdf"], "'pdf' is not known; choose one of html, md, latex, text."),
        (["--out", "a.doc"], "a.doc does not tell the format; end it in .html, .md, .tex, .txt"),
        (["3", "--out", "no/a.html"], "no/a.html cannot be written: No such file or directory"),
        (["3", "--format", "md", "--out", "."], "cannot be written: it is a folder"),
        (["--check", "--misprints"], "--check and --misprints are two commands"),
        (["--handout", "--check"], "--check and --handout are two commands; give one of them."),
        (
            ["25", "--handout"],
            "page of the whole derivation, in a file that ends in .html; leave",
        ),
        (["--handout", "25"], "leave out EQUATION."),
        (["--handout", "--format", "md"], "leave out --format."),
        (["--handout", "--out", "a.tex"], "leave out --out."),
        (["--handout", "--json"], "--json prints what --check or --misprints finds"),
        (["--handout", "--lang", "fr"], "in the language 'fr'; choose --lang de or --lang en."),
        (["--handout", "--out", "no/a.html"], "no/a.html cannot be written: No such file or dir"),
        (["--out", "no/a.html"], "no/a.html cannot be written: No such file or directory"),
        (["3", "--check", "--format", "html", "--json"], "leave out --format."),
        (["3", "--check", "--out", "-"], "writes a page only as HTML; leave out --out."),
        (["--check", "--out", "a.txt"], "leave out --out."),
        (["3", "--misprints", "--format", "md"], "leave out --format, EQUATION."),
        (["--check", "7"], "no equation '7'"),
        (["--json"], "--json prints what --check or --misprints finds; add one of them"),
        (["3", "--json", "--format", "md"], "choose the form of the derivation by --format"),
        (["3", "--out", "~nobody-of-that-name/a.md"], "there is no user of that name; write ~ "),
    ],
)
def test_bad_input(call: Any, tmp_path: Path, arguments: list[str], sentence: str) -> None:
    outcome = call(*arguments)
    assert outcome.code == 2
    assert outcome.out == ""
    assert sentence in outcome.err
    assert outcome.err.startswith("kugelpendel: ")
    assert list(tmp_path.iterdir()) == []


def test_what_was_there_stays_when_writing_fails(
    call: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.md").write_text("before")

    def fail(self: Path, target: Path) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", fail)
    outcome = call("3", "--out", "a.md")
    assert outcome.code == 2
    assert "No space left on device; choose another file with --out." in outcome.err
    assert [path.name for path in tmp_path.iterdir()] == ["a.md"]
    assert (tmp_path / "a.md").read_text() == "before"


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "de_AT.UTF-8"}, "de"),
        ({"LANG": "de_DE.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LC_MESSAGES": "de_DE", "LANG": "en_GB"}, "de"),
    ],
)
def test_language_of_the_locale(environment: dict[str, str], language: str) -> None:
    assert known_language(None, environment) == language


def test_nearest_are_in_order() -> None:
    displays = ["1", "6", "6.1", "6.2", "8", "9"]
    assert nearest("6.7", displays) == ["6", "6.1", "6.2", "8"]


@pytest.mark.parametrize("language", ["de", "en"])
def test_misprints_are_listed(call: Any, language: str) -> None:
    outcome = call("--misprints", "--lang", language)
    assert outcome.code == 0
    for misprint in paper.MISPRINTS:
        assert f"({misprint.where.partition(':')[0]}" in outcome.out
    assert "x/l⁴" in outcome.out


@pytest.mark.parametrize("language", ["de", "en"])
def test_misprints_as_json(call: Any, language: str) -> None:
    outcome = call("--misprints", "--json", "--lang", language)
    assert outcome.code == 0
    found = json.loads(outcome.out)
    assert [one["key"] for one in found] == [one.key for one in paper.MISPRINTS]
    (one,) = [one for one in found if one["key"] == "length-power-in-12"]
    assert one["where"] == "12"
    assert one["printed"] != one["right"]
    assert "l⁴" in one["explanation"]
    assert one["explanation"] == sentence(paper.words(language).misprint("length-power-in-12"))
    shown = [one for one in paper.MISPRINTS if paper.counterexample(one.key) is not None]
    assert {one["key"] for one in found if one["counterexample"]} == {one.key for one in shown}


def test_check_as_json(call: Any) -> None:
    outcome = call("3", "--check", "--json")
    assert outcome.code == 0
    found = json.loads(outcome.out)
    assert found["holds"] is True
    assert [one["label"] for one in found["formulas"]] == ["2:x", "2:y", "2:z", "3"]
    for one in found["formulas"]:
        assert one["symbolic"] is one["numeric"] is one["holds"] is True
        assert one["mutants"] == one["killed"] + one["equal"] > 2


def test_a_file_in_the_users_own_folder(
    call: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("USERPROFILE", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    assert call("3", "--out", "~/a.md").code == 0
    assert (tmp_path / "home" / "a.md").is_file()
    assert not (tmp_path / "~").exists()


@pytest.mark.parametrize("language", ["de", "en"])
def test_a_handout_has_a_file_by_default(call: Any, tmp_path: Path, language: str) -> None:
    outcome = call("--handout", "--lang", language)
    assert outcome.code == 0
    assert [path.name for path in tmp_path.iterdir()] == [f"handout.{language}.html"]
    page = (tmp_path / f"handout.{language}.html").read_text(encoding="utf-8")
    assert page == paper.handout(language)


def test_a_page_shows_what_was_proved_when_it_was_written(call: Any, tmp_path: Path) -> None:
    assert call("3", "--lang", "en", "--out", "a.html").code == 0
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert "4 of 4 formulas are proved with symbols and in numbers (" in page
    assert page.count('<details class="proof">') == 2
    assert "are tried by <code>kugelpendel derive --check</code>" in page
    assert "Spoilt: of" not in page


def test_a_check_writes_its_verdicts_into_the_page(call: Any, tmp_path: Path) -> None:
    outcome = call("3", "--check", "--lang", "en", "--format", "html")
    assert outcome.code == 0
    assert "4 of 4 formulas proved both ways." in outcome.out
    assert outcome.out.endswith("Written: derivation-3.en.html\n")
    page = (tmp_path / "derivation-3.en.html").read_text(encoding="utf-8")
    for row in paper.check(parallel=False, labels=["2:x", "2:y", "2:z", "3"]):
        said = (
            f"Spoilt: of {row.mutants} forms {row.killed} were rejected, {row.equal} say the same"
        )
        assert said in page
    assert "Their spoilt forms were tried as well." in page


def test_a_page_does_not_call_proved_what_fails(
    call: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def wrong(*asked: Any) -> list[paper.Evidence]:
        *others, last = proved(*asked)
        broken = replace(last.residuals[0], latex="l", is_zero=False)
        return [*others, replace(last, residuals=(broken,))]

    proved = paper.proved
    monkeypatch.setattr(paper, "proved", wrong, raising=False)
    assert call("3", "--lang", "en", "--out", "a.html").code == 0
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert "3 of 4 formulas are proved" in page
    assert page.count("✗ NOT PROVED") == 1
    assert "It does not vanish." in page


def test_check_of_what_leads_to_one_equation(call: Any) -> None:
    outcome = call("3", "--check", "--lang", "en")
    assert outcome.code == 0
    lines = outcome.out.splitlines()
    assert lines[0].split() == ["Formula", "step", "symbolic", "numeric", "mutants", "rejected"]
    assert [line.split()[0] for line in lines[2:6]] == ["(2:x)", "(2:y)", "(2:z)", "(3)"]
    assert "4 of 4 formulas proved both ways." in lines
    assert lines[-1].endswith("0 survived.")


def test_a_failure_is_shown_and_is_the_exit_code(
    call: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    row = paper.Row("12", paper.StepKind.MULTIPLY, False, True, 3, 1, ("+ for −",), 0.1)
    lines = table([row], paper.words("en"))
    assert lines[2].split()[:4] == ["(12)", "Multiply", "FAILS", "yes"]
    assert lines[-2:] == [
        "5 mutants: 3 rejected, 1 proved to say the same, 1 survived.",
        "(12) + for −",
    ]

    def check(**_: object) -> tuple[paper.Row, ...]:
        return (row,)

    monkeypatch.setattr(paper, "check", check, raising=False)
    assert call("--check").code == 1
    outcome = call("--check", "--json")
    assert outcome.code == 1
    assert json.loads(outcome.out)["holds"] is False


@pytest.mark.parametrize("arguments", [["--help"], ["derive", "--help"]])
def test_help_imports_nothing_heavy(arguments: list[str]) -> None:
    program = (
        "import sys\n"
        "from kugelpendel.cli import main\n"
        "try:\n"
        f"    main({arguments!r})\n"
        "except SystemExit:\n"
        "    pass\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules}), file=sys.stderr)\n"
    )
    environment = {**os.environ, "COLUMNS": "100"}
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, env=environment
    )
    assert not set(done.stderr.split()) & {"sympy", "mpmath", "numpy", "rich", "markdown_it"}
    assert "derive" in done.stdout


def test_missing_extra_is_a_sentence(call: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "kugelpendel.cli.derive.command", None)
    for name in ("sympy", "markdown_it"):
        monkeypatch.setitem(sys.modules, name, None)
    outcome = call("3")
    assert outcome.code == 2
    assert "markdown-it-py and sympy are not installed" in outcome.err
    assert "python -m pip install 'kugelpendel[paper]'" in outcome.err


def test_a_document_on_standard_output_is_utf_8(tmp_path: Path) -> None:
    def printed(out: str) -> bytes:
        return subprocess.run(
            [sys.executable, "-m", "kugelpendel", "derive", "3", "--lang", "de", "--format", "html",
             "--out", out],
            cwd=tmp_path, env={**os.environ, "PYTHONIOENCODING": "ascii"}, capture_output=True,
            check=True,
        ).stdout  # fmt: skip

    page = printed("-")
    assert list(tmp_path.iterdir()) == []
    printed("a.html")
    assert page == (tmp_path / "a.html").read_bytes()
    assert "ü" in page.decode("utf-8")


def test_a_check_is_interrupted_at_once() -> None:
    """Before, leaving waited for the proofs that were begun, 12 s on a busy machine."""
    command = [sys.executable, "-m", "kugelpendel", "derive", "--check"]
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    ) as process:
        time.sleep(5)  # the workers are at their proofs
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        assert time.monotonic() - sent < 3
    assert process.returncode == 130
    # A slow machine is told first how long it takes.
    estimate = r"(kugelpendel: this takes about [^;\n]+; Ctrl-C leaves everything as it was\.\n)?"
    kept = r"kugelpendel: interrupted; no file is left half-written\.\n"
    assert re.fullmatch(estimate + kept, err), err
