"""What the README shows is what the program does."""

import doctest
import re
import shlex
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

from kugelpendel.cli.job_file.job import read_job
from kugelpendel.cli.job_file.schema import JOB
from kugelpendel.cli.job_file.schema_text import example


@pytest.fixture(scope="module")
def readme(repository: Path) -> str:
    return (repository / "README.md").read_text(encoding="utf-8")


def blocks(readme: str, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", readme, flags=re.MULTILINE | re.DOTALL)


def test_python(readme: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    session = "".join(blocks(readme, "python"))
    test = doctest.DocTestParser().get_doctest(session, {}, "README", "README.md", 0)
    assert len(test.examples) > 15
    complaints: list[str] = []
    with np.printoptions():
        doctest.DocTestRunner(verbose=False).run(test, out=complaints.append)
    assert not complaints, "".join(complaints)
    assert (tmp_path / "laboratory.png").stat().st_size > 10_000


def test_console(readme: str, call, repository: Path) -> None:
    shutil.copytree(repository / "examples", "examples")
    found = blocks(readme, "console")
    assert found
    for block in found:
        command, _, expected = block.partition("\n")
        program, *arguments = shlex.split(command.removeprefix("$ "))
        assert program == "kugelpendel"
        outcome = call(*arguments)
        assert outcome.code == 0
        # A line of three dots stands for any lines.
        pattern = re.escape(expected).replace(re.escape("…") + "\\\n", "(?:.*\\n)*?")
        assert re.fullmatch(pattern, outcome.out), command


def test_job_is_the_example(readme: str, repository: Path, tmp_path: Path) -> None:
    (shown,) = blocks(readme, "toml")
    example = (repository / "examples/pantheon.toml").read_text(encoding="utf-8")
    assert tomllib.loads(shown) == tomllib.loads(example)


def test_job_of_the_help_can_be_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], call
) -> None:
    with pytest.raises(SystemExit):
        call("run", "--help")
    text = capsys.readouterr().out
    path = tmp_path / "job.toml"
    path.write_text(text[text.index("  [pendulum]") :], encoding="utf-8")
    assert read_job(path).grid.count == 36001


def test_job_of_the_sentence_can_be_run(tmp_path: Path) -> None:
    path = tmp_path / "job.toml"
    path.write_text(example(JOB), encoding="utf-8")
    assert read_job(path).grid.count == 36001


def test_links_lead_somewhere(readme: str, repository: Path) -> None:
    targets = re.findall(r"\]\(([^)]+)\)", readme)
    assert targets
    for target in targets:
        assert (repository / target).exists(), target


def test_picture_is_drawn_by_its_command(repository: Path, tmp_path: Path) -> None:
    import runpy

    script = runpy.run_path(str(repository / "docs/scripts/picture.py"))
    script["draw"](tmp_path / "picture.svg")
    drawn = (tmp_path / "picture.svg").read_text(encoding="utf-8")
    stored = (repository / "docs/laboratory.svg").read_text(encoding="utf-8")

    # Layout differs by version of matplotlib; what the picture says does not.
    def words(svg: str) -> list[str]:
        return re.findall(r"<text [^>]*>([^<]*)</text>", svg)

    assert words(drawn) == words(stored)
    assert len(drawn) < 102_400
